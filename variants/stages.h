// The stages of a rasterizer, each open to a change: planted bugs, legal variants and suspects of
// causes are rows that fill in one or two.
#ifndef RASTERPROOF_VARIANTS_STAGES_H_
#define RASTERPROOF_VARIANTS_STAGES_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/drawing.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/tie_rule.h"
#include "core/vertex.h"
#include "variants/points.h"

namespace rasterproof::variants {

/// The value of an edge at a point, or another number of its sign.
template <class Point>
using ValueOf = typename Lattice<Point>::Value;

/// A directed edge of a triangle of positive area: the inner side is the positive one.
template <class Point>
struct Edge {
  Point a = {};
  Point b = {};
  bool owns = false;  ///< whether a sample exactly on it is inside
  int opposite = 0;   ///< the vertex that it does not touch

  std::int64_t At(const GridPoint& p) const { return EdgeValue(a, b, p); }
};

/// A triangle as placed. When its facing is known it is turned over if it is a back face, so that
/// its inner side is the positive one.
template <class Point>
struct Placed {
  std::size_t number = 0;  ///< its place in the scene's list
  std::array<Vertex, 3> given = {};
  Triangle indices = {};
  std::array<Point, 3> v = {};
  bool front = true;
  bool is_turned = false;                 ///< vertices 1 and 2 are exchanged
  std::array<Edge<Point>, 3> edges = {};  ///< edge i is opposite vertex i

  /// What belongs to its vertices, in the order in which the scene lists them.
  template <class Number>
  std::array<Number, 3> AsListed(std::array<Number, 3> of_vertices) const {
    if (is_turned) std::swap(of_vertices[1], of_vertices[2]);
    return of_vertices;
  }
};

/// Whether a sample exactly on the edge is inside: it moves by (+-e, +-e^2), or by (+-e^2, +-e),
/// to one side.
template <class Point>
bool Owns(const Edge<Point>& edge, const TieRule& rule) {
  if (!rule.IsConsistent()) return rule.inclusive;
  const auto compare = [](auto a, auto b) { return (a > b) - (a < b); };
  const int along_x = rule.sign_x * compare(edge.b.y, edge.a.y);
  const int along_y = rule.sign_y * compare(edge.a.x, edge.b.x);
  const int first = rule.y_first ? along_y : along_x;
  return (first != 0 ? first : rule.y_first ? along_x : along_y) > 0;
}

/// One sample of the target, in axes of the screen: x right, y down, also where y is up.
template <class Point>
struct Sample {
  int x = 0;
  int row = 0;  ///< from the top
  int s = 0;    ///< its number in the pixel
  Point at = {};
  // of the target, in pixels
  int width = 0;
  int height = 0;
};

/// A triangle of clip space.
using ClipTriangle = std::array<Vertex, 3>;

enum class TileTest : std::uint8_t { kOutside, kInside, kMixed };

/// Of a triangle's vertices at a sample, as the scene lists them.
using Weights = std::array<double, 3>;

/// The stages, roughly in their order (`scene` goes before `options`). An empty function leaves its
/// stage sound. A scene of clip space with w other than 1 has only model, options, clip, turns_over
/// and after: the others are not asked.
template <class Point>
struct Stages {
  using Edge = variants::Edge<Point>;
  using Placed = variants::Placed<Point>;
  using Sample = variants::Sample<Point>;
  using Value = ValueOf<Point>;
  /// An edge's values at the outermost samples of a tile: top left, top right, bottom left, bottom
  /// right.
  using TileCorners = std::array<Value, 4>;

  int tile = 0;  ///< the side of its tiles where the options leave it to the subject; 0: the base's

  /// What it takes the stated profile for.
  std::function<void(Profile&, const Scene&)> model = {};
  /// The triangles of clip space that it draws in place of one: none, itself, pieces.
  std::function<std::vector<ClipTriangle>(const ClipTriangle&)> clip = {};
  /// Whether the triangle of clip space is taken for one of the other facing.
  std::function<bool(const ClipTriangle&)> turns_over = {};
  std::function<void(DrawOptions&, const Scene&)> options = {};
  /// What it takes the scene for.
  std::function<void(Scene&, const DrawOptions&)> scene = {};
  /// Whether the triangle is not even looked at.
  std::function<bool(const Scene&, std::size_t number)> drops = {};
  std::function<void(std::array<Vertex, 3>&)> vertices = {};
  /// Where fixed-point input puts a coordinate that it holds.
  std::function<double(double x)> wrap = {};
  std::function<double(double x, bool along_y)> snap = {};
  std::function<void(Point&, const Scene&)> place = {};
  /// Whether the triangle is larger than the profile's largest. Asked only where it has one.
  std::function<bool(const std::array<Point, 3>&)> too_large = {};
  /// Whether the triangle, placed and not turned over yet, is left out.
  std::function<bool(const Placed&, const Scene&)> leaves_out = {};
  /// Returns a number of the area's sign; 0: it is not drawn.
  std::function<Value(const std::array<Point, 3>&)> area = {};
  bool draws_flat = false;  ///< a triangle without area covers the samples on it
  std::function<void(Placed&)> facing = {};
  std::function<void(Placed&)> edges = {};
  std::function<void(PixelRect&, const Placed&, const Scene&)> box = {};
  std::function<void(int& begin, int& end, int worker, int workers)> share = {};
  std::function<TileTest(const std::array<TileCorners, 3>&, TileTest sound)> tile_test = {};
  // With one of the next two every sample of the box is tested, and no tile.
  std::function<Point(const Sample&)> sample = {};
  std::function<Value(const Edge&, const Sample&)> value = {};
  std::function<bool(const Edge&, const Placed&, const Sample&)> owns = {};
  /// How often the triangle counts at a sample that it covers.
  std::function<std::uint32_t(const Sample&, const Placed&)> times = {};
  std::function<std::size_t(const CoverageCounts&, const Sample&)> index = {};
  // Of fragments. Weights are screen barycentrics of the placed vertices, the value is the depth
  // that they interpolate, in the order of the vertices.
  std::function<std::size_t(std::size_t number, std::size_t count)> id = {};
  std::function<void(Weights&, const Placed&, const Sample&)> weights = {};
  std::function<void(double& depth, const Weights&, const Placed&)> depth = {};
  std::function<void(CoverageCounts&, const CoverageCounts& before)> after = {};
  /// By what images of whole draws are kept and found again, beside target, culling and scissor;
  /// each subject keeps its own. Empty: none is kept.
  std::function<std::vector<std::int64_t>(const Scene&)> kept_by = {};
  /// If set, the subject takes batches, and this changes the answers to one of several scenes.
  std::function<void(std::vector<DrawOutcome>&)> batch = {};
};

/// Both at once. Nothing if they change the same stage in two ways that exclude each other.
std::optional<Stages<Point2>> Composed(const Stages<Point2>& a, const Stages<Point2>& b);

}  // namespace rasterproof::variants

#endif  // RASTERPROOF_VARIANTS_STAGES_H_
