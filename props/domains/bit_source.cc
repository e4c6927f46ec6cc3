#include "props/domains/bit_source.h"

#include <Random123/philox.h>

#include <algorithm>
#include <bit>
#include <cstdint>

namespace rasterproof::props {
namespace {

__extension__ using UInt128 = unsigned __int128;

// Extra bits in a draw by multiplication: with n choices and 8 bits more than n needs, no choice is
// more than 2^-8 likelier than another, and a fuzzer spends at most two bytes on a small choice.
constexpr int kSpareBits = 8;

}  // namespace

std::int64_t BitSource::Int(std::int64_t low, std::int64_t high) {
  const std::uint64_t choices =
      static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
  if (choices == 1) return low;
  const auto needed = choices == 0 ? 64 : static_cast<int>(std::bit_width(choices - 1));
  const int count = std::min(64, std::has_single_bit(choices) ? needed : needed + kSpareBits);
  const std::uint64_t bits = Bits(count);
  if (choices == 0) return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + bits);
  const auto chosen = static_cast<std::uint64_t>((UInt128{bits} * choices) >> count);
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + chosen);
}

std::uint64_t PhiloxSource::Bits(int count) {
  if (unused_words_ == 0) {
    const r123::Philox4x64::ctr_type counter{{index_, block_++, stream_, 0}};
    const r123::Philox4x64::key_type key{{seed_, 0}};
    const r123::Philox4x64::ctr_type random = r123::Philox4x64()(counter, key);
    std::copy(random.begin(), random.end(), words_);
    unused_words_ = 4;
  }
  return words_[--unused_words_] >> (64 - count);
}

std::uint64_t ByteSource::Bits(int count) {
  std::uint64_t bits = 0;
  for (int shift = 0; shift < count && next_ < bytes_.size(); shift += 8) {
    bits |= std::uint64_t{bytes_[next_++]} << shift;
  }
  return count == 64 ? bits : bits & ((std::uint64_t{1} << count) - 1);
}

}  // namespace rasterproof::props
