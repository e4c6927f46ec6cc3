#include "io/json_writer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/quoted.h"
#include "io/number_text.h"

namespace rasterproof::io {

JsonWriter& JsonWriter::Key(std::string_view key) {
  NextLine();
  text_ += JsonString(key) + (open_.back().layout.has_blanks ? ": " : ":");
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::Text(std::string_view text) { return Value(JsonString(text)); }

JsonWriter& JsonWriter::Exact(double value) { return Value('"' + ExactText(value) + '"'); }

JsonWriter& JsonWriter::Rounded(double value) {
  if (!std::isfinite(value)) return Exact(value);
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6)
          .ptr;
  return Value({text.data(), end});
}

JsonWriter& JsonWriter::Shortest(double value) {
  if (!std::isfinite(value)) return Exact(value);
  // Without an exponent from 1e-4 to below 1e16, however long.
  const double size = std::fabs(value);
  const bool is_plain = value == 0 || (size >= 1e-4 && size < 1e16);
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value,
                    is_plain ? std::chars_format::fixed : std::chars_format::scientific)
          .ptr;
  return Value({text.data(), end});
}

JsonWriter& JsonWriter::Value(std::string_view json) {
  NextLine();
  text_ += json;
  return *this;
}

JsonWriter& JsonWriter::Begin(char bracket, const JsonLayout& layout) {
  NextLine();
  text_ += bracket;
  const bool is_on_a_line = !open_.empty() && !open_.back().layout.rest_breaks;
  open_.push_back({is_on_a_line ? open_.back().layout : layout, true});
  return *this;
}

JsonWriter& JsonWriter::End(char bracket) {
  const Container closed = open_.back();
  open_.pop_back();
  if (closed.layout.end_breaks && !closed.is_empty) Break();
  text_ += bracket;
  return *this;
}

void JsonWriter::Break() {
  text_ += '\n';
  text_.append(2 * (depth_ + open_.size()), ' ');
}

// Moves to the place of the next key or item; a value stays on the line of its key.
void JsonWriter::NextLine() {
  if (after_key_) {
    after_key_ = false;
  } else if (!open_.empty()) {
    auto& [layout, is_empty] = open_.back();
    const bool breaks = is_empty ? layout.first_breaks : layout.rest_breaks;
    if (!is_empty) text_ += layout.has_blanks && !breaks ? ", " : ",";
    if (breaks) Break();
    is_empty = false;
  }
}

std::string JsonString(std::string_view text) {
  const bool to_ascii = ShownName(text) != text;  // a terminal obeys U+007F to U+009F, too
  return nlohmann::json(text).dump(-1, ' ', to_ascii, nlohmann::json::error_handler_t::replace);
}

}  // namespace rasterproof::io
