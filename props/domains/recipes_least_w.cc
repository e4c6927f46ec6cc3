// Clip-space triangles whose w has no reciprocal.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"

namespace rasterproof::props {

static Case LeastW(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  builder.UseClipSpace();
  // 1 / w overflows below 2^-128 in float32 and below 2^-1024 in float64.
  const int overflows = builder.lattice().precision() == Precision::kFloat32 ? -128 : -1024;
  const std::int64_t triangles = bits.Int(1, 2);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const bool all = bits.Chance(128);
    const std::int64_t one = bits.Int(0, 2);
    std::array<std::int32_t, 3> v{};
    for (std::int64_t k = 0; k < 3; ++k) {
      const bool is_least = all || k == one;
      const auto exponent = is_least ? overflows + static_cast<int>(bits.Int(-12, 2))
                                     : static_cast<int>(bits.Int(-3, 3));
      const double w = std::ldexp(1.0, exponent);
      const Point2 p = builder.Place();
      v[static_cast<std::size_t>(k)] = builder.AddRaw({p.x * w, p.y * w, 0, w});
    }
    builder.AddTriangle(v[0], v[1], v[2]);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kLeastWDomain{
    .number = 93,
    .bits = 0xd7427ce52bb2e7d0,
    .name = "least-w",
    .summary = "one w or all so small that its reciprocal overflows, places on the target",
    .theme = DomainTheme::kClip,
    .clip = true,
    .draw = LeastW};

}  // namespace rasterproof::props
