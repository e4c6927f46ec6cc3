// What a picture says of a pixel.
#ifndef RASTERPROOF_REPORT_PIXEL_STATE_H_
#define RASTERPROOF_REPORT_PIXEL_STATE_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "report/palette.h"
#include "report/picture.h"

namespace rasterproof::report {

enum class SampleState : std::uint8_t {
  kRight,
  kMissing,     ///< counted less often than expected
  kUnexpected,  ///< counted more often than expected
  kFacing       ///< counted as often, but facing otherwise
};

/// Domain:     counts of the same shape.
SampleState StateOf(const CoverageCounts& observed, const CoverageCounts& expected,
                    std::size_t index);

/// The colour of a count: paper, then darker with every triangle.
Colour CountColour(std::uint64_t count);
/// The loud colour of a state, or the muted one of a sample that is right.
Colour StateColour(SampleState state, std::uint64_t expected);

/// The counts of all samples of a pixel, and what is wrong with it: the first state that is not
/// kRight.
struct Pixel {
  std::uint64_t expected = 0;
  std::uint64_t observed = 0;
  SampleState state = SampleState::kRight;
};
Pixel PixelAt(const CoverageCounts& observed, const CoverageCounts& expected, int x, int y);

/// Expected, actual and difference, of numbers where there are some; one panel alone where nothing
/// differs, for then the property is of values and not of coverage.
std::span<const std::string_view> PanelTitles(const Explanation& explanation);

/// The explanation's view within its target, at most `side` pixels wide and high, with the focus in
/// it.
PixelRect ReadableView(const Explanation& explanation, int side);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_PIXEL_STATE_H_
