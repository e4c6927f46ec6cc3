// Edge signs: every arithmetic against the oracle, and the oracle's deciders against each other.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/case.h"
#include "core/subject_info.h"
#include "exact/edge.h"
#include "fuzz/fuzz_target.h"
#include "props/codec/codec.h"

namespace {

using rasterproof::Point2;
using rasterproof::exact::Decider;
using rasterproof::exact::EdgeSign;
using rasterproof::fuzz::Checked;

constexpr std::array kChecked{
    Checked{"f32-direct", "EdgeSignIsRightOutsideItsBand"},
    Checked{"f32-direct", "EdgeErrorStaysWithinItsBound"},
    Checked{"f32-kahan", "EdgeErrorStaysWithinItsBound"},
    Checked{"f32-affine", "EdgeErrorStaysWithinItsBound"},
    Checked{"f64-direct", "EdgeErrorStaysWithinItsBound"},
    Checked{"filtered-exact", "EdgeSignIsRightOutsideItsBand"},
    Checked{"i64-snap8", "EdgeSignIsRightOutsideItsBand"},
};

// CGAL costs ten times the integers: one sample in this many.
constexpr std::uint64_t kCgalShare = 16;

void CompareDeciders(std::span<const std::uint8_t> bytes) {
  rasterproof::SubjectInfo info;
  info.input = rasterproof::Precision::kFloat64;
  const rasterproof::Case c = rasterproof::props::DecodeCase(bytes, info);
  constexpr int kMostSide = 8;  // many samples an execution, but not a whole target
  std::uint64_t asked = 0;
  for (const rasterproof::Triangle& triangle : c.scene.triangles) {
    const auto v = Corners(c.scene, triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!IsFinite(v[k]) || !IsFinite(v[(k + 1) % 3])) continue;
      const Point2 a = WindowPoint(v[k]);
      const Point2 b = WindowPoint(v[(k + 1) % 3]);
      for (int j = 0; j < c.scene.height && j < kMostSide; ++j) {
        for (int i = 0; i < c.scene.width && i < kMostSide; ++i) {
          const Point2 p = c.profile.pattern.At(i, j);
          const int fast = EdgeSign(a, b, p, Decider::kFast);
          const bool cgal = asked++ % kCgalShare == 0;
          if (fast != EdgeSign(a, b, p, Decider::kIntegers) || fast != -EdgeSign(b, a, p) ||
              (cgal && fast != EdgeSign(a, b, p, Decider::kCgal))) {
            rasterproof::fuzz::Fail("the deciders disagree on an edge sign", bytes);
          }
        }
      }
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes(data, size);
  CompareDeciders(bytes);
  rasterproof::fuzz::PutToTheTest(kChecked, bytes);
  return 0;
}
