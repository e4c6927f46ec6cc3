#include <memory>
#include <utility>

#include "tests/props/planted_bugs.h"

namespace rasterproof::props {

PlantedSubject::PlantedSubject(std::unique_ptr<Subject> sound, Bug bug)
    : sound_(std::move(sound)), bug_(std::move(bug)), info_(sound_->Info()) {
  info_.name += " with a planted bug";
  info_.takes_threads = bug_.claims_threads;
  if (bug_.promises) bug_.promises(info_.profile);
}

void PlantedSubject::Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  if (bug_.draw) {
    bug_.draw(*sound_, scene, options, counts);
  } else {
    sound_->Draw(scene, options, counts);
  }
}

double PlantedSubject::Value(Point2 a, Point2 b, Point2 p) const {
  const double sound = sound_->Edges()->Value(a, b, p);
  return bug_.value ? bug_.value(sound, a, b, p) : sound;
}

double PlantedSubject::ErrorBound(Point2 a, Point2 b, Point2 p) const {
  return sound_->Edges()->ErrorBound(a, b, p);
}

std::vector<double> PlantedSubject::Walk(Point2 a, Point2 b, Point2 p, Step step, int steps) const {
  std::vector<double> values = sound_->Edges()->Walk(a, b, p, step, steps);
  if (bug_.walk) bug_.walk(values, step);
  return values;
}

std::vector<double> PlantedSubject::WalkErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                                    int steps) const {
  return sound_->Edges()->WalkErrorBounds(a, b, p, step, steps);
}

std::array<double, 3> PlantedSubject::Weights(BarycentricForm form, const std::array<Point2, 3>& v,
                                              Point2 p) const {
  std::array<double, 3> weights = sound_->Weights()->Weights(form, v, p);
  if (bug_.weights) bug_.weights(weights, form, v);
  return weights;
}

std::array<double, 3> PlantedSubject::WeightErrorBounds(BarycentricForm form,
                                                        const std::array<Point2, 3>& v,
                                                        Point2 p) const {
  return sound_->Weights()->WeightErrorBounds(form, v, p);
}

double PlantedSubject::SumErrorBound(BarycentricForm form, const std::array<Point2, 3>& v,
                                     Point2 p) const {
  return sound_->Weights()->SumErrorBound(form, v, p);
}

double PlantedSubject::Interpolate(InterpolationForm form, const std::array<Corner, 3>& v,
                                   const std::array<double, 3>& attribute, Point2 p) const {
  return bug_.interpolate ? bug_.interpolate(*sound_->Weights(), form, v, attribute, p)
                          : sound_->Weights()->Interpolate(form, v, attribute, p);
}

double PlantedSubject::InterpolationErrorBound(InterpolationForm form,
                                               const std::array<Corner, 3>& v,
                                               const std::array<double, 3>& attribute,
                                               Point2 p) const {
  return sound_->Weights()->InterpolationErrorBound(form, v, attribute, p);
}

std::array<double, 3> PlantedSubject::EdgeDistances(WireframeForm form,
                                                    const std::array<Point2, 3>& v,
                                                    Point2 p) const {
  return bug_.distances ? bug_.distances(*sound_->Weights(), form, v, p)
                        : sound_->Weights()->EdgeDistances(form, v, p);
}

}  // namespace rasterproof::props
