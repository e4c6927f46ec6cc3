#include "legal/minimal_set.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <ranges>
#include <set>
#include <utility>

#include "core/coverage.h"
#include "legal/decided.h"
#include "legal/family_samples.h"
#include "legal/model_clauses.h"
#include "legal/triangle_samples.h"
#include "model/target_profile.h"

namespace rasterproof::legal {
namespace {

using SeenSet = std::set<Seen>;

// The models of one family at some samples, for repeated questions about which parts they explain.
class FamilyAtSamples {
 public:
  FamilyAtSamples(const Scene& scene, const TargetProfile& profile, const Family& family,
                  const Observed& observed, const std::vector<bool>* only)
      : view_(scene, profile, family), all_(view_, only), clauses_(view_) {
    for (const Need& need : NeedsOf(all_, observed)) {
      if (only != nullptr && !(*only)[need.seen.sample]) continue;
      if (need.IsImpossible()) impossible_.insert(need.seen);
      if (need.IsImpossible() || need.IsEmpty()) continue;
      std::vector<Literal> covers;
      Asked& asked = asked_[need.seen];
      for (const std::size_t o : need.open) {
        covers.push_back(clauses_.Covers(all_.open[o]));
        for (const std::size_t corner : all_.open[o].corner)
          asked.vertices.push_back(view_.VertexOf(all_.open[o].triangle, corner));
      }
      asked.literals.push_back(clauses_.Between(covers, need.least, need.most));
    }
    for (const CommonEdgeSample& edge : all_.common_edges) clauses_.AddOwner(edge);
    for (const Exclusion& one : all_.exclusions) clauses_.AddExclusion(one, all_.open);
  }

  // Every need that some choice may miss, or none can meet, and that so may contradict the rest.
  std::vector<Seen> MayBeWrong() const {
    SeenSet seen = impossible_;
    for (const auto& [one, asked] : asked_) seen.insert(one);
    return {seen.begin(), seen.end()};
  }

  Answer Explains(const SeenSet& set, std::uint64_t most_propagations) {
    rests_on_.clear();
    const auto wrong = std::ranges::find_if(set, [&](Seen s) { return impossible_.contains(s); });
    if (wrong != set.end()) {
      rests_on_.insert(*wrong);
      return Answer::kUnsatisfiable;
    }
    std::vector<Literal> assumptions;
    for (const Seen& one : set) {
      const auto asked = asked_.find(one);
      if (asked == asked_.end()) continue;
      assumptions.insert(assumptions.end(), asked->second.literals.begin(),
                         asked->second.literals.end());
    }
    const Answer answer = clauses_.solver().Solve(assumptions, most_propagations);
    if (answer != Answer::kUnsatisfiable) return answer;
    for (const Seen& one : set) {
      const auto asked = asked_.find(one);
      if (asked == asked_.end()) continue;
      const auto rests = [&](Literal literal) { return clauses_.solver().RestsOn(literal); };
      if (std::ranges::any_of(asked->second.literals, rests)) rests_on_.insert(one);
    }
    return answer;
  }

  // The observations of the last set on which its answer, kUnsatisfiable, rests.
  const SeenSet& RestsOn() const { return rests_on_; }

  // The vertices whose places decide it.
  std::vector<std::size_t> VerticesOf(const Seen& seen) const {
    const auto asked = asked_.find(seen);
    return asked == asked_.end() ? std::vector<std::size_t>() : asked->second.vertices;
  }

 private:
  struct Asked {
    std::vector<Literal> literals;
    std::vector<std::size_t> vertices;
  };

  FamilyView view_;
  FamilySamples all_;
  ModelClauses clauses_;
  SeenSet impossible_;
  std::map<Seen, Asked> asked_;
  SeenSet rests_on_;
};

std::vector<bool> SamplesOf(const std::ranges::range auto& seen, std::size_t samples) {
  std::vector<bool> only(samples);
  for (const Seen& one : seen) only[one.sample] = true;
  return only;
}

// The observations, and the cost allowed for finding a smaller part of them.
struct Search {
  const Scene& scene;
  const TargetProfile& profile;
  const Observed& observed;
  std::uint64_t most_propagations;

