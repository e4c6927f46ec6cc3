#include "legal/joint.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "exact/snap_clip.h"
#include "legal/family_samples.h"
#include "legal/minimal_set.h"
#include "legal/model_clauses.h"
#include "legal/needs.h"
#include "legal/triangle_samples.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"

namespace rasterproof::legal {
namespace {

// A union-find structure over nodes.
class Parts {
 public:
  explicit Parts(std::size_t nodes) : parent_(nodes) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t Root(std::size_t node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }
  void Join(std::size_t a, std::size_t b) { parent_[Root(a)] = Root(b); }

 private:
  std::vector<std::size_t> parent_;
};

// The needs, the owners of samples on common edges and the exclusions of one component.
struct Component {
  std::vector<const Need*> needs;
  std::vector<const CommonEdgeSample*> edges;
  std::vector<const Exclusion*> exclusions;
  std::size_t open = 0;
  std::size_t triangles = 0;
};

std::vector<Component> ComponentsOf(const FamilyView& view, const FamilySamples& all,
                                    const std::vector<Need>& needs) {
  const std::size_t positions = view.choices().places.size();
  const auto node = [&](const OpenSample* open) {
    return positions + static_cast<std::size_t>(open - all.open.data());
  };
  Parts parts(positions + all.open.size());
  for (const OpenSample& open : all.open) {
    for (const std::size_t corner : open.corner) {
      const std::size_t position = view.PositionOf(open.triangle, corner);
      if (view.choices().places[position].size() > 1) parts.Join(node(&open), position);
    }
  }
  for (const CommonEdgeSample& edge : all.common_edges) {
    parts.Join(node(edge.first), node(edge.second));
    if (!edge.opposite) continue;
    for (std::size_t k = 0; k < 3; ++k) {  // whether there is an owner depends on all corners
      parts.Join(node(edge.first), view.PositionOf(edge.first->triangle, k));
      parts.Join(node(edge.second), view.PositionOf(edge.second->triangle, k));
    }
  }
  for (const Exclusion& exclusion : all.exclusions) {
    for (const auto& one : exclusion) {
      parts.Join(positions + one.first, positions + exclusion.front().first);
    }
  }
  for (const Need& need : needs) {
    for (const std::size_t o : need.open) parts.Join(positions + o, positions + need.open[0]);
  }
  std::map<std::size_t, Component> components;
  for (const Need& need : needs) {
    if (!need.open.empty()) components[parts.Root(positions + need.open[0])].needs.push_back(&need);
  }
  const auto component_of = [&](std::size_t n) { return components.find(parts.Root(n)); };
  for (const CommonEdgeSample& edge : all.common_edges) {
    const auto found = component_of(node(edge.first));
    if (found != components.end()) found->second.edges.push_back(&edge);
  }
  for (const Exclusion& exclusion : all.exclusions) {
    const auto found = component_of(positions + exclusion.front().first);
    if (found != components.end()) found->second.exclusions.push_back(&exclusion);
  }
  std::map<std::size_t, std::size_t> last_triangle;  // by root: opens come by triangle
  for (const OpenSample& open : all.open) {
    const auto found = component_of(node(&open));
    if (found == components.end()) continue;
    ++found->second.open;
    const auto [last, is_new] = last_triangle.try_emplace(found->first, open.triangle);
    if (is_new || last->second != open.triangle) ++found->second.triangles;
    last->second = open.triangle;
  }
  std::vector<Component> list;
  for (auto& [root, component] : components) list.push_back(std::move(component));
  return list;
}

struct Explained {
  Answer answer = Answer::kSatisfiable;
  std::vector<Seen> rests_on;  ///< kUnsatisfiable: observations that its models do not explain
};

Explained Explain(const FamilyView& view, const FamilySamples& all, const Component& component,
                  const Effort& effort) {
  Explained explained;
  if (component.open > effort.most_open) return {Answer::kGaveUp, {}};
  ModelClauses clauses(view);
  std::vector<std::pair<Literal, const Need*>> assumed;
  for (const Need* need : component.needs) {
    std::vector<Literal> covers;
    for (const std::size_t o : need->open) covers.push_back(clauses.Covers(all.open[o]));
    if (!need->IsEmpty())
      assumed.emplace_back(clauses.Between(covers, need->least, need->most), need);
  }
  for (const CommonEdgeSample* edge : component.edges) clauses.AddOwner(*edge);
  for (const Exclusion* one : component.exclusions) clauses.AddExclusion(*one, all.open);
  std::vector<Literal> assumptions;
  for (const auto& [literal, need] : assumed) assumptions.push_back(literal);
  explained.answer = clauses.solver().Solve(assumptions, effort.most_propagations);
  if (explained.answer != Answer::kUnsatisfiable) return explained;
  for (const auto& [literal, need] : assumed) {
    if (clauses.solver().RestsOn(literal)) explained.rests_on.push_back(need->seen);
  }
  return explained;
}

std::uint64_t OpenSamplesOf(const Component& component) {
  std::vector<std::size_t> samples;
  for (const Need* need : component.needs) samples.push_back(need->seen.sample);
  std::ranges::sort(samples);
  return static_cast<std::uint64_t>(
      std::distance(samples.begin(), std::ranges::unique(samples).begin()));
}

// If the family is not legal, `refutation` holds observations that its models do not explain.
JointVerdict JudgeByFamily(const Scene& scene, const TargetProfile& profile,
                           const Observed& observed, const Family& family, const Effort& effort,
                           std::vector<Seen>& refutation) {
  JointVerdict verdict;
  verdict.family = family;
  verdict.samples = CoverageCounts::Size(scene.width, scene.height, profile.pattern.samples());
  const FamilyView view(scene, profile, family);
  const FamilySamples all(view);
  const std::vector<Need> needs = NeedsOf(all, observed);
  const auto impossible = std::ranges::find_if(needs, &Need::IsImpossible);
  if (impossible != needs.end()) {
    verdict.legality = Legality::kNotLegal;
    refutation = {impossible->seen};
    return verdict;
  }
  const std::vector<Component> components = ComponentsOf(view, all, needs);
  verdict.components = components.size();
  for (const Component& component : components) {
    verdict.largest_component = std::max(verdict.largest_component, component.triangles);
    Explained explained = Explain(view, all, component, effort);
    if (explained.answer == Answer::kGaveUp) {
      if (verdict.legality == Legality::kLegal) verdict.legality = Legality::kNotJudged;
      verdict.not_judged += OpenSamplesOf(component);
      verdict.largest_given_up = std::max(verdict.largest_given_up, component.triangles);
    }
    if (explained.answer != Answer::kUnsatisfiable) continue;
    verdict.legality = Legality::kNotLegal;
    refutation = std::move(explained.rests_on);
    return verdict;
  }
  return verdict;
}

// By triangle: the side that all families count it on, or 0.
std::vector<int> SidesOf(const Scene& scene, const TargetProfile& profile,
                         const std::vector<Family>& families) {
  std::vector<int> sides;
  for (const Family& family : families) {
    const FamilyView view(scene, profile, family);
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      const int side = view.SideOf(t);
      if (sides.size() <= t) sides.push_back(side);
      if (sides[t] != side) sides[t] = 0;
    }
  }
  return sides;
}

// What one call says of the families, each asked once at most.
class CallByFamily {
 public:
  CallByFamily(const Call& call, const TargetProfile& profile, const std::vector<Family>& families,
               const Effort& effort)
      : profile_(&profile),
        families_(&families),
        effort_(&effort),
        call_(call),
        known_(families.size()) {
    if (call_.observed.sides != Sides::kNotCompared) {
      call_.observed.side_of = SidesOf(*call_.scene, profile, families);
    }
  }

