#include "props/catalog/witness.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/profile.h"
#include "exact/attributes.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {
namespace {

// A failing case of a campaign has few triangles; in a whole mesh the first ones must do.
constexpr std::size_t kMaxTrianglesBlamed = 256;

std::string CountText(const CoverageCounts& counts, std::size_t index) {
  return "front " + std::to_string(counts.front[index]) + ", back " +
         std::to_string(counts.back[index]);
}

int NearestEdge(const std::array<Point2, 3>& v, Point2 p) {
  int nearest = -1;
  std::optional<exact::Rational> least;
  for (int i = 0; i < 3; ++i) {
    const auto square = exact::SquaredLineDistance(EdgeStart(v, i), EdgeEnd(v, i), p);
    if (square && (!least || *square < *least)) {
      least = square;
      nearest = i;
    }
  }
  return nearest;
}

std::string EdgeValuesText(const std::array<Point2, 3>& v, Point2 p) {
  std::string text = "; exact E of edges 0, 1, 2: ";
  for (int i = 0; i < 3; ++i) {
    text += exact::EdgeValue(EdgeStart(v, i), EdgeEnd(v, i), p).ToString();
    if (i < 2) text += ", ";
  }
  return text;
}

}  // namespace

std::string HexText(double x) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%a", x);
  return text.data();
}

std::string HexText(Point2 p) { return "(" + HexText(p.x) + ", " + HexText(p.y) + ")"; }

Witness WitnessAt(int triangle, int edge, const SamplePlace& place, std::string observed,
                  std::string expected) {
  return {triangle,           edge, place.x, place.row, place.sample, std::move(observed),
          std::move(expected)};
}

Witness WitnessOfCounts(const CoverageCounts& observed, const CoverageCounts& expected,
                        std::size_t index) {
  const auto samples = static_cast<std::size_t>(expected.samples);
  const auto width = static_cast<std::size_t>(expected.width);
  Witness witness;
  witness.x = static_cast<int>(index / samples % width);
  witness.y = static_cast<int>(index / samples / width);
  witness.sample = static_cast<int>(index % samples);
  witness.observed = CountText(observed, index);
  witness.expected = CountText(expected, index);
  return witness;
}

namespace {

// The subject's counts for the case, or nothing if it refuses it: then that is not what failed.
std::optional<CoverageCounts> DrawnIfPossible(Subject& subject, const Case& c,
                                              const DrawOptions& options) {
  try {
    return Drawn(subject, c.scene, c.profile, options);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void BlameOneOf(Subject& subject, const Case& c, const DrawOptions& options, Witness& witness) {
  const std::size_t count = std::min(c.scene.triangles.size(), kMaxTrianglesBlamed);
  for (std::size_t t = 0; t < count; ++t) {
    const Case alone = OnlyTriangles(c, {t});
    const std::optional<CoverageCounts> observed = DrawnIfPossible(subject, alone, options);
    if (!observed) continue;
    const CoverageCounts expected = exact::Coverage(alone.scene, alone.profile, options);
    const std::size_t index = expected.Index(witness.x, witness.y, witness.sample);
    if (observed->front[index] == expected.front[index] &&
        observed->back[index] == expected.back[index]) {
      continue;
    }
    witness.triangle = static_cast<int>(t);
    if (c.scene.clip_space) return;
    const auto places = SomeTriangles(alone, 1);
    if (places.empty()) return;
    const Point2 p = PlaceOf(c, witness.x, witness.y, witness.sample).at;
    witness.edge = NearestEdge(places[0].at, p);
    witness.expected += EdgeValuesText(places[0].at, p);
    return;
  }
}

}  // namespace

void BlameTriangle(Subject& subject, const Case& c, const DrawOptions& options, Witness& witness) {
  try {
    BlameOneOf(subject, c, options, witness);
  } catch (const SubjectFault&) {
    // What is wrong was seen before: a breakdown over less of the case does not unsay it.
  } catch (const SubjectTooSlow&) {
    // Nor does a lack of time.
  }
}

}  // namespace rasterproof::props
