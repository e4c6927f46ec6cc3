#include "props/compare/yardsticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include "exact/coverage.h"
#include "exact/sample_frame.h"
#include "legal/allowed.h"
#include "model/segment_distance.h"
#include "props/infer/observer.h"
#include "props/judging/as_shown.h"
#include "props/judging/legal_counts.h"
#include "props/run/description.h"
#include "props/run/submit.h"

namespace rasterproof::props {
namespace {

// Of one case: more would cost more than they tell.
constexpr std::size_t kMostMeasured = 64;

// The profile says something of the case, and the oracle decides it.
constexpr Gate kOwn{.space = Space::kEither,
                    .any_model = true,
                    .judges_shared_edge_samples = true,
                    .asks_oracle = true};
constexpr Gate kReal{.space = Space::kEither, .asks_oracle = true};

// The distance of the sample from the nearest edge of the scene's triangles, in pixels. Corners of
// clip space are divided by their w, which says nothing of a triangle that is not wholly in front
// of the eye.
double DistanceToEdges(const exact::PlacedScene& placed, const exact::SampleFrame& frame,
                       const CoverageCounts& shape, std::size_t at) {
  const auto samples = static_cast<std::size_t>(shape.samples);
  const auto width = static_cast<std::size_t>(shape.width);
  const std::size_t pixel = at / samples;
  const Point2 p =
      frame.At(static_cast<int>(pixel % width), static_cast<int>(pixel / width), at % samples);
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : placed.placed.triangles) {
    const auto v = exact::ScreenTriangle(placed.placed, t, frame);
    if (!v) continue;
    std::array<Point2, 3> corners;
    bool is_in_front = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex& one = (*v)[k];
      is_in_front = is_in_front && one.w > 0;
      corners[k] = {one.x / one.w, one.y / one.w};
    }
    if (is_in_front) least = std::min(least, BoundaryDistance(corners, p));
  }
  return least;
}

Description AsComparedOn(const PlacedCase& c, const Description& subject) {
  return c.before ? AsJudged(subject) : subject;
}

// Whether counts above one are shown as they are.
bool ShowsCounts(const SubjectInfo& info, const PlacedCase& c) {
  const bool counts =
      info.coverage == CoverageKind::kFacingCounts || info.coverage == CoverageKind::kCounts;
  return counts || (c.stated.freedom.IsNone() && !IsJudgedAsShown(info, c.scene));
}

}  // namespace

std::vector<std::size_t> WrongSamples(const CoverageCounts& drawn, const CoverageCounts& truth,
                                      bool counts) {
  std::vector<std::size_t> wrong;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const bool is_right = counts
                              ? drawn.front[k] == truth.front[k] && drawn.back[k] == truth.back[k]
                              : (drawn.Count(k) != 0) == (truth.Count(k) != 0);
    if (!is_right) wrong.push_back(k);
  }
  return wrong;
}

Answers AnswersTo(Subject& subject, const PlacedCase& c, std::vector<DrawQuestion> draws) {
  Check check;
  check.questions.draws = std::move(draws);
  const Request request{&c, &check, nullptr};
  return std::move(Submit(subject, {&request, 1}).front());
}

std::string WhyNotCompared(const Gate& gate, const Description& subject, const PlacedCase& c) {
  if (const auto verdict = FlatnessNotDecided(c, false)) return verdict->message;
  if (const auto verdict = Refusal(gate, subject, c)) return verdict->message;
  return "";
}

Reading Measured(const PlacedCase& c, const CoverageCounts& drawn, std::vector<std::size_t> wrong) {
  Reading reading{.wrong = std::move(wrong)};
  if (reading.wrong.empty()) return reading;
  const exact::SampleFrame frame(c.scene, c.profile, c.options);
  for (std::size_t k = 0; k < std::min(reading.wrong.size(), kMostMeasured); ++k) {
    const double distance = DistanceToEdges(c, frame, drawn, reading.wrong[k]);
    if (std::isfinite(distance)) reading.furthest = std::max(reading.furthest, distance);
  }
  return reading;
}

Profile RealProfileOf(const Profile& own) {
  Profile real;
  real.pattern = own.pattern;
  real.y_axis = own.y_axis;
  real.culls = own.culls;
  real.coordinate_limit = std::numeric_limits<double>::max();
  if (own.tie_rule.IsConsistent()) real.tie_rule = own.tie_rule;
  return real;
}

Yardstick OwnModel(const Description& subject) {
  return [subject](const CaseAtHand& at) -> Judging {
    const PlacedCase& c = at.placed();
    if (std::string why = WhyNotCompared(kOwn, AsComparedOn(c, subject), c); !why.empty()) {
      return {std::move(why)};
    }
    const Comparison comparison = ComparisonOf(c, subject.info, c.options);
    const legal::Allowed allowed(c, comparison.sight, c.options);
    if (!allowed.why_not().empty()) return {allowed.why_not()};
    return {"", [allowed, &c](const Drawn& drawn) {
              const CoverageCounts& counts = drawn.drawing->counts;
              return Measured(c, counts, allowed.Wrong(counts));
            }};
  };
}

// A snap can turn a triangle over: by facing, two drawings of real geometry are not comparable.
Yardstick RealGeometry(const Description& subject) {
  return [subject](const CaseAtHand& at) -> Judging {
    Case unsnapped = at.placed().Value();
    unsnapped.profile = RealProfileOf(at.placed().stated);
    const auto real = std::make_shared<const PlacedCase>(unsnapped);
    Description without = AsComparedOn(at.placed(), subject);
    without.info.profile = unsnapped.profile;
    if (std::string why = WhyNotCompared(kReal, without, *real); !why.empty()) {
      return {std::move(why)};
    }
    const bool counts = ShowsCounts(subject.info, at.placed());
    return {"", [real, counts](const Drawn& drawn) {
              CoverageCounts truth = exact::Coverage(*real, real->options);
              CoverageCounts joined = drawn.drawing->counts;
              JoinFacings(truth);
              JoinFacings(joined);
              return Measured(*real, joined, WrongSamples(joined, truth, counts));
            }};
  };
}

Yardstick AnotherSubject(const Description& subject, Subject& other) {
  return [subject, &other](const CaseAtHand& at) -> Judging {
    const SubjectInfo& info = other.Info();
    const PlacedCase& c = at.placed();
    if (!Takes(info, c.scene) || info.profile.pattern.samples() != c.profile.pattern.samples()) {
      return {info.name + " does not take such cases"};
    }
    const bool counts = ShowsCounts(subject.info, c) && ShowsCounts(info, c);
    return {"", [subject, &other, &c, counts](const Drawn& drawn) -> Reading {
              const Drawn others = DrawToJudge(other, subject, c);
              if (others.end.stop != Stop::kNone) {
                return {.end = {Stop::kNotDrawable, other.Info().name + ": " + others.end.why}};
              }
              CoverageCounts one = drawn.drawing->counts;
              CoverageCounts two = others.drawing->counts;
              JoinFacings(one);
              JoinFacings(two);
              return Measured(c, one, WrongSamples(one, two, counts));
            }};
  };
}

Drawn DrawToJudge(Subject& subject, const Description& description, const PlacedCase& c) {
  Answers answers = AnswersTo(subject, c, {ComparisonOf(c, description.info, c.options).question});
  if (answers.end.stop != Stop::kNone) return {std::move(answers.end), nullptr};
  return {{}, std::move(answers.draws.front())};
}

}  // namespace rasterproof::props
