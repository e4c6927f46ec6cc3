#include "props/cause/value_mistakes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "props/cause/investigation.h"
#include "props/judging/values/derivative_queries.h"
#include "props/judging/values/precision_units.h"
#include "props/judging/values/value_queries.h"
#include "props/run/case_order.h"
#include "props/run/description.h"
#include "props/run/judge.h"
#include "props/run/property_domains.h"
#include "props/run/submit.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kCasesTried = 60;
constexpr std::uint64_t kSeedOfMistakes = 3;
constexpr std::uint64_t kFirstTried = std::uint64_t{1} << 21;
// What a mistake computes is rounded as often as what is right, or a few times more.
constexpr double kMistakeConditions = 2 * kUsualConditions;

constexpr int kMostFewBits = 18;  // of float32's 24

using Numbers = std::array<double, 3>;

// One number that is shown, and what it is of.
struct Shown {
  const ShownValues& values;
  const ValueFragment& f;
  const ValueOwners& owners;
  Channel channel;
  Numbers numbers;
  double x = 0;
  int facing = 0;  // of the triangle on the screen
  const RayCorners* other_corners = nullptr;
};

struct Mistake {
  std::string_view name;
  std::string what;
  /// The number that a rasterizer with the mistake shows; nothing where it makes none.
  std::function<std::optional<ValueEstimate>(const Shown&)> shows;
  std::set<std::size_t> cases = {};  // with wrong numbers that it explains
};

Point2 PlaceOf(const Shown& s) { return PlaceOfValue(s.f, s.channel); }

ValueEstimate Estimated(const Shown& s, Interpolation plane, const Numbers& a, Point2 p) {
  return EstimateValue(s.owners.corners.front(), plane, a, p);
}

bool IsInterpolated(const Shown& s) { return s.channel.interpolation != Interpolation::kFlat; }

// sum g_i a_i / sum g_i with g_i = beta_i w_i^power.
ValueEstimate OfPower(const Shown& s, int power) {
  const RayCorners& v = s.owners.corners.front();
  const Numbers g = WeightsOfPower(v, power, PlaceOf(s));
  const double sum = g[0] + g[1] + g[2];
  ValueEstimate e = Estimated(s, Interpolation::kPerspective, s.numbers, PlaceOf(s));
  e.value = (g[0] * s.numbers[0] + g[1] * s.numbers[1] + g[2] * s.numbers[2]) / sum;
  const double size = std::fabs(g[0]) + std::fabs(g[1]) + std::fabs(g[2]);
  e.condition *= 1 + size / std::fabs(sum);
  return e;
}

void AddPlanes(std::vector<Mistake>& list) {
  const auto plane = [](Interpolation stated, Interpolation taken) {
    return [stated, taken](const Shown& s) -> std::optional<ValueEstimate> {
      if (s.channel.interpolation != stated) return std::nullopt;
      return Estimated(s, taken, s.numbers, PlaceOf(s));
    };
  };
  list.push_back({"affine-weights", "interpolates on the screen what is in perspective",
                  plane(Interpolation::kPerspective, Interpolation::kLinear)});
  list.push_back({"affine-weights", "interpolates in perspective what is affine on the screen",
                  plane(Interpolation::kLinear, Interpolation::kPerspective)});
  list.push_back({"affine-weights", "interpolates depth in perspective",
                  plane(Interpolation::kInverseW, Interpolation::kPerspective)});
  list.push_back({"missing-division", "does not divide depth by w",
                  plane(Interpolation::kInverseW, Interpolation::kLinear)});
  list.push_back({"missing-division", "does not divide by the interpolated 1/w",
                  plane(Interpolation::kPerspective, Interpolation::kInverseW)});
  const auto power = [](int of) {
    return [of](const Shown& s) -> std::optional<ValueEstimate> {
      if (s.channel.interpolation != Interpolation::kPerspective) return std::nullopt;
      return OfPower(s, of);
    };
  };
  list.push_back({"weights-by-w", "divides weights by w twice", power(-1)});
  list.push_back({"weights-by-w", "multiplies weights by w instead of dividing", power(2)});
  list.push_back({"weights-by-w", "divides weights by w squared and by w", power(-2)});
}

