// One staged rasterizer with one thing changed.
#ifndef RASTERPROOF_VARIANTS_RASTERIZER_H_
#define RASTERPROOF_VARIANTS_RASTERIZER_H_

#include <array>
#include <memory>
#include <optional>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "variants/stages.h"

namespace rasterproof::variants {

/// What the rasterizer computes with where no stage does: the definitions of whoever makes it.
template <class Point>
struct Arithmetic {
  Lattice<Point> lattice = {};
  int tile = 0;          ///< the side of its tiles; 0: it has none, whatever the options say
  bool has_twin = true;  ///< a second one of it may be drawn beside it

  /// The profile with what it says of the scene's target as its own.
  Profile (*on_target)(const Profile&, const Scene&);
  double (*wrap)(double x, const FixedInput&);
  double (*snap)(double x, const Snap&);
  bool (*exceeds)(const std::array<Point, 3>&, const MaxPrimitiveExtent&, const Lattice<Point>&);
  ValueOf<Point> (*value)(Point a, Point b, Point p);
  /// The scene in the window, if the profile's transform takes it there. Null: none does.
  std::optional<Scene> (*to_window)(const Profile&, const Scene&) = nullptr;
  /// Whether the scene is drawn by stages. Null: each is.
  bool (*has_stages)(const Scene&, const Profile&) = nullptr;
  /// Why one of the others can't be drawn. Null: each can.
  std::optional<InputError> (*why_not_whole)(const Scene&, const Profile&) = nullptr;
  /// Draws the others.
  CoverageCounts (*whole)(const Scene&, const Profile&, const DrawOptions&) = nullptr;
};

/// Makes a subject that draws as the stages say and shows what `info` states. Without stages it is
/// sound.
///
/// Wraps and snaps, drops what is too large, what has no area and what the profile culls, turns
/// back faces over, walks the tiles of the box, rejects and accepts tiles by their corners, and
/// tests the samples of the others with edge values. The rows are shared out among
/// DrawOptions::threads workers, who take turns on one thread.
///
/// Domain:     scenes in window space, or taken there; of others the arithmetic draws the whole
///             scene, with the stages that have a meaning there (stages.h). A triangle that is not
///             finite is not drawn.
template <class Point>
std::unique_ptr<Subject> MakeVariant(const SubjectInfo& info, Stages<Point> stages,
                                     const Arithmetic<Point>& arithmetic);

extern template std::unique_ptr<Subject> MakeVariant(const SubjectInfo&, Stages<Point2>,
                                                     const Arithmetic<Point2>&);
extern template std::unique_ptr<Subject> MakeVariant(const SubjectInfo&, Stages<GridPoint>,
                                                     const Arithmetic<GridPoint>&);

}  // namespace rasterproof::variants

#endif  // RASTERPROOF_VARIANTS_RASTERIZER_H_
