#include "subjects/mutants/placing.h"

#include <cmath>
#include <cstdint>

namespace rasterproof::subjects::mutants {
namespace {

// Finer than half a step of the finest grid, by one bit and more.
constexpr int kFineBits = 21;

// x in units of 2^-21. The last bit says that something is lost: no place that a rule looks at, a
// multiple of half a step, lies between x and that unit.
std::int64_t FineUnits(double x) {
  const double units = std::ldexp(x, kFineBits - 1);
  const double whole = std::floor(units);
  return 2 * static_cast<std::int64_t>(whole) + (whole == units ? 0 : 1);
}

// n units rounded to a multiple of 2^dropped, in units of that.
std::int64_t Rounded(std::int64_t n, int dropped, SnapRule rule) {
  const std::int64_t down = n >> dropped;
  const std::int64_t rest = n - (down << dropped);
  const std::int64_t half = std::int64_t{1} << (dropped - 1);
  switch (rule) {
    case SnapRule::kNearestEven:
      return down + (rest > half || (rest == half && down % 2 != 0) ? 1 : 0);
    case SnapRule::kNearestAway:
      return down + (rest > half || (rest == half && n > 0) ? 1 : 0);
    case SnapRule::kHalfUp:
      return down + (rest >= half ? 1 : 0);
    case SnapRule::kFloor:
      return down;
    case SnapRule::kTruncate:
      return down + (n < 0 && rest != 0 ? 1 : 0);
  }
  return down;
}

std::int64_t UnitsToRound(double x, const Snap& snap) {
  switch (snap.form) {
    case SnapForm::kCoordinate:
      break;
    case SnapForm::kExactDifference:
      return FineUnits(x) - FineUnits(snap.origin);
    case SnapForm::kFloat32Difference:
      return FineUnits(static_cast<float>(x) - static_cast<float>(snap.origin));
  }
  return FineUnits(x);
}

}  // namespace

double SnapToGrid(double x, const Snap& snap) {
  if (snap.IsNone() || !(std::fabs(x) < 0x1p41)) return x;
  const std::int64_t steps = Rounded(UnitsToRound(x, snap), kFineBits - snap.bits, snap.rule);
  const double origin = snap.form == SnapForm::kCoordinate ? 0 : snap.origin;
  return origin + std::ldexp(static_cast<double>(steps), -snap.bits);
}

Profile ModelOn(const Profile& profile, int width, int height) {
  Profile model = profile;
  for (const TargetModel& entry : profile.by_target_size) {
    if (width > entry.max_width || height > entry.max_height) continue;
    model.snap = entry.snap;
    model.pattern = entry.pattern;
    model.tie_rule = entry.tie_rule;
    break;
  }
  return model;
}

Profile ModelOn(const Profile& profile, const Scene& scene) {
  return ModelOn(profile, scene.width, scene.height);
}

}  // namespace rasterproof::subjects::mutants