void AddExchanges(std::vector<Mistake>& list) {
  struct Order {
    std::array<std::size_t, 3> of;
    std::string_view what;
  };
  constexpr std::array<Order, 5> kOrders{{{{1, 0, 2}, "exchanges the first two weights"},
                                          {{0, 2, 1}, "exchanges the last two weights"},
                                          {{2, 1, 0}, "exchanges the first and the last weight"},
                                          {{1, 2, 0}, "gives each weight to the next vertex"},
                                          {{2, 0, 1}, "gives each weight to the vertex before"}}};
  struct Side {
    int facing;
    std::string_view what;
  };
  constexpr std::array<Side, 3> kSides{{{0, ""}, {-1, " of back faces"}, {1, " of front faces"}}};
  for (const Side& side : kSides) {
    for (const Order& order : kOrders) {
      list.push_back(
          {"exchanged-weights", std::string(order.what).append(side.what),
           [order, facing = side.facing](const Shown& s) -> std::optional<ValueEstimate> {
             if (!IsInterpolated(s) || (facing != 0 && s.facing != facing)) return std::nullopt;
             const Numbers& a = s.numbers;
             return Estimated(s, s.channel.interpolation,
                              {a[order.of[0]], a[order.of[1]], a[order.of[2]]}, PlaceOf(s));
           }});
    }
  }
}

void AddPlaces(std::vector<Mistake>& list) {
  const auto at = [](auto place) {
    return [place](const Shown& s) -> std::optional<ValueEstimate> {
      if (!IsInterpolated(s)) return std::nullopt;
      return Estimated(s, s.channel.interpolation, s.numbers, place(s));
    };
  };
  list.push_back({"wrong-place", "evaluates at the pixel's centre",
                  at([](const Shown& s) { return s.f.centre; })});
  struct Move {
    Point2 by;
    std::string_view what;
  };
  for (const Move& move :
       {Move{{-0.5, -0.5}, "half a pixel towards the origin"},
        Move{{0.5, 0.5}, "half a pixel away from the origin"},
        Move{{-0.5, 0}, "half a pixel to the left"}, Move{{0.5, 0}, "half a pixel to the right"},
        Move{{0, -0.5}, "half a pixel before the row"},
        Move{{0, 0.5}, "half a pixel behind the row"}, Move{{1, 0}, "at the next pixel"},
        Move{{-1, 0}, "at the pixel before"}, Move{{0, 1}, "in the next row"},
        Move{{0, -1}, "in the row before"}}) {
    list.push_back({"wrong-place", std::string("evaluates ").append(move.what),
                    at([by = move.by](const Shown& s) {
                      const Point2 p = PlaceOf(s);
                      return Point2{p.x + by.x, p.y + by.y};
                    })});
  }
  list.push_back(
      {"other-corners", "interpolates between the other corners: given, not snapped, or snapped",
       [](const Shown& s) -> std::optional<ValueEstimate> {
         if (!IsInterpolated(s) || s.other_corners == nullptr) return std::nullopt;
         return EstimateValue(*s.other_corners, s.channel.interpolation, s.numbers, PlaceOf(s));
       }});
}

void AddFlat(std::vector<Mistake>& list) {
  constexpr std::array<std::string_view, 3> kVertices{"first", "second", "last"};
  for (std::size_t i = 0; i < 3; ++i) {
    list.push_back(
        {"wrong-provoking-vertex",
         std::string("takes flat values from the ").append(kVertices[i]).append(" vertex"),
         [i](const Shown& s) -> std::optional<ValueEstimate> {
           if (IsInterpolated(s)) return std::nullopt;
           return ValueEstimate{.value = s.numbers[i]};
         }});
  }
  list.push_back({"wrong-provoking-vertex", "interpolates flat values",
                  [](const Shown& s) -> std::optional<ValueEstimate> {
                    if (IsInterpolated(s)) return std::nullopt;
                    return Estimated(s, Interpolation::kPerspective, s.numbers, PlaceOf(s));
                  }});
}

