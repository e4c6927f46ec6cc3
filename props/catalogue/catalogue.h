// The catalogue of stiff and extreme cases: how a subject fares on each family of them.
#ifndef RASTERPROOF_PROPS_CATALOGUE_CATALOGUE_H_
#define RASTERPROOF_PROPS_CATALOGUE_CATALOGUE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "core/profile.h"
#include "core/subject.h"
#include "props/domains/domain.h"
#include "props/domains/worlds.h"

namespace rasterproof::props {

/// Families that are hard for the same reason, and what a right rasterizer does on all of them.
struct Theme {
  std::string_view name;
  std::string_view right;  ///< a sentence
};

/// A row of the catalogue: a domain, or a small world, every case of which is drawn.
struct Family {
  std::string_view name;
  std::string_view summary;  ///< what is hard about it, one line
  const Theme* theme = nullptr;
  const Domain* domain = nullptr;
  const World* world = nullptr;  ///< exactly one of the two is set
};

/// Every domain and every world, by theme.
std::vector<Family> Catalogue();

/// What drawings are compared with.
enum class Yardstick : std::uint8_t {
  kOwnModel,     ///< the profile that the subject is judged by: snapped, wrapped, within its limits
  kRealGeometry  ///< the vertices as given, with the subject's sample locations
};
inline constexpr std::array<std::string_view, 2> kYardstickNames{"own model", "real geometry"};

/// How a subject fares on a family by one yardstick.
struct FamilyCell {
  std::uint64_t cases = 0;  ///< compared
  std::uint64_t wrong = 0;  ///< cases with a sample that the yardstick counts otherwise
  std::uint64_t samples = 0;
  std::uint64_t wrong_samples = 0;
  /// How far the sample furthest off lies from the nearest edge of its scene, in pixels: what
  /// some edge was at least displaced by. Of a case the first 64 wrong samples are measured.
  /// Infinite where the subject broke down.
  double worst_pixels = 0;
  /// The case of that sample, with its name as origin.
  std::optional<Case> worst;
  std::uint64_t excused = 0;  ///< cases that the yardstick or the subject says nothing of
  std::string why;            ///< of the first of these, or how the subject broke down
  bool is_exhausted = false;  ///< every case of a world was compared

  bool Fails() const { return wrong != 0; }
};

struct FamilyResult {
  std::string_view family;
  std::array<FamilyCell, kYardstickNames.size()> cells;  ///< by Yardstick
  double seconds = 0;

  const FamilyCell& By(Yardstick yardstick) const {
    return cells[static_cast<std::size_t>(yardstick)];
  }
};

struct CataloguePlan {
  std::uint64_t seed = 1;
  /// Of each domain. A world has its own number; one of more than 100 times this is excused.
  std::uint64_t cases = 100;
  double seconds = 0;  ///< at most, for a family; 0: no limit
  /// Worlds of larger targets are left out.
  std::int64_t most_pixels = std::numeric_limits<std::int64_t>::max();
  /// Asked between cases: true ends the measurement. May be empty.
  std::function<bool()> stop = {};
};

/// The geometry as given, with the sample locations and the y axis of the profile, and its tie rule
/// where that is one-sided.
Profile RealProfileOf(const Profile& own);

/// Draws the first cases of the family, named FAMILY:INDEX@SEED, without culling or scissor, and
/// compares each with both yardsticks. Gives up after four cases that end the subject. A cell in
/// which no case fails is excused if more than twenty of its cases are for each that is not.
///
/// Domain:     a subject whose profile is about samples, not squares.
FamilyResult MeasureFamily(Subject& subject, const Family& family, const CataloguePlan& plan);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOGUE_CATALOGUE_H_
