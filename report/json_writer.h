// Writes JSON from front to back.
#ifndef RASTERPROOF_REPORT_JSON_WRITER_H_
#define RASTERPROOF_REPORT_JSON_WRITER_H_

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/counters.h"

namespace rasterproof::report {

/// A JSON text under construction, one member or item a line unless it is asked for as one line.
///
/// Domain:     the caller closes what it opens and gives every member of an object a key.
class JsonWriter {
 public:
  JsonWriter& BeginObject() { return Begin('{'); }
  JsonWriter& EndObject() { return End('}'); }
  JsonWriter& BeginArray() { return Begin('['); }
  JsonWriter& EndArray() { return End(']'); }
  /// An object or array whose members all stand on one line, and all within them.
  JsonWriter& BeginObjectLine() { return BeginLine('{'); }
  JsonWriter& BeginArrayLine() { return BeginLine('['); }
  JsonWriter& Key(std::string_view key);

  JsonWriter& Text(std::string_view text);
  JsonWriter& Bool(bool value) { return Value(value ? "true" : "false"); }
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

  /// The finished text, with a newline at its end.
  std::string Finish() { return text_ + '\n'; }

 private:
  JsonWriter& Begin(char bracket);
  JsonWriter& BeginLine(char bracket);
  JsonWriter& End(char bracket);
  void NextLine();

  std::string text_;
  std::vector<bool> empty_;  // of each open container: nothing in it yet
  bool after_key_ = false;
  std::size_t line_depth_ = 0;  // of the container that is written on one line; 0: none is
};

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_JSON_WRITER_H_