std::vector<Mistake> AllMistakes() {
  std::vector<Mistake> list;
  AddPlanes(list);
  AddExchanges(list);
  AddFlat(list);
  AddPlaces(list);
  return list;
}

enum class Fit : std::uint8_t { kUnknown, kRight, kWrong };

// Whether the number is what is stated.
Fit Stated(const Shown& s) {
  if (s.channel.interpolation == Interpolation::kFlat) {
    const std::size_t k = s.values.rule.provoking == ProvokingVertex::kLast ? 2 : 0;
    return s.x == s.numbers[k] ? Fit::kRight : Fit::kWrong;
  }
  const std::optional<ValueRange> range = RangeOf(s.values, s.f, s.owners, s.channel, s.numbers);
  if (!range) return Fit::kUnknown;
  if (range->SurelyHolds(s.x)) return Fit::kRight;
  return range->SurelyExcludes(s.x) ? Fit::kWrong : Fit::kUnknown;
}

Fit ShownBy(const Mistake& mistake, const Shown& s, Fit stated) {
  const std::optional<ValueEstimate> e = mistake.shows(s);
  if (!e) return stated;  // there it does as is stated
  if (!std::isfinite(e->value) || !std::isfinite(e->condition)) return Fit::kUnknown;
  double tolerance =
      kMistakeConditions * UnitRoundoff(s.values.precision) * (e->condition + std::fabs(e->value));
  if (const auto range = RangeOf(s.values, s.f, s.owners, s.channel, s.numbers))
    tolerance = std::max(tolerance, range->tolerance);
  return std::fabs(s.x - e->value) <= tolerance ? Fit::kRight : Fit::kWrong;
}

// What a search looks at.
enum class NumbersOf : std::uint8_t { kChannels, kBarycentrics, kDepths };

// All numbers of one fragment. 1/w is left out: whether a mistake is in it, too, is another matter.
std::vector<Shown> NumbersOfFragment(const ShownValues& values, const ValueFragment& f,
                                     NumbersOf what) {
  std::vector<Shown> list;
  const ValueOwners& owners = f.readings.front();
  if (what == NumbersOf::kDepths) {
    const Channel channel{"depth", Interpolation::kInverseW};
    return {{values, f, owners, channel, values.DepthsOf(f), values.drawing.depths[f.index]}};
  }
  if (what == NumbersOf::kBarycentrics) {
    const bool is_linear = !values.is_clip_space || values.rule.weights == WeightsIn::kScreen;
    const Channel channel{"barycentric",
                          is_linear ? Interpolation::kLinear : Interpolation::kPerspective};
    for (std::size_t i = 0; i < 3; ++i) {
      Numbers unit{};
      unit[i] = 1;
      list.push_back({values, f, owners, channel, unit, values.drawing.barycentrics[f.index][i]});
    }
    return list;
  }
  for (std::size_t k = 0; k < values.channels.size(); ++k) {
    const Channel& channel = values.channels[k];
    if (channel.interpolation == Interpolation::kInverseW || channel.at == EvaluatedAt::kCentroid)
      continue;
    list.push_back({values, f, owners, channel, NumbersAt(f, channel), values.Of(f, k)});
  }
  return list;
}

// The search: mistakes that no number has refuted yet.
class Search {
 public:
  Search(Subject& subject, NumbersOf what) : subject_(subject), what_(what), left_(AllMistakes()) {}

  void Compare(const Property& property, const Case& c, std::size_t number);
  bool IsOver() const { return is_stopped_; }
  ValueMistake Found() const;

 private:
  void CompareDrawing(const PlacedCase& placed, const DrawJob& job, const Drawing& drawing,
                      std::size_t number);
  void CompareNumber(const Shown& s, std::size_t number);
  void LookAtBits(const Shown& s);

