#include "tool/part_check.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/error.h"
#include "core/result.h"
#include "fmt/format.h"
#include "props/domains/worlds.h"
#include "props/property.h"
#include "props/run/property_domains.h"
#include "tool/shard.h"

namespace rasterproof::tool {
namespace {

// Of what is added up: a million parts of it are less than 2^64.
constexpr std::uint64_t kMostCounted = std::uint64_t{1} << 44;

// One test of a part, and what is said of it where it can't be so.
class TestCheck {
 public:
  TestCheck(const SubjectPart& part, const TestPart& test, const SubjectInfo& info)
      : part_(part), test_(test), info_(info) {}

  void All() const {
    RequireCounts();
    RequireDomains();
    RequireEnd();
    RequirePlaces();
    if (test_.run.found) RequireFound(*test_.run.found);
  }

 private:
  void Require(bool is_so, const std::string& what) const {
    if (is_so) return;
    throw InputError(part_.file,
                     fmt::format("its {}{}: {}", test_.property,
                                 test_.world.empty() ? "" : " in world " + test_.world, what),
                     "run the part again");
  }

  // Those of the part's range or shard.
  std::uint64_t CasesGiven() const {
    if (test_.world.empty()) return part_.range.end - part_.range.first;
    const CaseRange range =
        CasesOf(part_.shard.value_or(Shard{}), props::FindWorld(test_.world)->cases);
    return range.end - range.first;
  }

  void RequireCounts() const {
    const props::Sums& sums = test_.run.sums;
    for (const std::uint64_t count : {sums.exercised, sums.not_judged}) {
      Require(count <= kMostCounted, fmt::format("{} is no count that any run reaches", count));
    }
    Require(sums.cases_exercised <= sums.cases && sums.cases_exercised <= sums.exercised,
            fmt::format("exercised {} times in {} of {} cases", sums.exercised,
                        sums.cases_exercised, sums.cases));
    Require((sums.cases_exercised == 0) == (sums.exercised == 0),
            fmt::format("exercised {} times in {} cases", sums.exercised, sums.cases_exercised));
    Require(sums.cases_refused <= sums.cases && sums.refused_within_limits <= sums.cases_refused &&
                sums.not_applicable <= sums.cases - sums.cases_refused,
            fmt::format("{} cases refused, {} of them within the limits, and {} not applicable, of "
                        "{}",
                        sums.cases_refused, sums.refused_within_limits, sums.not_applicable,
                        sums.cases));
    Require(sums.worst_ratio >= 0, "the largest error is no number above 0");
  }

  std::size_t Domains() const {
    if (!test_.world.empty()) return 0;
    return props::DomainsFor(info_, *props::FindProperty(test_.property)).size();
  }

  void RequirePlaces() const {
    const props::Sums& sums = test_.run.sums;
    for (const auto& [asked, refused] : sums.places) {
      Require(refused <= asked && refused <= sums.refused_within_limits &&
                  asked - refused <= sums.cases_exercised,
              fmt::format("{} of {} cases with one kind of place refused, of {} in all", refused,
                          asked, sums.refused_within_limits));
    }
  }

  void RequireDomains() const {
    const props::Sums& sums = test_.run.sums;
    Require(sums.drawn.size() == Domains(),
            fmt::format("{} domains are told, and it draws from {}", sums.drawn.size(), Domains()));
    std::uint64_t left = sums.cases;
    for (const std::uint64_t drawn : sums.drawn) {
      Require(drawn <= left, "its domains have more cases than were run");
      left -= drawn;
    }
    Require(left == 0 || sums.drawn.empty(), "its domains have fewer cases than were run");
    for (const auto& near : sums.near_edge) {
      const std::uint64_t most =
          std::max({near.on_edge, near.within_1, near.within_16, near.within_256});
      Require(most <= near.samples && near.samples <= kMostCounted,
              "more of its samples lie near edges than were looked at");
    }
  }

  void RequireEnd() const {
    const std::uint64_t given = CasesGiven();
    const std::uint64_t run = test_.run.sums.cases;
    const bool draws_none = test_.world.empty() && Domains() == 0;
    switch (test_.run.end) {
      case props::End::kAllRun:
        Require(run == (draws_none ? 0 : given),
                fmt::format("all run, with {} of its {} cases", run, given));
        break;
      case props::End::kNotApplicable:
        Require(run == 0, fmt::format("not applicable, with {} cases run", run));
        break;
      case props::End::kFailed:
      case props::End::kTimeUp:
      case props::End::kInterrupted:
      case props::End::kInconclusive:  // with a case, which is not counted
        Require(run <= given, fmt::format("{} cases run of {}", run, given));
    }
    Require(test_.run.end == props::End::kFailed || !test_.run.found,
            "a case failed, and it did not end with a failure");
  }

  void RequireFound(const props::Counterexample& found) const {
    Require(found.outcome != Outcome::kHolds, "it failed, and the outcome is that it holds");
    Require(found.verdict.outcome == Outcome::kViolated,
            "it failed, and what was said of the case is not that it is violated");
    if (!found.verdict.witness) return;
    const Witness& w = *found.verdict.witness;
    const DrawnScene* drawn = found.verdict.drawn.get();
    const Scene& scene = drawn != nullptr ? drawn->scene : found.value.scene;
    const int samples = std::max(1, found.value.profile.pattern.samples());
    const auto triangles = static_cast<std::int64_t>(scene.triangles.size());
    Require(w.triangle >= -1 && w.triangle < triangles,
            fmt::format("its witness is triangle {} of {}", w.triangle, triangles));
    Require(w.edge >= -1 && w.edge < 3, fmt::format("its witness is edge {}", w.edge));
    Require(w.x >= -1 && w.x < scene.width && w.y >= -1 && w.y < scene.height,
            fmt::format("its witness is pixel ({}, {}) of {} x {}", w.x, w.y, scene.width,
                        scene.height));
    Require(w.sample >= 0 && w.sample < samples,
            fmt::format("its witness is sample {} of {}", w.sample, samples));
  }

  const SubjectPart& part_;
  const TestPart& test_;
  const SubjectInfo& info_;
};

}  // namespace

void RequireSound(const SubjectPart& part, const SubjectInfo& info) {
  for (const TestPart& test : part.tests) TestCheck(part, test, info).All();
}

}  // namespace rasterproof::tool
