#include "bench/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "bench/exact_triangles.h"
#include "core/clock.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "exact/coverage.h"
#include "model/segment_distance.h"

namespace rasterproof::bench {
namespace {

constexpr std::size_t kBlock = 64;
// A triangle of at least this number of pairs is lost if nothing of it was drawn: no moved edge
// explains that.
constexpr std::uint64_t kLostFrom = 16;
// With fewer wrong pairs their largest distance says all that their 99.9 % quantile would.
constexpr std::size_t kEnoughForQuantile = 10'000;
// For the triangles of a contender that is slow alone.
constexpr double kMostSecondsAlone = 3;

std::uint64_t Pixels(const PixelRect& area) {
  return static_cast<std::uint64_t>(std::max(0, area.x1 - area.x0)) *
         static_cast<std::uint64_t>(std::max(0, area.y1 - area.y0));
}

// Calls `visit` with column, row and place in a row-major buffer of the area.
template <class Visit>
void ForEachPixel(const PixelRect& area, const Visit& visit) {
  std::size_t at = 0;
  for (int y = area.y0; y < area.y1; ++y) {
    for (int x = area.x0; x < area.x1; ++x) visit(x, y, at++);
  }
}

// A wrong decision: the triangle, and the pixel.
using Pair = std::tuple<std::size_t, int, int>;

// Collects the wrong pairs of one geometry.
class ErrorCount {
 public:
  explicit ErrorCount(const ExactTriangles& exact) : exact_(exact) {}

  // Compares what was drawn of a triangle with what is covered: 1 or 0 a pixel of the area.
  void Add(std::size_t triangle, const PixelRect& area, std::span<const std::uint8_t> covers,
           const std::vector<std::uint8_t>& drawn) {
    if (std::ranges::equal(covers, drawn)) return;
    const auto covered = static_cast<std::uint64_t>(std::ranges::count(covers, 1));
    const auto shown = static_cast<std::uint64_t>(std::ranges::count(drawn, 1));
    const bool is_lost = shown == 0 && covered >= kLostFrom;
    const SeenEdges edges = exact_.EdgesOf(triangle);
    ForEachPixel(area, [&](int x, int y, std::size_t at) {
      if (drawn[at] == covers[at]) return;
      ++(covers[at] != 0 ? errors_.missing : errors_.unexpected);
      wrong_.insert({triangle, x, y});
      const double distance = DistanceFrom(edges, CentreOf(x, y));
      errors_.beside_edges += distance <= 1 ? 1 : 0;
      if (is_lost) {
        ++errors_.lost;
      } else {
        AddDistance(triangle, x, y, distance);
      }
    });
  }

  void AddFarOutside(std::uint64_t samples) { errors_.unexpected += samples; }

  BenchErrors Errors() {
    if (distances_.size() >= kEnoughForQuantile) {
      const auto at = distances_.begin() +
                      static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(distances_.size()));
      std::ranges::nth_element(distances_, at);
      errors_.displacement_999 = *at;
    }
    return errors_;
  }

  bool IsWrong(std::size_t triangle, int x, int y) const {
    return wrong_.contains({triangle, x, y});
  }
  const std::set<Pair>& wrong() const { return wrong_; }
  const ExactTriangles& exact() const { return exact_; }

 private:
  void AddDistance(std::size_t triangle, int x, int y, double distance) {
    distances_.push_back(distance);
    if (errors_.worst && distance <= errors_.displacement) return;
    errors_.displacement = distance;
    errors_.worst = BenchWitness{triangle, {}, x, y, distance};
  }

