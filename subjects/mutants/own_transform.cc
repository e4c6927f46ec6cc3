#include "subjects/mutants/own_transform.h"

#include <limits>
#include <utility>

#include "core/profile.h"
#include "subjects/mutants/fixed_point.h"

namespace rasterproof::subjects::mutants {
namespace {

class OwnTransform final : public Subject {
 public:
  OwnTransform(const std::string& name, const std::string& summary, TransformStages stages)
      : base_(MakeFixedPoint(name, summary, {})), info_(base_->Info()), stages_(std::move(stages)) {
    info_.profile.name = "transform of its own";
    info_.profile.transform = stages_.promised;
    info_.takes_window = false;
    info_.takes_clip = true;
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    Scene window = scene;
    window.clip_space = false;
    for (Vertex& v : window.vertices) {
      constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
      const bool has_place = IsFinite(v) && v.w > 0;
      const Point2 p = has_place ? stages_.to_window(v, scene) : Point2{kNowhere, kNowhere};
      v = {p.x, p.y, v.z, 1};
    }
    base_->Draw(window, options, counts);
  }

 private:
  std::unique_ptr<Subject> base_;
  SubjectInfo info_;
  TransformStages stages_;
};

}  // namespace

std::unique_ptr<Subject> MakeOwnTransform(const std::string& name, const std::string& summary,
                                          TransformStages stages) {
  return std::make_unique<OwnTransform>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
