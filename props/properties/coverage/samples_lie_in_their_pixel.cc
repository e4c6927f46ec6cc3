// Each sample has one place in its closed pixel, which explains all that is drawn over the pixel.
//
// Where a profile leaves places open within the pixel, one triangle alone says little of a sample,
// but much of its place: if it is covered, the place lies where a legal model puts the triangle,
// and if not, outside what all models cover. So does a mesh: each sample well inside is covered
// once unless it lies on a vertex, and so of two meshes with no vertex in common only one can miss
// it. Where a mesh folds, its triangles cover a sample front minus back as often as its outline
// winds around it, unless it lies on a vertex or a fold. The case's mesh is drawn again, moved by
// some sixteenths of a pixel: vertices on that grid stay on the grid of every device. A ruler
// (place_ruler.h), the same in every case on a target of this size, makes the places one choice of
// the run.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "props/judging/as_shown.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/freedom/place_ruler.h"
#include "props/judging/freedom/sample_region.h"
#include "props/judging/freedom/visible_edge.h"
#include "props/judging/mesh/mesh_model.h"
#include "props/judging/mesh/mesh_neighbours.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {
namespace samples_lie_in_their_pixel {

constexpr std::size_t kMostAlone = 24;
constexpr std::size_t kMostInAMesh = 4096;
constexpr std::array<Point2, 3> kMoves{{{0, 0}, {0x1p-4, 0x1p-4}, {5 * 0x1p-4, 3 * 0x1p-4}}};
constexpr double kHalfADiagonal = 0.70710678118654757;
constexpr double kRounded = 0x1p-10;  // VisibleEdge::Distance is off by a few ulps

constexpr std::array kRules{
    ProfileRule{BoundsSamples, "sample positions open within the pixel",
                "the profile states where samples lie, or lets them lie outside their pixel"},
    kCountsTies, kDrawsBothFacings,
    ProfileRule{[](const Profile& p) { return !p.max_primitive_extent; }, "no largest extent",
                "the profile drops triangles for their extent"}};

// The mesh of the case, or the same moved.
struct Mesh {
  std::string words;  ///< "the mesh"
  PlacedCase c;
  std::vector<TriangleReach> triangles = {};
  std::vector<std::int64_t> winding = {};
  std::vector<VisibleEdge> outline = {};
  std::vector<ConvexSet> folds = {};  ///< where edges between opposite facings may lie
  double margin = 0;       ///< pixels whose centre is no farther from the outline are not judged
  bool is_folded = false;  ///< front minus back is judged
  bool shows_overlaps = false;

  bool IsNearTheOutline(const PixelSquare& square) const {
    return std::ranges::any_of(
        outline, [&](const VisibleEdge& e) { return !(e.Distance(square.Centre()) > margin); });
  }
  // Where a sample of the pixel may be covered otherwise than once.
  std::vector<ConvexSet> OpenPlaces(const PixelSquare& square) const {
    std::vector<ConvexSet> places;
    for (const ConvexSet& fold : folds) {
      if (!AreApart(square, fold)) places.push_back(fold);
    }
    for (const TriangleReach& triangle : triangles) {
      if (AreApart(square, triangle.most)) continue;
      if (!triangle.facing) places.push_back(triangle.most);
      for (const ConvexSet& corner : triangle.around_corner) {
        if (!AreApart(square, corner)) places.push_back(corner);
      }
    }
    return places;
  }
};

Scene Moved(const Scene& scene, Point2 by) {
  Scene moved = scene;
  for (Vertex& v : moved.vertices) {
    v.x += by.x;
    v.y += by.y;
    if (scene.precision != Precision::kFloat32) continue;
    v.x = static_cast<float>(v.x);
    v.y = static_cast<float>(v.y);
  }
  return moved;
}

// Where edges may lie whose two triangles face opposite ways: on such an edge both lie on one side.
std::vector<ConvexSet> FoldsOf(const PlacedCase& c, const std::vector<TriangleReach>& triangles) {
  using End = std::pair<double, double>;
  std::map<std::pair<End, End>, std::vector<std::size_t>> by_edge;
  const Scene scene = UnsnappedScene(c);
  const auto edge_of = [&](std::size_t t, std::size_t from) {
    const std::array<Vertex, 3> v = Corners(scene, scene.triangles[t]);
    const Vertex& a = v[from];
    const Vertex& b = v[(from + 1) % 3];
    return std::pair{End{a.x, a.y}, End{b.x, b.y}};
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const std::size_t from : {0U, 1U, 2U}) by_edge[edge_of(t, from)].push_back(t);
  }
  std::vector<ConvexSet> folds;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const std::size_t from : {0U, 1U, 2U}) {
      const auto [a, b] = edge_of(t, from);
      const auto others = by_edge.find({b, a});
      if (others != by_edge.end() && std::ranges::any_of(others->second, [&](std::size_t other) {
            return triangles[t].facing != triangles[other].facing;
          }))
        folds.push_back(ReachOfEdge(c, c.scene.triangles[t], from));
    }
  }
  return folds;
}