  Legality By(std::size_t family) {
    if (!known_[family]) {
      std::vector<Seen> refutation;
      known_[family] = JudgeByFamily(*call_.scene, *profile_, call_.observed, (*families_)[family],
                                     *effort_, refutation)
                           .legality;
    }
    return *known_[family];
  }

  std::vector<bool> Possible() {
    std::vector<bool> possible;
    for (std::size_t f = 0; f < known_.size(); ++f)
      possible.push_back(By(f) != Legality::kNotLegal);
    return possible;
  }

 private:
  const TargetProfile* profile_;
  const std::vector<Family>* families_;
  const Effort* effort_;
  Call call_;
  std::vector<std::optional<Legality>> known_;
};

// Families of all vertices of the calls.
std::vector<Family> FamiliesOfCalls(const std::vector<Call>& calls, const TargetProfile& profile) {
  Scene all = *calls.front().scene;
  for (std::size_t k = 1; k < calls.size(); ++k) {
    const std::vector<Vertex>& more = calls[k].scene->vertices;
    all.vertices.insert(all.vertices.end(), more.begin(), more.end());
  }
  return FamiliesOf(profile, all);
}

std::vector<bool> Common(std::vector<bool> set, const std::vector<bool>& others) {
  for (std::size_t f = 0; f < set.size(); ++f) set[f] = set[f] && others[f];
  return set;
}

bool IsEmpty(const std::vector<bool>& set) { return std::ranges::find(set, true) == set.end(); }

// Calls without a common family: one, two, or as many as are left of all once each was tried
// without.
std::vector<std::size_t> ConflictOf(const std::vector<std::vector<bool>>& possible) {
  for (std::size_t a = 0; a < possible.size(); ++a) {
    if (IsEmpty(possible[a])) return {a};
  }
  for (std::size_t b = 0; b < possible.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (IsEmpty(Common(possible[a], possible[b]))) return {a, b};
    }
  }
  std::vector<std::size_t> left(possible.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  for (std::size_t k = left.size(); k-- > 0;) {
    std::vector<std::size_t> without = left;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
    std::vector<bool> common(possible.front().size(), true);
    for (const std::size_t call : without) common = Common(common, possible[call]);
    if (IsEmpty(common)) left = std::move(without);
  }
  return left;
}

// More places on an axis than this, and a vertex has hundreds.
constexpr double kMostSteps = 4;

std::optional<std::string> WhyNoPlaces(const Scene& scene, const TargetProfile& model) {
  if (!model.freedom.transform_error) return std::string(kNoTransformError);
  double farthest = 0;
  for (const Vertex& v : scene.vertices) {
    if (IsFinite(v)) farthest = std::max({farthest, std::fabs(v.x / v.w), std::fabs(v.y / v.w)});
  }
  const int bits = model.freedom.least_bits ? kMaxSubpixelBits : model.snap.bits;
  if (std::ldexp(model.freedom.TransformReach(farthest), bits) <= kMostSteps) return std::nullopt;
  return "the error of the profile's transform is more than 4 steps of the grid";
}

}  // namespace

