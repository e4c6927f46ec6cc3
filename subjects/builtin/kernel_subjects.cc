#include "subjects/builtin/kernel_subjects.h"

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/float_environment.h"
#include "library/rivals/rival.h"
#include "reference/plan.h"
#include "reference/proved.h"
#include "reference/whole_scene.h"

namespace rasterproof::subjects {
namespace {

using library::rivals::Rival;

// Their statements are those of library/rivals/rival.h.
struct RivalRow {
  std::string_view name;
  std::string_view summary;
};
constexpr std::array<RivalRow, 5> kRivals{{
    {"kernel-incremental", "float32 edge functions stepped from the box's corner, by vectors"},
    {"kernel-tiles", "float32 half-spaces: 8x8 tiles accepted, rejected or tested by pixel"},
    {"kernel-fixed-tiles", "the same in 28.8 fixed point: exact by its own model"},
    {"kernel-scanline", "float32 crossings of edges with rows, by vectors"},
    {"kernel-exact-unsafe", "spans-exact without what makes it exact"},
}};

constexpr std::string_view kClipKernel = "kernel-clip";

class KernelSubject final : public Subject {
 public:
  KernelSubject(std::string_view name, std::string_view summary, const Rival& rival)
      : rival_(rival) {
    info_.name = name;
    info_.summary = summary;
    info_.profile.coordinate_limit = double{std::numeric_limits<float>::max()};
    if (Snaps(rival.arithmetic)) {
      info_.profile.name = name;
      info_.profile.snap = {8, SnapRule::kNearestEven};
      info_.profile.coordinate_limit = double{library::rivals::kFixedRange};
      info_.states_exact = true;
    }
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    if (!reference::KernelsTake(scene)) {
      throw InputError("scene " + scene.name, info_.name + " computes in float32 and window space",
                       "use spans-exact");
    }
    reference::DrawByRival(rival_, scene, options, counts);
  }

 private:
  Rival rival_;
  SubjectInfo info_;
};

class ClipKernelSubject final : public Subject {
 public:
  ClipKernelSubject() {
    info_.name = kClipKernel;
    info_.summary = "edges of (x, y, w) as rows cross them, by vectors: float32, exact";
    info_.takes_window = false;
    info_.takes_clip = true;
    info_.states_exact = true;
    info_.proofs = reference::ClipKernelProofs();
    info_.profile.coordinate_limit = double{std::numeric_limits<float>::max()};
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    if (!reference::ClipKernelTakes(scene)) {
      throw InputError("scene " + scene.name, info_.name + " computes in float32 and clip space",
                       "use hom-exact");
    }
    reference::DrawByClipKernel(scene, options, counts);
  }

 private:
  SubjectInfo info_;
};

class PlannedSubject final : public Subject {
 public:
  PlannedSubject() {
    info_.name = "planned";
    info_.summary = "what `rasterproof plan` chooses for the scene";
    info_.input = Precision::kFloat64;
    info_.takes_clip = true;
    info_.states_exact = true;
    info_.profile.coordinate_limit = std::numeric_limits<double>::max();
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    const FloatEnvironment sane;
    const reference::Plan plan = reference::MakePlan(scene, info_.profile, options, {});
    plan.draw(scene, info_.profile, options, counts);
  }

 private:
  SubjectInfo info_;
};

}  // namespace

std::vector<std::string> KernelSubjectNames() {
  std::vector<std::string> names;
  for (const RivalRow& row : kRivals) names.emplace_back(row.name);
  names.emplace_back(kClipKernel);
  names.emplace_back("planned");
  return names;
}

std::unique_ptr<Subject> MakeKernelSubject(std::string_view name) {
  for (const RivalRow& row : kRivals) {
    if (row.name != name) continue;
    return std::make_unique<KernelSubject>(name, row.summary, *library::rivals::FindRival(name));
  }
  if (name == kClipKernel) return std::make_unique<ClipKernelSubject>();
  if (name == "planned") return std::make_unique<PlannedSubject>();
  return nullptr;
}

}  // namespace rasterproof::subjects
