// A built-in subject with one bug planted in it.
#ifndef RASTERPROOF_TESTS_PROPS_PLANTED_BUGS_H_
#define RASTERPROOF_TESTS_PROPS_PLANTED_BUGS_H_

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/evaluators.h"
#include "core/subject.h"
#include "core/subject_info.h"

namespace rasterproof::props {

using DrawBug =
    std::function<void(Subject& sound, const Scene&, const DrawOptions&, CoverageCounts&)>;
using ValueBug = std::function<double(double sound, Point2 a, Point2 b, Point2 p)>;
using SteppingBug = std::function<void(std::vector<double>& sound, Step)>;
using BarycentricsBug = std::function<void(std::array<double, 3>& sound, BarycentricForm,
                                           const std::array<Point2, 3>& v)>;
using InterpolationBug =
    std::function<double(const BarycentricEvaluator& sound, InterpolationForm,
                         const std::array<Corner, 3>& v, std::array<double, 3> attribute, Point2)>;
using DistancesBug = std::function<std::array<double, 3>(
    const BarycentricEvaluator& sound, WireframeForm, const std::array<Point2, 3>& v, Point2 p)>;

using ShowBug = std::function<void(Drawing& sound, const DrawJob&)>;
using BatchBug = std::function<void(std::vector<DrawOutcome>& sound)>;

/// What is planted; an empty function leaves that part sound.
struct Bug {
  DrawBug draw = {};
  ValueBug value = {};
  SteppingBug stepping = {};
  BarycentricsBug barycentrics = {};
  InterpolationBug interpolate = {};
  DistancesBug distances = {};
  /// Set: the subject shows fragments, the last ones drawn, with exact barycentrics; the centroid
  /// of one sample is its pixel's centre.
  ShowBug show = {};
  /// Set: the subject takes batches.
  BatchBug batch = {};
  bool states_threads = false;
  /// The subject can be made twice: its twin has the draw bug as it was planted.
  bool has_twin = false;
  /// Changes what the subject states, for contracts that no built-in subject has.
  std::function<void(Profile&)> states = {};
};

/// States the sound subject's bounds, which the bug violates.
class PlantedSubject final : public Subject, public EdgeEvaluator, public BarycentricEvaluator {
 public:
  PlantedSubject(std::unique_ptr<Subject> sound, Bug bug);

  const SubjectInfo& OwnInfo() const override { return info_; }
  Subject* Twin() override;
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override;
  Drawing Show(const DrawJob& job) override;
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override;
  const EdgeEvaluator* Edges() const override { return sound_->Edges() ? this : nullptr; }
  const BarycentricEvaluator* Barycentrics() const override {
    return sound_->Barycentrics() ? this : nullptr;
  }

  double Value(Point2 a, Point2 b, Point2 p) const override;
  double ErrorBound(Point2 a, Point2 b, Point2 p) const override;
  std::vector<double> Steps(Point2 a, Point2 b, Point2 p, Step step, int steps) const override;
  std::vector<double> SteppingErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                          int steps) const override;

  std::array<double, 3> Barycentrics(BarycentricForm form, const std::array<Point2, 3>& v,
                                     Point2 p) const override;
  std::array<double, 3> BarycentricErrorBounds(BarycentricForm form, const std::array<Point2, 3>& v,
                                               Point2 p) const override;
  double SumErrorBound(BarycentricForm form, const std::array<Point2, 3>& v,
                       Point2 p) const override;
  double Interpolate(InterpolationForm form, const std::array<Corner, 3>& v,
                     const std::array<double, 3>& attribute, Point2 p) const override;
  double InterpolationErrorBound(InterpolationForm form, const std::array<Corner, 3>& v,
                                 const std::array<double, 3>& attribute, Point2 p) const override;
  std::array<double, 3> EdgeDistances(WireframeForm form, const std::array<Point2, 3>& v,
                                      Point2 p) const override;

 private:
  std::unique_ptr<Subject> sound_;
  Bug bug_;
  SubjectInfo info_;
  std::unique_ptr<Subject> twin_;
};

/// A bug, the sound subject it is planted in, and the property that must catch it.
struct PlantedBug {
  std::string_view property;
  std::string_view name;
  std::string_view sound;  ///< a built-in subject
  Bug bug;
};

/// Those of barycentrics, and of distances made from them.
std::vector<PlantedBug> BarycentricPlantedBugs();
std::vector<PlantedBug> WireframePlantedBugs();

/// Those of primitive ids, fragments and calls.
std::vector<PlantedBug> OutputPlantedBugs();

/// Those of pixels as squares.
std::vector<PlantedBug> SquarePlantedBugs();

/// One for each property at least.
std::vector<PlantedBug> PlantedBugs();

}  // namespace rasterproof::props

#endif  // RASTERPROOF_TESTS_PROPS_PLANTED_BUGS_H_
