// A digest of numbers and words in their order: equal streams, equal digests, on any machine.
#ifndef RASTERPROOF_TESTS_BASELINE_DIGEST_H_
#define RASTERPROOF_TESTS_BASELINE_DIGEST_H_

#include <bit>
#include <cstdint>
#include <string_view>

namespace rasterproof::baseline {

/// What was added so far, in 64 bits. Not for adversaries.
class Digest {
 public:
  Digest& Word(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x9fb21c651e98df25U;
    state_ ^= state_ >> 32;
    return *this;
  }
  Digest& Integer(std::int64_t value) { return Word(static_cast<std::uint64_t>(value)); }
  /// By its bits: -0 is not +0, and NaN is a value like any other.
  Digest& Number(double value) { return Word(std::bit_cast<std::uint64_t>(value)); }
  Digest& Text(std::string_view text) {
    Word(text.size());
    for (const char letter : text) Word(static_cast<unsigned char>(letter));
    return *this;
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0x2545f4914f6cdd1dU;
};

/// So many things in a row, and their digest.
struct Stream {
  std::uint64_t count = 0;
  Digest digest;

  /// Counts one more, whose content is then added to what comes back.
  Digest& Next() {
    ++count;
    return digest;
  }
};

}  // namespace rasterproof::baseline

#endif  // RASTERPROOF_TESTS_BASELINE_DIGEST_H_