// Nothing if it may be clipped, or may fold or overlap itself and the subject shows no facings:
// then a sample may be covered otherwise.
std::optional<Mesh> MeshOf(const PlacedCase& given, Point2 by, const Description& subject) {
  Mesh mesh{.words = by == Point2{}
                         ? "the mesh"
                         : "the mesh, moved by (" + HexText(by.x) + ", " + HexText(by.y) + "),",
            .c = by == Point2{} ? given : given.With(Moved(given.scene, by))};
  const PlacedCase& c = mesh.c;
  if (c.profile.freedom.ties == TieOwnership::kOpen || !WithinLimits(c.scene, c.profile))
    return std::nullopt;
  std::optional<int> facing;
  for (const Triangle& t : c.scene.triangles) {
    std::optional<TriangleReach> reach = ReachOfTriangle(c, t);
    if (!reach || reach->is_clipped) return std::nullopt;
    if (reach->facing && facing.value_or(*reach->facing) != *reach->facing) mesh.is_folded = true;
    if (reach->facing) facing = reach->facing;
    mesh.triangles.push_back(*std::move(reach));
  }
  mesh.winding = WindingOf(c);
  mesh.is_folded = mesh.is_folded || std::ranges::any_of(mesh.winding, [](std::int64_t w) {
                     return std::abs(w) > 1;
                   });
  mesh.shows_overlaps = !IsJudgedAsShown(subject.info, c.scene);
  if (mesh.is_folded) {
    if (!TellsFacings(subject) || !mesh.shows_overlaps) return std::nullopt;
    mesh.folds = FoldsOf(c, mesh.triangles);
  }
  for (const BoundaryEdge& edge : BoundaryOf(UnsnappedScene(c)))
    mesh.outline.emplace_back(edge.a, edge.b);
  mesh.margin = kHalfADiagonal + OpenTriangles(c).MostMoved() + kRounded;
  return mesh;
}

struct Asked {
  std::vector<std::size_t> alone;  ///< triangles
  std::vector<TriangleReach> reaches;
  std::vector<Mesh> meshes;
  PlaceRuler ruler;  ///< drawn first
};

// The regions of all samples, or of all samples of a pixel that is like every other.
class Judge {
 public:
  Judge(const PlacedCase& c, const CoverageCounts& shape)
      : c_(c),
        shape_(shape),
        is_fixed_(c.profile.sample_positions == SamplePositions::kFixed),
        regions_(is_fixed_ ? static_cast<std::size_t>(shape.samples) : shape.size()) {}

  // The drawings of the ruler's strips, the first of all.
  void SeeRuler(const PlaceRuler& ruler, const Answers& answers) {
    std::vector<PlacesLeft> places(regions_.size());
    ForEachPixel([&](int x, int row) {
      const bool in_an_end_row = row == 0 || row == shape_.height - 1;
      const bool in_an_end_column = x == 0 || x == shape_.width - 1;
      for (int s = 0; s < shape_.samples && !violated_; ++s) {
        const std::size_t k = shape_.Index(x, row, s);
        PlacesLeft& left = places[RegionIndex(k)];
        for (std::size_t draw = 0; draw < ruler.strips.size() && !violated_; ++draw) {
          const PlaceRuler::Strips& strips = ruler.strips[draw];
          const bool covered = answers.draws[draw]->counts.Count(k) != 0;
          ++exercised_;
          // A sample on the end of a strip need not be covered.
          if (!covered && (strips.along_rows ? in_an_end_column : in_an_end_row)) continue;
          left.See(strips, covered);
          if (!left.IsEmpty()) continue;
          Violate(k,
                  {covered ? "the ruler's strips cover it" : "the ruler's strips do not cover it"},
                  false);
          violated_ = OfDraw(draw, *std::move(violated_));
        }
      }
    });
    for (std::size_t k = 0; k < places.size() && !violated_; ++k) {
      const auto [low, high] = places[k].Box();
      regions_[k].KeepWithinBox(low, high);
    }
  }

