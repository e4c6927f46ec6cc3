#include "report/json_writer.h"

#include <cmath>
#include <string>
#include <string_view>

#include "fmt/format.h"
#include "io/number_text.h"
#include "io/scene_json.h"

namespace rasterproof::report {

JsonWriter& JsonWriter::Key(std::string_view key) {
  NextLine();
  text_ += io::JsonString(key) + (line_depth_ == 0 ? ": " : ":");
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::Text(std::string_view text) { return Value(io::JsonString(text)); }

JsonWriter& JsonWriter::Exact(double value) { return Text(io::ExactText(value)); }

JsonWriter& JsonWriter::Rounded(double value) {
  return std::isfinite(value) ? Value(fmt::format("{:.6g}", value)) : Exact(value);
}

JsonWriter& JsonWriter::Shortest(double value) {
  return std::isfinite(value) ? Value(fmt::format("{}", value)) : Exact(value);
}

JsonWriter& JsonWriter::Value(std::string_view json) {
  NextLine();
  text_ += json;
  return *this;
}

JsonWriter& JsonWriter::Begin(char bracket) {
  NextLine();
  text_ += bracket;
  empty_.push_back(true);
  return *this;
}

JsonWriter& JsonWriter::BeginLine(char bracket) {
  Begin(bracket);
  if (line_depth_ == 0) line_depth_ = empty_.size();
  return *this;
}

JsonWriter& JsonWriter::End(char bracket) {
  const bool empty = empty_.back();
  const bool is_line = line_depth_ != 0;
  if (empty_.size() == line_depth_) line_depth_ = 0;
  empty_.pop_back();
  if (!empty && !is_line) text_ += '\n' + std::string(2 * empty_.size(), ' ');
  text_ += bracket;
  return *this;
}

// Moves to the place of the next key or item; a value stays on the line of its key.
void JsonWriter::NextLine() {
  if (after_key_) {
    after_key_ = false;
  } else if (!empty_.empty()) {
    if (!empty_.back()) text_ += ',';
    if (line_depth_ == 0) text_ += '\n' + std::string(2 * empty_.size(), ' ');
    empty_.back() = false;
  }
}

}  // namespace rasterproof::report