  bool HasThem(const Drawing& drawing) const;

  Subject& subject_;
  NumbersOf what_;
  std::vector<Mistake> left_;
  std::size_t numbers_ = 0;
  std::size_t wrong_ = 0;
  int most_bits_ = 0;    // of all wrong numbers
  double most_off_ = 0;  // relatively
  std::set<std::size_t> wrong_cases_;
  bool is_stopped_ = false;
};

// The bits from the first that is set to the last.
int SignificantBits(double x) {
  constexpr int kBitsOfADouble = 53;
  int exponent = 0;
  auto mantissa =
      static_cast<std::uint64_t>(std::ldexp(std::fabs(std::frexp(x, &exponent)), kBitsOfADouble));
  if (mantissa == 0) return 0;
  int bits = kBitsOfADouble;
  for (; (mantissa & 1U) == 0; mantissa >>= 1U) --bits;
  return bits;
}

void Search::LookAtBits(const Shown& s) {
  if (!IsInterpolated(s) || !std::isfinite(s.x) || std::ranges::count(s.numbers, s.x) != 0) return;
  const double value = Estimated(s, s.channel.interpolation, s.numbers, PlaceOf(s)).value;
  if (!std::isfinite(value) || value == 0) return;
  most_bits_ = std::max(most_bits_, SignificantBits(s.x));
  most_off_ = std::max(most_off_, std::fabs(s.x / value - 1));
}

void Search::CompareNumber(const Shown& s, std::size_t number) {
  const Fit stated = Stated(s);
  if (stated == Fit::kUnknown) return;
  ++numbers_;
  if (stated == Fit::kWrong) {
    ++wrong_;
    wrong_cases_.insert(number);
    LookAtBits(s);
  }
  std::erase_if(left_, [&](Mistake& mistake) {
    const Fit fit = ShownBy(mistake, s, stated);
    if (fit == Fit::kWrong) return true;
    if (fit == Fit::kRight && stated == Fit::kWrong) mistake.cases.insert(number);
    return false;
  });
}

// The other corners that values may be taken for: the given ones, or those on the grid.
SubjectInfo OfOtherCorners(const SubjectInfo& info) {
  SubjectInfo other = info;
  const bool is_given = info.fragments.barycentrics_of == BarycentricsOf::kGiven;
  other.fragments.barycentrics_of = is_given ? BarycentricsOf::kSnapped : BarycentricsOf::kGiven;
  return other;
}

void Search::CompareDrawing(const PlacedCase& placed, const DrawJob& job, const Drawing& drawing,
                            std::size_t number) {
  const SubjectInfo& info = subject_.Info();
  ValueRule rule = placed.profile.values;
  if (what_ != NumbersOf::kChannels)
    rule.error = {.absolute = what_ == NumbersOf::kDepths ? info.fragments.depth_error
                                                          : info.fragments.barycentric_error};
  const ShownValues values{drawing,
                           job.scene->channels,
                           rule,
                           info.input,
                           placed.profile.y_axis == YAxis::kUp,
                           placed.scene.clip_space,
                           job.scene.get()};
  const SubjectInfo other = OfOtherCorners(info);
  const auto fragments = FragmentsOf(placed, info, drawing, FragmentChoice::kSome);
  const auto others = FragmentsOf(placed, other, drawing, FragmentChoice::kSome);
  for (const ValueFragment& f : fragments) {
    if (f.readings.size() != 1 || !f.readings.front().known) continue;
    const auto same = std::ranges::find(others, f.index, &ValueFragment::index);
    const int facing = placed.facings[static_cast<std::size_t>(f.triangle)] > 0 ? 1 : -1;
    for (Shown& s : NumbersOfFragment(values, f, what_)) {
      s.facing = facing;
      if (same != others.end() && same->readings.size() == 1)
        s.other_corners = &same->readings.front().corners.front();
      CompareNumber(s, number);
    }
  }
}

