// A fuzz target in one statement.
#ifndef RASTERPROOF_FUZZ_TARGET_MACRO_H_
#define RASTERPROOF_FUZZ_TARGET_MACRO_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/fuzz_target.h"

/// Defines the target that calls `look(bound, bytes)` with rows of {subject, property} bound once:
///
///     RASTERPROOF_FUZZ_LOOK(ScreenCoverage, Limits{}, {"spans-exact", "CoverageEqualsTheModel"})
#define RASTERPROOF_FUZZ_LOOK(look, limits, ...)                                            \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {       \
    using namespace rasterproof::fuzz; /* NOLINT: names of the statement's own arguments */ \
    static const Bound bound(std::to_array<Checked>({__VA_ARGS__}), limits);                \
    return look(bound, std::span(data, size));                                              \
  }

namespace rasterproof::fuzz {

/// The plain way to look: every property, as `rasterproof check` judges it.
inline int LookAtProperties(const Bound& bound, std::span<const std::uint8_t> bytes) {
  return bound.PutToTheTest(bytes);
}

/// For properties that cost much: one of them, chosen by the bytes.
inline int LookAtOneProperty(const Bound& bound, std::span<const std::uint8_t> bytes) {
  return bound.PutOneToTheTest(bytes);
}

}  // namespace rasterproof::fuzz

#endif  // RASTERPROOF_FUZZ_TARGET_MACRO_H_
