#include "subjects/mutants/shown_values.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/coverage.h"
#include "core/scene.h"
#include "reference/barycentrics.h"
#include "reference/method.h"
#include "reference/rasterize.h"

namespace rasterproof::subjects::mutants {
namespace {

class ShownValues final : public Subject, public EdgeEvaluator, public BarycentricEvaluator {
 public:
  ShownValues(const std::string& name, const std::string& summary, ValueStages stages)
      : stages_(std::move(stages)),
        method_(*reference::FindMethod(stages_.method)),
        edges_(*method_.edges),
        barycentrics_(reference::ReferenceBarycentrics(method_.info.input)),
        info_(method_.info) {
    info_.name = name;
    info_.summary = summary;
    // What is proved of the method is not of the one with a bug in it.
    info_.proofs.clear();
    info_.states_exact = false;
    info_.profile.contract = Contract::kNone;
  }

  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    reference::Rasterize(scene, method_, {options, false}, counts);
  }
  const EdgeEvaluator* Edges() const override { return this; }
  const BarycentricEvaluator* Barycentrics() const override { return this; }

  double Value(Point2 a, Point2 b, Point2 p) const override {
    const double sound = edges_.Value(a, b, p);
    return stages_.value ? stages_.value(sound, a, b, p) : sound;
  }
  double ErrorBound(Point2 a, Point2 b, Point2 p) const override {
    return stages_.edge_bound * edges_.ErrorBound(a, b, p);
  }
  std::vector<double> Steps(Point2 a, Point2 b, Point2 p, Step step, int steps) const override {
    std::vector<double> values = edges_.Steps(a, b, p, step, steps);
    if (stages_.steps) stages_.steps(values, step);
    return values;
  }
  std::vector<double> SteppingErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                          int steps) const override {
    std::vector<double> bounds = edges_.SteppingErrorBounds(a, b, p, step, steps);
    for (double& bound : bounds) bound *= stages_.stepping_bound;
    return bounds;
  }
  Triple Barycentrics(BarycentricForm form, const std::array<Point2, 3>& v,
                      Point2 p) const override {
    Triple barycentrics = barycentrics_.Barycentrics(form, v, p);
    if (stages_.barycentrics) stages_.barycentrics(barycentrics, form, v, p);
    return barycentrics;
  }
  Triple BarycentricErrorBounds(BarycentricForm form, const std::array<Point2, 3>& v,
                                Point2 p) const override {
    Triple bounds = barycentrics_.BarycentricErrorBounds(form, v, p);
    for (double& bound : bounds) bound *= stages_.barycentric_bound;
    return bounds;
  }
  double SumErrorBound(BarycentricForm form, const std::array<Point2, 3>& v,
                       Point2 p) const override {
    return stages_.barycentric_bound * barycentrics_.SumErrorBound(form, v, p);
  }
  double Interpolate(InterpolationForm form, const std::array<Corner, 3>& v,
                     const Triple& attribute, Point2 p) const override {
    return stages_.interpolate ? stages_.interpolate(barycentrics_, form, v, attribute, p)
                               : barycentrics_.Interpolate(form, v, attribute, p);
  }
  double InterpolationErrorBound(InterpolationForm form, const std::array<Corner, 3>& v,
                                 const Triple& attribute, Point2 p) const override {
    return barycentrics_.InterpolationErrorBound(form, v, attribute, p);
  }
  Triple EdgeDistances(WireframeForm form, const std::array<Point2, 3>& v,
                       Point2 p) const override {
    return stages_.distances ? stages_.distances(barycentrics_, form, v, p)
                             : barycentrics_.EdgeDistances(form, v, p);
  }

 private:
  ValueStages stages_;
  const reference::Method& method_;
  const EdgeEvaluator& edges_;
  const BarycentricEvaluator& barycentrics_;
  SubjectInfo info_;
};

}  // namespace

std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              ValueStages stages) {
  return std::make_unique<ShownValues>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
