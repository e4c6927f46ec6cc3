#include "io/json_document.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/quoted.h"
#include "core/suggestion.h"
#include "io/renamed.h"

namespace rasterproof::io {
namespace {

std::string_view KindName(JsonKind kind) {
  switch (kind) {
    case JsonKind::kObject:
      return "an object";
    case JsonKind::kArray:
      return "an array";
    case JsonKind::kKey:
    case JsonKind::kString:
      return "a string";
    case JsonKind::kNumber:
      return "a number";
    case JsonKind::kBoolean:
      return "true or false";
    case JsonKind::kNull:
      return "null";
  }
  return "unknown";
}

// Line and column, from 1, of the byte before `end`, where the parser gave up.
std::string LineAndColumn(std::string_view text, std::size_t end) {
  const std::string_view before = text.substr(0, end == 0 ? 0 : end - 1);
  const auto lines = std::ranges::count(before, '\n');
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0: the first line
  // Bytes 10xxxxxx continue a character.
  const auto column = std::ranges::count_if(before.substr(line_begin), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  });
  return "line " + std::to_string(lines + 1) + ", column " + std::to_string(column + 1);
}

// The parser's reason without its exception id and its position.
std::string Reason(std::string_view what) {
  const std::size_t column = what.find(", column ");
  const std::size_t colon = what.find(": ", column == std::string_view::npos ? 0 : column);
  if (colon != std::string_view::npos) what.remove_prefix(colon + 2);
  return Printable(what);
}

}  // namespace

// Takes the parser's events.
class JsonBuilder {
 public:
  JsonBuilder(JsonDocument& document, std::string_view source)
      : document_(document), source_(source) {}

  bool null() { return Add(JsonKind::kNull, {}); }
  bool boolean(bool value) { return Add(JsonKind::kBoolean, value ? "true" : "false"); }
  // The parser gives non-negative integers as unsigned: the integer 0 can only have been "-0".
  bool number_integer(std::int64_t value) {
    return Add(JsonKind::kNumber, value == 0 ? "-0" : std::to_string(value));
  }
  bool number_unsigned(std::uint64_t value) {
    return Add(JsonKind::kNumber, std::to_string(value));
  }
  // The parser's double is not used: it may have been rounded once already.
  bool number_float(double /*value*/, std::string text) {
    // The parser writes the decimal point of the locale.
    for (char& c : text) {
      if (std::string_view("0123456789+-eE").find(c) == std::string_view::npos) c = '.';
    }
    return Add(JsonKind::kNumber, text);
  }
  bool string(const std::string& text) { return Add(JsonKind::kString, text); }
  bool binary(const std::vector<std::uint8_t>& /*bytes*/) { return false; }

  bool start_object(std::size_t /*unknown*/) { return Open(JsonKind::kObject); }
  bool end_object() { return Close(); }
  bool start_array(std::size_t /*unknown*/) { return Open(JsonKind::kArray); }
  bool end_array() { return Close(); }
  bool key(const std::string& name) {
    const JsonValue object(&document_, open_.back());
    if (object.Find(name)) {
      throw object.Error("says the key " + Quoted(name) + " twice", "keep one of them");
    }
    if (++keys_.back() > JsonDocument::kMaxKeys) {
      throw object.Error("has more than " + std::to_string(JsonDocument::kMaxKeys) + " keys",
                         "objects of this format have fewer");
    }
    Add(JsonKind::kKey, name);
    return true;
  }

  template <class Exception>
  bool parse_error(std::size_t position, const std::string& token, const Exception& error) {
    constexpr int kNumberOverflow = 406;
    if (error.id == kNumberOverflow) {
      Add(JsonKind::kNumber, {});
      const auto node = static_cast<std::uint32_t>(document_.nodes_.size() - 1);
      throw JsonValue(&document_, node)
          .Error("the number " + Quoted(token) + " rounds to infinity",
                 "write \"inf\" if infinity is meant");
    }
    const std::string reason = Reason(error.what());
    const bool cut = reason.find("unexpected end of input") != std::string::npos;
    const bool may_be_nan = token.ends_with("N") || token.ends_with("Na") || token.ends_with("I") ||
                            token.ends_with("n") || token.ends_with("-I");
    throw InputError(
        document_.place_ + ": " + LineAndColumn(source_, std::min(position, source_.size() + 1)),
        reason,
        cut          ? "the file is cut short: write it again"
        : may_be_nan ? "JSON has no NaN or infinity: write \"nan\", \"inf\" or \"-inf\""
                     : "correct the JSON there");
  }

