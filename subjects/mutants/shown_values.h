// The sound base of mutants that show numbers: the reference's edge values and barycentrics.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_SHOWN_VALUES_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_SHOWN_VALUES_H_

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/evaluators.h"
#include "core/subject.h"
#include "core/vertex.h"

namespace rasterproof::subjects::mutants {

using Triple = std::array<double, 3>;

/// What is changed of the numbers that the reference's method shows; the bounds that it proves are
/// stated all the same. An empty function leaves its numbers sound.
struct ValueStages {
  std::string_view method = "f32-direct";

  std::function<double(double sound, Point2 a, Point2 b, Point2 p)> value = {};
  std::function<void(std::vector<double>& sound, Step)> steps = {};
  std::function<void(Triple& sound, BarycentricForm, const std::array<Point2, 3>& v, Point2 p)>
      barycentrics = {};
  std::function<double(const BarycentricEvaluator& sound, InterpolationForm,
                       const std::array<Corner, 3>& v, const Triple& attribute, Point2 p)>
      interpolate = {};
  std::function<Triple(const BarycentricEvaluator& sound, WireframeForm,
                       const std::array<Point2, 3>& v, Point2 p)>
      distances = {};
  /// What the stated bounds are multiplied by.
  double edge_bound = 1;
  double barycentric_bound = 1;
  double stepping_bound = 1;
};

/// A subject whose coverage is not judged (contract none): only what it shows is.
std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              ValueStages stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_SHOWN_VALUES_H_
