// Bugs that show in another floating-point mode of the caller alone.
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/float_environment.h"
#include "library/exact_sign.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

int ExactSign(Point2 a, Point2 b, Point2 p) {
  const FloatEnvironment sane;
  return library::EdgeSign(a, b, p);
}

// Adding 1.5 2^44 rounds to multiples of 2^-8, as the thread rounds.
double SnapByAMagicNumber(double x, bool /*along_y*/) {
  constexpr double kMagic = 0x1.8p44;
  const volatile double sum = x + kMagic;
  return sum - kMagic;
}

RealStages MagicSnap() {
  RealStages stages = Signing(ExactSign);
  stages.profile = FixedPointProfile();
  stages.snap = SnapByAMagicNumber;
  return stages;
}

// Two vertices are equal if their differences are 0: so long as no difference is flushed to 0.
bool HasEqualVertices(const PointStages::Placed& triangle, const Scene&) {
  const Points& v = triangle.v;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2& a = v[i];
    const Point2& b = v[(i + 1) % 3];
    constexpr double kMost = 0x1p100;  // no difference overflows
    if (std::fabs(a.x) > kMost || std::fabs(a.y) > kMost) continue;
    if (std::fabs(b.x) > kMost || std::fabs(b.y) > kMost) continue;
    const float dx = static_cast<float>(b.x) - static_cast<float>(a.x);
    const float dy = static_cast<float>(b.y) - static_cast<float>(a.y);
    if (dx == 0 && dy == 0) return true;
  }
  return false;
}

// Divides before it asks whether there is anything to divide by.
int DividesByTheArea(const Points& v) {
  const auto area = static_cast<float>(ExactSign(v[0], v[1], v[2]));
  const volatile float divisor = area;
  const float reciprocal = 1 / divisor;
  return std::isinf(reciprocal) ? 0 : static_cast<int>(reciprocal);
}

RealStages NeedsSubnormals() {
  RealStages stages = Signing(ExactSign);
  stages.leaves_out = HasEqualVertices;
  return stages;
}

RealStages Traps() {
  RealStages stages = Signing(ExactSign);
  stages.area = DividesByTheArea;
  return stages;
}

std::vector<Mutant> ModeMutants() {
  return {
      {.name = "mode-magic-snap",
       .change = "it snaps by adding and subtracting a large number",
       .source = "a usual way to round, before processors had instructions for it",
       .stages = MagicSnap(),
       .causes = "float-mode",
       .killers = "EnvironmentKeepsCoverage",
       .takes_float_modes = true},
      {.name = "mode-needs-subnormals",
       .change = "vertices are equal if their differences in float32 are 0",
       .source = "libraries linked with -ffast-math flush subnormal numbers in the whole process",
       .stages = NeedsSubnormals(),
       .causes = "float-mode",
       .killers = "EnvironmentKeepsCoverage",
       .takes_float_modes = true},
      {.name = "mode-traps",
       .change = "it divides by the area of a degenerate triangle before it leaves it out",
       .source = "",
       .stages = Traps(),
       .causes = "float-mode",
       .takes_float_modes = true},
  };
}

}  // namespace

extern constinit const MutantTable kModeMutants{MutantKind::kPlanted, 25, ModeMutants};

}  // namespace rasterproof::subjects::mutants