  const ExactTriangles& exact_;
  BenchErrors errors_;
  std::set<Pair> wrong_;
  std::vector<double> distances_;
};

// Of two triangles of an edge, the samples at most a pixel from it that exactly one of them covers:
// drawn by none, a gap; by both, an overlap.
BenchLeaks Leaks(const ErrorCount& errors, const JudgedTriangles& judged,
                 const std::set<std::size_t>& drawn_alone) {
  BenchLeaks leaks;
  for (const auto& [triangle, x, y] : errors.wrong()) {
    const SeenEdges edges = errors.exact().EdgesOf(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t found = judged.NeighbourAt(triangle, k);
      if (found < 0) continue;
      const auto other = static_cast<std::size_t>(found);
      if (!drawn_alone.contains(other)) continue;
      const bool other_is_wrong = errors.IsWrong(other, x, y);
      if (other_is_wrong && other < triangle) continue;  // counted from there
      if (!edges[k] || SegmentDistance((*edges[k])[0], (*edges[k])[1], CentreOf(x, y)) > 1)
        continue;
      const int here = errors.exact().Covers(triangle, x, y) ? 1 : 0;
      const int there = errors.exact().Covers(other, x, y) ? 1 : 0;
      if (here + there != 1) continue;
      const int drawn = (1 - here) + (other_is_wrong ? 1 - there : there);
      if (drawn == 0) ++leaks.gaps;
      if (drawn == 2) ++leaks.overlaps;
    }
  }
  return leaks;
}

void CountDistance(double distance, EdgeDistances& distances) {
  for (std::size_t i = 0; i < EdgeDistances::kUpTo.size(); ++i) {
    if (distance > EdgeDistances::kUpTo[i]) continue;
    ++distances.pairs[i];
    return;
  }
}

// Samples at most a pixel from the segment, within the target.
std::uint64_t SamplesBeside(const std::array<Point2, 2>& edge, const PixelRect& area) {
  std::uint64_t samples = 0;
  ForEachPixel(area, [&](int x, int y, std::size_t) {
    samples += SegmentDistance(edge[0], edge[1], CentreOf(x, y)) <= 1 ? 1 : 0;
  });
  return samples;
}

}  // namespace

JudgedTriangles::JudgedTriangles(const Scene& scene, std::uint64_t most_pixels) : scene_(scene) {
  std::uint64_t pixels = 0;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) pixels += Pixels(JudgedArea(scene, t));
  const std::uint64_t every = pixels / std::max<std::uint64_t>(most_pixels, 1) + 1;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    if ((t / kBlock) % every == 0) indices_.push_back(t);
  }
  for (const std::size_t t : indices_) {
    for (std::size_t k = 0; k < 3; ++k) owners_[EdgeOf(t, k)].push_back(t);
  }
}

JudgedTriangles::Edge JudgedTriangles::EdgeOf(std::size_t triangle, std::size_t k) const {
  const Triangle& t = scene_.triangles[triangle];
  return std::minmax(t[k], t[(k + 1) % 3]);
}

std::int64_t JudgedTriangles::NeighbourAt(std::size_t triangle, std::size_t k) const {
  const auto found = owners_.find(EdgeOf(triangle, k));
  if (found == owners_.end() || found->second.size() != 2) return -1;
  const std::vector<std::size_t>& both = found->second;
  return static_cast<std::int64_t>(both[0] == triangle ? both[1] : both[0]);
}

BenchFamily Describe(const FamilyInput& family, const JudgedTriangles& judged) {
  const Scene& scene = family.scene;
  BenchFamily described;
  described.name = family.name;
  described.summary = family.summary;
  described.width = scene.width;
  described.height = scene.height;
  described.is_clip_space = scene.clip_space;
  described.is_constructed = family.is_constructed;
  described.is_random = family.is_random;
  described.triangles = scene.triangles.size();
  for (const Vertex& v : scene.vertices) {
    described.largest_coordinate =
        std::max({described.largest_coordinate, std::abs(v.x), std::abs(v.y)});
  }
  const CoverageCounts counts = exact::Coverage(scene, Profile{});
  for (std::size_t i = 0; i < counts.size(); ++i) described.covered += counts.Count(i);
  described.judged_triangles = judged.indices().size();
  ExactTriangles exact(scene, Profile{});
  std::vector<std::uint8_t> covered;
  for (const std::size_t t : judged.indices()) {
    const PixelRect area = JudgedArea(scene, t);
    exact.Cover(t, area, covered);
    const SeenEdges edges = exact.EdgesOf(t);
    ForEachPixel(area, [&](int x, int y, std::size_t at) {
      described.judged_covered += covered[at];
      const double distance = DistanceFrom(edges, CentreOf(x, y));
      if (distance > 1) return;
      ++described.boundary_pairs;
      CountDistance(distance, described.distances);
    });
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t other = judged.NeighbourAt(t, k);
      if (other <= static_cast<std::int64_t>(t)) continue;
      if (edges[k]) described.shared_pairs += SamplesBeside(*edges[k], area);
    }
  }
  return described;
}

