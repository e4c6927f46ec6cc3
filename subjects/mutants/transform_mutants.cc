// Bugs in the transform from clip space to the window, and transforms that keep their contract.
#include <cmath>
#include <cstdint>
#include <vector>

#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

struct Vertex32 {
  float x = 0;
  float y = 0;
  float w = 1;
};

Vertex32 InFloat(const Vertex& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.w)};
}

float Half(int size) { return static_cast<float>(size) * 0.5F; }

// As the stated operations say, written out once more.
Point2 Quotients(const Vertex& v, const Scene&) {
  const Vertex32 c = InFloat(v);
  return {c.x / c.w, c.y / c.w};
}

Point2 Reciprocals(const Vertex& v, const Scene&) {
  const Vertex32 c = InFloat(v);
  const float r = 1.0F / c.w;
  return {c.x * r, c.y * r};
}

Point2 MultipliedAndAdded(const Vertex& v, const Scene& scene) {
  const Vertex32 c = InFloat(v);
  const float w = Half(scene.width);
  const float h = Half(scene.height);
  return {c.x / c.w * w + w, -(c.y / c.w) * h + h};
}

Point2 Fused(const Vertex& v, const Scene& scene) {
  const Vertex32 c = InFloat(v);
  const float w = Half(scene.width);
  const float h = Half(scene.height);
  return {std::fma(c.x / c.w, w, w), std::fma(-(c.y / c.w), h, h)};
}

Point2 AddedAndMultiplied(const Vertex& v, const Scene& scene) {
  const Vertex32 c = InFloat(v);
  const float r = 1.0F / c.w;
  return {(c.x * r + 1.0F) * Half(scene.width), (c.y * r + 1.0F) * Half(scene.height)};
}

Point2 InDouble(const Vertex& v, const Scene& scene) {
  return {v.x / v.w * (scene.width * 0.5) + scene.width * 0.5,
          v.y / v.w * (scene.height * 0.5) + scene.height * 0.5};
}

constexpr Transform kQuotients{};

// Shows fragments, with depths that are off by `depth_error`.
TransformStages ShownAsFragments(double depth_error) {
  return {kQuotients, Quotients, true, depth_error};
}

TransformStages WithFlatDepths(double difference) {
  TransformStages stages = ShownAsFragments(0);
  stages.flat_depths = difference;
  return stages;
}

constexpr Transform kMultiplyAdd{.viewport = ViewportForm::kMultiplyAdd, .flips_y = true};

std::vector<Mutant> TransformMutants() {
  return {
      {"transform-reciprocal", "x is multiplied by 1/w where it is to be divided", "",
       TransformStages{kQuotients, Reciprocals}, "transform"},
      {"transform-w-12-bits", "the reciprocal of w has 12 bits", "PPSSPP #9686",
       TransformStages{kQuotients,
                       [](const Vertex& v, const Scene&) {
                         const Vertex32 c = InFloat(v);
                         const float r =
                             std::ldexp(std::nearbyint(std::ldexp(1.0F / c.w, 12)), -12);
                         return Point2{c.x * r, c.y * r};
                       }},
       "transform"},
      {"transform-w-near-one", "w within 2^-10 of one is taken for one", "",
       TransformStages{kQuotients,
                       [](const Vertex& v, const Scene& scene) {
                         Vertex near = v;
                         if (std::fabs(v.w - 1) < 0x1p-10) near.w = 1;
                         return Quotients(near, scene);
                       }},
       "transform"},
      {"transform-fused", "the viewport is one fused operation where two are stated",
       "one Mesa binary rounds either way, by path", TransformStages{kMultiplyAdd, Fused},
       "transform"},
      {"transform-half-pixels-lost", "half the target's size is truncated to whole pixels", "",
       TransformStages{kMultiplyAdd,
                       [](const Vertex& v, const Scene& scene) {
                         Scene even = scene;
                         even.width &= ~1;
                         even.height &= ~1;
                         return MultipliedAndAdded(v, even);
                       }},
       "transform"},
      {"transform-flipped-late", "y is flipped in the window: the height less y", "",
       TransformStages{kMultiplyAdd,
                       [](const Vertex& v, const Scene& scene) {
                         const Vertex32 c = InFloat(v);
                         const float h = Half(scene.height);
                         const float y = static_cast<float>(scene.height) - (c.y / c.w * h + h);
                         return Point2{MultipliedAndAdded(v, scene).x, y};
                       }},
       "transform"},
      {"transform-in-double", "float64 where float32 is stated", "",
       TransformStages{Transform{.viewport = ViewportForm::kMultiplyAdd}, InDouble}, "transform"},
      {"transform-depth-off", "depths are off by a quarter more than is said of them", "",
       ShownAsFragments(1.25 * kDepthError), "shown-values"},
      {"transform-flat-depths", "depths that differ by less than 2^-10 are taken for one", "",
       WithFlatDepths(0x1p-10), "shown-values"},
  };
}

std::vector<Mutant> TransformVariants() {
  return {
      {"transform-quotients", "x is divided by w in float32", "",
       TransformStages{kQuotients, Quotients}},
      {"transform-multiply-add", "float32 quotients, a viewport of two operations, y flipped",
       "Direct3D's way round", TransformStages{kMultiplyAdd, MultipliedAndAdded}},
      {"transform-fused", "float32 quotients, a fused viewport, y flipped", "",
       TransformStages{Transform{.viewport = ViewportForm::kFused, .flips_y = true}, Fused}},
      {"transform-add-multiply", "float32 reciprocals, one is added before the scale", "",
       TransformStages{
           Transform{.division = Division::kReciprocal, .viewport = ViewportForm::kAddMultiply},
           AddedAndMultiplied}},
      {"transform-float64", "all in float64", "",
       TransformStages{
           Transform{.precision = Precision::kFloat64, .viewport = ViewportForm::kMultiplyAdd},
           InDouble}},
      {"transform-fragments",
       "x is divided by w in float32, and fragments are shown, as far off as is said", "",
       ShownAsFragments(0.75 * kDepthError)},
  };
}

}  // namespace

extern constinit const MutantTable kTransformMutants{MutantKind::kPlanted, 9, TransformMutants};
extern constinit const MutantTable kTransformVariants{MutantKind::kLegal, 2, TransformVariants};

}  // namespace rasterproof::subjects::mutants
