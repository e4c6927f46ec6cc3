// The race of suspects: what was drawn refutes them, and draws more tell apart what is left.
#include "props/cause/investigation.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/clock.h"
#include "core/coverage.h"
#include "props/cause/suspect.h"
#include "props/judging/redraw.h"
#include "props/run/case_order.h"
#include "props/run/property_domains.h"
#include "props/run/submit.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kSplits = 320;  // cases that are looked at to tell suspects apart
constexpr std::uint64_t kSeedOfSplits = 1;
constexpr std::uint64_t kFirstSplit = std::uint64_t{1} << 21;
constexpr std::size_t kConfirmations = 16;  // draws more in which what is left must be wrong alike

constexpr std::int64_t kSmallestBudget = 16;
constexpr std::int64_t kLargestBudget = 1 << 16;

// The number of [least, end) that is a multiple of the largest power of two.
std::int64_t Roundest(std::int64_t least, std::int64_t end) {
  std::int64_t round = least;
  for (; least < end; least += least & -least) round = least;
  return round;
}

std::uint64_t CoveredIn(const Seen& drawings) {
  std::uint64_t covered = 0;
  for (const auto& drawing : drawings) {
    const CoverageCounts& counts = drawing->counts;
    for (std::size_t k = 0; k < counts.size(); ++k) covered += counts.Count(k);
  }
  return covered;
}

}  // namespace

// Wrong observations first, then modelled right ones, then the others. Equal ones keep their order.
void Investigation::Sort() {
  for (Observation& o : observations_) o.is_wrong = o.is_modelled && !Reproduces(*stated_, o);
  const auto rank = [](const Observation& o) { return o.is_wrong ? 0 : o.is_modelled ? 1 : 2; };
  std::vector<Observation> sorted;
  for (const int wanted : {0, 1, 2}) {
    for (Observation& o : observations_) {
      if (rank(o) == wanted) sorted.push_back(std::move(o));
    }
    if (wanted == 0) wrong_ = sorted.size();
    if (wanted == 1) modelled_ = sorted.size();
  }
  observations_ = std::move(sorted);
}

// Whether, wherever it differs from the stated model, the subject draws as it does; counts the
// wrong draws that it reproduces.
bool Investigation::IsSound(Fitting& fitting) const {
  for (std::size_t k = 0; k < modelled_; ++k) {
    const Seen seen = DrawnBy(*fitting.draws, observations_[k]);
    if (AreAlike(seen, observations_[k].seen)) {
      fitting.reproduced += k < wrong_ ? 1 : 0;
    } else if (k >= wrong_ || !AreAlike(seen, stated_drew_[k])) {
      return false;
    }
    // The failing cases come first.
    const bool are_over = k < wrong_ && observations_[k].failure == Observation::kAround;
    if (fitting.reproduced == 0 && (are_over || k + 1 == wrong_)) return false;
  }
  return true;
}

// The suspect with the budget within which it draws as much as the subject: of several the
// roundest. A larger one draws no less, so that it is found by halving. What differs by more than a
// budget is another fault's.
std::optional<Suspect> Investigation::WithBudget(Suspect suspect) const {
  if (!suspect.within) return suspect;
  std::int64_t least = kSmallestBudget;
  std::int64_t end = kLargestBudget + 1;
  for (const Observation& o : std::span(observations_).first(modelled_)) {
    const std::uint64_t seen = CoveredIn(o.seen);
    const auto drawn = [&](std::int64_t budget) {
      return CoveredIn(DrawnBy(*MakeSuspect(subject_->Info(), suspect.within(budget)), o));
    };
    if (drawn(Roundest(least, end)) == seen) continue;
    if (drawn(kSmallestBudget) > seen || drawn(kLargestBudget) < seen) continue;
    const auto first = [&](auto draws_less) {
      return *std::ranges::partition_point(std::views::iota(least, end), draws_less);
    };
    least = first([&](std::int64_t n) { return drawn(n) < seen; });
    end = first([&](std::int64_t n) { return drawn(n) <= seen; });
    if (least == end) return std::nullopt;
  }
  if (end > kLargestBudget) return std::nullopt;
  const std::int64_t budget = Roundest(least, end);
  suspect.stages = suspect.within(budget);
  suspect.what.replace(suspect.what.find("{}"), 2, std::to_string(budget));
  return suspect;
}

void Investigation::Race() {
  suspects_.clear();
  for (Suspect& row : SuspectsOf(subject_->Info().profile)) {
    if (std::optional<Suspect> suspect = WithBudget(std::move(row)))
      suspects_.push_back(*std::move(suspect));
  }
  partly_.clear();
  raced_ = observations_.size();
  stated_drew_.clear();
  for (std::size_t k = 0; k < wrong_; ++k)
    stated_drew_.push_back(DrawnBy(*stated_, observations_[k]));
  found_.suspects = 0;
  for (const Suspect& suspect : suspects_) {
    if (IsLate()) return;
    ++found_.suspects;
    Fitting fitting{suspect.cause, suspect.what, suspect.stages,
                    MakeSuspect(subject_->Info(), suspect.stages), 0};
    if (IsSound(fitting)) partly_.push_back(std::move(fitting));
  }
}

