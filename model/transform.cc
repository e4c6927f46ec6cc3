#include "model/transform.h"

#include <cmath>
#include <limits>

namespace rasterproof {
namespace {

template <class T>
T Divided(T x, T w, Division division) {
  return division == Division::kQuotient ? x / w : x * (T{1} / w);
}

template <class T>
T Placed(T q, int size, ViewportForm form) {
  const T half = static_cast<T>(size) / 2;
  switch (form) {
    case ViewportForm::kNone:
      break;
    case ViewportForm::kMultiplyAdd:
      return q * half + half;
    case ViewportForm::kFused:
      return std::fma(q, half, half);
    case ViewportForm::kAddMultiply:
      return (q + 1) * half;
  }
  return q;
}

template <class T>
Vertex OnMapIn(const Vertex& v, const MapGrid& map, Division division) {
  const T x = static_cast<T>(v.x) - static_cast<T>(map.x0);
  const T y = static_cast<T>(v.y) - static_cast<T>(map.y0);
  return {Divided(x, static_cast<T>(map.dx), division),
          Divided(y, static_cast<T>(map.dy), division), v.z, 1};
}

template <class T>
Vertex ToWindowIn(const Vertex& clip, const Transform& transform, int width, int height) {
  if (transform.map) return OnMapIn<T>(clip, *transform.map, transform.division);
  const T w = static_cast<T>(clip.w);
  const T x = Divided(static_cast<T>(clip.x), w, transform.division);
  const T y = Divided(static_cast<T>(clip.y), w, transform.division);
  return {Placed(x, width, transform.viewport),
          Placed(transform.flips_y ? -y : y, height, transform.viewport), clip.z, 1};
}

// The quotient that the viewport maps to x.
double BeforeViewport(double x, int size, ViewportForm form) {
  return form == ViewportForm::kNone ? x : x / (size / 2.0) - 1;
}

}  // namespace

Vertex ToWindow(const Vertex& clip, const Transform& transform, int width, int height) {
  if (!IsFinite(clip) || (!transform.map && !(clip.w > 0))) {
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    return {kNowhere, kNowhere, clip.z, 1};
  }
  return transform.precision == Precision::kFloat32
             ? ToWindowIn<float>(clip, transform, width, height)
             : ToWindowIn<double>(clip, transform, width, height);
}

Vertex ToClip(const Vertex& window, double w, const Transform& transform, int width, int height) {
  if (const auto& map = transform.map)
    return {window.x * map->dx + map->x0, window.y * map->dy + map->y0, window.z, 1};
  const double x = BeforeViewport(window.x, width, transform.viewport);
  const double y = BeforeViewport(window.y, height, transform.viewport);
  return {x * w, (transform.flips_y ? -y : y) * w, window.z, w};
}

Scene ToWindow(const Scene& scene, const Transform& transform) {
  Scene window = scene;
  window.clip_space = false;
  window.precision = transform.precision;
  for (Vertex& v : window.vertices) v = ToWindow(v, transform, scene.width, scene.height);
  return window;
}

}  // namespace rasterproof
