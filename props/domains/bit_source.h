// The sources of a recipe's choices: a counter-based generator, fuzz bytes, RapidCheck, an
// enumeration.
#ifndef RASTERPROOF_PROPS_DOMAINS_BIT_SOURCE_H_
#define RASTERPROOF_PROPS_DOMAINS_BIT_SOURCE_H_

#include <cstdint>
#include <span>

namespace rasterproof::props {

/// An endless source of bits. A recipe that draws from it is total: every bit string makes a valid
/// case.
class BitSource {
 public:
  virtual ~BitSource() = default;
  /// Returns `count` bits, 1 <= count <= 64, in the low bits.
  virtual std::uint64_t Bits(int count) = 0;

  /// An integer of [low, high], by multiplication: no rejection, no loop.
  std::int64_t Int(std::int64_t low, std::int64_t high);
  /// True with probability numerator / 2^8.
  bool Chance(int numerator_of_256) {
    return Bits(8) < static_cast<std::uint64_t>(numerator_of_256);
  }
  template <class T>
  const T& OneOf(std::span<const T> choices) {
    return choices[static_cast<std::size_t>(Int(0, static_cast<std::int64_t>(choices.size()) - 1))];
  }
};

/// Philox4x64 (Random123): the bits of `index` of `stream` under `seed` are the same on every
/// machine and need no earlier ones. Streams are independent.
class PhiloxSource final : public BitSource {
 public:
  PhiloxSource(std::uint64_t seed, std::uint64_t index, std::uint64_t stream = 0)
      : seed_(seed), index_(index), stream_(stream) {}
  std::uint64_t Bits(int count) override;

 private:
  std::uint64_t seed_;
  std::uint64_t index_;
  std::uint64_t stream_;
  std::uint64_t block_ = 0;
  std::uint64_t words_[4] = {};
  int unused_words_ = 0;
};

/// Fuzz bytes, read from the front; zeros once they run out.
class ByteSource final : public BitSource {
 public:
  explicit ByteSource(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint64_t Bits(int count) override;

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_BIT_SOURCE_H_