struct CoverageJudge::Answers {
  Profile model;
  ExactTriangles exact;
  // Of all areas, in the order of the judged triangles, and where each begins.
  std::vector<std::uint8_t> covered;
  std::vector<std::size_t> starts;
  std::vector<std::uint64_t> boundary_pairs;  // of each triangle, of real geometry alone

  Answers(const Scene& scene, const Profile& of, const std::vector<std::size_t>& triangles)
      : model(of), exact(scene, of) {
    std::vector<std::uint8_t> one;
    const bool is_real = SameModel(of, Profile{});
    for (const std::size_t t : triangles) {
      const PixelRect area = JudgedArea(scene, t);
      exact.Cover(t, area, one);
      starts.push_back(covered.size());
      covered.insert(covered.end(), one.begin(), one.end());
      if (!is_real) continue;
      const SeenEdges edges = exact.EdgesOf(t);
      std::uint64_t& near = boundary_pairs.emplace_back(0);
      ForEachPixel(area, [&](int x, int y, std::size_t) {
        near += DistanceFrom(edges, CentreOf(x, y)) <= 1 ? 1 : 0;
      });
    }
  }
};

CoverageJudge::CoverageJudge(const FamilyInput& family, const JudgedTriangles& judged)
    : family_(family), judged_(judged) {}
CoverageJudge::~CoverageJudge() = default;

const CoverageJudge::Answers& CoverageJudge::AnswersOf(const Profile& model) {
  for (const Answers& answers : answers_) {
    if (SameModel(answers.model, model)) return answers;
  }
  return answers_.emplace_back(family_.scene, model, judged_.indices());
}

// All places, or blocks in an order in which a few are spread over the family.
std::vector<std::size_t> CoverageJudge::PlacesFor(const Contender& contender) const {
  const std::size_t count = judged_.indices().size();
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  // A step that is coprime to the count visits every block.
  std::size_t step = contender.IsSlowAlone() ? blocks * 5 / 8 : 1;
  while (step > 1 && std::gcd(step, blocks) != 1) --step;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < blocks; ++k) {
    const std::size_t first = k * std::max<std::size_t>(step, 1) % blocks * kBlock;
    for (std::size_t i = first; i < std::min(first + kBlock, count); ++i) places.push_back(i);
  }
  return places;
}

const Judgement& CoverageJudge::Of(Contender& contender) {
  const auto [found, is_new] = known_.try_emplace(contender.method().name);
  Judgement& judgement = found->second;
  if (!is_new) return judgement;
  const Answers& real = AnswersOf(Profile{});
  const Answers& own = AnswersOf(contender.model());
  ErrorCount against_real(real.exact);
  ErrorCount against_own(own.exact);
  std::set<std::size_t> drawn_alone;
  const double begun = WallSeconds();
  for (const std::size_t place : PlacesFor(contender)) {
    if (contender.IsSlowAlone() && WallSeconds() - begun > kMostSecondsAlone) break;
    const std::size_t t = judged_.indices()[place];
    const PixelRect area = JudgedArea(family_.scene, t);
    std::vector<std::uint8_t> drawn(Pixels(area), 0);
    contender.DrawAlone(t, area, drawn);
    const auto answers = [&](const Answers& of) {
      return std::span(of.covered).subspan(of.starts[place], drawn.size());
    };
    against_real.Add(t, area, answers(real), drawn);
    if (&own != &real) against_own.Add(t, area, answers(own), drawn);
    drawn_alone.insert(t);
    judgement.boundary_pairs += real.boundary_pairs[place];
  }
  judgement.judged_triangles = drawn_alone.size();
  const std::uint64_t outside = contender.LeftBehind();
  against_real.AddFarOutside(outside);
  against_own.AddFarOutside(outside);
  judgement.leaks = Leaks(&own != &real ? against_own : against_real, judged_, drawn_alone);
  judgement.real = against_real.Errors();
  judgement.own = &own != &real ? against_own.Errors() : judgement.real;
  for (BenchErrors* errors : {&judgement.real, &judgement.own}) {
    if (!errors->worst) continue;
    const Triangle& triangle = family_.scene.triangles[errors->worst->triangle];
    errors->worst->corners = Corners(family_.scene, triangle);
  }
  return judgement;
}

}  // namespace rasterproof::bench
