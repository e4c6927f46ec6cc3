// The sound base of most mutants: a fixed-point rasterizer, with every stage open to a change.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_FIXED_POINT_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_FIXED_POINT_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/drawing.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject.h"

namespace rasterproof::subjects::mutants {

/// A place in steps of the grid that holds the vertices and the samples: 1/256 pixel, or finer.
/// Screen axes: x right, y down, whatever the profile's y axis.
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// A directed edge of a triangle of positive area: the inner side is the positive one.
struct GridEdge {
  GridPoint a;
  GridPoint b;
  bool owns = false;  ///< whether a sample exactly on it is inside

  /// The edge's value at p, or what 64 bits hold that is nearest to it.
  ///
  /// Domain:     coordinates below 2^61.
  std::int64_t At(GridPoint p) const {
    __extension__ using Wide = __int128;
    const Wide value = Wide{p.x - a.x} * (b.y - a.y) - Wide{p.y - a.y} * (b.x - a.x);
    constexpr Wide kLeast = std::numeric_limits<std::int64_t>::min();
    constexpr Wide kMost = std::numeric_limits<std::int64_t>::max();
    return static_cast<std::int64_t>(std::clamp(value, kLeast, kMost));
  }
};

/// A triangle after snapping, turned over if its area was negative.
struct GridTriangle {
  std::size_t number = 0;  ///< its place in the scene's list
  Triangle indices{};
  std::array<GridPoint, 3> v;
  bool front = true;
  std::array<GridEdge, 3> edges;  ///< edge i is opposite vertex i
};

/// One sample of the target.
struct Sample {
  int x = 0;
  int row = 0;
  int s = 0;
  GridPoint at;
  // of the target, in pixels
  int width = 0;
  int height = 0;
};

/// An edge's values at the outermost samples of a tile: top left, top right, bottom left, bottom
/// right.
using TileCorners = std::array<std::int64_t, 4>;
enum class TileTest : std::uint8_t { kOutside, kInside, kMixed };

/// Eight subpixel bits, nearest-even, top-left, up to 2^15 pixels: the model of the API presets,
/// and a triangle that is not finite covers nothing.
Profile FixedPointProfile();

/// The stages of the rasterizer, in their order. An empty function leaves its stage sound; a mutant
/// fills in one or two.
struct FixedStages {
  /// What the subject states, and what the sound stages do.
  Profile profile = FixedPointProfile();
  int tile = 8;  ///< where the options leave it to the subject
  int bits = 8;  ///< of the grid that holds vertices and samples, if the profile's are fewer

  std::function<void(DrawOptions&, const Scene&)> options = {};
  std::function<Profile(const Profile&, const Scene&)> target_model = {};
  std::function<bool(const Scene&, std::size_t number)> drops = {};
  std::function<void(std::array<Vertex, 3>&)> vertices = {};
  /// From a coordinate's integer, in units of its fixed-point input, to the one that is used.
  std::function<std::int64_t(std::int64_t raw)> wrap = {};
  std::function<double(double x, bool along_y)> snap = {};
  std::function<void(GridPoint&)> place = {};
  /// Returns whether a triangle of this width and height, in steps of the grid, is dropped.
  std::function<bool(std::int64_t width, std::int64_t height)> too_large = {};
  std::function<std::int64_t(const std::array<GridPoint, 3>&)> area = {};
  bool draws_flat = false;  ///< a triangle without area covers the samples on it
  std::function<void(GridTriangle&)> facing = {};
  std::function<void(GridTriangle&)> edges = {};
  std::function<void(PixelRect&, const GridTriangle&, const Scene&)> box = {};
  std::function<void(int& begin, int& end, int worker, int workers)> share = {};
  std::function<TileTest(const std::array<TileCorners, 3>&, TileTest sound)> tile_test = {};
  // With one of the next two every sample of the box is tested, and no tile.
  std::function<GridPoint(const Sample&)> sample = {};
  std::function<std::int64_t(const GridEdge&, const Sample&)> value = {};
  std::function<bool(const GridEdge&, const GridTriangle&, const Sample&)> owns = {};
  std::function<std::uint32_t(const Sample&, const GridTriangle&)> times = {};
  std::function<std::size_t(const CoverageCounts&, const Sample&)> index = {};
  std::function<void(CoverageCounts&, const CoverageCounts& before)> after = {};
  /// By what images of whole draws are kept and found again, beside target, culling and scissor;
  /// each subject keeps its own. Empty: none is kept.
  std::function<std::vector<std::int64_t>(const Scene&)> kept_by = {};
  /// If set, the subject takes batches, and this changes the answers to one of several scenes.
  std::function<void(std::vector<DrawOutcome>&)> batch = {};
};

/// The rasterizer with the given stages.
///
/// Wraps and snaps, drops what is too large and zero areas, culls, walks the tiles of the box,
/// rejects and accepts tiles by their corners, and tests the samples of the others with integer
/// edge functions. The rows are shared out among DrawOptions::threads workers, who take turns on
/// one thread.
///
/// Domain:     float32 scenes in window space. A triangle that is not finite or leaves twice the
///             profile's limit is not drawn. 2 limit 2^bits <= 2^60; edge values are held to 64
///             bits, which is all of them while 2 limit 2^bits <= 2^30.
std::unique_ptr<Subject> MakeFixedPoint(const std::string& name, const std::string& summary,
                                        FixedStages stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_FIXED_POINT_H_
