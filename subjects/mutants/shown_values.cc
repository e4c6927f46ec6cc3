#include "subjects/mutants/shown_values.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/coverage.h"
#include "core/scene.h"
#include "reference/method.h"
#include "reference/rasterize.h"
#include "reference/weights.h"

namespace rasterproof::subjects::mutants {
namespace {

class ShownValues final : public Subject, public EdgeEvaluator, public WeightEvaluator {
 public:
  ShownValues(const std::string& name, const std::string& summary, ValueStages stages)
      : stages_(std::move(stages)),
        method_(*reference::FindMethod(stages_.method)),
        edges_(*method_.edges),
        weights_(reference::ReferenceWeights(method_.info.input)),
        info_(method_.info) {
    info_.name = name;
    info_.summary = summary;
    // What is proved of the method is not of the one with a bug in it.
    info_.proofs.clear();
    info_.claims_exact = false;
    info_.profile.contract = Contract::kNone;
  }

  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    reference::Rasterize(scene, method_, {options, false}, counts);
  }
  const EdgeEvaluator* Edges() const override { return this; }
  const WeightEvaluator* Weights() const override { return this; }

  double Value(Point2 a, Point2 b, Point2 p) const override {
    const double sound = edges_.Value(a, b, p);
    return stages_.value ? stages_.value(sound, a, b, p) : sound;
  }
  double ErrorBound(Point2 a, Point2 b, Point2 p) const override {
    return stages_.edge_bound * edges_.ErrorBound(a, b, p);
  }
  std::vector<double> Walk(Point2 a, Point2 b, Point2 p, Step step, int steps) const override {
    std::vector<double> values = edges_.Walk(a, b, p, step, steps);
    if (stages_.walk) stages_.walk(values, step);
    return values;
  }
  std::vector<double> WalkErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                      int steps) const override {
    std::vector<double> bounds = edges_.WalkErrorBounds(a, b, p, step, steps);
    for (double& bound : bounds) bound *= stages_.walk_bound;
    return bounds;
  }
  Triple Weights(BarycentricForm form, const std::array<Point2, 3>& v, Point2 p) const override {
    Triple weights = weights_.Weights(form, v, p);
    if (stages_.weights) stages_.weights(weights, form, v, p);
    return weights;
  }
  Triple WeightErrorBounds(BarycentricForm form, const std::array<Point2, 3>& v,
                           Point2 p) const override {
    Triple bounds = weights_.WeightErrorBounds(form, v, p);
    for (double& bound : bounds) bound *= stages_.weight_bound;
    return bounds;
  }
  double SumErrorBound(BarycentricForm form, const std::array<Point2, 3>& v,
                       Point2 p) const override {
    return stages_.weight_bound * weights_.SumErrorBound(form, v, p);
  }
  double Interpolate(InterpolationForm form, const std::array<Corner, 3>& v,
                     const Triple& attribute, Point2 p) const override {
    return stages_.interpolate ? stages_.interpolate(weights_, form, v, attribute, p)
                               : weights_.Interpolate(form, v, attribute, p);
  }
  double InterpolationErrorBound(InterpolationForm form, const std::array<Corner, 3>& v,
                                 const Triple& attribute, Point2 p) const override {
    return weights_.InterpolationErrorBound(form, v, attribute, p);
  }
  Triple EdgeDistances(WireframeForm form, const std::array<Point2, 3>& v,
                       Point2 p) const override {
    return stages_.distances ? stages_.distances(weights_, form, v, p)
                             : weights_.EdgeDistances(form, v, p);
  }

 private:
  ValueStages stages_;
  const reference::Method& method_;
  const EdgeEvaluator& edges_;
  const WeightEvaluator& weights_;
  SubjectInfo info_;
};

}  // namespace

std::unique_ptr<Subject> MakeShownValues(const std::string& name, const std::string& summary,
                                         ValueStages stages) {
  return std::make_unique<ShownValues>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