  void SeeAlone(std::size_t t, const TriangleReach& reach, const CoverageCounts& counts) {
    ForEachPixel([&](int x, int row) {
      const PixelSquare square = SquareOf(c_, x, row);
      const bool is_apart = AreApart(square, reach.most);
      const bool is_inside = !is_apart && reach.least && IsInside(square, *reach.least);
      for (int s = 0; s < shape_.samples && !violated_; ++s) {
        const std::size_t k = shape_.Index(x, row, s);
        const bool covered = counts.Count(k) != 0;
        ++exercised_;
        if (covered ? is_inside : is_apart) continue;  // wherever it lies
        SampleRegion& region = RegionOf(k);
        if (covered) {
          region.KeepWithin(square, {&reach.most, 1});
        } else if (reach.least) {
          region.TakeAway(square, *reach.least);
        }
        if (!region.IsEmpty()) continue;
        Violate(k, {"triangle " + std::to_string(t), covered ? " covers it" : " does not cover it"},
                covered ? is_apart : is_inside);
        violated_->witness->triangle = static_cast<int>(t);
      }
    });
  }

  // `front`: the sign of the area whose side the subject shows as front; 0: not known.
  void SeeMesh(const Mesh& mesh, std::size_t draw, const CoverageCounts& counts, int front) {
    if (mesh.is_folded && front == 0) return;
    ForEachPixel([&](int x, int row) {
      const PixelSquare square = SquareOf(c_, x, row);
      if (mesh.IsNearTheOutline(square)) return;
      for (int s = 0; s < shape_.samples && !violated_; ++s) {
        const std::size_t k = shape_.Index(x, row, s);
        const std::int64_t winding = mesh.winding[k] * (mesh.is_folded ? front : 1);
        const std::int64_t due = mesh.is_folded ? winding : std::abs(winding);
        const std::int64_t count = mesh.is_folded ? counts.Signed(k) : counts.Count(k);
        exercised_ += static_cast<std::uint64_t>(std::abs(winding));
        if (count == due || (due == 1 && count > 1 && !mesh.shows_overlaps)) continue;
        RegionOf(k).KeepWithin(square, mesh.OpenPlaces(square));
        if (!RegionOf(k).IsEmpty()) continue;
        Violate(k,
                {mesh.words + " covers it ", count,
                 mesh.is_folded ? " times, front minus back" : " times"},
                false);
        violated_ = OfDraw(draw, *std::move(violated_));
      }
    });
  }

  Verdict Done() const { return violated_ ? *violated_ : Verdict::Held(exercised_); }

 private:
  template <class See>
  void ForEachPixel(See see) {
    for (int row = 0; row < shape_.height; ++row) {
      for (int x = 0; x < shape_.width && !violated_; ++x) see(x, row);
    }
  }

  std::size_t RegionIndex(std::size_t k) const {
    return is_fixed_ ? k % static_cast<std::size_t>(shape_.samples) : k;
  }
  SampleRegion& RegionOf(std::size_t k) { return regions_[RegionIndex(k)]; }

  void Violate(std::size_t k, WitnessValue observed, bool wherever) {
    Witness witness = WitnessAtIndex(shape_, k);
    witness.observed = std::move(observed);
    witness.expected = {wherever ? "what holds wherever in its closed pixel the sample lies"
                        : is_fixed_
                            ? "one place in the closed pixel, the same in all, that explains this "
                              "and what was drawn before"
                            : "one place in the closed pixel that explains this and what was drawn "
                              "before"};
    violated_ = Verdict::Violated(exercised_, "no place in its pixel explains a sample", witness);
  }

  const PlacedCase& c_;
  const CoverageCounts& shape_;
  bool is_fixed_;
  std::vector<SampleRegion> regions_;
  std::uint64_t exercised_ = 0;
  std::optional<Verdict> violated_;
};

// Which side is the front, where the profile leaves it open: as a triangle alone shows it that has
// one facing in every legal model. That it is one for all is another property's.
int FrontSign(const PlacedCase& c, const Asked& asked, const Answers& answers) {
  if (c.profile.front_face == FrontFace::kPositiveArea) return 1;
  for (std::size_t k = 0; k < asked.alone.size(); ++k) {
    if (!asked.reaches[k].facing) continue;
    const std::vector<std::int64_t> winding = WindingOf(c.Only({asked.alone[k]}));
    const CoverageCounts& counts = answers.draws[asked.ruler.strips.size() + k]->counts;
    std::int64_t alike = 0;
    for (std::size_t i = 0; i < winding.size(); ++i) alike += winding[i] * counts.Signed(i);
    if (alike != 0) return alike > 0 ? 1 : -1;
  }
  return 0;
}