// Takes a modelled draw more: it comes after the others of its kind.
void Investigation::Observe(Observation observation) {
  observation.is_wrong = !Reproduces(*stated_, observation);
  observation.place = observations_.size();
  const std::size_t place = observation.is_wrong ? wrong_++ : modelled_;
  ++modelled_;
  observations_.insert(observations_.begin() + static_cast<std::ptrdiff_t>(place),
                       std::move(observation));
}

// Asks the subject where the suspects draw differently, and, if `also_alike`, where they differ
// from the stated model: that finds another wrong draw, or refutes them. Returns whether it was
// asked where they do.
bool Investigation::Split(std::vector<Fitting>& left, const Case& c, bool also_alike) {
  const auto placed = std::make_shared<const PlacedCase>(Place(c, true));
  Observation o{Observation::kAround, placed};
  o.check.questions.draws = {CountsOf(placed->scene, placed->profile, placed->options)};
  if (!Takes(subject_->Info(), c.scene) || !IsModelled(o, subject_->Info())) return false;
  const Request request{placed.get(), &o.check, nullptr};
  Answers first = std::move(Submit(*left.front().draws, {&request, 1}).front());
  if (first.end.stop != Stop::kNone) return false;
  o.seen = first.draws;
  const auto agrees = [&](const Fitting& fitting) { return Reproduces(*fitting.draws, o); };
  const bool are_alike = std::ranges::all_of(left, agrees);
  const bool is_as_stated = Reproduces(*stated_, o);
  if (are_alike && (!also_alike || is_as_stated)) return false;
  const double begun = SecondsOfDraws(*subject_);
  Answers answers = std::move(Submit(*subject_, {&request, 1}).front());
  asked_ += SecondsOfDraws(*subject_) - begun;
  if (answers.end.stop != Stop::kNone) return false;
  o.seen = std::move(answers.draws);
  std::vector<bool> stays;
  for (const Fitting& fitting : left) stays.push_back(agrees(fitting));
  std::size_t k = 0;
  std::erase_if(left, [&](const Fitting&) { return !stays[k++]; });
  Observe(std::move(o));
  return !is_as_stated;
}

// By turns of the model's domains and of a failed property's; nothing if none suits the subject.
std::optional<Case> Investigation::NextSplit(std::uint64_t number) const {
  const Property* property = FindProperty("CoverageEqualsTheModel");
  if (number % 2 == 1) property = failures_[number / 2 % failures_.size()].property;
  const CaseOrder order(subject_->Info(), *property, kSeedOfSplits);
  if (order.IsEmpty()) return std::nullopt;
  return DrawCase(subject_->Info(), order.Name(kFirstSplit + number / 2));
}

void Investigation::TellApart(std::vector<Fitting>& left) {
  std::size_t confirmed = 0;
  for (std::uint64_t k = 0; k < kSplits; ++k) {
    const bool also_alike = confirmed < kConfirmations || AreFew();
    if (left.empty() || (left.size() == 1 && !also_alike) || IsLate() || IsSlow()) return;
    const std::optional<Case> c = NextSplit(k);
    if (c && Split(left, *c, also_alike)) ++confirmed;
  }
}

Cause Investigation::Of(CauseKind kind, const std::vector<Fitting>& left) const {
  Cause cause;
  cause.kind = kind;
  cause.name = left.front().name;
  for (const Fitting& fitting : left) {
    if (std::ranges::find(cause.what, fitting.what) == cause.what.end())
      cause.what.push_back(fitting.what);
  }
  cause.draws = DrawsOf(std::span(observations_).first(modelled_));
  cause.reproduced = cause.draws;
  // Those that no draw tells apart explain the same scenes.
  const std::vector<bool> reproduced = ReproducedBy(left.front().stages);
  cause.wrong_scenes = WrongScenes(reproduced);
  cause.rests_on_few = AreFewScenes(kind, cause.wrong_scenes, AllWrongScenes());
  cause.only_with = OnlyWith(observations_);
  return cause;
}

std::vector<const Observation*> Investigation::AllWrong() const {
  std::vector<const Observation*> wrong;
  for (std::size_t k = 0; k < wrong_; ++k) wrong.push_back(&observations_[k]);
  return wrong;
}

// The different scenes among the wrong draws that count.
std::size_t Investigation::WrongScenes(const std::vector<bool>& counts) const {
  std::vector<const Observation*> wrong;
  for (std::size_t k = 0; k < wrong_; ++k) {
    if (counts[k]) wrong.push_back(&observations_[k]);
  }
  return ScenesOf(wrong);
}

// Whether the property's own draws differ from the stated model. Of those that were not asked it
// is taken for granted.
bool Investigation::HasWrongDraws(std::size_t failure) const {
  bool is_asked = false;
  for (const Observation& o : observations_) {
    if (o.failure != failure) continue;
    is_asked = true;
    if (o.is_wrong) return true;
  }
  return !is_asked && !AsksForValues(*subject_, failures_[failure]);
}

}  // namespace rasterproof::props
