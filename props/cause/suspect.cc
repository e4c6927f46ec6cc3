#include "props/cause/suspect.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/error.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "model/drop.h"
#include "model/snap.h"
#include "model/target_profile.h"
#include "model/transform.h"
#include "model/wrap.h"
#include "variants/rasterizer.h"

namespace rasterproof::props {

namespace {

constexpr variants::Arithmetic<Point2> kExact{
    .on_target = [](const Profile& stated, const Scene& scene) -> Profile {
      return TargetProfile(stated, scene);
    },
    .wrap = [](double x, const FixedInput& fixed) { return Wrapped(x, fixed); },
    .snap = [](double x, const Snap& snap) { return SnapCoordinate(x, snap); },
    .exceeds = [](const std::array<Point2, 3>& v, const MaxPrimitiveExtent& most,
                  const variants::Lattice<Point2>&) { return Exceeds(v, most); },
    .value = [](Point2 a, Point2 b, Point2 p) { return exact::EdgeSign(a, b, p); },
    .to_window = [](const Profile& profile, const Scene& scene) -> std::optional<Scene> {
      if (!TakesToWindow(profile, scene)) return std::nullopt;
      return ToWindow(scene, *profile.transform);
    },
    .has_stages = HasStages,
    .why_not_whole = [](const Scene& scene,
                        const Profile& profile) { return exact::WhyNotDecided({scene, profile}); },
    .whole = [](const Scene& scene, const Profile& profile,
                const DrawOptions& options) { return exact::Coverage(scene, profile, options); },
};

}  // namespace

bool HasStages(const Scene& scene, const Profile& profile) {
  return !profile.squares && profile.scanline_rounding.IsNone() &&
         profile.contract != Contract::kSquares && !IsHomogeneous(scene, profile);
}

double WorkOf(const Scene& scene, const SubjectInfo& info) {
  const double samples = double{1} * scene.width * scene.height * info.profile.pattern.samples();
  const auto triangles = static_cast<double>(std::max<std::size_t>(1, scene.triangles.size()));
  return samples * triangles;
}

bool SuspectsDraw(const Scene& scene, const SubjectInfo& info) {
  constexpr double kMostWork = 0x1p18;
  if (WorkOf(scene, info) > kMostWork) return false;
  if (HasStages(scene, info.profile)) return true;
  return !ShowsPrimitiveIds(info) && !exact::WhyNotDecided({scene, info.profile});
}

std::unique_ptr<Subject> MakeSuspect(const SubjectInfo& info, SuspectStages stages) {
  return variants::MakeVariant(info, std::move(stages), kExact);
}

std::vector<Suspect> SuspectsOf(const Profile& profile) {
  std::vector<Suspect> list;
  AddEdges(profile, list);
  AddPlacing(profile, list);
  AddTaking(profile, list);
  AddTraversal(profile, list);
  AddClipping(profile, list);
  return list;
}

}  // namespace rasterproof::props
