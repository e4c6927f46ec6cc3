#include "props/catalogue/catalogue.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/coverage.h"
#include "core/question.h"
#include "exact/coverage.h"
#include "exact/sample_frame.h"
#include "legal/allowed.h"
#include "model/segment_distance.h"
#include "props/infer/observer.h"
#include "props/judging/as_shown.h"
#include "props/judging/gate.h"
#include "props/judging/legal_counts.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/run/description.h"
#include "props/run/property_domains.h"
#include "props/run/submit.h"

namespace rasterproof::props {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kMostStops = 4;
// Most worlds have small scenes: one is drawn if it has at most this many times the cases of a
// domain.
constexpr std::uint64_t kMostOfWorld = 100;
// A cell in which no case fails is excused if it has more excused cases than this for each other.
constexpr std::uint64_t kMostExcusedForEach = 20;
// Of one case: more would cost more than they tell.
constexpr std::size_t kMostMeasured = 64;

// What the own model is compared under: the profile says something of the case, and the oracle
// decides it.
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

class Measuring {
 public:
  Measuring(Subject& subject, const Family& family, const CataloguePlan& plan)
      : subject_(subject), family_(family), plan_(plan), description_(DescriptionOf(subject)) {
    result_.family = family.name;
  }

  FamilyResult Run() {
    const Clock::time_point began = Clock::now();
    const auto since = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
    if (const std::string why = WhyNotDrawn(); !why.empty()) {
      for (FamilyCell& cell : result_.cells) Excuse(cell, why);
      return std::move(result_);
    }
    const std::uint64_t cases = family_.world != nullptr ? family_.world->cases : plan_.cases;
    std::uint64_t done = 0;
    for (; done < cases && stops_ < kMostStops; ++done) {
      if ((plan_.seconds > 0 && since() >= plan_.seconds) || (plan_.stop && plan_.stop())) break;
      Take(CaseOf(done));
    }
    for (FamilyCell& cell : result_.cells) {
      cell.is_exhausted = family_.world != nullptr && cell.cases == cases;
      ExcuseIfFew(cell);
    }
    result_.seconds = since();
    return std::move(result_);
  }

 private:
  FamilyCell& By(Yardstick yardstick) { return result_.cells[static_cast<std::size_t>(yardstick)]; }

  static void Excuse(FamilyCell& cell, const std::string& why) {
    if (cell.excused++ == 0 && cell.why.empty()) cell.why = why;
  }

  // Hardly any case was compared, and under another seed none might be.
  static void ExcuseIfFew(FamilyCell& cell) {
    if (cell.Fails() || cell.excused <= kMostExcusedForEach * cell.cases) return;
    cell.excused += std::exchange(cell.cases, 0);
    cell.samples = 0;
  }

  std::string WhyNotDrawn() const {
    const SubjectInfo& info = description_.info;
    if (const Domain* domain = family_.domain; domain != nullptr) {
      if (domain->is_stated != nullptr && !domain->is_stated(info.profile)) {
        return "the profile states nothing that the family is about";
      }
      return Suits(*domain, info) ? "" : "the subject takes none of the family's scenes";
    }
    if ((family_.world->cases - 1) / kMostOfWorld >= plan_.cases) {
      return "the world has " + std::to_string(family_.world->cases) + " cases, more than " +
             std::to_string(kMostOfWorld) + " times as many as a domain is given";
    }
    if (family_.world->pixels > plan_.most_pixels) {
      return "the world's targets are larger than the report draws: check --catalogue draws them";
    }
    return WhyNotGiven(*family_.world, info);
  }

  Case CaseOf(std::uint64_t index) const {
    Case c = family_.domain != nullptr
                 ? DrawCase(description_.info, {std::string(family_.name), index, plan_.seed})
                 : DrawCase(description_.info, NameOfCase(*family_.world, index));
    c.options = {};
    return c;
  }

  void Take(const Case& given) {
    const PlacedCase own = Place(given, false);
    const Description& subject = own.before ? AsJudged(description_) : description_;
    Case unsnapped = own.Value();
    unsnapped.profile = RealProfileOf(own.stated);
    const PlacedCase real(unsnapped);
    Description without = subject;
    without.info.profile = unsnapped.profile;
    std::string why_not_own = WhyNotCompared(kOwn, subject, own);
    const std::string why_not_real = WhyNotCompared(kReal, without, real);
    Comparison comparison = ComparisonOf(own, description_.info, own.options);
    std::optional<legal::Allowed> allowed;
    if (why_not_own.empty()) {
      allowed.emplace(own, comparison.sight, own.options);
      why_not_own = allowed->why_not();
    }
    if (!why_not_own.empty()) Excuse(By(Yardstick::kOwnModel), why_not_own);
    if (!why_not_real.empty()) Excuse(By(Yardstick::kRealGeometry), why_not_real);
    if (!why_not_own.empty() && !why_not_real.empty()) return;
    const Answers answers = Draw(own, std::move(comparison.question));
    if (answers.end.stop != Stop::kNone) {
      return Ended(answers.end, given, why_not_own.empty(), why_not_real.empty());
    }
    const CoverageCounts& drawn = answers.draws.front()->counts;
    if (why_not_own.empty())
      Add(By(Yardstick::kOwnModel), own, allowed->Wrong(drawn), drawn, given);
    if (why_not_real.empty()) CompareWithReal(real, drawn, given);
  }

