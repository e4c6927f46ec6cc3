// One of our own methods as a plugin, -DMETHOD=F32Direct and so on, to be swept with the sources
// of reference/ that it calls (docs/stiff.md names them).
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "kit/rasterproof_plugin.h"
#include "reference/box.h"
#include "reference/edge_walks.h"
#include "reference/fill.h"
#include "reference/filtered_form.h"
#include "reference/integer_form.h"
#include "reference/method.h"
#include "reference/spans.h"

namespace rasterproof::reference {
namespace {

struct SweptMethod {
  Stages stages;
  const char* profile;
  rasterproof_input input;
};

template <class Walk>
constexpr Stages Walking(int (*facing)(const Corners3&, const RasterOptions&)) {
  return {&PlaceAsGiven, &BoxOfCorners, facing, &FillByWalk<Walk>};
}

template <class Walk>
constexpr SweptMethod Real(rasterproof_input input) {
  return {Walking<Walk>(&FacingBy<typename Walk::Form>), "real", input};
}

// Inside the integers' proven domain, which the profile's limit is: no spans beyond it.
template <class Form>
std::optional<Corners3> PlaceOnGrid(const Corners3& given) {
  std::optional<Corners3> v = PlaceAsGiven(given);
  if (!v) return v;
  for (Vertex& vertex : *v) {
    const Point2 p = Form::Snapped(WindowPoint(vertex));
    if (!Form::Fits(p)) return std::nullopt;
    vertex.x = p.x;
    vertex.y = p.y;
  }
  return v;
}

template <class Form>
constexpr SweptMethod Snapped(const char* profile) {
  Stages stages = Walking<RowWalk<Form>>(&FacingBy<Form>);
  stages.place = &PlaceOnGrid<Form>;
  return {stages, profile, RASTERPROOF_FLOAT64};
}

// Templates, so that a method which is not asked for needs no source.
template <int = 0>
SweptMethod F32Direct() {
  return Real<FreshWalk<DirectForm<float>>>(RASTERPROOF_FLOAT32);
}
template <int = 0>
SweptMethod F32Kahan() {
  return Real<FreshWalk<KahanForm<float>>>(RASTERPROOF_FLOAT32);
}
template <int = 0>
SweptMethod F32Affine() {
  return Real<FreshWalk<AffineForm<float>>>(RASTERPROOF_FLOAT32);
}
template <int = 0>
SweptMethod F32Incremental() {
  return Real<CornerWalk<DirectForm<float>>>(RASTERPROOF_FLOAT32);
}
template <int = 0>
SweptMethod F64Direct() {
  return Real<FreshWalk<DirectForm<double>>>(RASTERPROOF_FLOAT64);
}
template <int = 0>
SweptMethod I64Snap8() {
  return Snapped<IntegerForm<std::int64_t, 8>>(
      R"({"name": "swept", "subpixel_bits": 8, "coordinate_limit": 4194304})");
}
template <int = 0>
SweptMethod FilteredExact() {
  return {Walking<FreshWalk<FilteredForm>>(&ExactFacing), "real", RASTERPROOF_FLOAT64};
}
template <int = 0>
SweptMethod SpansExact() {
  return {{&PlaceAsGiven, &BoxOfCorners, &ExactFacing, &FillSpans}, "real", RASTERPROOF_FLOAT64};
}

Corners3 CornersOf(const rasterproof_scene& scene, std::size_t triangle) {
  Corners3 v;
  for (std::size_t k = 0; k < 3; ++k) {
    const double* at = scene.vertices + 4 * scene.triangles[3 * triangle + k];
    v[k] = {at[0], at[1], at[2], at[3]};
  }
  return v;
}

std::int32_t DrawByMethod(void* /*state*/, const rasterproof_scene* scene,
                          const rasterproof_target* target) {
  const Stages stage = METHOD().stages;
  const PixelRect whole{0, 0, scene->width, scene->height};
  for (std::size_t t = 0; t < scene->triangle_count; ++t) {
    std::optional<Corners3> v = stage.place(CornersOf(*scene, t));
    if (!v) continue;
    const PixelRect box = stage.box(*v, whole);
    const int facing = IsEmpty(box) ? 0 : stage.facing(*v, {});
    if (facing == 0) continue;
    if (facing < 0) std::swap((*v)[1], (*v)[2]);
    stage.fill(*v, {}, {box, box, target->front, static_cast<int>(target->stride)});
  }
  return 0;
}

}  // namespace
}  // namespace rasterproof::reference

const rasterproof_plugin* rasterproof_plugin_describe() {
  static rasterproof_plugin plugin;
  plugin.version = RASTERPROOF_PLUGIN_VERSION;
  plugin.size = sizeof plugin;
  plugin.name = "swept";
  plugin.profile = rasterproof::reference::METHOD().profile;
  plugin.input = rasterproof::reference::METHOD().input;
  plugin.coverage = RASTERPROOF_COUNTS;
  plugin.draw = rasterproof::reference::DrawByMethod;
  return &plugin;
}
