// Pictures of pixels: what explain, coverage --png and legal --decided --png show.
#ifndef RASTERPROOF_REPORT_PICTURE_H_
#define RASTERPROOF_REPORT_PICTURE_H_

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/compared_numbers.h"
#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/fragments.h"
#include "core/profile.h"
#include "core/sample_pattern.h"
#include "core/scene.h"
#include "io/image.h"
#include "report/palette.h"

namespace rasterproof::report {

/// What explain knows of a failing place. Exact numbers come as text: report computes nothing.
struct Explanation {
  Scene scene;  ///< window space (snapped, if the profile snaps), or homogeneous
  CoverageCounts expected;
  CoverageCounts observed;
  PixelRect view;    ///< the pixels to show
  int focus_x = -1;  ///< the pixel in question: the failing one, or one that was chosen
  int focus_y = -1;
  std::vector<int> triangles;  ///< the triangles that matter there
  /// Lines such as "triangle 0, edge v2-v0: E = -3/65536".
  std::vector<std::string> edge_values;
  std::string headline;
  std::string replay;  ///< the command that shows this again
  /// Where the samples lie. Dots are left out if it has another number of them than the counts.
  SamplePattern pattern;
  YAxis y_axis = YAxis::kDown;
  /// Numbers beside coverage, if one of them failed: the panels then show these.
  std::shared_ptr<const ComparedNumbers> numbers = nullptr;
};

/// The pixel grid in characters: expected, actual and difference of coverage, or of numbers, side
/// by side, with a legend.
/// Colour only if asked.
///
/// Domain:     counts of one shape. A view that is empty or beyond what can be read is moved to the
///             focus and cut; with several samples to a pixel the counts are sums over them.
std::string ExplanationToText(const Explanation& explanation, bool colour);
/// The grid with the exact triangles over it: expected, actual, difference as three panels.
std::string ExplanationToSvg(const Explanation& explanation);
io::Image ExplanationToImage(const Explanation& explanation);

/// Paints the nearest triangle at each pixel, one colour for each triangle, paper where there is
/// none.
io::Image PaintFlat(const FragmentBuffers& fragments);
/// The three vertices in vermilion, green and blue, mixed by the barycentrics; grey where they are
/// NaN.
io::Image PaintBarycentrics(const FragmentBuffers& fragments);
/// Near is light, far is dark, over the range of finite depths in the picture.
io::Image PaintDepth(const FragmentBuffers& fragments);
/// Lines of the given width along the edges, hidden ones hidden.
///
/// Units:      pixels.
io::Image PaintWireframe(const FragmentBuffers& fragments, double width_pixels);
/// 0 white, 1 grey, more than one in a growing scale of red; sample 0.
io::Image PaintCounts(const CoverageCounts& counts);
/// Right samples muted, missing and unexpected ones in two loud colours.
io::Image PaintDifference(const CoverageCounts& observed, const CoverageCounts& expected);

/// The part `view` of an image of the scene's target with each pixel as a square of `scale` pixels;
/// from 4 on with the edges of the scene's triangles, from 8 on with pixel borders, from 16 on with
/// pixel centres.
///
/// Domain:     the view lies within the image; scale at least 1. Edges with a vertex that is not
///             finite or not in front of the eye are left out.
io::Image Enlarged(const io::Image& image, const Scene& scene, PixelRect view, int scale,
                   YAxis y_axis);

struct LegendEntry {
  Colour colour;
  std::string_view words;
};
/// Returns a picture of the pixels of a view, each a square of `scale` pixels, with column numbers
/// above, row numbers to the left, as many as there is room for, and the legend below.
///
/// Domain:     as Enlarged() returned it for the view and the scale.
io::Image Labelled(const io::Image& pixels, PixelRect view, int scale,
                   std::span<const LegendEntry> legend);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_PICTURE_H_
