#include "report/pixel_state.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "report/explanation_numbers.h"

namespace rasterproof::report {
namespace {

// The part [first, last) of [0, size) to show.
void Cut(int& first, int& last, int size, int focus, int side) {
  first = std::clamp(first, 0, size);
  last = std::clamp(last, 0, size);
  if (first >= last) {
    first = 0;
    last = size;
  }
  if (last - first <= side) return;
  const int middle = focus >= first && focus < last ? focus : first + side / 2;
  first = std::clamp(middle - side / 2, first, last - side);
  last = first + side;
}

}  // namespace

SampleState StateOf(const CoverageCounts& observed, const CoverageCounts& expected,
                    std::size_t index) {
  const std::uint64_t have = std::uint64_t{observed.front[index]} + observed.back[index];
  const std::uint64_t want = std::uint64_t{expected.front[index]} + expected.back[index];
  if (have < want) return SampleState::kMissing;
  if (have > want) return SampleState::kUnexpected;
  return observed.front[index] == expected.front[index] ? SampleState::kRight
                                                        : SampleState::kFacing;
}

Colour CountColour(std::uint64_t count) {
  switch (count) {
    case 0:
      return kUncovered;
    case 1:
      return kCovered;
    case 2:
      return kCoveredTwice;
    default:
      return kCoveredMore;
  }
}

Colour StateColour(SampleState state, std::uint64_t expected) {
  switch (state) {
    case SampleState::kRight:
      return expected == 0 ? kUncovered : Colour{232, 235, 239};
    case SampleState::kMissing:
      return kVermilion;
    case SampleState::kUnexpected:
      return kBlue;
    case SampleState::kFacing:
      return kPurple;
  }
  return kPaper;
}

Pixel PixelAt(const CoverageCounts& observed, const CoverageCounts& expected, int x, int y) {
  Pixel pixel;
  for (int s = 0; s < expected.samples; ++s) {
    const std::size_t index = expected.Index(x, y, s);
    pixel.expected += std::uint64_t{expected.front[index]} + expected.back[index];
    pixel.observed += std::uint64_t{observed.front[index]} + observed.back[index];
    if (pixel.state == SampleState::kRight) pixel.state = StateOf(observed, expected, index);
  }
  return pixel;
}

std::span<const std::string_view> PanelTitles(const Explanation& explanation) {
  static constexpr std::array<std::string_view, 3> kThree{"expected", "actual", "difference"};
  static constexpr std::array<std::string_view, 3> kOfNumbers{"exact", "shown", "difference"};
  static constexpr std::array<std::string_view, 1> kOne{"coverage, as expected"};
  if (HasNumbers(explanation)) return kOfNumbers;
  if (Compare(explanation.observed, explanation.expected).wrong == 0) return kOne;
  return kThree;
}

PixelRect ReadableView(const Explanation& explanation, int side) {
  PixelRect view = explanation.view;
  Cut(view.x0, view.x1, explanation.expected.width, explanation.focus_x, side);
  Cut(view.y0, view.y1, explanation.expected.height, explanation.focus_y, side);
  return view;
}

}  // namespace rasterproof::report
