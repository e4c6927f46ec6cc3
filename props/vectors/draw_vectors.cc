#include "props/vectors/draw_vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/clauses/clauses.h"
#include "core/coverage.h"
#include "core/error.h"
#include "core/subject_info.h"
#include "legal/alone.h"
#include "legal/decided.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"
#include "props/domains/domain.h"
#include "props/properties/clause_lists.h"
#include "props/run/near_edge.h"
#include "props/run/property_domains.h"
#include "props/vectors/value_vectors.h"

namespace rasterproof::props {
namespace {

constexpr int kLeastLatticeBits = 8;
// Of one domain, in succession.
constexpr int kMostUnfit = 256;

bool IsSmall(const Scene& scene) {
  return !scene.clip_space && std::max(scene.width, scene.height) <= kMostVectorSide &&
         !scene.triangles.empty() && scene.triangles.size() <= kMostVectorTriangles &&
         scene.vertices.size() <= kMostVectorVertices;
}

std::vector<std::size_t> AllSamples(std::size_t samples) {
  std::vector<std::size_t> all(samples);
  for (std::size_t s = 0; s < samples; ++s) all[s] = s;
  return all;
}

// What is stated of the triangles at a sample that several of them may cover.
std::vector<JointVector> JointOf(const legal::Decided& decided) {
  std::vector<std::vector<std::size_t>> may(decided.counts.size());
  std::vector<int> must(decided.counts.size());
  for (std::size_t t = 0; t < decided.triangles.size(); ++t) {
    if (decided.triangles[t].is_anything) return {};
    for (const std::size_t s : decided.triangles[t].may) may[s].push_back(t);
    for (const std::size_t s : decided.triangles[t].must) ++must[s];
  }
  std::vector<JointVector> joint;
  for (std::size_t s = 0; s < may.size(); ++s) {
    if (may[s].size() < 2) continue;
    JointVector at{s, may[s], {}};
    const auto most = static_cast<int>(may[s].size());
    for (int k = 0; k <= most; ++k) {
      if ((decided.counts[s] >> (must[s] + k) & 1U) != 0) at.counts.push_back(k);
    }
    if (at.counts.size() != may[s].size() + 1) joint.push_back(std::move(at));
  }
  return joint;
}

// Returns whether anything is stated of any triangle.
bool State(const Scene& scene, const TargetProfile& profile, TestVector& vector) {
  if (legal::WhyNotAlone(scene, profile)) return false;
  legal::Decided decided;
  if (HasOneModel(profile)) {
    decided.triangles = legal::DecideAlone(scene, profile);
  } else {
    decided = legal::DecidedSamples(scene, profile);
    vector.joint = JointOf(decided);
  }
  const std::size_t samples =
      CoverageCounts::Size(scene.width, scene.height, profile.pattern.samples());
  bool is_stated = false;
  for (const legal::TriangleDecided& triangle : decided.triangles) {
    is_stated = is_stated || !triangle.is_anything;
    vector.triangles.push_back(triangle.is_anything
                                   ? TriangleVector{0, {}, AllSamples(samples)}
                                   : TriangleVector{triangle.facing, triangle.must, triangle.may});
  }
  return is_stated;
}

using LatticePoints = std::vector<std::array<std::int32_t, 2>>;

std::optional<LatticePoints> OnLattice(const Scene& scene, const TargetProfile& profile, int bits) {
  const Scene placed = HasOneModel(profile) ? SnapVertices(scene, profile) : scene;
  LatticePoints points;
  for (const Vertex& v : placed.vertices) {
    const std::array<double, 2> at{std::ldexp(v.x, bits), std::ldexp(v.y, bits)};
    const auto is_point = [](double x) { return std::fabs(x) <= INT32_MAX && std::trunc(x) == x; };
    if (!std::ranges::all_of(at, is_point)) return std::nullopt;
    points.push_back({static_cast<std::int32_t>(at[0]), static_cast<std::int32_t>(at[1])});
  }
  return points;
}

// The clauses of the profile's specification, and of the one that it builds on, among these.
template <class Ids>
std::vector<std::string> ClausesAmong(const Ids& ids, const Profile& profile) {
  std::vector<std::string> found;
  const Specification* const specification = SpecificationOf(profile);
  if (specification == nullptr) return found;
  for (const std::string_view id : ids) {
    const std::string_view api = id.substr(0, id.find('.'));
    if (api == specification->api || api == specification->base) found.emplace_back(id);
  }
  return found;
}

bool IsOfCommonEdges(std::string_view id) { return id.ends_with(".common-edge"); }

// One of the domains that are drawn in turn.
struct DomainsTurn {
  const Domain* domain = nullptr;
  std::uint64_t next = 0;
  bool is_over = false;
};

std::optional<TestVector> NextOf(DomainsTurn& turn, const SubjectInfo& info,
                                 const VectorChoice& choice) {
  for (int unfit = 0; unfit < kMostUnfit; ++unfit) {
    const CaseName name{std::string(turn.domain->name), turn.next++, choice.seed};
    std::optional<TestVector> vector = VectorOf(DrawCase(info, name), choice);
    if (!vector) continue;
    vector->domain = turn.domain->summary;
    return vector;
  }
  turn.is_over = true;
  return std::nullopt;
}

}  // namespace

void RequireStatesSamples(const Profile& profile) {
  const std::string place = "profile \"" + profile.name + "\"";
  const std::string remedy =
      "give a profile of window space that states single samples, as vulkan or d3d11-canonical";
  if (profile.contract != Contract::kSampleExact)
    throw InputError(place, "its contract does not state single samples", remedy);
  if (profile.transform) throw InputError(place, "it has a transform of its own", remedy);
  Scene scene;
  scene.vertices = {{0, 0}, {1, 0}, {0, 1}};
  scene.triangles = {{0, 1, 2}};
  if (const auto why = legal::WhyNotAlone(scene, profile)) throw InputError(place, *why, remedy);
}

int LatticeBitsOf(const Profile& profile) {
  const bool is_at_origin = profile.snap.form == SnapForm::kCoordinate || profile.snap.origin == 0;
  int bits = is_at_origin && !profile.snap.IsNone()
                 ? profile.snap.bits
                 : std::max(profile.snap.bits, kLeastLatticeBits);
  for (const TargetModel& target : profile.by_target_size) bits = std::max(bits, target.snap.bits);
  return bits;
}

std::vector<std::string> SampleClausesOf(const Profile& profile) {
  std::vector<std::string> clauses = ClausesAmong(kLegalModelClauses, profile);
  std::erase_if(clauses, IsOfCommonEdges);
  return clauses;
}

std::vector<std::string> JointClausesOf(const Profile& profile) {
  std::vector<std::string> clauses = ClausesAmong(kLegalModelClauses, profile);
  if (std::ranges::any_of(clauses, IsOfCommonEdges))
    std::erase_if(clauses, [](const std::string& id) { return !IsOfCommonEdges(id); });
  return clauses;
}

std::optional<TestVector> VectorOf(const Case& c, const VectorChoice& choice) {
  const Scene& scene = c.scene;
  if (!IsSmall(scene) || !WithinLimits(scene, c.profile)) return std::nullopt;
  const TargetProfile profile(c.profile, scene);
  TestVector vector{c.origin, scene, profile.pattern, profile.y_axis, {}, {}, {}, {}, {}};
  vector.on_lattice = OnLattice(scene, profile, LatticeBitsOf(c.profile));
  if (choice.only_on_lattice && !vector.on_lattice) return std::nullopt;
  if (!State(scene, profile, vector)) return std::nullopt;
  vector.near_edges = CountNearEdges(c);
  if (choice.with_values) StateValues(profile, vector);
  return vector;
}

std::uint64_t DrawVectors(const Profile& profile, const VectorChoice& choice,
                          const std::function<bool(const TestVector&)>& take) {
  SubjectInfo info;
  info.name = "vectors";
  info.profile = profile;
  std::vector<DomainsTurn> turns;
  for (const Domain& domain : Domains()) {
    if (Suits(domain, info) && !domain.clip && !domain.non_finite) turns.push_back({&domain});
  }
  std::uint64_t taken = 0;
  while (taken < choice.cases && !turns.empty()) {
    for (DomainsTurn& turn : turns) {
      if (taken == choice.cases) break;
      const std::optional<TestVector> vector = NextOf(turn, info, choice);
      if (!vector) continue;
      ++taken;
      if (!take(*vector)) return taken;
    }
    std::erase_if(turns, [](const DomainsTurn& turn) { return turn.is_over; });
  }
  return taken;
}

}  // namespace rasterproof::props
