#include "props/cause/value_mistakes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/value_rule.h"
#include "props/cause/investigation.h"
#include "props/cause/value_mistake_list.h"
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
constexpr int kFewestBits = 4;    // fewer explain any number of about that size
constexpr std::string_view kDepthName = "depth";

enum class Fit : std::uint8_t { kUnknown, kRight, kWrong };

Point2 PlaceOfShown(const ShownNumber& s) { return PlaceOfValue(s.f, s.channel); }
bool IsInterpolatedChannel(const ShownNumber& s) {
  return s.channel.interpolation != Interpolation::kFlat;
}

DerivativeCheck CheckSlope(const ShownNumber& s) {
  return CheckDerivative(s.values, s.f, s.owners, s.channel, s.axis, s.x);
}

bool HasDepthFormat(const ShownNumber& s) {
  return s.channel.name == kDepthName && s.values.rule.depth != DepthFormat::kUnstated;
}

// What the number may be; depths are clamped to their format, and rounded to it.
std::optional<ValueRange> StatedRange(const ShownNumber& s) {
  std::optional<ValueRange> range = RangeOf(s.values, s.f, s.owners, s.channel, s.numbers);
  if (!range || !HasDepthFormat(s)) return range;
  if (DepthStep(s.values.rule.depth) != 0) {
    range->low = std::clamp(range->low, 0.0, 1.0);
    range->high = std::clamp(range->high, 0.0, 1.0);
  }
  range->tolerance += DepthRoundingOf(s.values.rule, range->high);
  return range;
}

// Whether the number is what is stated, and the least that is allowed about any number.
struct Statement {
  Fit fit = Fit::kUnknown;
  double tolerance = 0;
};

Statement Stated(const ShownNumber& s) {
  if (s.axis >= 0) {
    const DerivativeCheck check = CheckSlope(s);
    if (!check.is_judged) return {};
    return {check.holds ? Fit::kRight : Fit::kWrong, check.tolerance};
  }
  if (!IsInterpolatedChannel(s)) {
    if (s.values.rule.provoking == ProvokingVertex::kUnstated) return {};
    const std::size_t k = s.values.rule.provoking == ProvokingVertex::kLast ? 2 : 0;
    return {s.x == s.numbers[k] ? Fit::kRight : Fit::kWrong, 0};
  }
  const std::optional<ValueRange> range = StatedRange(s);
  if (!range) return {};
  if (HasDepthFormat(s) && !IsOfDepthFormat(s.x, s.values.rule.depth))
    return {Fit::kWrong, range->tolerance};
  if (range->SurelyHolds(s.x)) return {Fit::kRight, range->tolerance};
  return {range->SurelyExcludes(s.x) ? Fit::kWrong : Fit::kUnknown, range->tolerance};
}

Fit ShownBy(const Mistake& mistake, const ShownNumber& s, const Statement& stated) {
  const std::vector<MadeNumber> made = mistake.shows(s);
  if (made.empty()) return stated.fit;  // there it does as is stated
  for (const MadeNumber& one : made) {
    if (!std::isfinite(one.value) || !std::isfinite(one.condition)) return Fit::kUnknown;
  }
  // A mistake before the rounding to the format of depths leaves numbers of that format.
  const bool is_of_format = !HasDepthFormat(s) || IsOfDepthFormat(s.x, s.values.rule.depth);
  for (const MadeNumber& one : made) {
    if (!one.within && !is_of_format) continue;
    const double rounding = kMistakeConditions * UnitRoundoff(s.values.precision) *
                            (one.condition + std::fabs(one.value));
    const double tolerance = one.within.value_or(std::max(stated.tolerance, rounding));
    if (std::fabs(s.x - one.value) <= tolerance) return Fit::kRight;
  }
  return Fit::kWrong;
}

// All numbers of one fragment. 1/w is another matter than the channels with numbers.
std::vector<ShownNumber> NumbersOfFragment(const ShownValues& values, const ValueFragment& f,
                                           NumbersOf what) {
  std::vector<ShownNumber> list;
  const ValueOwners& owners = f.readings.front();
  if (what == NumbersOf::kDepths) {
    const Channel channel{std::string(kDepthName), Interpolation::kInverseW};
    return {{values, f, owners, channel, values.DepthsOf(f), values.drawing.depths[f.index]}};
  }
  if (what == NumbersOf::kBarycentrics) {
    const bool is_linear = !values.is_clip_space || values.rule.weights == WeightsIn::kScreen;
    const Channel channel{"barycentric",
                          is_linear ? Interpolation::kLinear : Interpolation::kPerspective};
    for (std::size_t i = 0; i < 3; ++i) {
      VertexNumbers unit{};
      unit[i] = 1;
      list.push_back({values, f, owners, channel, unit, values.drawing.barycentrics[f.index][i]});
    }
    return list;
  }
  for (std::size_t k = 0; k < values.channels.size(); ++k) {
    const Channel& channel = values.channels[k];
    const bool is_inverse = channel.interpolation == Interpolation::kInverseW;
    if (channel.at == EvaluatedAt::kCentroid) continue;
    ShownNumber s{values, f, owners, channel, NumbersAt(f, channel), values.Of(f, k)};
    s.entry = k;
    if (what != NumbersOf::kDerivatives) {
      if (is_inverse == (what == NumbersOf::kInverseW)) list.push_back(s);
      continue;
    }
    if (channel.interpolation == Interpolation::kFlat || channel.at != EvaluatedAt::kSample)
      continue;
    for (s.axis = 0; s.axis < 2; ++s.axis) {
      s.x = values.DerivativesOf(f, k)[static_cast<std::size_t>(s.axis)];
      list.push_back(s);
    }
  }
  return list;
}

