// Which triangles a legal choice can turn, flatten or drop, and which samples that concerns.
#ifndef RASTERPROOF_PROPS_JUDGING_FREEDOM_FREE_CHOICES_H_
#define RASTERPROOF_PROPS_JUDGING_FREEDOM_FREE_CHOICES_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/scene.h"
#include "core/vertex.h"
#include "legal/clipped_triangle.h"
#include "props/judging/gate.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// The rectangle of the window in which all legal models of a profile put a vertex.
struct LegalPlaces {
  Point2 low;
  Point2 high;
};

/// The corners of the rectangle, each once.
std::vector<Point2> CornersOf(const LegalPlaces& places);

/// The sign of the area of every triangle with a vertex in each list, or nothing if two differ in
/// it. Affine in each of six coordinates, the area over rectangles has its extremes at corners.
std::optional<int> FacingOfAll(std::span<const Point2> a, std::span<const Point2> b,
                               std::span<const Point2> c);
inline std::optional<int> FacingOfAll(const std::array<LegalPlaces, 3>& places) {
  return FacingOfAll(CornersOf(places[0]), CornersOf(places[1]), CornersOf(places[2]));
}

/// The samples that legal models decide differently because they clip triangles.
class ClippedEdges {
 public:
  /// None.
  ClippedEdges() = default;
  /// Domain:     window space. Elsewhere, and where vertices that clipping makes do not move
  ///             (MovesClippedEdges is false), there are none.
  explicit ClippedEdges(const PlacedCase& c);

  bool MayDecide(Point2 p) const {
    return std::ranges::any_of(triangles_, [&](const auto& t) { return t.MayDecide(p); });
  }
  bool IsEmpty() const { return triangles_.empty(); }

 private:
  std::vector<legal::ClippedTriangle> triangles_;
};

/// The triangles of a case that legal models draw with more than one facing, or that some drop and
/// others don't.
///
/// Legal models: a vertex takes any grid point that the profile's tolerance allows, each position
/// one. Watertight and closed subjects: any point within a step of the grid that the profile
/// states, or within a pixel on each axis where it states none. A triangle that the subject may
/// clip: a pixel further. A triangle that is not open has one facing in every legal model: the area
/// is affine in each coordinate, so that its exact signs at the rectangles' corners bound it.
class OpenTriangles {
 public:
  /// Makes an empty set: no triangle is open.
  OpenTriangles() = default;
  /// Domain:     a case as properties see it; window space, or clip space without a transform.
  explicit OpenTriangles(const PlacedCase& c);

  /// Returns whether two of the other triangles face opposite ways.
  bool RestIsFolded() const { return front_ && back_; }
  /// Returns whether an open triangle can cover the place in some legal model.
  bool CanCover(Point2 p) const;
  bool IsEmpty() const { return open_.empty(); }
  std::size_t size() const { return open_.size(); }
  /// From now on only triangles that some legal models drop count as open.
  void ForgetTurned();
  /// The farthest that a legal model puts a vertex from where it is given, in pixels.
  double MostMoved() const { return most_moved_; }

 private:
  struct Open {
    bool is_dropped = false;  ///< by some legal models
    bool has_place = true;    ///< if not, it can lie anywhere
    std::array<Point2, 3> at{};
    double reach = 0;
  };

  bool front_ = false;
  bool back_ = false;
  double most_moved_ = 0;
  std::vector<Open> open_;
};

/// The places where legal models put each corner of a triangle, including the whole pixels by which
/// a watertight subject's grid may be shifted.
///
/// Returns:    nothing if some legal model puts one outside the guard-band rectangle, and may move
///             its edges.
/// Domain:     a window-space case; finite corners.
std::optional<std::array<LegalPlaces, 3>> LegalPlacesOf(const PlacedCase& c, const Triangle& t);

/// Returns whether every legal model puts the corners of a triangle where they are given.
///
/// Domain:     as LegalPlacesOf().
bool StaysWhereGiven(const PlacedCase& c, const Triangle& t);

/// Returns whether the subject itself reports the facing of a triangle, so that it is not computed
/// from the canonical model.
bool TellsFacings(const Description& subject);

/// The window-space scene with its coordinates wrapped but not snapped; triangles that every legal
/// model drops for their extent or culls have their corners in one place. Vertices in one place
/// here are in one place in every legal model; others may be too.
Scene UnsnappedScene(const PlacedCase& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FREEDOM_FREE_CHOICES_H_
