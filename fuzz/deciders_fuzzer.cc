// The oracle against itself: its deciders agree on every edge sign, and on whole coverages.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/case.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "fuzz/fuzz_target.h"
#include "props/judging/places.h"
#include "props/placed_case.h"

namespace {

using rasterproof::Case;
using rasterproof::Point2;
using rasterproof::exact::Decider;
using rasterproof::exact::EdgeSign;
using rasterproof::fuzz::Fail;

// CGAL costs ten times the integers: one sample in this many.
constexpr std::uint64_t kCgalShare = 16;
constexpr int kTriangles = 4;
constexpr int kPerEdge = 4;

void CompareSigns(const Case& c) {
  std::uint64_t asked = 0;
  const rasterproof::props::PlacedCase placed(c);
  for (const auto& corners : rasterproof::props::SomeTriangles(placed, kTriangles)) {
    for (const auto& place : rasterproof::props::SamplesNearEdges(placed, corners.at, kPerEdge)) {
      for (int i = 0; i < 3; ++i) {
        const Point2 a = rasterproof::props::EdgeStart(corners.at, i);
        const Point2 b = rasterproof::props::EdgeEnd(corners.at, i);
        const int fast = EdgeSign(a, b, place.at);
        const bool cgal = asked++ % kCgalShare == 0;
        if (fast != EdgeSign(a, b, place.at, Decider::kIntegers) ||
            fast != -EdgeSign(b, a, place.at) || fast != EdgeSign(a, place.at, b) * -1 ||
            (cgal && fast != EdgeSign(a, b, place.at, Decider::kCgal))) {
          Fail("the deciders disagree on an edge sign");
        }
      }
    }
  }
}

void CompareCoverage(const Case& c) {
  constexpr std::int64_t kMostSamples = 12 * 12;
  constexpr std::size_t kMostTriangles = 4;
  if (!rasterproof::fuzz::Limits{kMostSamples, kMostTriangles}.Admit(c)) return;
  using rasterproof::exact::Coverage;
  if (Coverage(c.scene, c.profile, c.options) !=
      Coverage(c.scene, c.profile, c.options, Decider::kIntegers)) {
    Fail("the deciders disagree on a coverage");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using rasterproof::fuzz::Bound;
  using rasterproof::fuzz::Checked;
  // Subjects of float64, of a grid and of clip space: they lend their inputs.
  static const Bound bound(std::to_array<Checked>({{"spans-exact", "CoverageEqualsTheModel"},
                                                   {"i64-snap8", "CoverageEqualsTheModel"},
                                                   {"hom-exact", "CoverageEqualsTheModel"}}));
  return bound.ForEachCase(std::span(data, size), [](const auto& /*group*/, const Case& c) {
    if (!c.scene.clip_space) CompareSigns(c);
    if (!rasterproof::exact::WhyNotDecided({c.scene, c.profile})) CompareCoverage(c);
  });
}
