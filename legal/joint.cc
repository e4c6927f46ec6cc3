#include "legal/joint.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "core/drawing.h"
#include "exact/snap_clip.h"
#include "legal/family_samples.h"
#include "legal/model_clauses.h"
#include "legal/triangle_samples.h"
#include "model/target_model.h"

namespace rasterproof::legal {
namespace {

// What was seen at a sample: so many of these open decisions cover it.
struct Need {
  std::size_t sample = 0;
  std::vector<std::size_t> open;
  int least = 0;
  int most = 0;

  bool IsEmpty() const { return least <= 0 && most >= static_cast<int>(open.size()); }
  bool IsImpossible() const {
    return least > static_cast<int>(open.size()) || most < 0 || least > most;
  }
};

// Which node hangs together with which.
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

// What the counts of each triangle, drawn alone, ask for.
void AddNeedsOfAlone(const FamilySamples& all, const Observed& observed, std::vector<Need>& needs) {
  for (std::size_t t = 0; t < observed.alone.size(); ++t) {
    if (all.covers_anything[t]) continue;
    const CoverageCounts& counts = *observed.alone[t];
    std::vector<std::int64_t> open_at(counts.size(), -1);
    std::vector<int> decided(counts.size(), 0);
    for (const std::size_t s : all.covered[t]) decided[s] = 1;
    for (std::size_t o = all.first_open[t]; o < all.first_open[t + 1]; ++o) {
      open_at[all.open[o].sample] = static_cast<std::int64_t>(o);
    }
    for (std::size_t s = 0; s < counts.size(); ++s) {
      const int seen = static_cast<int>(counts.Count(s)) - decided[s];
      Need need{s, {}, seen, seen};
      if (open_at[s] >= 0) need.open.push_back(static_cast<std::size_t>(open_at[s]));
      if (!need.open.empty() || seen != 0) needs.push_back(std::move(need));
    }
  }
}

void AddNeedsOfCounts(const FamilySamples& all, const CoverageCounts& counts, bool is_mask,
                      std::vector<Need>& needs) {
  const int anything = all.Anything();
  const std::vector<int> decided = all.CoveredTimes(counts.size());
  std::vector<std::vector<std::size_t>> open = all.OpenBySample(counts.size());
  for (std::size_t s = 0; s < counts.size(); ++s) {
    const auto seen = static_cast<int>(counts.Count(s));
    Need need{s, std::move(open[s]), seen - decided[s] - anything, seen - decided[s]};
    if (is_mask && seen != 0) {
      need.least = decided[s] + anything > 0 ? 0 : 1;
      need.most = static_cast<int>(need.open.size());
    }
    if (!need.IsEmpty() || !need.open.empty()) needs.push_back(std::move(need));
  }
}

void AddNeedsOfPrimitiveIds(const FamilySamples& all, const Observed& observed,
                            std::vector<Need>& needs) {
  const std::vector<std::int32_t>& ids = *observed.primitive_ids;
  if (all.Anything() != 0) return;  // it may hide any other
  // Later in the order of drawing: more visible.
  const auto rank = [&](std::size_t t) {
    const auto n = static_cast<std::int64_t>(t);
    return observed.last_is_visible ? n : static_cast<std::int64_t>(all.covered.size()) - 1 - n;
  };
  std::vector<std::int64_t> decided(ids.size(), -1);  // the highest rank that covers it for sure
  for (std::size_t t = 0; t < all.covered.size(); ++t) {
    for (const std::size_t s : all.covered[t]) decided[s] = std::max(decided[s], rank(t));
  }
  const std::vector<std::vector<std::size_t>> open = all.OpenBySample(ids.size());
  for (std::size_t s = 0; s < ids.size(); ++s) {
    const std::int64_t seen = ids[s] == kNoPrimitive ? -1 : rank(static_cast<std::size_t>(ids[s]));
    bool is_explained = decided[s] == seen;
    for (const std::size_t o : open[s]) {
      const std::int64_t here = rank(all.open[o].triangle);
      if (here < seen) continue;
      const int covers = here == seen ? 1 : 0;
      is_explained = is_explained || here == seen;
      needs.push_back({s, {o}, covers, covers});
    }
    if (!is_explained || decided[s] > seen) needs.push_back({s, {}, 1, 1});
  }
}

std::vector<Need> NeedsOf(const FamilySamples& all, const Observed& observed) {
  std::vector<Need> needs;
  AddNeedsOfAlone(all, observed, needs);
  if (observed.together != nullptr)
    AddNeedsOfCounts(all, *observed.together, observed.is_mask, needs);
  if (observed.primitive_ids != nullptr) AddNeedsOfPrimitiveIds(all, observed, needs);
  return needs;
}

// The needs of one component, and the owners of samples on its common edges.
struct Component {
  std::vector<const Need*> needs;
  std::vector<const CommonEdgeSample*> edges;
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
  for (const CommonEdgeSample& edge : all.common_edges)
    parts.Join(node(edge.first), node(edge.second));
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
  std::vector<const Need*> core;
  bool is_minimal = true;
};

// Leaves out one need after the other, as long as the others still conflict.
void Minimize(Solver& solver, std::vector<std::pair<Literal, const Need*>>& core,
              std::uint64_t propagations, bool& is_minimal) {
  constexpr std::size_t kMostTried = 400;
  if (core.size() > kMostTried) {
    is_minimal = false;
    return;
  }
  for (std::size_t k = 0; k < core.size();) {
    std::vector<Literal> others;
    for (std::size_t j = 0; j < core.size(); ++j) {
      if (j != k) others.push_back(core[j].first);
    }
    const Answer answer = solver.Solve(others, propagations);
    if (answer != Answer::kUnsatisfiable) {
      is_minimal = is_minimal && answer == Answer::kSatisfiable;
      ++k;
      continue;
    }
    core.erase(core.begin() + static_cast<std::ptrdiff_t>(k));
    const auto from = core.begin() + static_cast<std::ptrdiff_t>(k);
    core.erase(std::remove_if(from, core.end(),
                              [&](const auto& need) { return !solver.RestsOn(need.first); }),
               core.end());
  }
}

Explained Explain(const FamilyView& view, const FamilySamples& all, const Component& component,
                  const Effort& effort) {
  Explained explained;
  if (component.open > effort.most_open) return {Answer::kGaveUp, {}, true};
  ModelClauses clauses(view);
  std::vector<std::pair<Literal, const Need*>> assumed;
  for (const Need* need : component.needs) {
    std::vector<Literal> covers;
    for (const std::size_t o : need->open) covers.push_back(clauses.Covers(all.open[o]));
    if (!need->IsEmpty())
      assumed.emplace_back(clauses.Between(covers, need->least, need->most), need);
  }
  for (const CommonEdgeSample* edge : component.edges) clauses.AddOwner(*edge);
  std::vector<Literal> assumptions;
  for (const auto& [literal, need] : assumed) assumptions.push_back(literal);
  explained.answer = clauses.solver().Solve(assumptions, effort.most_propagations);
  if (explained.answer != Answer::kUnsatisfiable) return explained;
  std::erase_if(assumed, [&](const auto& need) { return !clauses.solver().RestsOn(need.first); });
  Minimize(clauses.solver(), assumed, effort.most_propagations, explained.is_minimal);
  for (const auto& [literal, need] : assumed) explained.core.push_back(need);
  return explained;
}

Core CoreOf(const Scene& scene, const FamilyView& view, const FamilySamples& all,
            const std::vector<const Need*>& needs, bool is_minimal) {
  Core core;
  core.is_minimal = is_minimal;
  for (const Need* need : needs) {
    Requirement requirement{need->sample, {}, {}, need->least, need->most};
    const auto per_pixel = static_cast<std::size_t>(view.samples_per_pixel());
    const std::size_t pixel = need->sample / per_pixel;
    const auto width = static_cast<std::size_t>(scene.width);
    requirement.at = view.At(static_cast<int>(pixel % width), static_cast<int>(pixel / width),
                             need->sample % per_pixel);
    for (const std::size_t o : need->open) {
      const OpenSample& open = all.open[o];
      requirement.triangles.push_back(open.triangle);
      for (const std::size_t corner : open.corner) {
        core.vertices.push_back(static_cast<std::size_t>(scene.triangles[open.triangle][corner]));
      }
    }
    core.requirements.push_back(std::move(requirement));
  }
  std::ranges::sort(core.vertices);
  const auto repeated = std::ranges::unique(core.vertices);
  core.vertices.erase(repeated.begin(), repeated.end());
  return core;
}

std::uint64_t OpenSamplesOf(const Component& component) {
  std::vector<std::size_t> samples;
  for (const Need* need : component.needs) samples.push_back(need->sample);
  std::ranges::sort(samples);
  return static_cast<std::uint64_t>(
      std::distance(samples.begin(), std::ranges::unique(samples).begin()));
}

JointVerdict JudgeByFamily(const Scene& scene, const Profile& profile, const Observed& observed,
                           const Family& family, const Effort& effort) {
  JointVerdict verdict;
  verdict.family = family;
  verdict.samples = CoverageCounts::Size(scene.width, scene.height, profile.pattern.samples());
  const FamilyView view(scene, profile, family);
  const FamilySamples all(view);
  const std::vector<Need> needs = NeedsOf(all, observed);
  for (const Need& need : needs) {
    if (!need.IsImpossible()) continue;
    verdict.legality = Legality::kNotLegal;
    verdict.core = CoreOf(scene, view, all, {&need}, true);
    return verdict;
  }
  const std::vector<Component> components = ComponentsOf(view, all, needs);
  verdict.components = components.size();
  for (const Component& component : components) {
    const std::uint64_t open = OpenSamplesOf(component);
    verdict.open += open;
    verdict.largest_component = std::max(verdict.largest_component, component.triangles);
    const Explained explained = Explain(view, all, component, effort);
    if (explained.answer == Answer::kGaveUp) {
      if (verdict.legality == Legality::kLegal) verdict.legality = Legality::kNotJudged;
      verdict.not_judged += open;
      verdict.largest_given_up = std::max(verdict.largest_given_up, component.triangles);
    }
    if (explained.answer != Answer::kUnsatisfiable) continue;
    verdict.legality = Legality::kNotLegal;
    verdict.core = CoreOf(scene, view, all, explained.core, explained.is_minimal);
    return verdict;
  }
  return verdict;
}

}  // namespace

namespace {

// More places on an axis than this, and a vertex has hundreds.
constexpr double kMostSteps = 4;

std::optional<std::string> WhyNoPlaces(const Scene& scene, const Profile& model) {
  if (!model.freedom.transform_error) return "the profile states no error of its transform";
  double farthest = 0;
  for (const Vertex& v : scene.vertices) {
    if (IsFinite(v)) farthest = std::max({farthest, std::fabs(v.x / v.w), std::fabs(v.y / v.w)});
  }
  const int bits = model.freedom.least_bits ? kMaxSubpixelBits : model.snap.bits;
  if (std::ldexp(model.freedom.TransformReach(farthest), bits) <= kMostSteps) return std::nullopt;
  return "the error of the profile's transform is more than 4 steps of the grid";
}

}  // namespace

std::optional<std::string> WhyNotJoint(const Scene& scene, const Profile& profile) {
  const Profile model = ForTarget(profile, scene.width, scene.height);
  if (!model.scanline_rounding.IsNone()) return "the profile rounds crossings, which has no model";
  if (model.contract == Contract::kSquares) {
    return "the contract states whole pixels of each triangle alone, which check judges";
  }
  const bool is_free_and_watertight =
      model.contract == Contract::kWatertight && !model.freedom.IsNone();
  if (model.contract != Contract::kSampleExact && !is_free_and_watertight)
    return "the contract does not state single samples";
  if (!scene.clip_space) return std::nullopt;
  if (model.transform) return "the profile has a transform of its own";
  if (model.snap.IsNone()) return "the profile has no grid in clip space";
  if (const auto error = exact::SnapClipError(scene, model)) return error->what();
  return WhyNoPlaces(scene, model);
}

JointVerdict JudgeJointly(const Scene& scene, const Profile& profile, const Observed& observed,
                          const Effort& effort) {
  std::optional<JointVerdict> first;
  std::optional<JointVerdict> open;
  std::size_t tried = 0;
  for (const Family& family : FamiliesOf(profile, scene)) {
    JointVerdict verdict = JudgeByFamily(scene, profile, observed, family, effort);
    verdict.families = ++tried;
    if (verdict.legality == Legality::kLegal) return verdict;
    if (verdict.legality == Legality::kNotJudged && !open) open = verdict;
    if (!first) first = std::move(verdict);
  }
  JointVerdict verdict = open ? *std::move(open) : *std::move(first);
  verdict.families = tried;
  return verdict;
}

}  // namespace rasterproof::legal
