#include "props/judging/values/stepping.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/one_by_one.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

constexpr int kSteppingTriangles = 2;
constexpr int kLongRowTriangles = 1;
constexpr std::array<int, 4> kLengths{1, 2, 8, 16};
// Every step of a short stepping is looked at; of a long one the first ones and then an even
// spread, its end included. A wrong step shifts all that follow, so little can hide in between.
constexpr int kLookedAtFirst = 32;
constexpr int kLookedAtInAll = 256;

bool IsLookedAt(int n, int steps) {
  if (n <= kLookedAtFirst || n == steps || steps <= kLookedAtInAll) return true;
  return n % (steps / (kLookedAtInAll - kLookedAtFirst)) == 0;
}

// Steps that keep the stepping within the profile's limit.
int WithinLimit(const PlacedCase& c, Point2 from, Step step, int wanted) {
  const double start = step.along_y ? from.y : from.x;
  const double room = c.profile.coordinate_limit - step.sign * start;
  const double steps = std::floor(room / step.length);
  return steps >= wanted ? wanted : std::max(0, static_cast<int>(steps));
}

void AddStepping(const PlacedCase& c, const EdgeQuery& from, Step step, int wanted,
                 std::vector<SteppingQuery>& steppings) {
  const int steps = WithinLimit(c, from.place.at, step, wanted);
  if (steps > 0) steppings.push_back({from, step, steps});
}

Verdict WithinItsBound(const SteppingQuery& stepping, const std::vector<double>& values,
                       const std::vector<double>& bounds) {
  if (auto wrong = WrongLength(stepping, values.size(), bounds.size())) return *wrong;
  const EdgeQuery& q = stepping.from;
  std::uint64_t exercised = 0;
  double worst = 0;
  for (int n = 0; n <= stepping.steps; ++n) {
    const auto k = static_cast<std::size_t>(n);
    if (!IsLookedAt(n, stepping.steps) || !IsStated(bounds[k])) continue;
    ++exercised;
    const Point2 p = AfterSteps(stepping, n);
    const Distance distance = CompareWithEdge(values[k], q.a, q.b, p, bounds[k]);
    if (!distance.within) {
      return EdgeViolation(q, exercised,
                           "stepping outside its proven bound " + StepsText(stepping, n),
                           {values[k]}, {"E = ", ExactEdge(q.a, q.b, p), " within ", bounds[k]});
    }
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

// A stepping with the bounds that the subject states on its values.
struct BoundedStepping {
  SteppingQuery stepping;
  std::vector<double> bounds;
};

Verdict AllWithinTheirBounds(const std::vector<BoundedStepping>& steppings,
                             const Answers& answers) {
  return OneByOne(steppings.size(), [&](std::size_t k) {
    return WithinItsBound(steppings[k].stepping, answers.steps[k], steppings[k].bounds);
  });
}

}  // namespace

Point2 AfterSteps(const SteppingQuery& stepping, int n) {
  Point2 p = stepping.from.place.at;
  const double distance = double{1} * stepping.step.sign * stepping.step.length * n;
  (stepping.step.along_y ? p.y : p.x) += distance;
  return p;
}

std::vector<SteppingQuery> SomeSteppingQueries(const PlacedCase& c) {
  constexpr int kLongestShortStepping = 64;
  std::vector<SteppingQuery> steppings;
  for (const CornersPlace& corners : SomeTriangles(c, kSteppingTriangles)) {
    const std::vector<SamplePlace> places = SamplesNearEdges(c, corners.at, 1);
    for (int i = 0; i < 3; ++i) {
      const SamplePlace& place = places[static_cast<std::size_t>(i) % places.size()];
      const EdgeQuery from{corners.triangle, i, EdgeStart(corners.at, i), EdgeEnd(corners.at, i),
                           place};
      for (const bool along_y : {false, true}) {
        const int side = along_y ? c.scene.height : c.scene.width;
        for (const int sign : {+1, -1}) {
          for (const int length : kLengths) {
            AddStepping(c, from, {along_y, sign, length},
                        std::clamp(side / length, 2, kLongestShortStepping), steppings);
          }
        }
      }
    }
  }
  return steppings;
}

std::vector<SteppingQuery> LongRows(const PlacedCase& c, int steps) {
  // Two along x, either way, and one along y.
  constexpr std::array<Step, 3> kSteps{{{false, +1, 1}, {false, -1, 1}, {true, +1, 1}}};
  std::vector<SteppingQuery> steppings;
  for (const CornersPlace& corners : SomeTriangles(c, kLongRowTriangles)) {
    // Some bits of the case choose, so that over many cases every edge and step has its turn.
    const Point2& v = corners.at[0];
    const std::uint64_t bits =
        std::bit_cast<std::uint64_t>(v.x) ^ std::bit_cast<std::uint64_t>(v.y);
    const auto choice = (bits ^ (bits >> 32)) % (3 * kSteps.size());
    const int i = static_cast<int>(choice % 3);
    const EdgeQuery from{corners.triangle, i, EdgeStart(corners.at, i), EdgeEnd(corners.at, i),
                         PlaceOf(c, 0, 0, 0)};
    AddStepping(c, from, kSteps[static_cast<std::size_t>(choice / 3)], steps, steppings);
  }
  return steppings;
}

std::string StepsText(const SteppingQuery& stepping, int n) {
  const int stride = stepping.step.sign * stepping.step.length;
  return "after " + std::to_string(n) + " steps of " + std::to_string(stride) + " along " +
         (stepping.step.along_y ? "y" : "x");
}

StepsQuestion StepsOf(const SteppingQuery& stepping) {
  return {stepping.from.a, stepping.from.b, stepping.from.place.at, stepping.step, stepping.steps};
}

std::vector<double> BoundsOf(const SteppingQuery& stepping, const EdgeBounds& bounds) {
  const EdgeQuery& q = stepping.from;
  return bounds.SteppingErrorBounds(q.a, q.b, q.place.at, stepping.step, stepping.steps);
}

std::optional<Verdict> WrongLength(const SteppingQuery& stepping, std::size_t values,
                                   std::size_t bounds) {
  const std::size_t wanted = static_cast<std::size_t>(stepping.steps) + 1;
  if (values == wanted && bounds == wanted) return std::nullopt;
  return EdgeViolation(stepping.from, 1, "a stepping of the wrong length",
                       {std::to_string(values) + " values, " + std::to_string(bounds) + " bounds"},
                       {std::to_string(wanted) + " of each"});
}

Checks StepsStayWithinTheirBound(std::span<const SteppingQuery> steppings,
                                 const EdgeBounds& bounds) {
  if (steppings.empty()) return {};
  Questions questions;
  std::vector<BoundedStepping> bounded;
  for (const SteppingQuery& stepping : steppings) {
    questions.steps.push_back(StepsOf(stepping));
    bounded.push_back({stepping, BoundsOf(stepping, bounds)});
  }
  return OneCheck(std::move(questions), [bounded = std::move(bounded)](const Answers& answers) {
    return AllWithinTheirBounds(bounded, answers);
  });
}

}  // namespace rasterproof::props
