#include "props/cause/cause.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "props/cause/investigation.h"
#include "props/cause/suspect.h"
#include "props/cause/value_mistakes.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kMostCombined = 4;        // suspects at once
constexpr std::size_t kMostDrawsCompared = 48;  // draws, while the next of them is looked for
constexpr std::ptrdiff_t kLeastGain = 2;        // fewer draws more are chance
constexpr int kMostRaces = 2;                   // whose winners draws more may refute

}  // namespace

// Whether nothing is covered in any draw, where something should be in some.
bool Investigation::FindNothingDrawn() {
  const auto is_empty = [](const std::shared_ptr<const Drawing>& drawing) {
    const auto is_zero = [](std::uint32_t n) { return n == 0; };
    return std::ranges::all_of(drawing->counts.front, is_zero) &&
           std::ranges::all_of(drawing->counts.back, is_zero);
  };
  if (AreFew()) return false;
  for (std::size_t k = 0; k < modelled_; ++k) {
    if (!std::ranges::all_of(observations_[k].seen, is_empty)) return false;
  }
  Cause cause;
  cause.kind = CauseKind::kNothingDrawn;
  cause.name = "nothing-drawn";
  cause.draws = DrawsOf(std::span(observations_).first(modelled_));
  cause.wrong_scenes = AllWrongScenes();
  for (std::size_t k = 0; k < failures_.size(); ++k) {
    if (HasWrongDraws(k)) cause.properties.push_back(k);
  }
  if (!cause.properties.empty()) Take(std::move(cause));
  return true;
}

bool Investigation::FindWhole() {
  std::vector<Fitting> whole;
  std::erase_if(partly_, [&](Fitting& fitting) {
    if (fitting.reproduced < wrong_) return false;
    whole.push_back(std::move(fitting));
    return true;
  });
  if (whole.empty()) return false;
  TellApart(whole);
  if (whole.empty()) return false;  // draws more refuted all of them
  Cause cause = Of(CauseKind::kModel, whole);
  for (std::size_t k = 0; k < failures_.size(); ++k) {
    if (HasWrongDraws(k)) cause.properties.push_back(k);
  }
  if (!cause.properties.empty()) Take(std::move(cause));
  return true;
}

bool Investigation::AreFew() const { return ScenesOf(AllWrong(), kFewestScenes) < kFewestScenes; }

// A draw more that refutes what was left belongs to the evidence: other suspects may fit it.
bool Investigation::FindWholeByRaces() {
  for (int race = 0;; ++race) {
    Race();
    const std::size_t seen = observations_.size();
    if (race == kMostRaces) return false;
    if (FindWhole()) return true;
    if (observations_.size() == seen) return false;
  }
}

// Which of the modelled observations a rasterizer of these stages reproduces.
std::vector<bool> Investigation::ReproducedBy(const SuspectStages& stages) const {
  const std::unique_ptr<Subject> suspect = MakeSuspect(subject_->Info(), stages);
  std::vector<bool> reproduced(modelled_);
  for (std::size_t k = 0; k < modelled_; ++k)
    reproduced[k] = Reproduces(*suspect, observations_[k]);
  return reproduced;
}

// The suspect that, beside the stages so far, reproduces most draws more than it loses.
std::optional<std::size_t> Investigation::BestWith(const SuspectStages& stages,
                                                   const std::vector<bool>& reproduced) {
  std::vector<std::size_t> open, kept;
  for (std::size_t k = 0; k < modelled_; ++k) (reproduced[k] ? kept : open).push_back(k);
  open.resize(std::min(open.size(), kMostDrawsCompared));
  kept.resize(std::min(kept.size(), kMostDrawsCompared));
  std::optional<std::size_t> best;
  std::ptrdiff_t most = kLeastGain;
  for (std::size_t n = 0; n < suspects_.size() && !IsLate(); ++n) {
    const std::optional<SuspectStages> both = Composed(stages, suspects_[n].stages);
    if (!both) continue;
    const std::unique_ptr<Subject> draws = MakeSuspect(subject_->Info(), *both);
    const auto reproduces = [&](std::size_t k) { return Reproduces(*draws, observations_[k]); };
    const std::ptrdiff_t gain = std::ranges::count_if(open, reproduces);
    if (gain <= most) continue;
    const std::ptrdiff_t loss =
        static_cast<std::ptrdiff_t>(kept.size()) - std::ranges::count_if(kept, reproduces);
    if (gain - loss <= most) continue;
    most = gain - loss;
    best = n;
  }
  return best;
}

