// What the four fuzz targets share: bytes to a case, the case to a property, a failed property to a
// report and a trap.
#ifndef RASTERPROOF_FUZZ_FUZZ_TARGET_H_
#define RASTERPROOF_FUZZ_FUZZ_TARGET_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace rasterproof::fuzz {

/// A property that must hold of a subject on every input.
struct Checked {
  std::string_view subject;
  std::string_view property;
};

/// Puts every property to the test, each on the case that the bytes stand for with its subject: its
/// input lattice and profile are part of what they mean.
///
/// Domain:     any bytes; the decoder is total.
/// Error:      a violated property prints the command that makes a case file of the input, and
/// aborts.
void PutToTheTest(std::span<const Checked> all, std::span<const std::uint8_t> bytes);

/// Prints what failed and aborts, for checks that are not in the catalogue.
[[noreturn]] void Fail(std::string_view what, std::span<const std::uint8_t> bytes);

}  // namespace rasterproof::fuzz

/// The entry that libFuzzer, AFL++'s driver and fuzz/replay_main.cc call.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

#endif  // RASTERPROOF_FUZZ_FUZZ_TARGET_H_