 private:
  bool Add(JsonKind kind, std::string_view text) {
    auto& nodes = document_.nodes_;
    nodes.push_back({static_cast<std::uint32_t>(document_.text_.size()),
                     static_cast<std::uint32_t>(text.size()),
                     static_cast<std::uint32_t>(nodes.size() + 1), kind});
    document_.text_ += text;
    return true;
  }
  bool Open(JsonKind kind) {
    Add(kind, {});
    const auto node = static_cast<std::uint32_t>(document_.nodes_.size() - 1);
    document_.nodes_.back().next = 0;
    if (open_.size() == JsonDocument::kMaxDepth) {
      throw JsonValue(&document_, node)
          .Error("is nested more than " + std::to_string(JsonDocument::kMaxDepth) + " levels deep",
                 "values of this format are flatter");
    }
    open_.push_back(node);
    keys_.push_back(0);
    return true;
  }
  bool Close() {
    document_.nodes_[open_.back()].next = static_cast<std::uint32_t>(document_.nodes_.size());
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  JsonDocument& document_;
  std::string_view source_;
  std::vector<std::uint32_t> open_;
  std::vector<std::size_t> keys_;
};

JsonDocument::JsonDocument(std::string_view text, std::string place) : place_(std::move(place)) {
  // Every value and key is at least a byte of text, so node numbers fit wherever offsets do.
  if (text.size() >= std::numeric_limits<std::uint32_t>::max()) {
    throw InputError(place_, "is longer than 4 GiB", "write a smaller file");
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw InputError(place_, "is empty", "give a JSON file");
  }
  JsonBuilder builder(*this, text);
  nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
}

JsonValue JsonDocument::root() const { return {this, 0}; }

// Only errors ask for a place, so it is searched for, not stored. Open containers reach to the end.
std::string JsonDocument::Place(std::uint32_t node) const {
  std::string path;
  std::uint32_t at = 0;
  while (at != node) {
    const bool object = nodes_[at].kind == JsonKind::kObject;
    std::uint32_t child = at + 1;
    std::size_t index = 0;
    for (;; ++index) {
      const std::uint32_t value = object ? child + 1 : child;
      if (nodes_[value].next == 0 || node < nodes_[value].next) break;
      child = nodes_[value].next;
    }
    if (object) {
      path += (path.empty() ? "" : ".") + Printable(Text(child));
      at = child + 1;
    } else {
      path += "[" + std::to_string(index) + "]";
      at = child;
    }
  }
  return path.empty() ? place_ : place_ + ": " + path;
}

void JsonValue::RequireObject(std::span<const std::string_view> allowed) const {
  if (kind() != JsonKind::kObject) {
    throw Error("is " + std::string(KindName(kind())) + ", not an object", "write {...}");
  }
  const auto end = document_->nodes_[node_].next;
  for (std::uint32_t key = node_ + 1; key != end; key = document_->nodes_[key + 1].next) {
    const std::string_view name = document_->Text(key);
    if (std::ranges::find(allowed, name) != allowed.end()) continue;
    const std::vector<std::string_view> known(allowed.begin(), allowed.end());
    throw Error("unknown key " + Quoted(name) + RenamedText(name),
                Suggestion(name, known) + "known here are" + ListedNames(known));
  }
}

std::optional<JsonValue> JsonValue::Find(std::string_view key) const {
  const auto& nodes = document_->nodes_;
  const auto end =
      nodes[node_].next == 0 ? static_cast<std::uint32_t>(nodes.size()) : nodes[node_].next;
  for (std::uint32_t k = node_ + 1; k < end; k = nodes[k + 1].next) {
    if (document_->Text(k) == key) return JsonValue(document_, k + 1);
  }
  return std::nullopt;
}

JsonValue JsonValue::Get(std::string_view key) const {
  const std::optional<JsonValue> value = Find(key);
  if (!value) throw Error("the key " + Quoted(key) + " is missing", "add it");
  return *value;
}

std::size_t JsonValue::Items::size() const {
  std::size_t n = 0;
  for (Iterator i = first; i != last; ++i) ++n;
  return n;
}

JsonValue::Items JsonValue::RequireArray() const {
  if (kind() != JsonKind::kArray) {
    throw Error("is " + std::string(KindName(kind())) + ", not an array", "write [...]");
  }
  return {{document_, node_ + 1}, {document_, document_->nodes_[node_].next}};
}

bool JsonValue::IsSameAs(const JsonValue& other) const {
  const std::uint32_t size = document_->nodes_[node_].next - node_;
  if (other.document_->nodes_[other.node_].next - other.node_ != size) return false;
  for (std::uint32_t k = 0; k < size; ++k) {
    const JsonDocument::Node& mine = document_->nodes_[node_ + k];
    const JsonDocument::Node& its = other.document_->nodes_[other.node_ + k];
    const bool is_container = mine.kind == JsonKind::kObject || mine.kind == JsonKind::kArray;
    if (mine.kind != its.kind || mine.next - node_ != its.next - other.node_) return false;
    if (!is_container && document_->Text(node_ + k) != other.document_->Text(other.node_ + k))
      return false;
  }
  return true;
}

std::string_view JsonValue::RequireString() const {
  if (kind() != JsonKind::kString) {
    throw Error("is " + std::string(KindName(kind())) + ", not a string", "write \"...\"");
  }
  return text();
}

std::string JsonValue::RequireName() const { return ShownName(RequireString()); }

std::int64_t JsonValue::RequireInteger(std::int64_t least, std::int64_t greatest) const {
  const std::string range =
      "write an integer from " + std::to_string(least) + " to " + std::to_string(greatest);
  if (kind() != JsonKind::kNumber) {
    throw Error("is " + std::string(KindName(kind())) + ", not an integer", range);
  }
  const std::string_view digits = text();
  std::int64_t value = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (status == std::errc::invalid_argument || end != digits.data() + digits.size()) {
    throw Error("the number " + Printable(digits) + " is not an integer", range);
  }
  if (status != std::errc{} || value < least || value > greatest) {
    throw Error("the number " + Printable(digits) + " is out of range", range);
  }
  return value;
}

}  // namespace rasterproof::io