// Several suspects at once that reproduce every draw, found one after the other.
bool Investigation::FindCombination() {
  SuspectStages stages;
  std::vector<bool> reproduced(modelled_, true);
  std::fill_n(reproduced.begin(), wrong_, false);
  std::vector<std::size_t> combined;
  while (!std::ranges::all_of(reproduced, std::identity())) {
    if (combined.size() == kMostCombined) return false;
    const std::optional<std::size_t> next = BestWith(stages, reproduced);
    if (!next) return false;
    combined.push_back(*next);
    stages = *Composed(stages, suspects_[*next].stages);
    reproduced = ReproducedBy(stages);
  }
  // What explains all draws must foretell others.
  std::vector<Fitting> left;
  left.push_back({"", "", stages, MakeSuspect(subject_->Info(), stages), wrong_});
  TellApart(left);
  if (left.empty()) return false;
  Share(combined);
  return true;
}

// Gives each property to the first of the suspects without which its failing draws are others.
void Investigation::Share(const std::vector<std::size_t>& combined) {
  std::vector<Cause> causes;
  std::set<std::size_t> unshared = open_;
  for (const std::size_t n : combined) {
    Cause& cause = causes.emplace_back();
    cause.kind = combined.size() == 1 ? CauseKind::kModel : CauseKind::kPart;
    cause.name = suspects_[n].cause;
    cause.what = {suspects_[n].what};
    cause.draws = DrawsOf(std::span(observations_).first(modelled_));
    cause.reproduced = cause.draws;
    cause.together = combined.size() == 1 ? 0 : combined.size();
    SuspectStages others;
    for (const std::size_t other : combined) {
      if (other != n) others = *Composed(others, suspects_[other].stages);
    }
    std::vector<bool> without = ReproducedBy(others);
    for (std::size_t k = 0; k < wrong_; ++k) {
      const std::size_t failure = observations_[k].failure;
      if (!without[k] && unshared.erase(failure) != 0) cause.properties.push_back(failure);
    }
    without.flip();
    cause.wrong_scenes = WrongScenes(without);
    cause.rests_on_few = AreFewScenes(CauseKind::kModel, cause.wrong_scenes, cause.wrong_scenes);
  }
  for (Cause& cause : causes) Take(std::move(cause));
}

// Names the cause of its properties, or, if it rests on too few scenes, keeps it as a hint.
void Investigation::Take(Cause cause) {
  for (const std::size_t k : cause.properties) {
    if (cause.rests_on_few) {
      hints_.try_emplace(k, cause);
    } else {
      open_.erase(k);
    }
  }
  if (!cause.rests_on_few) found_.all.push_back(std::move(cause));
}