// The search: mistakes that no number has refuted yet.
class Search {
 public:
  Search(Subject& subject, NumbersOf what)
      : subject_(subject), what_(what), left_(MistakesOf(what)) {}

  void Compare(const Property& property, const Case& c, std::size_t number);
  bool IsOver() const { return is_stopped_; }
  ValueMistake Found() const;

 private:
  void CompareDrawing(const PlacedCase& placed, const DrawJob& job, const Drawing& drawing,
                      std::size_t number);
  void CompareNumber(const ShownNumber& s, std::size_t number);
  void LookAtBits(const ShownNumber& s);

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

void Search::LookAtBits(const ShownNumber& s) {
  if (!IsInterpolatedChannel(s) || !std::isfinite(s.x) || std::ranges::count(s.numbers, s.x) != 0)
    return;
  const ValueEstimate e =
      EstimateValue(s.owners.corners.front(), s.channel.interpolation, s.numbers, PlaceOfShown(s));
  const double value = s.axis < 0 ? e.value : e.derivatives[static_cast<std::size_t>(s.axis)];
  if (!std::isfinite(value) || value == 0) return;
  most_bits_ = std::max(most_bits_, SignificantBits(s.x));
  most_off_ = std::max(most_off_, std::fabs(s.x / value - 1));
}

void Search::CompareNumber(const ShownNumber& s, std::size_t number) {
  const Statement stated = Stated(s);
  if (stated.fit == Fit::kUnknown) return;
  ++numbers_;
  if (stated.fit == Fit::kWrong) {
    ++wrong_;
    wrong_cases_.insert(number);
    LookAtBits(s);
  }
  std::erase_if(left_, [&](Mistake& mistake) {
    const Fit fit = ShownBy(mistake, s, stated);
    if (fit == Fit::kWrong) return true;
    if (fit == Fit::kRight && stated.fit == Fit::kWrong) mistake.cases.insert(number);
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
  if (what_ == NumbersOf::kDepths || what_ == NumbersOf::kBarycentrics)
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
  std::map<int, OtherTriangle> seen;
  for (const ValueFragment& f : fragments) {
    if (f.readings.size() == 1 && f.readings.front().known)
      seen.try_emplace(f.triangle, OtherTriangle{&f.readings.front().corners.front(), f.vertices});
  }
  const auto find = [&](int triangle) {
    const auto found = seen.find(triangle);
    return found == seen.end() ? nullptr : &found->second;
  };
  for (const ValueFragment& f : fragments) {
    if (f.readings.size() != 1 || !f.readings.front().known) continue;
    const auto same = std::ranges::find(others, f.index, &ValueFragment::index);
    const int facing = placed.facings[static_cast<std::size_t>(f.triangle)] > 0 ? 1 : -1;
    for (ShownNumber& s : NumbersOfFragment(values, f, what_)) {
      s.facing = facing;
      s.triangle_before = find(f.triangle - 1);
      s.triangle_after = find(f.triangle + 1);
      if (same != others.end() && same->readings.size() == 1)
        s.other_corners = &same->readings.front().corners.front();
      CompareNumber(s, number);
    }
  }
}

bool Search::HasThem(const Drawing& drawing) const {
  if (drawing.primitive_ids.empty()) return false;
  if (what_ == NumbersOf::kDerivatives) return !drawing.derivatives.empty();
  if (what_ == NumbersOf::kChannels || what_ == NumbersOf::kInverseW)
    return !drawing.values.empty();
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
  const auto explains = [most](const Mistake& mistake) {
    return mistake.cases.size() >= std::max(most, kFewestScenes);
  };
  const bool is_narrow = std::ranges::any_of(
      left_, [&](const Mistake& mistake) { return !mistake.is_wide && explains(mistake); });
  for (const Mistake& mistake : left_) {
    if (!explains(mistake) || (mistake.is_wide && is_narrow)) continue;
    if (found.name.empty()) found.name = mistake.name;
    found.what.push_back(mistake.what);
  }
  const bool are_few = most_bits_ >= kFewestBits && most_bits_ <= kMostFewBits &&
                       most_off_ <= std::ldexp(1.0, 1 - most_bits_);
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

// A derivative that is not the plane's may be right, and the value wrong; a depth that does not
// follow from barycentrics, and they.
ValueMistake FindValueMistake(Subject& subject, const FailedProperty& failure, double seconds) {
  const Shows shows = failure.property->gate.shows;
  if (shows == Shows::kFragments)
    return FindIn(NumbersOf::kBarycentrics, subject, failure, seconds);
  if (shows != Shows::kDepths) {
    ValueMistake of_values = FindIn(NumbersOf::kChannels, subject, failure, seconds);
    if (of_values.wrong != 0) return of_values;
    return FindIn(shows == Shows::kDerivatives ? NumbersOf::kDerivatives : NumbersOf::kInverseW,
                  subject, failure, seconds);
  }
  ValueMistake of_depths = FindIn(NumbersOf::kDepths, subject, failure, seconds);
  if (of_depths.wrong != 0) return of_depths;
  return FindIn(NumbersOf::kBarycentrics, subject, failure, seconds);
}

}  // namespace rasterproof::props
