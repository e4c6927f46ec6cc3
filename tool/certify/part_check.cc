#include "tool/certify/part_check.h"

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
#include "tool/certify/shard.h"

namespace rasterproof::tool {
namespace {

// Of what is added up: a million parts of it are less than 2^64.
constexpr std::uint64_t kMostCounted = std::uint64_t{1} << 44;

// One test of a part, and what is said of it where it can't be so.
class TestCheck {
 public:
  TestCheck(const SubjectPart& part, const PropertyResult& result, const SubjectInfo& info)
      : part_(part), result_(result), info_(info) {}

  void All() const {
    RequireCounts();
    RequireDomains();
    RequireEnd();
    RequirePlaces();
    if (result_.counterexample) RequireFound(*result_.counterexample);
  }

 private:
  void Require(bool is_so, const std::string& what) const {
    if (is_so) return;
    throw InputError(part_.file,
                     fmt::format("its {}{}: {}", result_.property,
                                 result_.world.empty() ? "" : " in world " + result_.world, what),
                     "run the part again");
  }

  // Those of the part's range or shard.
  std::uint64_t CasesGiven() const {
    if (result_.world.empty()) return part_.range.end - part_.range.first;
    const CaseRange range =
        CasesOf(part_.shard.value_or(Shard{}), props::FindWorld(result_.world)->cases);
    return range.end - range.first;
  }

  void RequireCounts() const {
    for (const std::uint64_t count :
         {result_.exercised, result_.not_judged, result_.draws.window, result_.draws.clip}) {
      Require(count <= kMostCounted, fmt::format("no run can reach a count of {}", count));
    }
    Require(
        result_.cases_exercised <= result_.cases && result_.cases_exercised <= result_.exercised,
        fmt::format("exercised {} times in {} of {} cases", result_.exercised,
                    result_.cases_exercised, result_.cases));
    Require(
        (result_.cases_exercised == 0) == (result_.exercised == 0),
        fmt::format("exercised {} times in {} cases", result_.exercised, result_.cases_exercised));
    Require(result_.cases_refused <= result_.cases &&
                result_.refused_within_limits <= result_.cases_refused &&
                result_.not_applicable <= result_.cases - result_.cases_refused,
            fmt::format("{} cases refused, {} of them within the limits, and {} not applicable, of "
                        "{}",
                        result_.cases_refused, result_.refused_within_limits,
                        result_.not_applicable, result_.cases));
    Require(result_.worst_ratio >= 0, "the largest error is not a positive number");
  }

  std::size_t Domains() const {
    if (!result_.world.empty()) return 0;
    return props::DomainsFor(info_, *props::FindProperty(result_.property)).size();
  }

  void RequirePlaces() const {
    for (const auto& [asked, refused] : result_.places) {
      Require(refused <= asked && refused <= result_.refused_within_limits &&
                  asked - refused <= result_.cases_exercised,
              fmt::format("{} of {} cases with one kind of place refused, of {} in all", refused,
                          asked, result_.refused_within_limits));
    }
  }

  void RequireDomains() const {
    Require(
        result_.domains.size() == Domains(),
        fmt::format("it lists {} domains but draws from {}", result_.domains.size(), Domains()));
    std::uint64_t left = result_.cases;
    for (const auto& [drawn, near_edge] : result_.domains) {
      Require(drawn <= left, "its domains have more cases than were run");
      left -= drawn;
    }
    Require(left == 0 || result_.domains.empty(), "its domains have fewer cases than were run");
    for (const auto& [drawn, near] : result_.domains) {
      const std::uint64_t most =
          std::max({near.on_edge, near.within_1, near.within_16, near.within_256});
      Require(most <= near.samples && near.samples <= kMostCounted,
              "more of its samples lie near edges than were tested");
    }
  }

  void RequireEnd() const {
    const std::uint64_t given = CasesGiven();
    const std::uint64_t run = result_.cases;
    const bool draws_none = result_.world.empty() && Domains() == 0;
    switch (result_.end) {
      case End::kAllRun:
        Require(run == (draws_none ? 0 : given),
                fmt::format("all run, with {} of its {} cases", run, given));
        break;
      case End::kNotApplicable:
        Require(run == 0, fmt::format("not applicable, with {} cases run", run));
        break;
      case End::kFailed:
      case End::kTimeUp:
      case End::kInterrupted:
      case End::kInconclusive:  // with a case, which is not counted
        Require(run <= given, fmt::format("{} cases run of {}", run, given));
    }
  }

  void RequireFound(const Counterexample& found) const {
    Require(found.outcome != Outcome::kHolds, "it failed, but its outcome is 'holds'");
    Require(found.verdict.outcome == Outcome::kViolated,
            "it failed, but its case is not said to violate it");
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
  const PropertyResult& result_;
  const SubjectInfo& info_;
};

}  // namespace

void RequireSound(const SubjectPart& part, const SubjectInfo& info) {
  for (const PropertyResult& test : part.tests) TestCheck(part, test, info).All();
}

}  // namespace rasterproof::tool