// Sound suspects of which each wrong draw is reproduced by one, the one of most draws first; with
// each those that reproduce the same. Nothing if there are no such.
std::vector<std::vector<Fitting>> Investigation::PartsOfAll() {
  std::vector<std::vector<bool>> reproduced;
  for (const Fitting& fitting : partly_) {
    reproduced.push_back(ReproducedBy(fitting.stages));
    reproduced.back().resize(wrong_);
  }
  std::vector<std::vector<Fitting>> parts;
  std::vector<bool> left(wrong_, true);
  while (std::ranges::find(left, true) != left.end()) {
    const auto news = [&](const std::vector<bool>& of) {
      std::size_t n = 0;
      for (std::size_t k = 0; k < wrong_; ++k) n += of[k] && left[k] ? 1 : 0;
      return n;
    };
    const auto best = std::ranges::max_element(reproduced, {}, news);
    if (best == reproduced.end() || news(*best) == 0 || parts.size() == kMostCombined) return {};
    for (std::size_t k = 0; k < wrong_; ++k) left[k] = left[k] && !(*best)[k];
    std::vector<bool> is_of_part;
    for (const std::vector<bool>& of : reproduced) is_of_part.push_back(of == *best);
    std::vector<Fitting>& part = parts.emplace_back();
    for (std::size_t n = 0; n < partly_.size(); ++n) {
      if (is_of_part[n]) part.push_back(std::move(partly_[n]));
    }
    std::size_t n = 0;
    std::erase_if(partly_, [&](const Fitting&) { return is_of_part[n++]; });
    n = 0;
    std::erase_if(reproduced, [&](const std::vector<bool>&) { return is_of_part[n++]; });
  }
  return parts;
}

// Several suspects, of which each wrong draw is one's: of faults that never meet in a draw.
bool Investigation::FindParts() {
  if (raced_ != observations_.size()) Race();  // sound for all that is known by now
  std::vector<std::vector<Fitting>> parts = PartsOfAll();
  const std::size_t known = wrong_;
  for (std::vector<Fitting>& part : parts) {
    TellApart(part);
    if (part.empty()) return false;
  }
  // A wrong draw more must be one's, too: they are few, and looked at one by one.
  for (std::size_t k = known; k < wrong_; ++k) {
    const bool is_explained = std::ranges::any_of(parts, [&](const std::vector<Fitting>& part) {
      return Reproduces(*part.front().draws, observations_[k]);
    });
    if (!is_explained) return false;
  }
  std::set<std::size_t> unshared = open_;
  std::vector<Cause> causes;
  for (const std::vector<Fitting>& part : parts) {
    Cause& cause = causes.emplace_back(Of(CauseKind::kPart, part));
    cause.draws = wrong_;
    const std::vector<bool> reproduced = ReproducedBy(part.front().stages);
    cause.reproduced = 0;
    for (std::size_t k = 0; k < wrong_; ++k) {
      if (!reproduced[k]) continue;
      ++cause.reproduced;
      const std::size_t failure = observations_[k].failure;
      if (unshared.erase(failure) != 0) cause.properties.push_back(failure);
    }
  }
  // Where one of them can't be named, the others leave draws unexplained.
  const bool are_sure = std::ranges::none_of(causes, &Cause::rests_on_few);
  for (Cause& cause : causes) {
    if (are_sure || cause.rests_on_few) Take(std::move(cause));
  }
  return are_sure && !causes.empty();
}

// Of properties about numbers that draws show. What a subject covers may be no part of it, so that
// these are looked at first.
void Investigation::FindMistakes() {
  for (std::size_t k = 0; k < failures_.size(); ++k) {
    if (!IsAboutShownNumbers(failures_[k].property->gate.shows)) continue;
    ValueMistake mistake = FindValueMistake(*subject_, failures_[k], kGatheringShare * seconds_);
    if (mistake.name.empty()) continue;
    open_.erase(k);
    const auto same = std::ranges::find_if(found_.all, [&](const Cause& other) {
      return other.name == mistake.name && other.what == mistake.what;
    });
    if (same != found_.all.end()) {
      same->properties.push_back(k);
      same->draws += mistake.numbers;
      same->reproduced = same->draws;
      continue;
    }
    Cause& cause = found_.all.emplace_back();
    cause.kind = CauseKind::kMistake;
    cause.name = std::move(mistake.name);
    cause.what = std::move(mistake.what);
    cause.reproduced = cause.draws = mistake.numbers;
    cause.properties = {k};
  }
}

