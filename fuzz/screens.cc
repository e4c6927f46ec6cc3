#include "fuzz/screens.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/evaluators.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "exact/winding.h"
#include "fuzz/guidance.h"
#include "props/judging/gate.h"
#include "props/judging/places.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/witness.h"

namespace rasterproof::fuzz {
namespace {

constexpr int kTriangles = 4;
constexpr int kRows = 16;   // of an edge, or columns
constexpr int kAcross = 4;  // samples in each, half of them on either side

int ClampedFloor(double x, int size) {
  if (!(x > 0)) return 0;
  return x >= size ? size - 1 : static_cast<int>(x);
}

// Samples on both sides of an edge line, in each of some rows, or columns of a flat edge.
struct NearSamples {
  static constexpr std::size_t kMost = std::size_t{kAcross} * kRows;
  std::array<Point2, kMost> at;
  std::size_t count = 0;
};

void FindNear(const Case& c, Point2 a, Point2 b, NearSamples& near) {
  near.count = 0;
  const bool steep = std::fabs(b.y - a.y) >= std::fabs(b.x - a.x);
  const int length = steep ? c.scene.height : c.scene.width;
  const int across = steep ? c.scene.width : c.scene.height;
  const double low = steep ? std::min(a.y, b.y) : std::min(a.x, b.x);
  const double high = steep ? std::max(a.y, b.y) : std::max(a.x, b.x);
  const int first = ClampedFloor(low - 1, length);
  const int last = ClampedFloor(high + 1, length);
  const int count = std::min(kRows, last - first + 1);
  const Point2 offset = c.profile.pattern.locations.front();
  const double slope = steep ? (b.x - a.x) / (b.y - a.y) : (b.y - a.y) / (b.x - a.x);
  for (int k = 0; k < count; ++k) {
    const int along = first + k * (last - first + 1) / count;
    const double crossing = steep ? a.x + (along + offset.y - a.y) * slope - offset.x
                                  : a.y + (along + offset.x - a.x) * slope - offset.y;
    const int side = ClampedFloor(crossing, across);
    const int from = std::clamp(side - kAcross / 2 + 1, 0, std::max(0, across - kAcross));
    for (int place = from; place < std::min(from + kAcross, across); ++place) {
      near.at[near.count++] =
          steep ? c.profile.pattern.At(place, along) : c.profile.pattern.At(along, place);
    }
  }
}

void LookAtSign(const BoundSubject& bound, double value, int sign, Point2 a, Point2 b, Point2 p) {
  if (props::HasSign(value, sign)) return;
  const double stated = bound.subject->Edges()->ErrorBound(a, b, p);
  if (!props::IsStated(stated)) return;
  if (stated > 0 && props::CompareWithEdge(0, a, b, p, stated).within) return;
  Fail("EdgeSignIsRightOutsideItsBand is violated by " + bound.subject->Info().name + ": edge " +
       props::HexText(a) + " -> " + props::HexText(b) + " at " + props::HexText(p) + " is " +
       props::HexText(value) + ", the sign of E is " + std::to_string(sign));
}

// Of the products of E at the first of the samples: they are near each other.
double SizeOfProducts(Point2 a, Point2 b, const NearSamples& near) {
  if (near.count == 0) return 0;
  const Point2 p = near.at[0];
  return std::fabs((p.x - a.x) * (b.y - a.y)) + std::fabs((p.y - a.y) * (b.x - a.x));
}

void LookAtEdge(const Group& group, Point2 a, Point2 b, const NearSamples& near) {
  std::array<int, NearSamples::kMost> signs{};
  for (std::size_t k = 0; k < near.count; ++k) signs[k] = exact::EdgeSign(a, b, near.at[k]);
  for (const BoundSubject& bound : group.subjects) {
    const EdgeEvaluator& edges = *bound.subject->Edges();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < near.count; ++k) {
      const double value = edges.Value(a, b, near.at[k]);
      LookAtSign(bound, value, signs[k], a, b, near.at[k]);
      if (value != 0) least = std::min(least, std::fabs(value));
    }
    NoteNearZero(bound.slot, least, SizeOfProducts(a, b, near));
  }
}

CoverageCounts Drawn(const BoundSubject& bound, const Case& c, const DrawOptions& options) {
  CoverageCounts counts(c.scene.width, c.scene.height, c.profile.pattern.samples());
  DrawOnto(*bound.subject, c.scene, options, counts);
  return counts;
}

// Whether a case is one that the model speaks of. The rest is for the properties about extremes.
bool IsModelled(const props::PlacedCase& c) {
  return WithinLimits(c.scene, c.profile) && !exact::WhyNotDecided(c);
}

}  // namespace

int ScreenEdgeSigns(const Bound& bound, std::span<const std::uint8_t> bytes) {
  return bound.ForEachCase(bytes, [](const Group& group, const Case& c) {
    if (c.scene.clip_space || !WithinLimits(c.scene, c.profile)) return;
    NearSamples near;
    for (const props::CornersPlace& corners :
         props::SomeTriangles(props::PlacedCase(c), kTriangles)) {
      for (int i = 0; i < 3; ++i) {
        const Point2 a = props::EdgeStart(corners.at, i);
        const Point2 b = props::EdgeEnd(corners.at, i);
        FindNear(c, a, b, near);
        LookAtEdge(group, a, b, near);
      }
    }
  });
}

int ScreenCoverage(const Bound& bound, std::span<const std::uint8_t> bytes) {
  return bound.ForEachCase(bytes, [](const Group& group, const Case& c) {
    const props::PlacedCase placed(c);
    if (!IsModelled(placed)) return;
    const CoverageCounts model = exact::Coverage(placed, c.options);
    for (const BoundSubject& each : group.subjects) {
      if (Drawn(each, c, c.options) != model) PutToTheTest(each, c);
    }
  });
}

int ScreenWinding(const Bound& bound, std::span<const std::uint8_t> bytes) {
  return bound.ForEachCase(bytes, [](const Group& group, const Case& c) {
    if (c.scene.clip_space) return;
    const props::PlacedCase placed(c);
    if (!IsModelled(placed)) return;
    const std::vector<std::int64_t> winding = exact::BoundaryWinding(placed);
    for (const BoundSubject& each : group.subjects) {
      const CoverageCounts counts = Drawn(each, c, props::WholeTarget(placed));
      for (std::size_t k = 0; k < winding.size(); ++k) {
        if (counts.Signed(k) != winding[k]) {
          PutToTheTest(each, c);
          break;
        }
      }
    }
  });
}

}  // namespace rasterproof::fuzz
