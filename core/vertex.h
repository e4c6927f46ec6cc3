// Points, vertices and triangles.
#ifndef RASTERPROOF_CORE_VERTEX_H_
#define RASTERPROOF_CORE_VERTEX_H_

#include <array>
#include <cmath>
#include <cstdint>

namespace rasterproof {

/// A point of window space.
///
/// Units:      pixels, x right, y down.
struct Point2 {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point2&, const Point2&) = default;
};

/// A vertex, taken as an exact number.
///
/// Domain:     any double; a scene of precision float32 holds only values that float32 holds.
/// Units:      window space: x, y in pixels, w = 1. Clip space: window = (x / w, y / w).
///             z never affects coverage.
struct Vertex {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// Returns whether x, y and w are finite (z is free: it never affects coverage).
inline bool IsFinite(const Vertex& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.w);
}

/// Three indices into the scene's vertices, in drawing order.
using Triangle = std::array<std::int32_t, 3>;

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_VERTEX_H_
