#include "props/judging/squares.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/scene.h"
#include "core/square_rule.h"
#include "exact/coverage.h"
#include "exact/square_coverage.h"
#include "props/judging/as_shown.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kMostSingles = 64;

// How many squares the triangles of a case touch as they are given.
std::uint64_t TouchedSquares(PlacedCase c) {
  c.profile.freedom = {};
  c.profile.culls = Cull::kNone;
  c.profile.squares =
      SquareRule{.must = std::nullopt, .may = SquareRegion{}, .flat = FlatSquares::kDrawn};
  const CoverageCounts touched = exact::MayCover(c, WholeTarget(c));
  std::uint64_t squares = 0;
  for (std::size_t k = 0; k < touched.size(); ++k) squares += touched.Count(k) != 0 ? 1 : 0;
  return squares;
}

// A triangle that may cover no square was exercised at the squares that it touches.
Verdict ComparedToNone(const Verdict& verdict, MayBe allowed, const PlacedCase& one) {
  const bool is_none = allowed == MayBe::kLess && verdict.outcome == Outcome::kNotExercised;
  return is_none ? Verdict::Held(TouchedSquares(one)) : verdict;
}

}  // namespace

Verdict ComparedTo(const CoverageCounts& observed, const CoverageCounts& expected, MayBe allowed,
                   std::string_view message) {
  std::uint64_t exercised = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const std::uint32_t want = expected.Count(k);
    const std::uint32_t seen = observed.Count(k);
    if (want != 0 || seen != 0) ++exercised;
    if (allowed == MayBe::kMore ? seen >= want : seen <= want) continue;
    return Verdict::Violated(exercised, std::string(message),
                             WitnessOfCounts(observed, expected, k));
  }
  return Verdict::Held(exercised);
}

Checks CompareEachAndAll(const PlacedCase& c, const Description& subject, MayBe allowed,
                         std::string_view message,
                         CoverageCounts (*expected)(const PlacedCase& of,
                                                    const DrawOptions& options)) {
  Checks asked;
  const auto scene = std::make_shared<const Scene>(c.scene);
  for (std::size_t t = 0; t < std::min(kMostSingles, c.scene.triangles.size()); ++t) {
    Check check;
    check.questions.draws.push_back(CountsOfOne(scene, t, c.profile, WholeTarget(c)));
    check.judge = [&c, t, allowed, message, expected](const Answers& answers) {
      const PlacedCase one = c.Only({t});
      Verdict verdict =
          ComparedTo(answers.draws[0]->counts, expected(one, WholeTarget(c)), allowed, message);
      verdict = ComparedToNone(verdict, allowed, one);
      if (verdict.witness) verdict.witness->triangle = static_cast<int>(t);
      return verdict;
    };
    asked.checks.push_back(std::move(check));
  }
  Check mesh;
  mesh.questions.draws.push_back(CountsOf(c.scene, c.profile, WholeTarget(c)));
  mesh.judge = [&c, allowed, message, expected,
                as_shown = IsJudgedAsShown(subject.info, c.scene)](const Answers& answers) {
    CoverageCounts truth = expected(c, WholeTarget(c));
    if (as_shown) truth = AsShown(std::move(truth));
    return ComparedTo(answers.draws[0]->counts, truth, allowed, message);
  };
  asked.checks.push_back(std::move(mesh));
  return asked;
}

CoverageCounts CentresOf(const PlacedCase& c, const DrawOptions& options) {
  Profile centres;
  centres.y_axis = c.profile.y_axis;
  const CoverageCounts once = exact::Coverage(c.scene, centres, options);
  CoverageCounts counts(once.width, once.height, c.profile.pattern.samples());
  const auto samples = static_cast<std::size_t>(counts.samples);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    counts.front[k] = once.front[k / samples];
    counts.back[k] = once.back[k / samples];
  }
  return counts;
}

}  // namespace rasterproof::props