  std::size_t Samples() const {
    return CoverageCounts::Size(scene.width, scene.height, profile.pattern.samples());
  }
  std::unique_ptr<FamilyAtSamples> At(const Family& family, const std::vector<bool>* only) const {
    return std::make_unique<FamilyAtSamples>(scene, profile, family, observed, only);
  }
};

// The observations that no model of any family explains alone. The finest grid leaves least open
// and comes first: the others are not asked about observations that it explains.
std::vector<Seen> WrongByThemselves(const Search& search, const std::vector<Family>& families) {
  std::vector<Seen> wrong;
  for (std::size_t f = families.size(); f-- > 0;) {
    const bool is_first = f + 1 == families.size();
    const std::vector<bool> only = SamplesOf(wrong, search.Samples());
    const auto family = search.At(families[f], is_first ? nullptr : &only);
    if (is_first) wrong = family->MayBeWrong();
    std::erase_if(wrong, [&](const Seen& one) {
      return family->Explains({one}, search.most_propagations) != Answer::kUnsatisfiable;
    });
    if (wrong.empty()) break;
  }
  return wrong;
}

using Families = std::vector<std::unique_ptr<FamilyAtSamples>>;

// The union of the families' refutations of the set; nothing if a family has a model, or gave up.
std::optional<SeenSet> Refuted(const Families& families, const SeenSet& set,
                               std::uint64_t most_propagations, bool& gave_up) {
  SeenSet rests_on;
  for (const auto& family : families) {
    const Answer answer = family->Explains(set, most_propagations);
    gave_up = gave_up || answer == Answer::kGaveUp;
    if (answer != Answer::kUnsatisfiable) return std::nullopt;
    rests_on.insert(family->RestsOn().begin(), family->RestsOn().end());
  }
  return rests_on;
}

// Leaves out one observation after another as long as no family has a model of the rest. Returns
// whether the result is minimal.
bool Minimize(const Families& families, std::uint64_t most_propagations, SeenSet& set) {
  bool gave_up = false;
  if (const auto fewer = Refuted(families, set, most_propagations, gave_up)) set = *fewer;
  constexpr std::size_t kMostTried = 400;
  if (set.size() > kMostTried) return false;
  for (auto one = set.begin(); one != set.end();) {
    const Seen here = *one;
    SeenSet others = set;
    others.erase(here);
    if (const auto fewer = Refuted(families, others, most_propagations, gave_up)) set = *fewer;
    one = set.upper_bound(here);
  }
  return !gave_up;
}

// What legal models decide of one triangle at a sample: at least and at most.
struct OfTriangle {
  std::size_t triangle = 0;
  int least = 0;
  int most = 0;
};

// By sample of `only`: the triangles that cover it in some legal model, in rising order.
std::map<std::size_t, std::vector<OfTriangle>> TrianglesBySample(const Decided& decided,
                                                                 const SeenSet& set) {
  std::map<std::size_t, std::vector<OfTriangle>> by_sample;
  for (const Seen& seen : set) by_sample[seen.sample];
  for (std::size_t t = 0; t < decided.triangles.size(); ++t) {
    const TriangleDecided& triangle = decided.triangles[t];
    const auto add = [&](std::size_t sample, int least) {
      const auto found = by_sample.find(sample);
      if (found == by_sample.end()) return;
      std::vector<OfTriangle>& list = found->second;
      if (list.empty() || list.back().triangle != t) list.push_back({t, least, 1});
    };
    for (const std::size_t s : triangle.must) add(s, 1);
    if (triangle.is_anything) {
      for (const auto& [sample, list] : by_sample) add(sample, 0);
    } else {
      for (const std::size_t s : triangle.may) add(s, 0);
    }
  }
  return by_sample;
}

// How many of them legal models count on one side, where so many of all cover the sample.
CountRange RangeOnSide(const std::vector<OfTriangle>& triangles, const std::vector<int>& side_of,
                       int side, const Decided& decided, std::size_t sample) {
  CountRange here;
  CountRange there;
  for (const OfTriangle& one : triangles) {
    const int of = side_of[one.triangle];
    if (of != -side) here.most += one.most;
    if (of != side) there.most += one.most;
    if (of == side) here.least += one.least;
    if (of == -side) there.least += one.least;
  }
  return {std::max(here.least, decided.Least(sample) - there.most),
          std::min(here.most, decided.Most(sample) - there.least)};
}

// Those that some legal model shows: any, or none that another always hides.
std::vector<std::size_t> MayBeVisible(const std::vector<OfTriangle>& triangles,
                                      const Observed& observed) {
  std::vector<std::size_t> visible;
  const auto look_at = [&](const OfTriangle& one) {
    visible.push_back(one.triangle);
    return one.least != 0 && !observed.any_is_visible;
  };
  if (observed.last_is_visible && !observed.any_is_visible) {
    for (const OfTriangle& one : std::views::reverse(triangles)) {
      if (look_at(one)) break;
    }
    std::ranges::reverse(visible);
  } else {
    for (const OfTriangle& one : triangles) {
      if (look_at(one)) break;
    }
  }
  return visible;
}

void AddObservedTogether(const Search& search, const Decided& decided,
                         const std::vector<OfTriangle>& triangles, Requirement& requirement) {
  const Observed& observed = search.observed;
  const std::size_t sample = requirement.sample;
  for (const OfTriangle& one : triangles) requirement.triangles.push_back(one.triangle);
  requirement.legal_least = decided.Least(sample);
  requirement.legal_most = decided.Most(sample);
  if (observed.primitive_ids != nullptr) {
    requirement.visible = (*observed.primitive_ids)[sample];
    requirement.legal_visible = MayBeVisible(triangles, observed);
    if (observed.ShowsWrongSide(sample))
      requirement.wrong_front = (*observed.visible_front)[sample];
  }
  if (observed.together == nullptr) return;
  const auto count = static_cast<int>(observed.together->Count(sample));
  const auto all = static_cast<int>(search.scene.triangles.size());
  if (observed.sides != Sides::kNotCompared) {
    requirement.by_side = {static_cast<int>(observed.together->front[sample]),
                           static_cast<int>(observed.together->back[sample])};
    const int front = observed.sides == Sides::kPositiveArea ? 1 : -1;
    requirement.legal_by_side = {RangeOnSide(triangles, observed.side_of, front, decided, sample),
                                 RangeOnSide(triangles, observed.side_of, -front, decided, sample)};
  }
  requirement.least = count;
  requirement.most = observed.is_mask && count != 0 ? std::max(count, all) : count;
}

// The samples with the triangles that may cover them, and how often legal models let them.
std::vector<Requirement> RequirementsOf(const Search& search, const SeenSet& set) {
  const std::vector<bool> only = SamplesOf(set, search.Samples());
  const Decided decided = DecidedSamples(search.scene, search.profile, &only);
  const auto by_sample = TrianglesBySample(decided, set);
  const auto samples = static_cast<std::size_t>(decided.samples);
  const auto width = static_cast<std::size_t>(search.scene.width);
  const auto families = FamiliesOf(search.profile, search.scene);
  const FamilyView view(search.scene, search.profile, families.front());
  std::vector<Requirement> requirements;
  for (const Seen& seen : set) {
    const std::size_t pixel = seen.sample / samples;
    Requirement& requirement = requirements.emplace_back();
    requirement.sample = seen.sample;
    requirement.at = view.At(static_cast<int>(pixel % width), static_cast<int>(pixel / width),
                             seen.sample % samples);
    const std::vector<OfTriangle>& triangles = by_sample.at(seen.sample);
    if (seen.triangle == Seen::kTogether) {
      AddObservedTogether(search, decided, triangles, requirement);
      continue;
    }
    requirement.triangles = {seen.triangle};
    const auto found = std::ranges::find(triangles, seen.triangle, &OfTriangle::triangle);
    if (found != triangles.end()) {
      requirement.legal_least = found->least;
      requirement.legal_most = found->most;
    }
    const auto count = search.observed.alone[seen.triangle]->Count(seen.sample);
    requirement.least = requirement.most = static_cast<int>(count);
  }
  return requirements;
}

void SortOnce(std::vector<std::size_t>& numbers) {
  std::ranges::sort(numbers);
  const auto repeated = std::ranges::unique(numbers);
  numbers.erase(repeated.begin(), repeated.end());
}

}  // namespace

Core MinimalSet(const Scene& scene, const TargetProfile& profile, const Observed& observed,
                std::span<const std::vector<Seen>> refutations, const Effort& effort) {
  const Search search{scene, profile, observed, effort.most_propagations};
  const std::vector<Family> of_profile = FamiliesOf(profile, scene);
  Core core;
  const std::vector<Seen> wrong = WrongByThemselves(search, of_profile);
  if (!wrong.empty()) {
    core.wrong_by_themselves = wrong.size();
    const std::size_t told = std::min(wrong.size(), kMostWrongTold);
    core.wrong =
        RequirementsOf(search, {wrong.begin(), wrong.begin() + static_cast<std::ptrdiff_t>(told)});
    core.requirements = {core.wrong.front()};
    return core;
  }
  SeenSet set;
  for (const std::vector<Seen>& refutation : refutations)
    set.insert(refutation.begin(), refutation.end());
  const std::vector<bool> only = SamplesOf(set, search.Samples());
  Families families;
  for (const Family& family : of_profile) families.push_back(search.At(family, &only));
  core.is_minimal = Minimize(families, effort.most_propagations, set);
  for (const Seen& seen : set) {
    for (const auto& family : families) {
      const std::vector<std::size_t> vertices = family->VerticesOf(seen);
      core.vertices.insert(core.vertices.end(), vertices.begin(), vertices.end());
    }
  }
  SortOnce(core.vertices);
  core.requirements = RequirementsOf(search, set);
  return core;
}

}  // namespace rasterproof::legal
