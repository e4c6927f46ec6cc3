// Writes JSON from front to back: all JSON of the program.
#ifndef RASTERPROOF_IO_JSON_WRITER_H_
#define RASTERPROOF_IO_JSON_WRITER_H_

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/counters.h"

namespace rasterproof::io {

/// Where the members or items of a container stand.
struct JsonLayout {
  bool first_breaks = true;  ///< the first begins a line
  bool rest_breaks = true;   ///< so do the others; false: all within stand on this line, too
  bool end_breaks = true;    ///< and so does the closing bracket
  bool has_blanks = true;    ///< after commas within a line, and after colons
};
inline constexpr JsonLayout kLines{};
inline constexpr JsonLayout kEndOnLastLine{true, true, false, true};
inline constexpr JsonLayout kFromThisLine{false, true, false, true};
inline constexpr JsonLayout kOneLine{false, false, false, true};
inline constexpr JsonLayout kDenseLine{false, false, false, false};

/// A JSON text under construction, one member or item a line unless it is asked for otherwise.
///
/// Domain:     the caller closes what it opens and gives every member of an object a key.
class JsonWriter {
 public:
  /// `depth`: of the value within the text that it'll be part of.
  explicit JsonWriter(std::size_t depth = 0) : depth_(depth) {}

  JsonWriter& BeginObject(const JsonLayout& layout = kLines) { return Begin('{', layout); }
  JsonWriter& EndObject() { return End('}'); }
  JsonWriter& BeginArray(const JsonLayout& layout = kLines) { return Begin('[', layout); }
  JsonWriter& EndArray() { return End(']'); }
  JsonWriter& BeginObjectLine() { return Begin('{', kDenseLine); }
  JsonWriter& BeginArrayLine() { return Begin('[', kDenseLine); }
  JsonWriter& Key(std::string_view key);

  JsonWriter& Text(std::string_view text);
  JsonWriter& Bool(bool value) { return Value(value ? "true" : "false"); }
  JsonWriter& Null() { return Value("null"); }
  template <std::integral T>
  JsonWriter& Integer(T value) {
    return Value(std::to_string(value));
  }
  /// A double as the exact string that scene files use: "0x1.8p+0", "inf", "nan". Never null.
  JsonWriter& Exact(double value);
  /// A double for drawing or reading, to six digits; a string where JSON has no number for it.
  JsonWriter& Rounded(double value);
  /// A double as a decimal number as short as reads back to it; a string where JSON has no number.
  JsonWriter& Shortest(double value);
  /// A member for each counter.
  template <class T, std::size_t kCount>
  JsonWriter& Members(const Counters<T, kCount>& counters, const T& from) {
    for (const auto& [name, counter] : counters) Key(name).Integer(from.*counter);
    return *this;
  }
  /// JSON text as it is.
  JsonWriter& Value(std::string_view json);

  /// What is written so far.
  const std::string& json() const { return text_; }
  /// The finished text, with a newline at its end.
  std::string Finish() { return text_ + '\n'; }

 private:
  struct Container {
    JsonLayout layout;
    bool is_empty = true;
  };

  JsonWriter& Begin(char bracket, const JsonLayout& layout);
  JsonWriter& End(char bracket);
  void NextLine();
  void Break();

  std::string text_;
  std::size_t depth_;
  std::vector<Container> open_;
  bool after_key_ = false;
};

/// The text as a JSON string, quotes included. Bytes that are not UTF-8 are replaced, and no
/// control character remains.
std::string JsonString(std::string_view text);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_JSON_WRITER_H_
