// Numbers of one bit too few: what a rasterizer of 12.4 input keeps of edge values, products and
// steps.
//
// In units of 1/16 pixel a coordinate lies in [-32768, 32767], so differences have 17 bits, and an
// edge value at a sample of the vertices' box 33. A target of 4096 pixels a side reaches beyond the
// range, to 65528: there edge values have up to 34 bits (8,588,820,495 at most), a step of a pixel
// 21, one of 8 pixels 24.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

// The base's grid has 8 bits, the input 4 of them.
constexpr std::int64_t kUnit = 16;
constexpr std::int64_t kUnitsOfAPixel = 16;  // in units
constexpr int kBin = 8;

// Wraps n to two's complement of `bits` bits.
std::int64_t Wrapped(std::int64_t n, int bits) {
  const int unused = 64 - bits;
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(n) << unused) >> unused;
}

std::int64_t Saturated(std::int64_t n, int bits) {
  const std::int64_t end = std::int64_t{1} << (bits - 1);
  return std::clamp(n, -end, end - 1);
}

// What an edge is to a rasterizer of 12.4 input, all in its units.
std::int64_t ValueAt(const GridEdge& e, GridPoint p) { return e.At(p) / (kUnit * kUnit); }
std::int64_t Rise(const GridEdge& e) { return (e.b.y - e.a.y) / kUnit; }

GridPoint Moved(GridPoint p, std::int64_t pixels_x, std::int64_t pixels_y) {
  return {p.x + pixels_x * kUnitsOfAPixel * kUnit, p.y + pixels_y * kUnitsOfAPixel * kUnit};
}

FixedStages Of(FixedStages stages) {
  stages.profile.name = "12.4 input";
  stages.profile.fixed = FixedInput{12, 4, true, false};
  stages.profile.snap = {};
  return stages;
}

using Value = std::function<std::int64_t(const GridEdge&, const Sample&)>;

// `value` at every sample of the target, of the triangle's box or not.
FixedStages OnAllOfTheTarget(Value value) {
  return Of({{.box = [](PixelRect& box, const GridTriangle&,
                        const Scene& scene) { box = {0, 0, scene.width, scene.height}; },
              .value = std::move(value)}});
}

FixedStages ValuesOf(int bits) {
  return OnAllOfTheTarget(
      [bits](const GridEdge& e, const Sample& at) { return Wrapped(ValueAt(e, at.at), bits); });
}

FixedStages ProductsOf(int bits) {
  return OnAllOfTheTarget([bits](const GridEdge& e, const Sample& at) {
    const auto product = [bits](std::int64_t a, std::int64_t b) {
      return Wrapped(a / kUnit * (b / kUnit), bits);
    };
    return product(at.at.x - e.a.x, e.b.y - e.a.y) - product(at.at.y - e.a.y, e.b.x - e.a.x);
  });
}

// Steps from the left end of the row by `pixels` pixels at a time, with a step that wraps at `bits`
// bits, and then by single pixels, which are sound.
FixedStages StepsOf(int pixels, int bits) {
  return OnAllOfTheTarget([pixels, bits](const GridEdge& e, const Sample& at) {
    const int single = at.x % pixels;
    const std::int64_t step = Wrapped(pixels * kUnitsOfAPixel * Rise(e), bits);
    return ValueAt(e, Moved(at.at, -at.x, 0)) + at.x / pixels * step +
           single * kUnitsOfAPixel * Rise(e);
  });
}

// Takes floats up to 2048 on a grid of four bits: the places of 12.4 input, and one step more.
FixedStages LimitedTo2048(FixedStages stages) {
  stages.profile = FixedPointProfile();
  stages.profile.snap.bits = 4;
  stages.profile.coordinate_limit = 0x1p11;
  return stages;
}

FixedStages SaturatingRows(int bits) {
  return OnAllOfTheTarget([bits](const GridEdge& e, const Sample& at) {
    const int steps = at.width - 1 - at.x;
    const std::int64_t at_the_end = ValueAt(e, Moved(at.at, steps, 0));
    return Saturated(at_the_end, bits) - steps * kUnitsOfAPixel * Rise(e);
  });
}

FixedStages BinCornersOf(int bits) {
  return OnAllOfTheTarget([bits](const GridEdge& e, const Sample& at) {
    const std::int64_t corner = ValueAt(e, Moved(at.at, -(at.x % kBin), -(at.row % kBin)));
    return Wrapped(corner, bits) + ValueAt(e, at.at) - corner;
  });
}

std::vector<Mutant> WidthMutants() {
  return {
      {"width-values-32", "edge values of 12.4 input have 32 bits", "", ValuesOf(32), "overflow"},
      {"width-values-33", "edge values of 12.4 input have 33 bits, those of the vertices' box", "",
       ValuesOf(33), "overflow"},
      {"width-values-33-of-floats", "edge values have 33 bits, of floats on 4 bits up to 2048", "",
       LimitedTo2048(ValuesOf(33)), "overflow"},
      {"width-saturates-33", "rows begin at their right end, with values that saturate at 33 bits",
       "", SaturatingRows(33), "overflow"},
      {"width-products-32", "products of 12.4 input have 32 bits, their difference all", "",
       ProductsOf(32), "overflow"},
      {"width-products-33", "products of 12.4 input have 33 bits, their difference all", "",
       ProductsOf(33), "overflow"},
      {"width-steps-20", "steps of a pixel have 20 bits", "", StepsOf(1, 20), "overflow"},
      {"width-steps-of-8-23", "steps of 8 pixels have 23 bits", "", StepsOf(kBin, 23), "overflow"},
      {"width-bin-corners-33", "values at the first sample of 8 by 8 have 33 bits", "",
       BinCornersOf(33), "overflow"},
  };
}

std::vector<Mutant> WidthVariants() {
  return {
      {"width-values-34", "edge values of 12.4 input have 34 bits on targets of up to 4096", "",
       OnAllOfTheTarget([](const GridEdge& e, const Sample& at) {
         const std::int64_t value = ValueAt(e, at.at);
         return std::max(at.width, at.height) <= 4096 ? Wrapped(value, 34) : value;
       })},
      {"width-steps-21", "steps of a pixel have 21 bits", "", StepsOf(1, 21)},
      {"width-steps-of-8-24", "steps of 8 pixels have 24 bits", "", StepsOf(kBin, 24)},
  };
}

}  // namespace

extern constinit const MutantTable kWidthMutants{MutantKind::kPlanted, 24, WidthMutants};
extern constinit const MutantTable kWidthVariants{MutantKind::kLegal, 16, WidthVariants};

}  // namespace rasterproof::subjects::mutants
