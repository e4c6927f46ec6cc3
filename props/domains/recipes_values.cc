// Triangles whose values are hard: w of very different sizes, and slivers that differ in w.
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
namespace {

// A vertex that is seen at p, with a w of its own.
std::int32_t AddAt(CaseBuilder& builder, Point2 p, double w) {
  return builder.AddRaw({p.x * w, p.y * w, 0, w});
}

// A ratio of up to 2^60 between the largest w and the smallest, both as far from 1.
Case WRatios(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  builder.UseClipSpace();
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const auto most = static_cast<int>(bits.Int(1, 30));
    std::array<std::int32_t, 3> v{};
    for (std::int32_t& vertex : v) {
      const double w =
          builder.lattice().RoundToFloat(std::fabs(builder.LogUniform(-most, most - 1)));
      vertex = AddAt(builder, builder.Place(), w);
    }
    builder.AddTriangle(v[0], v[1], v[2]);
  }
  return builder.Done(Finish::kAnyOrder);
}

// Around a sample, so that it covers something: a corner on either side of it along a line, and the
// third a little off.
Case ClipSlivers(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  builder.UseClipSpace();
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 p = builder.Sample();
    const Point2 along{builder.Uniform(-20, 20), builder.Uniform(-20, 20)};
    const double thickness = std::ldexp(1.0, -static_cast<int>(bits.Int(0, 12)));
    const double beyond = builder.Uniform(0.25, 2);
    const auto w = [&] {
      return builder.lattice().RoundToFloat(std::fabs(builder.LogUniform(-6, 5)));
    };
    const std::int32_t a = AddAt(builder, {p.x - along.x, p.y - along.y - thickness}, w());
    const std::int32_t b =
        AddAt(builder, {p.x + beyond * along.x, p.y + beyond * along.y - thickness}, w());
    const std::int32_t c =
        AddAt(builder, {p.x + thickness * along.y, p.y - thickness * along.x + thickness}, w());
    builder.AddTriangle(a, b, c);
  }
  return builder.Done(Finish::kAnyOrder);
}

}  // namespace

extern constinit const Domain kWRatiosDomain{
    .number = 104,
    .bits = 0x3864d20a1c832489,
    .name = "w-ratios",
    .summary = "clip space in front of the eye, the largest w up to 2^60 times the smallest",
    .theme = DomainTheme::kClip,
    .clip = true,
    .draw = WRatios};

extern constinit const Domain kClipSliversDomain{
    .number = 105,
    .bits = 0xda432442477f27d7,
    .name = "clip-slivers",
    .summary = "clip space, slivers 1 to 2^-12 of a pixel thick around a sample, w of 1/64 to 64",
    .theme = DomainTheme::kClip,
    .clip = true,
    .draw = ClipSlivers};

}  // namespace rasterproof::props
