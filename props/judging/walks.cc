#include "props/judging/walks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "props/judging/exact_comparison.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

constexpr int kTriangles = 2;
constexpr int kLongWalkTriangles = 1;
constexpr std::array<int, 4> kLengths{1, 2, 8, 16};
// Every step of a short walk is looked at; of a long one the first ones and then an even spread,
// its end included. A wrong step shifts all that follow, so little can hide in between.
constexpr int kLookedAtFirst = 32;
constexpr int kLookedAtInAll = 256;

bool IsLookedAt(int n, int steps) {
  if (n <= kLookedAtFirst || n == steps || steps <= kLookedAtInAll) return true;
  return n % (steps / (kLookedAtInAll - kLookedAtFirst)) == 0;
}

// Steps that keep the walk within the profile's limit.
int WithinLimit(const Case& c, Point2 from, Step step, int wanted) {
  const double start = step.along_y ? from.y : from.x;
  const double room = c.profile.coordinate_limit - step.sign * start;
  const double steps = std::floor(room / step.length);
  return steps >= wanted ? wanted : std::max(0, static_cast<int>(steps));
}

void AddWalk(const Case& c, const EdgeQuery& from, Step step, int wanted,
             std::vector<WalkQuery>& walks) {
  const int steps = WithinLimit(c, from.place.at, step, wanted);
  if (steps > 0) walks.push_back({from, step, steps});
}

Verdict WithinItsBound(const WalkQuery& walk, const std::vector<double>& values,
                       const std::vector<double>& bounds) {
  if (auto wrong = WrongLength(walk, values.size(), bounds.size())) return *wrong;
  const EdgeQuery& q = walk.from;
  std::uint64_t exercised = 0;
  double worst = 0;
  for (int n = 0; n <= walk.steps; ++n) {
    const auto k = static_cast<std::size_t>(n);
    if (!IsLookedAt(n, walk.steps) || !Claims(bounds[k])) continue;
    ++exercised;
    const Point2 p = AfterSteps(walk, n);
    const Distance distance = CompareWithEdge(values[k], q.a, q.b, p, bounds[k]);
    if (!distance.within) {
      return EdgeViolation(q, exercised, "walk outside its proven bound " + StepsText(walk, n),
                           HexText(values[k]),
                           ExactEdgeText(q.a, q.b, p) + " within " + HexText(bounds[k]));
    }
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

}  // namespace

Point2 AfterSteps(const WalkQuery& walk, int n) {
  Point2 p = walk.from.place.at;
  const double distance = double{1} * walk.step.sign * walk.step.length * n;
  (walk.step.along_y ? p.y : p.x) += distance;
  return p;
}

std::vector<WalkQuery> SomeWalks(const Case& c) {
  constexpr int kLongestShortWalk = 64;
  std::vector<WalkQuery> walks;
  for (const CornersPlace& corners : SomeTriangles(c, kTriangles)) {
    const std::vector<SamplePlace> places = SamplesNearEdges(c, corners.at, 1);
    for (int i = 0; i < 3; ++i) {
      const SamplePlace& place = places[static_cast<std::size_t>(i) % places.size()];
      const EdgeQuery from{corners.triangle, i, EdgeStart(corners.at, i), EdgeEnd(corners.at, i),
                           place};
      for (const bool along_y : {false, true}) {
        const int side = along_y ? c.scene.height : c.scene.width;
        for (const int sign : {+1, -1}) {
          for (const int length : kLengths) {
            AddWalk(c, from, {along_y, sign, length},
                    std::clamp(side / length, 2, kLongestShortWalk), walks);
          }
        }
      }
    }
  }
  return walks;
}

std::vector<WalkQuery> LongWalks(const Case& c, int steps) {
  // Two along x, either way, and one along y.
  constexpr std::array<Step, 3> kSteps{{{false, +1, 1}, {false, -1, 1}, {true, +1, 1}}};
  std::vector<WalkQuery> walks;
  for (const CornersPlace& corners : SomeTriangles(c, kLongWalkTriangles)) {
    // Some bits of the case choose, so that over many cases every edge and step has its turn.
    const Point2& v = corners.at[0];
    const std::uint64_t bits =
        std::bit_cast<std::uint64_t>(v.x) ^ std::bit_cast<std::uint64_t>(v.y);
    const auto choice = (bits ^ (bits >> 32)) % (3 * kSteps.size());
    const int i = static_cast<int>(choice % 3);
    const EdgeQuery from{corners.triangle, i, EdgeStart(corners.at, i), EdgeEnd(corners.at, i),
                         PlaceOf(c, 0, 0, 0)};
    AddWalk(c, from, kSteps[choice / 3], steps, walks);
  }
  return walks;
}

std::string StepsText(const WalkQuery& walk, int n) {
  const int stride = walk.step.sign * walk.step.length;
  return "after " + std::to_string(n) + " steps of " + std::to_string(stride) + " along " +
         (walk.step.along_y ? "y" : "x");
}

StepsQuestion StepsOf(const WalkQuery& walk) {
  return {walk.from.a, walk.from.b, walk.from.place.at, walk.step, walk.steps};
}

std::vector<double> BoundsOf(const WalkQuery& walk, const EdgeBounds& bounds) {
  const EdgeQuery& q = walk.from;
  return bounds.WalkErrorBounds(q.a, q.b, q.place.at, walk.step, walk.steps);
}

std::optional<Verdict> WrongLength(const WalkQuery& walk, std::size_t values, std::size_t bounds) {
  const std::size_t wanted = static_cast<std::size_t>(walk.steps) + 1;
  if (values == wanted && bounds == wanted) return std::nullopt;
  return EdgeViolation(walk.from, 1, "a walk of the wrong length",
                       std::to_string(values) + " values, " + std::to_string(bounds) + " bounds",
                       std::to_string(wanted) + " of each");
}

Asked WalksStayWithinTheirBound(std::span<const WalkQuery> walks, const EdgeBounds& bounds) {
  Asked asked;
  for (const WalkQuery& walk : walks) {
    Check check;
    check.questions.steps.push_back(StepsOf(walk));
    check.judge = [walk, claimed = BoundsOf(walk, bounds)](const Answers& answers) {
      return WithinItsBound(walk, answers.steps[0], claimed);
    };
    asked.checks.push_back(std::move(check));
  }
  return asked;
}

}  // namespace rasterproof::props
