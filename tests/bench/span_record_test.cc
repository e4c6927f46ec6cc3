#include "bench/span_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "bench/family.h"
#include "library/kernels/kernel.h"

namespace rasterproof::bench {
namespace {

namespace kernels = library::kernels;

FamilyInput FamilyNamed(std::string_view name) {
  const auto kinds = FamilyKinds();
  return MakeFamily(*std::ranges::find(kinds, name, &FamilyKind::name), FamilySize::kQuick, 1);
}

int Differing(const kernels::Surface& a, const kernels::Surface& b) {
  int differing = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) differing += a.At(x, y) != b.At(x, y) ? 1 : 0;
  }
  return differing;
}

// The floor is one only if it writes all that the kernel writes: small triangles, wide ones, those
// of one pixel's row, slivers with empty rows between.
TEST(SpanRecord, WritesWhatTheExactKernelDraws) {
  for (const std::string_view name : {"px5", "px100", "needles"}) {
    const FamilyInput family = FamilyNamed(name);
    const kernels::KernelScene scene = family.KernelScene();
    for (const kernels::Target target : kernels::SupportedTargets()) {
      const SpanRecord record(target, scene);
      for (const kernels::Sink sink : kernels::kSinks) {
        kernels::Surface drawn(sink, scene.width, scene.height);
        kernels::Draw(target, scene, drawn);
        kernels::Surface written(sink, scene.width, scene.height);
        kernels::DrawKnown(target, record.View(), scene, written);
        EXPECT_EQ(Differing(written, drawn), 0)
            << name << " " << NameOf(target) << " " << NameOf(sink);
      }
    }
  }
}

TEST(SpanRecord, WritesWhatTheKernelOfClipSpaceDraws) {
  const FamilyInput family = FamilyNamed("perspective");
  const kernels::ClipScene scene{family.clip_vertices, family.indices, family.scene.width,
                                 family.scene.height, kernels::NearPlane::kNone};
  for (const kernels::Target target : kernels::SupportedTargets()) {
    const SpanRecord record(target, scene);
    for (const kernels::Sink sink : {kernels::Sink::kFacing, kernels::Sink::kMask}) {
      kernels::Surface drawn(sink, scene.width, scene.height);
      kernels::DrawClip(target, scene, drawn);
      kernels::Surface written(sink, scene.width, scene.height);
      kernels::DrawKnown(target, record.View(), {{}, {}, scene.width, scene.height}, written);
      EXPECT_EQ(Differing(written, drawn), 0) << NameOf(target) << " " << NameOf(sink);
    }
  }
}

}  // namespace
}  // namespace rasterproof::bench