  static std::string WhyNotCompared(const Gate& gate, const Description& subject,
                                    const PlacedCase& c) {
    if (const auto verdict = FlatnessNotDecided(c, false)) return verdict->message;
    if (const auto verdict = Refusal(gate, subject, c)) return verdict->message;
    return "";
  }

  Answers Draw(const PlacedCase& c, DrawQuestion question) {
    Check check;
    check.questions.draws = {std::move(question)};
    const Request request{&c, &check, nullptr};
    return std::move(Submit(subject_, {&request, 1}).front());
  }

  void Ended(const CallEnd& end, const Case& given, bool by_own, bool by_real) {
    for (const auto yardstick : {Yardstick::kOwnModel, Yardstick::kRealGeometry}) {
      if (!(yardstick == Yardstick::kOwnModel ? by_own : by_real)) continue;
      FamilyCell& cell = By(yardstick);
      if (!IsBreakdown(end.stop)) {
        Excuse(cell, end.why);
        continue;
      }
      ++cell.cases;
      if (cell.wrong++ == 0 || std::isfinite(cell.worst_pixels)) {
        cell.worst = given;
        cell.why = end.why;
      }
      cell.worst_pixels = std::numeric_limits<double>::infinity();
    }
    if (end.stop != Stop::kRefused && end.stop != Stop::kNotDrawable) ++stops_;
  }

  // Whether counts above one are shown as one.
  bool ShowsCounts(const PlacedCase& c) const {
    const SubjectInfo& info = description_.info;
    const bool counts =
        info.coverage == CoverageKind::kFacingCounts || info.coverage == CoverageKind::kCounts;
    return counts || (c.stated.freedom.IsNone() && !IsJudgedAsShown(info, c.scene));
  }

  // A snap can turn a triangle over: by facing, two drawings of real geometry are not comparable.
  void CompareWithReal(const PlacedCase& real, const CoverageCounts& drawn, const Case& given) {
    CoverageCounts truth = exact::Coverage(real, real.options);
    CoverageCounts joined = drawn;
    JoinFacings(truth);
    JoinFacings(joined);
    Add(By(Yardstick::kRealGeometry), real, WrongSamples(joined, truth, ShowsCounts(real)), drawn,
        given);
  }

  static std::vector<std::size_t> WrongSamples(const CoverageCounts& drawn,
                                               const CoverageCounts& truth, bool counts) {
    std::vector<std::size_t> wrong;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      const bool is_right = counts
                                ? drawn.front[k] == truth.front[k] && drawn.back[k] == truth.back[k]
                                : (drawn.Count(k) != 0) == (truth.Count(k) != 0);
      if (!is_right) wrong.push_back(k);
    }
    return wrong;
  }

  void Add(FamilyCell& cell, const PlacedCase& c, const std::vector<std::size_t>& wrong,
           const CoverageCounts& drawn, const Case& given) const {
    ++cell.cases;
    cell.samples += drawn.size();
    cell.wrong_samples += wrong.size();
    if (wrong.empty()) return;
    ++cell.wrong;
    double furthest = 0;
    const exact::SampleFrame frame(c.scene, c.profile, c.options);
    for (std::size_t k = 0; k < std::min(wrong.size(), kMostMeasured); ++k) {
      const double distance = DistanceToEdges(c, frame, drawn, wrong[k]);
      if (std::isfinite(distance)) furthest = std::max(furthest, distance);
    }
    if (!cell.worst || furthest > cell.worst_pixels) {
      cell.worst = given;
      cell.worst_pixels = furthest;
    }
  }

  Subject& subject_;
  const Family& family_;
  const CataloguePlan& plan_;
  Description description_;
  FamilyResult result_;
  std::uint64_t stops_ = 0;
};

}  // namespace

Profile RealProfileOf(const Profile& own) {
  Profile real;
  real.pattern = own.pattern;
  real.y_axis = own.y_axis;
  real.culls = own.culls;
  real.coordinate_limit = std::numeric_limits<double>::max();
  if (own.tie_rule.IsConsistent()) real.tie_rule = own.tie_rule;
  return real;
}

FamilyResult MeasureFamily(Subject& subject, const Family& family, const CataloguePlan& plan) {
  return Measuring(subject, family, plan).Run();
}

}  // namespace rasterproof::props
