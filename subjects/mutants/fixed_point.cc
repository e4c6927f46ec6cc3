#include "subjects/mutants/fixed_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/subject_info.h"
#include "subjects/mutants/placing.h"
#include "variants/rasterizer.h"

namespace rasterproof::subjects::mutants {
namespace {

// The low n + m bits, the highest of them read as the sign.
double Wrapped(double x, const FixedInput& fixed) {
  auto used = static_cast<std::int64_t>(std::ldexp(x, fixed.fraction_bits));
  const int bits = fixed.integer_bits + fixed.fraction_bits;
  if (fixed.wraps) {
    used &= (std::int64_t{1} << bits) - 1;
    if (fixed.is_signed && (used >> (bits - 1)) != 0) used -= std::int64_t{1} << bits;
  }
  return std::ldexp(static_cast<double>(used), -fixed.fraction_bits);
}

bool IsTooLarge(const std::array<GridPoint, 3>& v, const MaxPrimitiveExtent& most,
                const variants::Lattice<GridPoint>& lattice) {
  const auto [left, right] = std::ranges::minmax(v, {}, &GridPoint::x);
  const auto [top, bottom] = std::ranges::minmax(v, {}, &GridPoint::y);
  return right.x - left.x > lattice.Steps(most.width) ||
         bottom.y - top.y > lattice.Steps(most.height);
}

int GridBits(const FixedStages& stages) {
  const Profile& profile = stages.profile;
  int bits = std::max(stages.bits, profile.snap.bits);
  if (profile.fixed) bits = std::max(bits, profile.fixed->fraction_bits);
  for (const TargetModel& model : profile.by_target_size) bits = std::max(bits, model.snap.bits);
  return bits;
}

}  // namespace

Profile FixedPointProfile() {
  Profile profile = *PresetProfile("d3d11-canonical");
  profile.name = "fixed point";
  profile.infinite_vertex = InfiniteVertex::kNothing;
  return profile;
}

bool OwnsIfFlat(const GridEdge& edge, const GridTriangle& triangle, const Sample&) {
  return edge.owns || GridEdge{triangle.v[0], triangle.v[1]}.At(triangle.v[2]) == 0;
}

SubjectInfo FixedPointInfo(const std::string& name, const std::string& summary,
                           const Profile& profile) {
  SubjectInfo info;
  info.name = name;
  info.summary = summary;
  info.profile = profile;
  info.takes_threads = true;
  return info;
}

std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const FixedStages& stages) {
  SubjectInfo info = FixedPointInfo(name, summary, stages.profile);
  info.takes_tiles = info.takes_threads = stages.has_workers;
  return Make(info, stages);
}

std::unique_ptr<Subject> Make(const SubjectInfo& info, const FixedStages& stages) {
  return variants::MakeVariant<GridPoint>(info, stages,
                                          {.lattice = {GridBits(stages)},
                                           .tile = 8,
                                           .has_twin = stages.has_workers,
                                           .on_target = ModelOn,
                                           .wrap = Wrapped,
                                           .snap = SnapToGrid,
                                           .exceeds = IsTooLarge,
                                           .value = variants::EdgeValue});
}

}  // namespace rasterproof::subjects::mutants