bool Search::HasThem(const Drawing& drawing) const {
  if (drawing.primitive_ids.empty()) return false;
  if (what_ == NumbersOf::kChannels) return !drawing.values.empty();
  return what_ == NumbersOf::kDepths ? !drawing.depths.empty() : !drawing.barycentrics.empty();
}

void Search::Compare(const Property& property, const Case& c, std::size_t number) {
  const Description description = DescriptionOf(subject_);
  const CaseJudge judge(property, c, description);
  for (const Check& check : judge.AllChecks()) {
    const bool is_plain = check.bases.empty() && check.questions.company == Company::kAny;
    if (check.questions.draws.empty() || !is_plain) continue;
    const std::vector<std::shared_ptr<const Drawing>> nothing;
    const Request request{&judge.Placed(), &check, &nothing};
    const Answers answers = std::move(Submit(subject_, {&request, 1}).front());
    if (answers.end.stop != Stop::kNone) {
      is_stopped_ = EndsTheCall(answers.end.stop);
      return;
    }
    for (std::size_t k = 0; k < answers.draws.size(); ++k) {
      const DrawJob& job = check.questions.draws[k].job;
      // Some properties draw scenes of their own.
      if (!std::ranges::equal(job.Triangles(), judge.Placed().scene.triangles)) continue;
      if (!HasThem(*answers.draws[k])) continue;
      CompareDrawing(judge.Placed(), job, *answers.draws[k], number);
    }
  }
}

ValueMistake Search::Found() const {
  ValueMistake found;
  found.numbers = numbers_;
  found.wrong = wrong_;
  std::size_t most = kFewestScenes - 1;
  for (const Mistake& mistake : left_) most = std::max(most, mistake.cases.size());
  for (const Mistake& mistake : left_) {
    if (mistake.cases.size() < std::max(most, kFewestScenes)) continue;
    if (found.name.empty()) found.name = mistake.name;
    found.what.push_back(mistake.what);
  }
  const bool are_few =
      most_bits_ > 0 && most_bits_ <= kMostFewBits && most_off_ <= std::ldexp(1.0, 1 - most_bits_);
  if (found.name.empty() && are_few && wrong_cases_.size() >= kFewestScenes) {
    found.name = "few-bits";
    found.what = {"keeps " + std::to_string(most_bits_) + " bits of a value"};
  }
  return found;
}

}  // namespace

bool IsAboutShownNumbers(Shows shows) {
  return shows == Shows::kFragments || shows == Shows::kDepths || shows == Shows::kValues ||
         shows == Shows::kDerivatives;
}

namespace {

ValueMistake FindIn(NumbersOf what, Subject& subject, const FailedProperty& failure,
                    double seconds) {
  Search search(subject, what);
  const double end = SecondsOfDraws(subject) + seconds;
  std::size_t number = 0;
  for (const Case& c : failure.cases) search.Compare(*failure.property, c, number++);
  const CaseOrder order(subject.Info(), *failure.property, kSeedOfMistakes);
  for (std::uint64_t k = 0; k < kCasesTried && !order.IsEmpty(); ++k) {
    if (search.IsOver() || SecondsOfDraws(subject) > end) break;
    search.Compare(*failure.property, DrawCase(subject.Info(), order.Name(kFirstTried + k)),
                   number++);
  }
  return search.Found();
}

}  // namespace

// A depth that does not follow from barycentrics may be right, and they wrong.
ValueMistake FindValueMistake(Subject& subject, const FailedProperty& failure, double seconds) {
  const Shows shows = failure.property->gate.shows;
  if (shows == Shows::kFragments)
    return FindIn(NumbersOf::kBarycentrics, subject, failure, seconds);
  if (shows != Shows::kDepths) return FindIn(NumbersOf::kChannels, subject, failure, seconds);
  ValueMistake of_depths = FindIn(NumbersOf::kDepths, subject, failure, seconds);
  if (of_depths.wrong != 0) return of_depths;
  return FindIn(NumbersOf::kBarycentrics, subject, failure, seconds);
}

}  // namespace rasterproof::props
