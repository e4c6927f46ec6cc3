// Clip-space triangles whose plane passes the eye so closely that the determinant of their vertices
// cancels to a few units, and that cover a sample all the same: an edge passes through it.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"

namespace rasterproof::props {
namespace recipes_eye_planes {

using Whole = std::array<std::int64_t, 3>;  // x, y and w

Whole Sum(std::int64_t k, const Whole& a, std::int64_t m, const Whole& b) {
  return {k * a[0] + m * b[0], k * a[1] + m * b[1], k * a[2] + m * b[2]};
}

// Mostly as large as may be: then products have the most bits to lose.
std::int64_t Signed(BitSource& bits, int most_bits) {
  const std::int64_t least = bits.Chance(192) ? most_bits - 2 : 1;
  const auto size =
      static_cast<std::int64_t>(bits.Bits(static_cast<int>(bits.Int(least, most_bits))));
  return bits.Chance(128) ? size : -size;
}

Whole Cross(const Whole& a, const Whole& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::int64_t Dot(const Whole& a, const Whole& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Of the steps of up to four units a coordinate, one with the least product with the normal that is
// not zero.
Whole LeastStepOff(const Whole& normal) {
  Whole least{0, 0, 1};
  std::int64_t best = std::numeric_limits<std::int64_t>::max();
  for (std::int64_t x = -4; x <= 4; ++x) {
    for (std::int64_t y = -4; y <= 4; ++y) {
      for (std::int64_t w = -4; w <= 4; ++w) {
        const std::int64_t off = std::abs(Dot({x, y, w}, normal));
        if (off == 0 || off >= best) continue;
        best = off;
        least = {x, y, w};
      }
    }
  }
  return least;
}

// The first two add up to a small multiple of the sample's ray: it lies on their edge, in front of
// the eye. The third is a step off their plane.
std::array<Whole, 3> Draw(BitSource& bits, const Whole& ray, int digits) {
  const auto size = static_cast<std::uint64_t>(std::max({ray[0], ray[1], ray[2]}));
  const int room = digits - 1 - static_cast<int>(std::bit_width(size));
  const std::int64_t most_aside = bits.Chance(192) ? 1 : 8;
  Whole aside{};
  for (std::int64_t& x : aside) x = bits.Int(-most_aside, most_aside);
  const std::int64_t times = bits.Chance(128) ? 1 : bits.Int(2, 4);
  const Whole first = Sum(Signed(bits, room), ray, 1, aside);
  const Whole second = Sum(times, ray, -1, first);
  const std::int64_t along = Signed(bits, room - 1);
  const std::int64_t across = Signed(bits, digits - (most_aside == 1 ? 2 : 5));
  const std::int64_t side = bits.Chance(128) ? 1 : -1;
  const Whole off = LeastStepOff(Cross(ray, aside));
  return {first, second, Sum(1, Sum(along, ray, across, aside), side, off)};
}

}  // namespace recipes_eye_planes

static Case EyePlanes(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  builder.UseClipSpace();
  const int digits = builder.lattice().digits();
  const std::int64_t triangles = bits.Int(1, 2);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 sample = builder.Sample();
    // Samples in the middle of pixels; others are rounded, and the edge passes beside them.
    const recipes_eye_planes::Whole ray{std::llround(sample.x * 2), std::llround(sample.y * 2), 2};
    const double scale = std::ldexp(1.0, -static_cast<int>(bits.Int(0, digits - 1)));
    std::array<std::int32_t, 3> v{};
    std::size_t corner = 0;
    for (const auto& p : recipes_eye_planes::Draw(bits, ray, digits)) {
      v[corner++] =
          builder.AddRaw({static_cast<double>(p[0]) * scale, static_cast<double>(p[1]) * scale, 0,
                          static_cast<double>(p[2]) * scale});
    }
    builder.AddTriangle(v[0], v[1], v[2]);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kEyePlanesDomain{
    .number = 94,
    .bits = 0xd6a7f0e352989e42,
    .name = "eye-planes",
    .summary = "planes next to the eye: determinants that cancel, edges through samples",
    .theme = DomainTheme::kClip,
    .clip = true,
    .in_a_round = 2,
    .draw = EyePlanes};

}  // namespace rasterproof::props