std::optional<std::string> WhyNotJoint(const Scene& scene, const TargetProfile& profile) {
  if (!profile.scanline_rounding.IsNone())
    return "the profile rounds crossings, for which there is no joint model";
  if (profile.contract == Contract::kSquares) {
    return "the contract is about whole pixels, which 'check' judges";
  }
  const bool is_free_and_watertight =
      profile.contract == Contract::kWatertight && !profile.freedom.IsNone();
  if (profile.contract != Contract::kSampleExact && !is_free_and_watertight)
    return "the contract does not state single samples";
  if (profile.sample_positions != SamplePositions::kStated)
    return "the profile does not state where samples lie";
  if (TakesToWindow(profile, scene)) return "the profile has a transform of its own";
  if (MayMoveEdgesAnyhow(scene, profile)) return std::string(kClippedAnyhow);
  if (auto why = WhyBeyondLimits(scene, profile)) return why;
  if (!scene.clip_space) return std::nullopt;
  if (profile.snap.IsNone()) return "the profile has no grid in clip space";
  if (const auto error = exact::SnapClipError(scene, profile)) return error->what();
  return WhyNoPlaces(scene, profile);
}

JointVerdict JudgeJointly(const Scene& scene, const TargetProfile& profile, const Observed& seen,
                          const Effort& effort) {
  Observed observed = seen;
  const std::vector<Family> of_profile = FamiliesOf(profile, scene);
  if (observed.sides != Sides::kNotCompared) observed.side_of = SidesOf(scene, profile, of_profile);
  std::optional<JointVerdict> first;
  std::optional<JointVerdict> open;
  std::vector<std::vector<Seen>> refutations;
  for (const Family& family : of_profile) {
    JointVerdict verdict =
        JudgeByFamily(scene, profile, observed, family, effort, refutations.emplace_back());
    verdict.families = refutations.size();
    if (verdict.legality == Legality::kLegal) return verdict;
    if (verdict.legality == Legality::kNotJudged && !open) open = verdict;
    if (!first) first = std::move(verdict);
  }
  JointVerdict verdict = open ? *std::move(open) : *std::move(first);
  verdict.families = refutations.size();
  if (verdict.legality == Legality::kNotLegal)
    verdict.core = MinimalSet(scene, profile, observed, refutations, effort);
  return verdict;
}

CallsVerdict JudgeCalls(const std::vector<Call>& calls, const TargetProfile& profile,
                        const Effort& effort) {
  const std::vector<Family> families = FamiliesOfCalls(calls, profile);
  std::vector<CallByFamily> judged;
  for (const Call& call : calls) judged.emplace_back(call, profile, families, effort);
  std::vector<std::size_t> order(calls.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  bool may_be_legal = false;
  for (std::size_t f = 0; f < families.size(); ++f) {
    bool is_given_up = false;
    const auto refuting = std::ranges::find_if(order, [&](std::size_t k) {
      const Legality legality = judged[k].By(f);
      is_given_up = is_given_up || legality == Legality::kNotJudged;
      return legality == Legality::kNotLegal;
    });
    if (refuting == order.end() && !is_given_up) return {.family = families[f]};
    if (refuting == order.end()) may_be_legal = true;
    if (refuting != order.end()) std::rotate(order.begin(), refuting, refuting + 1);
  }
  if (may_be_legal) return {.legality = Legality::kNotJudged};
  CallsVerdict verdict{.legality = Legality::kNotLegal};
  std::vector<std::vector<bool>> possible;
  for (CallByFamily& call : judged) {
    possible.push_back(call.Possible());
    std::vector<Family>& explaining = verdict.explaining.emplace_back();
    for (std::size_t f = 0; f < families.size(); ++f) {
      if (possible.back()[f]) explaining.push_back(families[f]);
    }
  }
  verdict.conflict = ConflictOf(possible);
  return verdict;
}

std::vector<Family> ExplainingFamilies(const Call& call, const TargetProfile& profile,
                                       const Effort& effort) {
  const std::vector<Family> families = FamiliesOf(profile, *call.scene);
  CallByFamily judged(call, profile, families, effort);
  std::vector<Family> explaining;
  for (std::size_t f = 0; f < families.size(); ++f) {
    if (judged.By(f) != Legality::kNotLegal) explaining.push_back(families[f]);
  }
  return explaining;
}

}  // namespace rasterproof::legal