Verdict Judged(const PlacedCase& c, const Asked& asked, const Answers& answers) {
  Judge judge(c, answers.draws[0]->counts);
  if (!asked.ruler.strips.empty()) judge.SeeRuler(asked.ruler, answers);
  std::size_t draw = asked.ruler.strips.size();
  for (std::size_t k = 0; k < asked.alone.size(); ++k)
    judge.SeeAlone(asked.alone[k], asked.reaches[k], answers.draws[draw++]->counts);
  const bool folds = std::ranges::any_of(asked.meshes, &Mesh::is_folded);
  const int front = folds ? FrontSign(c, asked, answers) : 0;
  for (const Mesh& mesh : asked.meshes) {
    judge.SeeMesh(mesh, draw, answers.draws[draw]->counts, front);
    ++draw;
  }
  return judge.Done();
}

void AskRuler(const PlacedCase& c, Asked& asked, Questions& questions) {
  if (c.profile.freedom.ties == TieOwnership::kOpen) return;  // a strip's diagonal may have cracks
  asked.ruler = PlaceRulerFor(c);
  for (const PlaceRuler::Strips& strips : asked.ruler.strips)
    questions.draws.push_back(CountsOf(strips.scene, c.profile, WholeTarget(c)));
}

// Evenly over the list.
void AskAlone(const PlacedCase& c, Asked& asked, Questions& questions) {
  const std::size_t size = c.scene.triangles.size();
  const std::size_t most = std::min(size, kMostAlone);
  const auto scene = std::make_shared<const Scene>(c.scene);
  for (std::size_t k = 0; k < most; ++k) {
    const std::size_t t = k * size / most;
    std::optional<TriangleReach> reach = ReachOfTriangle(c, c.scene.triangles[t]);
    if (!reach) continue;
    asked.alone.push_back(t);
    asked.reaches.push_back(*std::move(reach));
    questions.draws.push_back(CountsOfOne(scene, t, c.profile, WholeTarget(c)));
  }
}

void AskMeshes(const PlacedCase& c, const Description& subject, Asked& asked,
               Questions& questions) {
  if (c.scene.triangles.size() < 2 || c.scene.triangles.size() > kMostInAMesh) return;
  for (const Point2 by : kMoves) {
    if (c.before && by != Point2{}) break;  // its own transform takes places of the case alone
    std::optional<Mesh> mesh = MeshOf(c, by, subject);
    if (!mesh) continue;
    questions.draws.push_back(CountsOf(mesh->c.scene, c.profile, WholeTarget(c)));
    asked.meshes.push_back(*std::move(mesh));
  }
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (c.before && c.profile.freedom.transform_error != 0.0)
    return NotExercised("the subject's own transform may err");
  auto asked = std::make_shared<Asked>();
  Questions questions;
  AskRuler(c, *asked, questions);
  AskAlone(c, *asked, questions);
  AskMeshes(c, subject, *asked, questions);
  if (questions.draws.empty()) return NotExercised("nothing is known of where its triangles lie");
  return OneCheck(std::move(questions),
                  [&c, asked](const Answers& answers) { return Judged(c, *asked, answers); });
}

constexpr auto kDomains = std::to_array<std::string_view>(
    {"fine-meshes", "uniform-subpixel", "axis-aligned", "vertices-on-samples", "fans", "grids",
     "edges-through-samples", "shared-edge", "tile-borders", "needles", "pattern-lines"});
constexpr auto kClauses = std::to_array<std::string_view>({"vulkan.samples-in-the-pixel"});

}  // namespace samples_lie_in_their_pixel

extern constinit const Property kSamplesLieInTheirPixel{
    .name = "SamplesLieInTheirPixel",
    .group = "coverage",
    .clause =
        "Sample points lie inside or on the boundary of the pixel's unit square (Vulkan, "
        "Multisampling), and are one choice for all that is drawn over it.",
    .required_by = samples_lie_in_their_pixel::kClauses,
    .tolerance = "the profile's own freedom, and the closed pixel",
    .domains = samples_lie_in_their_pixel::kDomains,
    .gate =
        {.any_model = true,
         .judges_clipped = true,
         .unwrapped = true,
         .rules = samples_lie_in_their_pixel::kRules,
         .asks_oracle = true,
         .where =
             "strips of sixteenths of a pixel; some triangles alone; meshes that nothing clips, "
             "also moved by sixteenths of a pixel, in pixels away from their outline, and "
             "of a subject without facings only those that no legal choice folds"},
    .ask = samples_lie_in_their_pixel::Ask,
};

}  // namespace rasterproof::props
