#include "core/sample_pattern.h"

#include <span>
#include <utility>

namespace rasterproof {
namespace {

// In sixteenths of a pixel, from its corner of least x and y.
using Place = std::pair<int, int>;
constexpr Place kOne[]{{8, 8}};
constexpr Place kTwo[]{{12, 12}, {4, 4}};
constexpr Place kFour[]{{6, 2}, {14, 6}, {2, 10}, {10, 14}};
constexpr Place kEight[]{{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}};
constexpr Place kSixteen[]{{9, 9},  {7, 5}, {5, 10}, {12, 7}, {3, 6}, {10, 13}, {13, 11}, {11, 3},
                           {6, 14}, {8, 1}, {4, 2},  {2, 12}, {0, 8}, {15, 4},  {14, 15}, {1, 0}};

std::span<const Place> PlacesOf(int samples) {
  switch (samples) {
    case 1:
      return kOne;
    case 2:
      return kTwo;
    case 4:
      return kFour;
    case 8:
      return kEight;
    case 16:
      return kSixteen;
    default:
      return {};
  }
}

}  // namespace

std::optional<SamplePattern> StandardPattern(int samples) {
  const std::span<const Place> places = PlacesOf(samples);
  if (places.empty()) return std::nullopt;
  SamplePattern pattern;
  pattern.locations.clear();
  for (const auto& [x, y] : places) pattern.locations.push_back({x / 16.0, y / 16.0});
  return pattern;
}

}  // namespace rasterproof
