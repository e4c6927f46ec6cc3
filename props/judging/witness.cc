#include "props/judging/witness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "exact/edge.h"
#include "legal/allowed.h"
#include "props/judging/freedom/thin_triangles.h"
#include "props/judging/freedom/visible_edge.h"
#include "props/judging/mesh/mesh_neighbours.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// A failing case of a campaign has few triangles; in a whole mesh the first ones must do.
constexpr std::size_t kMaxTrianglesBlamed = 256;

WitnessValue CountsAt(const CoverageCounts& counts, std::size_t index) {
  return {FacingCounts{counts.front[index], counts.back[index]}};
}

}  // namespace

RationalText Exactly(const exact::Rational& number) { return {number.ToString()}; }

RationalText ExactEdge(Point2 a, Point2 b, Point2 p) { return Exactly(exact::EdgeValue(a, b, p)); }

std::string HexText(Point2 p) { return "(" + HexText(p.x) + ", " + HexText(p.y) + ")"; }

Witness WitnessAt(int triangle, int edge, const SamplePlace& place, WitnessValue observed,
                  WitnessValue expected) {
  return {triangle,           edge, place.x, place.row, place.sample, std::move(observed),
          std::move(expected)};
}

Witness WitnessAtIndex(const CoverageCounts& shape, std::size_t index) {
  const auto samples = static_cast<std::size_t>(shape.samples);
  const auto width = static_cast<std::size_t>(shape.width);
  Witness witness;
  witness.x = static_cast<int>(index / samples % width);
  witness.y = static_cast<int>(index / samples / width);
  witness.sample = static_cast<int>(index % samples);
  return witness;
}

Witness WitnessOfCounts(const CoverageCounts& observed, const CoverageCounts& expected,
                        std::size_t index) {
  Witness witness = WitnessAtIndex(expected, index);
  witness.observed = CountsAt(observed, index);
  witness.expected = CountsAt(expected, index);
  return witness;
}

namespace {

// Lists the exact edge values of the triangle beside the value.
void AddEdgeValues(const PlacedCase& alone, Point2 p, WitnessValue& value) {
  if (alone.scene.clip_space) return;
  for (const CornersPlace& place : SomeTriangles(alone, 1)) {
    for (int i = 0; i < 3; ++i) {
      value.emplace_back(i == 0 ? "; exact E of edges v1-v2, v2-v0, v0-v1: " : ", ");
      value.push_back(ExactEdge(EdgeStart(place.at, i), EdgeEnd(place.at, i), p));
    }
  }
}

Point2 SampleOf(const PlacedCase& c, const Witness& witness) {
  return PlaceOf(c, witness.x, witness.y, witness.sample).at;
}

std::size_t TrianglesToBlame(const PlacedCase& c) {
  return std::min(c.scene.triangles.size(), kMaxTrianglesBlamed);
}

Verdict Blamed(Witness witness) { return Verdict::Violated(1, "", std::move(witness)); }

// The edge nearest to the witness's sample of all that the first triangles have.
Verdict BlameNearest(const PlacedCase& c, Witness witness) {
  const Point2 p = SampleOf(c, witness);
  std::optional<exact::Rational> least;
  for (std::size_t t = 0; t < TrianglesToBlame(c); ++t) {
    const std::array<Vertex, 3> v = Corners(c.placed, c.placed.triangles[t]);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    for (int i = 0; i < 3; ++i) {
      const VisibleEdge edge(EdgeStart(v, i), EdgeEnd(v, i));
      if (least && edge.Distance(p) > 1 + std::sqrt(least->ToDouble())) continue;
      const std::optional<exact::Rational> square = edge.SquaredDistance(p);
      if (!square || (least && *square >= *least)) continue;
      least = square;
      witness.triangle = static_cast<int>(t);
      witness.edge = i;
    }
  }
  return Blamed(std::move(witness));
}

// Violated if the subject's counts for triangle t alone are not legal at the witness's sample.
Verdict BlameOne(const PlacedCase& c, std::size_t t, const DrawOptions& options, Witness witness,
                 const CoverageCounts& observed) {
  const PlacedCase alone = c.Only({t});
  const std::size_t index = observed.Index(witness.x, witness.y, witness.sample);
  const legal::Allowed allowed(alone, {}, options);
  if (!allowed.why_not().empty() || allowed.Allows(observed, index)) return Verdict::Held(1);
  witness.triangle = static_cast<int>(t);
  const std::array<Vertex, 3> v = Corners(alone.placed, alone.placed.triangles[0]);
  if (std::ranges::all_of(v, IsFinite)) {
    const Point2 p = SampleOf(c, witness);
    witness.edge = NearestEdge(v, p);
    AddEdgeValues(alone, p, witness.expected);
  }
  return Blamed(std::move(witness));
}

}  // namespace

Checks BlameTriangles(const PlacedCase& c, const Verdict& verdict, const DrawOptions& options) {
  const Witness& witness = *verdict.witness;
  if (LegalReach(c) != 0) {
    return OneCheck({}, [&c, witness](const Answers&) { return BlameNearest(c, witness); });
  }
  Checks asked;
  const auto scene = std::make_shared<const Scene>(c.scene);
  for (std::size_t t = 0; t < TrianglesToBlame(c); ++t) {
    Check check;
    check.questions.draws.push_back(CountsOfOne(scene, t, c.profile, options));
    check.judge = [&c, t, options, witness](const Answers& answers) {
      return BlameOne(c, t, options, witness, answers.draws[0]->counts);
    };
    asked.checks.push_back(std::move(check));
  }
  return asked;
}

}  // namespace rasterproof::props
