#include "subjects/mutants/real_geometry.h"

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "library/exact_sign.h"
#include "reference/homogeneous.h"
#include "subjects/mutants/placing.h"
#include "variants/rasterizer.h"

namespace rasterproof::subjects::mutants {
namespace {

constexpr variants::Arithmetic<Point2> kRealGeometry{
    .has_twin = false,
    .on_target = ModelOn,
    .wrap = [](double x, const FixedInput&) { return x; },
    .snap = SnapToGrid,
    .exceeds = [](const Points&, const MaxPrimitiveExtent&,
                  const variants::Lattice<Point2>&) { return false; },
    .value = library::EdgeSign};

CoverageCounts DrawnInClipSpace(const Scene& scene, const Profile& profile,
                                const DrawOptions& options) {
  CoverageCounts counts(scene.width, scene.height, profile.pattern.samples());
  reference::DrawHomogeneousExact(scene, profile, options, counts);
  return counts;
}

}  // namespace

SubjectInfo RealGeometryInfo(const std::string& name, const std::string& summary,
                             const Profile& profile) {
  SubjectInfo info;
  info.name = name;
  info.summary = summary;
  info.profile = profile;
  return info;
}

RealStages Signing(int (*sign)(Point2 a, Point2 b, Point2 p)) {
  return {{.area = [sign](const Points& v) { return sign(v[0], v[1], v[2]); },
           .value = [sign](const PointStages::Edge& e,
                           const PointStages::Sample& at) { return sign(e.a, e.b, at.at); }}};
}

std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const RealStages& stages) {
  return Make(RealGeometryInfo(name, summary, stages.profile), stages);
}

std::unique_ptr<Subject> Make(const SubjectInfo& info, const RealStages& stages) {
  return variants::MakeVariant<Point2>(info, stages, kRealGeometry);
}

std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const ClipStages& stages) {
  SubjectInfo info = RealGeometryInfo(name, summary, stages.profile);
  info.takes_window = false;
  info.takes_clip = true;
  variants::Arithmetic<Point2> homogeneous = kRealGeometry;
  homogeneous.has_stages = [](const Scene&, const Profile&) { return false; };
  homogeneous.whole = DrawnInClipSpace;
  return variants::MakeVariant<Point2>(info, stages, homogeneous);
}

}  // namespace rasterproof::subjects::mutants
