// The base of rasterizers that use their freedom: each vertex goes to the legal grid point that
// does most harm, and whatever is shown is shown of that.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_FREE_CHOICE_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_FREE_CHOICE_H_

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "core/profile.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/tie_rule.h"
#include "core/vertex.h"

namespace rasterproof::subjects::mutants {

/// A vertex on its way to the grid.
struct FreeCorner {
  Point2 at;  ///< in the window; of clip space its quotients
  // What only an illegal choice looks at.
  std::array<Point2, 3> triangle;  ///< all three of its triangle's corners
  bool is_turned = false;          ///< the triangle, by the legal choice of its corners, or flat
};

/// The rasterizer's free choices, and how it reports them.
struct FreeStages {
  Profile profile;
  /// The grid that it does use, and how many steps of it a vertex may be off on each axis.
  int bits = 8;
  double tolerance = 0;
  /// How much harm a grid point does: the legal one that does most is taken. A function of the
  /// position alone.
  std::function<double(Point2 at, Point2 grid_point)> harm = {};
  CoverageKind coverage = CoverageKind::kFacingCounts;
  bool takes_clip = false;
  /// The tie rule that it does use; empty: the profile's.
  std::function<TieRule(const std::array<Point2, 3>& triangle)> rule = {};
  /// A planted bug: where the vertex goes instead of where `harm` says.
  std::function<Point2(const FreeCorner& corner, Point2 legal)> instead = {};
  /// A planted bug: the primitive id that is shown for triangle `number` of `count`.
  std::function<std::size_t(std::size_t number, std::size_t count)> id = {};
};

/// Domain:     float32 scenes in window space, or in clip space in front of the eye.
std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const FreeStages& stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_FREE_CHOICE_H_
