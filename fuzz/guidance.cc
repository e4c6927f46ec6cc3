#include "fuzz/guidance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace rasterproof::fuzz {
namespace {

constexpr std::size_t kRatioSteps = 128;  // eight each time that the distance from 1 halves
constexpr std::size_t kOrders = 128;      // of doubles from floats: |E| / S may be less still
constexpr std::size_t kSlotSize = kRatioSteps + kOrders;

// libFuzzer reads what lies in this section after each run and clears it before the next. Nothing
// else reads it: without `volatile` and `used` the compiler would leave it out.
[[gnu::used, gnu::section("__libfuzzer_extra_counters")]] volatile std::uint8_t
    counters[kGuidedSlots * kSlotSize];  // NOLINT(modernize-avoid-c-arrays): a section's bytes

std::array<double, kGuidedSlots> largest{};

void Take(std::size_t slot, std::size_t place) {
  counters[std::min(slot, kGuidedSlots - 1) * kSlotSize + place] = 1;
}

}  // namespace

void NoteErrorOverBound(std::size_t slot, double ratio) {
  if (!(ratio > 0)) return;
  double& most = largest[std::min(slot, kGuidedSlots - 1)];
  most = std::max(most, ratio);
  const double step = ratio < 1 ? -8 * std::log2(1 - ratio) : double{kRatioSteps};
  Take(slot, std::min(static_cast<std::size_t>(step), kRatioSteps - 1));
}

void NoteNearZero(std::size_t slot, double value, double sum_of_products) {
  if (value == 0 || !std::isfinite(value) || !std::isfinite(sum_of_products)) return;
  // A sum that underflowed to zero has the exponent -inf: it lost nothing.
  const double lost = std::logb(sum_of_products) - std::logb(value);
  Take(slot, kRatioSteps + static_cast<std::size_t>(std::clamp(lost, 0.0, kOrders - 1.0)));
}

double LargestErrorOverBound(std::size_t slot) { return largest[slot]; }

}  // namespace rasterproof::fuzz
