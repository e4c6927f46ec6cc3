// The sound base of rasterizers that cover whole pixels: by exact signs at a square's four corners.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_SQUARES_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_SQUARES_H_

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "core/profile.h"
#include "core/snap.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/vertex.h"

namespace rasterproof::subjects::mutants {

/// Which contact between a square and a triangle counts: a square that only touches the triangle
/// meets it, one that touches an edge from within lies in it.
enum class Contact : std::uint8_t {
  kAny,
  kFloor,    ///< contact at the square's floor corner, or along a floor side
  kCeiling,  ///< at the other end
  kNone
};

/// A pixel's square, grown, in the profile's own axes, and the triangle that is asked about.
struct SquareQuestion {
  std::array<Point2, 3> v;
  Point2 low;
  Point2 high;
};

/// The square's corners, the floor corner first and the ceiling corner last.
inline std::array<Point2, 4> CornersOf(const SquareQuestion& q) {
  return {q.low, Point2{q.high.x, q.low.y}, Point2{q.low.x, q.high.y}, q.high};
}

/// What the subject states and what it draws.
struct SquareStages {
  Profile profile = {};
  bool holds = false;               ///< the squares within the triangle, not those that meet it
  Contact contact = Contact::kAny;  ///< of triangles with area
  Contact flat_contact = Contact::kAny;  ///< of flat ones
  double half_width = 0;
  /// Where it places vertices; none: where they are given.
  Snap placing = {};
  bool draws_flat = true;
  CoverageKind coverage = CoverageKind::kCounts;
  /// Planted: triangles, as placed, that are not drawn.
  std::function<bool(const std::array<Point2, 3>& v)> drops = {};
  /// Planted: what is said in place of the sound answer.
  std::function<bool(const SquareQuestion& question, bool sound)> instead = {};
};

/// Domain:     float32 scenes in window space.
std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const SquareStages& stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_SQUARES_H_