void Investigation::FindRest() {
  while (!open_.empty()) {
    const std::size_t k = *open_.begin();
    open_.erase(open_.begin());
    std::vector<const Observation*> wrong;
    for (const Observation& o : observations_) {
      if (o.failure == k && o.is_wrong) wrong.push_back(&o);
    }
    Cause cause;
    cause.draws = modelled_;
    cause.properties = {k};
    // Who states nothing of coverage is not at fault in it.
    const bool states_coverage = subject_->Info().profile.contract != Contract::kNone;
    const bool is_of_numbers = IsAboutShownNumbers(failures_[k].property->gate.shows);
    if (!wrong.empty() && (states_coverage || !is_of_numbers)) {
      Circumstance circumstance = FindCircumstance(make_, wrong, observations_);
      cause.kind = circumstance.name.empty() ? CauseKind::kUnexplained : CauseKind::kCircumstance;
      cause.name = circumstance.name;
      if (!cause.name.empty()) {
        cause.what = {circumstance.what};
      } else if (const auto hint = hints_.find(k); hint != hints_.end()) {
        cause.what = hint->second.what;
        cause.wrong_scenes = hint->second.wrong_scenes;
        cause.rests_on_few = true;
      }
      if (!cause.rests_on_few) cause.only_with = OnlyWith(observations_);
      if (cause.name.empty()) cause.pattern = PatternOf(AllWrong(), *stated_);
    } else if (failures_[k].property->gate.shows == Shows::kFloatModes) {
      // It compares draws in other modes with those in the usual one.
      cause.kind = CauseKind::kCircumstance;
      cause.name = "float-mode";
      cause.what = {"in the usual floating-point mode"};
    } else if (is_of_numbers || AsksForValues(*subject_, failures_[k])) {
      cause.kind = CauseKind::kShownValues;
      cause.name = "shown-values";
      cause.what = {std::string(failures_[k].property->group)};
    }
    const auto same = std::ranges::find_if(found_.all, [&](const Cause& other) {
      return other.kind == cause.kind && other.name == cause.name && other.what == cause.what;
    });
    if (same != found_.all.end()) {
      same->properties.push_back(k);
    } else {
      found_.all.push_back(std::move(cause));
    }
  }
}

Causes Investigation::Run() {
  subject_ = make_();
  Gathered gathered = Gather(*subject_, failures_, kGatheringShare * seconds_);
  observations_ = std::move(gathered.observations);
  for (std::size_t k = 0; k < observations_.size(); ++k) observations_[k].place = k;
  found_.is_cut_short = gathered.is_cut_short;
  end_ = ThreadSeconds() + (1 - kGatheringShare) * seconds_;
  stated_ = MakeSuspect(subject_->Info(), {});
  Sort();
  for (std::size_t k = 0; k < failures_.size(); ++k) open_.insert(k);
  FindMistakes();
  const bool are_points = subject_->Info().profile.contract != Contract::kSquares;
  if (wrong_ != 0 && are_points && !open_.empty()) {
    if (!FindNothingDrawn() && !FindWholeByRaces() && !FindCombination()) FindParts();
  }
  found_.draws = DrawsOf(observations_);
  found_.wrong = DrawsOf(std::span(observations_).first(wrong_));
  FindRest();
  // clang calls what std::stable_sort uses deprecated.
  std::vector<std::pair<std::pair<bool, std::size_t>, std::size_t>> order;
  for (std::size_t k = 0; k < found_.all.size(); ++k) {
    const Cause& cause = found_.all[k];
    order.push_back({{cause.name.empty(), failures_.size() - cause.properties.size()}, k});
  }
  std::ranges::sort(order);
  std::vector<Cause> sorted;
  for (const auto& [rank, k] : order) sorted.push_back(std::move(found_.all[k]));
  found_.all = std::move(sorted);
  return std::move(found_);
}

bool AreFewScenes(CauseKind kind, std::size_t explained, std::size_t wrong) {
  return explained < kFewestScenes && (kind == CauseKind::kModel || 2 * explained < wrong);
}

Causes FindCauses(const MakesSubject& make, std::span<const FailedProperty> failures,
                  double seconds) {
  if (failures.empty()) return {};
  return Investigation(make, failures, seconds).Run();
}

}  // namespace rasterproof::props
