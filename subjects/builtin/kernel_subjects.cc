#include "subjects/builtin/kernel_subjects.h"

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/float_environment.h"
#include "reference/plan.h"
#include "reference/proved.h"
#include "reference/whole_scene.h"

namespace rasterproof::subjects {
namespace {

using library::kernels::KernelMethod;

// The kernel's statements are those of library/kernels/kernel.h.
struct KernelRow {
  std::string_view name;
  std::string_view summary;
  KernelMethod method;
};
constexpr std::array<KernelRow, 5> kKernels{{
    {"kernel-incremental", "float32 edge functions stepped from the box's corner, by vectors",
     KernelMethod::kIncremental},
    {"kernel-tiles", "float32 half-spaces: 8x8 tiles accepted, rejected or tested by pixel",
     KernelMethod::kTiles},
    {"kernel-fixed-tiles", "the same in 28.8 fixed point: exact by its own model",
     KernelMethod::kFixedTiles},
    {"kernel-scanline", "float32 crossings of edges with rows, by vectors",
     KernelMethod::kScanline},
    {"kernel-exact-unsafe", "spans-exact without what makes it exact", KernelMethod::kExactUnsafe},
}};

constexpr std::string_view kClipKernel = "kernel-clip";

class KernelSubject final : public Subject {
 public:
  explicit KernelSubject(const KernelRow& row) : method_(row.method) {
    info_.name = row.name;
    info_.summary = row.summary;
    info_.profile.coordinate_limit = double{std::numeric_limits<float>::max()};
    if (method_ == KernelMethod::kFixedTiles) {
      info_.profile.name = row.name;
      info_.profile.snap = {8, SnapRule::kNearestEven};
      info_.profile.coordinate_limit = double{library::kernels::kFixedRange};
      info_.states_exact = true;
    }
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    if (!reference::KernelsTake(scene)) {
      throw InputError("scene " + scene.name, info_.name + " computes in float32 and window space",
                       "use spans-exact");
    }
    reference::DrawByKernel(method_, scene, options, counts);
  }

 private:
  KernelMethod method_;
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
    info_.proofs = {reference::ClipKernelProof()};
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
  for (const KernelRow& row : kKernels) names.emplace_back(row.name);
  names.emplace_back(kClipKernel);
  names.emplace_back("planned");
  return names;
}

std::unique_ptr<Subject> MakeKernelSubject(std::string_view name) {
  for (const KernelRow& row : kKernels) {
    if (row.name == name) return std::make_unique<KernelSubject>(row);
  }
  if (name == kClipKernel) return std::make_unique<ClipKernelSubject>();
  if (name == "planned") return std::make_unique<PlannedSubject>();
  return nullptr;
}

}  // namespace rasterproof::subjects
