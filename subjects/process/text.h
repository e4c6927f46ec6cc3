// Reads and writes the numbers and words of protocol lines, without streams or copies.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_TEXT_H_
#define RASTERPROOF_SUBJECTS_PROCESS_TEXT_H_

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace rasterproof::subjects {

/// Most characters of one number: a double has 24 at most ("-2.2250738585072014e-308").
inline constexpr std::size_t kMostOfANumber = 24;

/// A text that grows by numbers and words.
class TextWriter {
 public:
  void Add(std::string_view words) {
    Room(words.size());
    length_ += words.copy(text_.data() + length_, words.size());
  }
  void Add(char c) {
    Room(1);
    text_[length_++] = c;
  }
  template <std::integral T>
  void AddNumber(T x) {
    Room(kMostOfANumber);
    char* const at = text_.data() + length_;
    if (x >= 0 && x <= 9) {  // nearly all counts
      *at = static_cast<char>('0' + static_cast<int>(x));
      ++length_;
      return;
    }
    length_ += static_cast<std::size_t>(std::to_chars(at, at + kMostOfANumber, x).ptr - at);
  }
  /// The shortest decimal number that is read back as the same bits; nan for every NaN.
  void AddNumber(double x) {
    if (std::isnan(x)) return Add("nan");
    Room(kMostOfANumber);
    char* const at = text_.data() + length_;
    length_ += static_cast<std::size_t>(std::to_chars(at, at + kMostOfANumber, x).ptr - at);
  }

  /// Returns the text that was written and leaves this empty.
  std::string Take() {
    text_.resize(length_);
    length_ = 0;
    return std::move(text_);
  }

 private:
  void Room(std::size_t more) {
    if (text_.size() - length_ < more) text_.resize(2 * text_.size() + more + 256);
  }

  std::string text_;  ///< its first characters are the text; the rest is free
  std::size_t length_ = 0;
};

/// The words of a line, one after the other. They end at blanks: spaces, tabs, carriage returns.
///
/// Domain:     a line that outlives this.
class WordReader {
 public:
  explicit WordReader(std::string_view line) : at_(line.data()), end_(at_ + line.size()) {}

  bool AtEnd() {
    SkipBlanks();
    return at_ == end_;
  }
  /// The next word; empty at the end.
  std::string_view Word() {
    SkipBlanks();
    const char* const begin = at_;
    while (at_ != end_ && !IsBlank(*at_)) ++at_;
    return {begin, at_};
  }
  /// Reads the next word as a number. Returns whether it is one, whole, that T holds.
  template <class T>
  bool Number(T& value) {
    SkipBlanks();
    if constexpr (std::integral<T>) {
      const bool is_digit = at_ != end_ && *at_ >= '0' && *at_ <= '9';
      if (is_digit && (at_ + 1 == end_ || IsBlank(at_[1]))) {
        value = static_cast<T>(*at_++ - '0');
        return true;
      }
    }
    const auto [stop, error] = std::from_chars(at_, end_, value);
    if (error != std::errc{} || (stop != end_ && !IsBlank(*stop))) return false;
    at_ = stop;
    return true;
  }

 private:
  static bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  void SkipBlanks() {
    while (at_ != end_ && IsBlank(*at_)) ++at_;
  }

  const char* at_;
  const char* end_;
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_TEXT_H_
