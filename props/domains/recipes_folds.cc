// Meshes that a legal choice of grid points folds: strips and fans of triangles about a step of the
// grid high, between others that nothing turns.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/is_stated.h"

namespace rasterproof::props {
namespace {

// Steps of the grids that a subject may have without saying so.
constexpr std::array<double, 4> kUnstatedSteps{1, 0.25, 0x1p-4, 0x1p-8};

class Folder {
 public:
  explicit Folder(CaseBuilder& builder)
      : builder_(builder),
        step_(DrawStep(builder)),
        at_(builder.Sample()),
        exchanged_(builder.bits().Chance(128)),
        mirrored_(builder.bits().Chance(128)) {}

  // So many steps and a few pixels: nothing turns that.
  double Far() { return 4 * step_ + static_cast<double>(builder_.bits().Int(2, 8)); }
  // Up to so many steps, in 64ths: half of the time next to a half.
  double Near(int steps) {
    const auto whole = static_cast<double>(builder_.bits().Int(-steps, steps - 1));
    const std::int64_t part =
        builder_.bits().Chance(128) ? builder_.bits().Int(24, 40) : builder_.bits().Int(0, 63);
    return step_ * (whole + static_cast<double>(part) / 64);
  }
  // From the sample, along the fold and across it.
  std::int32_t Add(double along, double across) {
    if (mirrored_) across = -across;
    const Point2 p{at_.x + (exchanged_ ? across : along), at_.y + (exchanged_ ? along : across)};
    return builder_.AddRaw({p.x, p.y});
  }
  void AddTriangle(std::int32_t a, std::int32_t b, std::int32_t c) {
    triangles_.push_back({a, b, c});
  }
  // Every triangle, or every one and its back.
  Case Done(bool doubled) {
    for (const Triangle& t : triangles_) {
      builder_.AddTriangle(t[0], t[1], t[2]);
      if (doubled) builder_.AddTriangle(t[0], t[2], t[1]);
    }
    return builder_.Done(Finish::kMesh);
  }
  BitSource& bits() { return builder_.bits(); }

 private:
  static double DrawStep(CaseBuilder& builder) {
    const Snap& snap = builder.profile().snap;
    return snap.IsNone() ? builder.bits().OneOf(std::span<const double>(kUnstatedSteps))
                         : std::ldexp(1.0, -snap.bits);
  }

  CaseBuilder& builder_;
  double step_;
  Point2 at_;
  bool exchanged_;
  bool mirrored_;
  std::vector<Triangle> triangles_;
};

// Three rows of quads, the middle one about a step high.
void AddStrip(Folder& folder) {
  const auto cells = static_cast<std::int32_t>(folder.bits().Int(1, 5));
  const double length = static_cast<double>(folder.bits().Int(1, 8)) / 2;
  const auto first = static_cast<double>(folder.bits().Int(0, cells));
  const double above = -folder.Far();
  const double below = folder.Far();
  for (std::int32_t i = 0; i <= cells; ++i) {
    const double along = (i - first) * length + folder.Near(1);
    const double upper = folder.Near(1);
    const double lower = upper + std::fabs(folder.Near(1));
    folder.Add(along, above);
    folder.Add(along, upper);
    folder.Add(along, lower);
    folder.Add(along, below);
  }
  for (std::int32_t i = 0; i < cells; ++i) {
    for (std::int32_t row = 0; row < 3; ++row) {
      const std::int32_t a = 4 * i + row;
      const std::int32_t b = a + 4;
      const bool falling = folder.bits().Chance(128);
      folder.AddTriangle(a, b, falling ? b + 1 : a + 1);
      folder.AddTriangle(falling ? a : b, b + 1, a + 1);
    }
  }
}

// A hub about a step off an edge of its own rim, and a triangle beyond that edge.
void AddFan(Folder& folder) {
  const double along = folder.Near(1);
  const std::int32_t hub = folder.Add(along, folder.Near(1));
  const auto rim = [&](double sign) {
    const double far = sign * folder.Far();
    return folder.Add(far, folder.Near(2));
  };
  const std::int32_t left = rim(-1);
  const std::int32_t right = rim(+1);
  const auto corner = [&](double sign) {
    const double across = sign * folder.Far();
    return folder.Add(folder.Near(2), across);
  };
  const std::int32_t below = corner(+1);
  const std::int32_t above = corner(-1);
  folder.AddTriangle(hub, below, left);
  folder.AddTriangle(hub, right, below);
  folder.AddTriangle(hub, left, right);
  folder.AddTriangle(above, right, left);
}

Case Folded(BitSource& bits, const SubjectInfo& info, bool doubled) {
  CaseBuilder builder(bits, info);
  Folder folder(builder);
  if (bits.Chance(128)) {
    AddStrip(folder);
  } else {
    AddFan(folder);
  }
  return folder.Done(doubled);
}

}  // namespace

static Case Folds(BitSource& bits, const SubjectInfo& info) { return Folded(bits, info, false); }

extern constinit const Domain kFoldsDomain{
    .number = 48,
    .bits = 0x17152c45d17b1a49,
    .name = "folds",
    .summary = "strips and fans of triangles a step of the grid high: a legal choice turns",
    .theme = DomainTheme::kSnapping,
    .in_theme = 523,
    .off_grid = true,
    .mesh = true,
    .overlaps = true,
    // What a legal choice turns is most of what freedom can go wrong by.
    .in_a_round = 8,
    .is_stated = LeavesGridPoints,
    .draw = Folds};

static Case ClosedFolds(BitSource& bits, const SubjectInfo& info) {
  return Folded(bits, info, true);
}

extern constinit const Domain kClosedFoldsDomain{
    .number = 49,
    .bits = 0x37f644e123a94f2,
    .name = "closed-folds",
    .summary = "the same with the back of each triangle: closed, whatever is chosen",
    .theme = DomainTheme::kSnapping,
    .in_theme = 524,
    .off_grid = true,
    .mesh = true,
    .overlaps = true,
    .is_stated = LeavesGridPoints,
    .draw = ClosedFolds};

}  // namespace rasterproof::props
