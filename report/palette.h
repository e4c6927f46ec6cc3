// The colours of every picture and page, which eyes of any kind distinguish.
#ifndef RASTERPROOF_REPORT_PALETTE_H_
#define RASTERPROOF_REPORT_PALETTE_H_

#include <array>
#include <cstdint>

namespace rasterproof::report {

using Colour = std::array<std::uint8_t, 3>;

// Source: Okabe and Ito, "Color Universal Design" (2008). Loud colours mean one thing everywhere.
inline constexpr Colour kVermilion{213, 94, 0};        // a missing sample
inline constexpr Colour kBlue{0, 114, 178};            // an unexpected one
inline constexpr Colour kPurple{204, 121, 167};        // the right count, the wrong facing
inline constexpr Colour kGreen{0, 158, 115};           // a property that holds
inline constexpr Colour kYellow{240, 228, 66};         // the place that matters
inline constexpr Colour kInk{34, 38, 46};              // text, edges of triangles
inline constexpr Colour kFaintInk{118, 126, 138};      // labels
inline constexpr Colour kGrid{214, 218, 224};          // pixel borders
inline constexpr Colour kPaper{255, 255, 255};         // behind everything
inline constexpr Colour kUncovered{250, 250, 251};     // count 0
inline constexpr Colour kCovered{205, 216, 228};       // count 1
inline constexpr Colour kCoveredTwice{140, 162, 188};  // count 2
inline constexpr Colour kCoveredMore{84, 106, 136};    // count 3 and more

/// a at t = 0, b at t = 1.
Colour Mix(Colour a, Colour b, double t);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_PALETTE_H_
