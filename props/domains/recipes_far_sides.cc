// Edges as wide as the stated range, on targets that reach beyond it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"

namespace rasterproof::props {
namespace {

// A target's long side. On 4096 by 4096 pixels an edge value of signed 12.4 input has 34 bits at
// most, and on few rows of 4096 it has them too, in their far corner.
constexpr std::array<int, 6> kLengths{4096, 4096, 4096, 4095, 2049, 1024};
constexpr int kFewRows = 8;
constexpr int kMostRows = 40;  // where bins of 16 pixels begin beyond 33 bits

// The lower or the upper end of the range: itself, up to two steps inside, or up to an eighth.
double NearEnd(CaseBuilder& builder, bool upper) {
  const double end = upper ? builder.Range() : builder.LeastOfRange();
  const std::int64_t kind = builder.bits().Int(0, 3);
  if (kind < 2) return end;
  const int inwards = upper ? -1 : 1;
  if (kind == 2) return builder.lattice().Move(end, inwards * builder.bits().Int(0, 2));
  const int most = std::max(0, std::ilogb(builder.Range()) - 2);
  return end + inwards * std::fabs(builder.LogUniform(-4, most));
}

CaseBuilder DrawLongTarget(BitSource& bits, const SubjectInfo& info) {
  const int samples = info.profile.pattern.samples();
  const int rows = bits.Chance(192) ? kFewRows : kMostRows;
  const int length = bits.OneOf(std::span<const int>(kLengths));
  const int across = static_cast<int>(bits.Int(2, std::max(2, rows / samples)));
  const bool is_tall = bits.Chance(96);
  return {bits, info, is_tall ? across : length, is_tall ? length : across};
}

}  // namespace

static Case FarSides(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder = DrawLongTarget(bits, info);
  // From corner to corner of the range. Where the edge falls to the left, the target's far corner
  // lies on one side of it, as far away as can be; else its two other corners do.
  const bool falls_left = bits.Chance(192);
  const double right = NearEnd(builder, true);
  const double top = NearEnd(builder, false);
  const double left = NearEnd(builder, false);
  const double bottom = NearEnd(builder, true);
  const Point2 a{falls_left ? right : left, top};
  const Point2 b{falls_left ? left : right, bottom};
  // The others near the edge or as far as the range is: at a sample beyond a thin triangle two
  // values are about half of the third, and only the third has too many bits.
  const double least = 4 * builder.lattice().Step(builder.Range());
  const auto beside = [&](double side) {
    const double along = builder.Uniform(0, 1);
    const int most = std::max(0, std::ilogb(builder.Range()) - 1);
    const double off = side * std::max(least, std::fabs(builder.LogUniform(-4, most)));
    return Point2{a.x + along * (b.x - a.x) + (falls_left ? off : -off),
                  a.y + along * (b.y - a.y) + off};
  };
  const std::int32_t ia = builder.Add(a);
  const std::int32_t ib = builder.Add(b);
  const std::int64_t kind = bits.Int(0, 3);
  if (kind != 3) builder.AddTriangle(ia, ib, builder.Add(beside(-1)));
  if (kind >= 2) builder.AddTriangle(ib, ia, builder.Add(beside(+1)));
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kFarSidesDomain{
    .number = 70,
    .bits = 0xc281c76bcbcd063b,
    .name = "far-sides",
    .summary = "edges as wide as the stated range, targets of up to 4096 a side",
    .theme = DomainTheme::kMagnitudes,
    .in_theme = 181,
    .mesh = true,
    .draw = FarSides};

}  // namespace rasterproof::props
