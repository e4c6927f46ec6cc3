#include "tests/report/sample_results.h"

#include <string>

namespace rasterproof::report {
namespace {

Case OneTriangle() {
  Case c;
  c.scene.name = "one";
  c.scene.width = 4;
  c.scene.height = 4;
  c.scene.vertices = {{0, 0}, {4, 0}, {0, 0x1.000002p+1}};
  c.scene.triangles = {{0, 2, 1}};
  c.origin = "needles:12@7";
  return c;
}

SceneResult OnScene(const std::string& profile, std::uint64_t wrong) {
  SceneResult result;
  result.scene = "bunny <front>";
  result.subject = "f32-direct";
  result.profile = profile;
  result.triangles = 69666;
  result.difference = {262144, 100000, wrong, wrong, 0, 17};
  result.seconds = 0.25;
  return result;
}

}  // namespace

PropertyResult SampleProperty(const std::string& name, Outcome outcome) {
  PropertyResult result;
  result.property = name;
  result.subject = "f32-direct";
  result.clause = "each sample on a shared edge belongs to one triangle";
  result.tolerance = "none: exact";
  result.outcome = outcome;
  result.seed = 0xFFFFFFFFFFFFFFFFU;
  result.cases = 1000;
  result.domains = {{1000, {1000, 100, 200, 300, 400}}};
  result.seconds = 1.5;
  if (outcome == Outcome::kHolds) {
    result.cases_exercised = 998;
    result.exercised = 12345;
    result.worst_ratio = 0.75;
  }
  if (outcome == Outcome::kNotApplicable) result.message = "it shows no edge values";
  if (outcome == Outcome::kNotExercised) result.message = "no sample lay on an edge";
  if (outcome == Outcome::kViolated) {
    result.message = "sample covered twice";
    Counterexample& found = result.counterexample.emplace();
    found.value = OneTriangle();
    found.verdict = Verdict::Violated(3, "sample covered twice", {0, 1, 2, 3, 0, {2}, {1}});
    found.failing_case = "needles:12@7";
  }
  return result;
}

Certificate SampleCertificate() {
  Certificate certificate;
  certificate.tool_version = "0.1.0";
  certificate.subject.name = "f32-direct";
  certificate.subject.summary = "float32, five operations";
  certificate.command = "rasterproof certify f32-direct --out out";
  certificate.environment = {{"compiler", "g++ 12.2"}, {"rounding", "to nearest"}};
  certificate.seed = 7;
  certificate.not_asked = {{"depths in clip space", "no property judges them"},
                           {"targets above 4096 samples", ""}};
  certificate.proved = {{"the sign is exact up to 11 bits", "reference/proofs/direct.g"}};
  certificate.tested = {SampleProperty("EdgeIsAntisymmetric", Outcome::kHolds),
                        SampleProperty("SharedEdgeSamplesAreCoveredOnce", Outcome::kViolated),
                        SampleProperty("HubIsCoveredOnce", Outcome::kNotExercised),
                        SampleProperty("SteppingIsExact", Outcome::kNotApplicable)};
  PropertyResult exhausted = SampleProperty("CoverageEqualsTheModel", Outcome::kHolds);
  exhausted.world = "triangles-3x3";
  exhausted.world_cases = exhausted.cases;
  exhausted.domains.clear();
  certificate.tested.push_back(exhausted);
  certificate.measured = {OnScene("real", 5)};
  certificate.oracle_tiers = {.filter = 900, .exact = 3};
  return certificate;
}

}  // namespace rasterproof::report
