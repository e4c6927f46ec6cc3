// What explains the violations of a subject in which a bug was planted.
#ifndef RASTERPROOF_TESTS_PROPS_PLANTED_CAUSE_H_
#define RASTERPROOF_TESTS_PROPS_PLANTED_CAUSE_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "core/case.h"
#include "core/vertex.h"
#include "props/cause/cause.h"
#include "props/cause/evidence.h"
#include "props/property.h"
#include "subjects/mutants/fixed_point.h"

namespace rasterproof::props {

inline constexpr double kLongestSearch = 800;  // seconds: what is found may not depend on the clock

inline MakesSubject Planted(const subjects::mutants::FixedStages& stages) {
  return [stages] { return subjects::mutants::Make("planted", "planted", stages); };
}

/// A case of the triangles of each three vertices.
inline Case TrianglesOf(int width, int height, std::vector<Vertex> vertices) {
  Case c;
  c.scene.width = width;
  c.scene.height = height;
  for (std::int32_t k = 0; k + 2 < static_cast<std::int32_t>(vertices.size()); k += 3)
    c.scene.triangles.push_back({k, k + 1, k + 2});
  c.scene.vertices = std::move(vertices);
  return c;
}

/// Explains violations of the model by these cases, a property for each list of them.
inline Causes ExplainPlanted(const subjects::mutants::FixedStages& stages,
                             std::vector<std::vector<Case>> cases,
                             double seconds = kLongestSearch) {
  std::vector<FailedProperty> failures;
  for (std::vector<Case>& of_one : cases) {
    for (Case& c : of_one) c.profile = stages.profile;
    failures.push_back({FindProperty("CoverageEqualsTheModel"), std::move(of_one)});
  }
  return FindCauses(Planted(stages), failures, seconds);
}

}  // namespace rasterproof::props

#endif  // RASTERPROOF_TESTS_PROPS_PLANTED_CAUSE_H_
