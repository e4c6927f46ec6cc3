#include "props/judging/redraw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "core/profile.h"
#include "core/scene.h"
#include "core/target_size.h"
#include "exact/coverage.h"
#include "legal/allowed.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"
#include "props/judging/gate.h"
#include "props/judging/legal_counts.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// Number of k of [0, size) with k + offset in [low, high].
std::uint64_t SamplesBetween(double low, double high, double offset, int size) {
  const double first = std::max(std::ceil(low - offset), 0.0);
  const double last = std::min(std::floor(high - offset), size - 1.0);
  return last < first ? 0 : static_cast<std::uint64_t>(last - first) + 1;
}

DrawJob JobOf(std::shared_ptr<const Scene> scene, const Profile& profile,
              const DrawOptions& options) {
  DrawJob job(std::move(scene), options, profile.pattern.samples());
  job.wants = kCoverageAndPrimitiveIds;
  return job;
}

}  // namespace

DrawQuestion CountsOf(const Scene& scene, const Profile& profile, const DrawOptions& options) {
  return {JobOf(std::make_shared<const Scene>(scene), profile, options), Parts::kFacings};
}

DrawQuestion CountsOfOne(const std::shared_ptr<const Scene>& scene, std::size_t t,
                         const Profile& profile, const DrawOptions& options) {
  DrawJob job = JobOf(scene, profile, options);
  job.triangles = {{scene->triangles[t]}};
  return {std::move(job), Parts::kFacings};
}

DrawQuestion WholeCallOf(const Scene& scene, const Profile& profile, const DrawOptions& options) {
  return {JobOf(std::make_shared<const Scene>(scene), profile, options), Parts::kWhole};
}

Check BaseDraw(DrawQuestion question) {
  Check check;
  check.questions.draws.push_back(std::move(question));
  check.judge = [](const Answers&) { return Verdict::Held(0); };
  return check;
}

Check CheckAgainstBase(
    DrawQuestion question,
    std::function<Verdict(const CoverageCounts& observed, const CoverageCounts& base)> judge) {
  Check check;
  check.questions.draws.push_back(std::move(question));
  check.bases = {0};
  check.judge = [judge = std::move(judge)](const Answers& answers) {
    return OfDraw(1, judge(answers.draws[1]->counts, answers.draws[0]->counts));
  };
  return check;
}

Checks CompareVariations(const PlacedCase& c, const std::vector<Variation>& variations,
                         const OpenByCall& open) {
  Checks asked;
  for (const Variation& variation : variations) {
    Check check;
    // The case itself is drawn once, with the first of them.
    if (asked.checks.empty()) {
      check.questions.draws.push_back(WholeCallOf(c.scene, c.profile, WholeTarget(c)));
    } else {
      check.bases = {0};
    }
    check.questions.draws.push_back(WholeCallOf(variation.scene, c.profile, WholeTarget(c)));
    check.judge = [&c, open, property = variation.property](const Answers& answers) {
      const CoverageCounts& observed = answers.draws[1]->counts;
      return OfDraw(1, SameCounts(observed, open.Expected(observed, answers.draws[0]->counts),
                                  open.Judged(DecisionsOf(c)), property));
    };
    asked.checks.push_back(std::move(check));
  }
  return asked;
}

bool HasTheModelOf(const PlacedCase& c, int width, int height) {
  return IsTargetSize(width, height, c.profile.pattern.samples()) &&
         c.stated.max_target.Holds(width, height) &&
         TargetProfile(c.stated, width, height) == c.profile;
}

std::uint64_t DecisionsOf(const PlacedCase& c) {
  // As far as a vertex may go to its grid point.
  const double step = c.profile.snap.IsNone() ? 0 : std::ldexp(1.0, -c.profile.snap.bits);
  std::uint64_t decisions = 0;
  std::optional<Scene> wrapped;
  if (!IsUnwrapped(c.scene, c.profile)) {
    Profile fixed_alone;
    fixed_alone.fixed = c.profile.fixed;
    wrapped = SnapScene(c.scene, {fixed_alone, c.scene});
  }
  const Scene& scene = wrapped ? *wrapped : c.scene;
  for (const Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> v = Corners(scene, t);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    if (c.scene.clip_space) {
      decisions += CoverageCounts::Size(c.scene.width, c.scene.height, c.profile.pattern.samples());
      continue;
    }
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [low, high] = std::minmax({v[0].y, v[1].y, v[2].y});
    // With y up rows are counted from below, and samples lie as far above their pixel's lower side.
    for (const Point2& at : c.profile.pattern.locations) {
      decisions += SamplesBetween(left - step, right + step, at.x, c.scene.width) *
                   SamplesBetween(low - step, high + step, at.y, c.scene.height);
    }
  }
  return decisions;
}

CoverageCounts CoverageUnder(const PlacedCase& c, const TieRule& rule, const DrawOptions& options) {
  exact::PlacedScene scene = c;
  scene.profile.tie_rule = rule;
  return exact::Coverage(scene, options);
}

CoverageCounts CutTo(const PixelRect& rect, const CoverageCounts& whole) {
  CoverageCounts part(whole.width, whole.height, whole.samples);
  for (int row = rect.y0; row < rect.y1; ++row) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      for (int s = 0; s < whole.samples; ++s) {
        const std::size_t k = whole.Index(x, row, s);
        part.front[k] = whole.front[k];
        part.back[k] = whole.back[k];
      }
    }
  }
  return part;
}

Verdict OfDraw(std::size_t draw, Verdict verdict) {
  if (verdict.outcome == Outcome::kViolated) verdict.failed_draw = draw;
  return verdict;
}

Verdict SameCounts(const CoverageCounts& observed, const CoverageCounts& expected,
                   std::uint64_t exercised, const std::string& property) {
  const CoverageDifference difference = Compare(observed, expected);
  if (difference.wrong == 0) return Verdict::Held(exercised);
  Verdict verdict = Verdict::Violated(std::max<std::uint64_t>(exercised, 1),
                                      "coverage differs from " + property + " at " +
                                          std::to_string(difference.wrong) + " of " +
                                          std::to_string(difference.samples) + " samples",
                                      WitnessOfCounts(observed, expected, difference.first_wrong));
  if (observed.size() <= kMostCompared)
    verdict.compared = std::make_shared<ComparedCounts>(observed, expected);
  return verdict;
}

Checks CompareWithTheModel(const PlacedCase& c, const Description& subject) {
  Comparison comparison = ComparisonOf(c, subject.info, c.options);
  Questions questions;
  questions.draws.push_back(std::move(comparison.question));
  return OneCheck(std::move(questions), [&c, sight = comparison.sight](const Answers& answers) {
    const legal::Allowed allowed(c, sight, c.options);
    if (!allowed.why_not().empty()) return Verdict::NotApplicable(allowed.why_not());
    return AsAllowed(allowed, answers.draws[0]->counts, DecisionsOf(c));
  });
}

}  // namespace rasterproof::props
