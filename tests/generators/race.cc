#include "tests/generators/race.h"

#include <time.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/coverage.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/verdict.h"
#include "exact/coverage.h"
#include "props/judging/gate.h"
#include "props/run/judged_case.h"
#include "props/run/trial.h"

namespace rasterproof::generators {
namespace {

constexpr std::array<std::string_view, 5> kJudges{
    "CoverageEqualsTheModel", "ClipSpaceCoverageEqualsTheModel",
    "EmbeddedMeshSamplesAreCoveredOnce", "SharedEdgeSamplesAreCoveredOnce",
    "NonFiniteTrianglesCoverNothing"};

// A shared machine makes no difference to it.
double CoreSeconds() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

bool IsViolated(Subject& subject, const std::vector<const props::Property*>& properties,
                const Case& c) {
  return std::ranges::any_of(properties, [&](const props::Property* property) {
    return props::TryCase(subject, *property, c).verdict.outcome == Outcome::kViolated;
  });
}

}  // namespace

std::span<const std::string_view> JudgingProperties() { return kJudges; }

std::vector<const props::Property*> Applicable(Subject& subject,
                                               std::span<const std::string_view> names) {
  std::vector<const props::Property*> properties;
  const props::Description description = props::AsJudged(props::DescriptionOf(subject));
  for (const std::string_view name : names) {
    const props::Property* const property = props::FindProperty(name);
    if (property == nullptr) {
      throw InputError(std::string(name), "no such property", "see: rasterproof list");
    }
    if (!props::DoesNotApply(property->gate, description)) properties.push_back(property);
  }
  return properties;
}

Race RunRace(Subject& subject, const std::vector<const props::Property*>& properties,
             CaseStream& cases, double cap, double least) {
  Race race;
  const double start = CoreSeconds();
  do {
    const Case c = cases.Next();
    ++race.cases;
    const bool violated = !c.scene.triangles.empty() && IsViolated(subject, properties, c);
    race.seconds = CoreSeconds() - start;
    if (!violated) continue;
    ++race.violating;
    if (race.cases_to_first) continue;
    race.cases_to_first = race.cases;
    race.seconds_to_first = race.seconds;
  } while (race.seconds < cap && !(race.violating > 0 && race.seconds >= least));
  return race;
}

Wrong CountWrong(Subject& subject, CaseStream& cases, std::uint64_t count, double cap) {
  Wrong result;
  const double start = CoreSeconds();
  for (std::uint64_t k = 0; k < count && CoreSeconds() - start < cap; ++k) {
    const Case c = cases.Next();
    if (!WithinLimits(c.scene, c.profile) || exact::WhyNotDecided(c.scene, c.profile)) continue;
    CoverageCounts drawn(c.scene.width, c.scene.height, c.profile.pattern.samples());
    DrawOnto(subject, c.scene, c.options, drawn);
    ++result.cases;
    if (drawn != exact::Coverage(c.scene, c.profile, c.options)) ++result.wrong;
  }
  return result;
}

}  // namespace rasterproof::generators
