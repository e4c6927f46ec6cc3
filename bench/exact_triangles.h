// The exact answers about the triangles of a family, one triangle at a time.
#ifndef RASTERPROOF_BENCH_EXACT_TRIANGLES_H_
#define RASTERPROOF_BENCH_EXACT_TRIANGLES_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"

namespace rasterproof::bench {

/// The pixels whose decisions are looked at: those of the triangle's box, and two more all round,
/// within the target. Corners of clip space are divided by their w; of a triangle that does not lie
/// before the eye as a whole, the whole target.
PixelRect JudgedArea(const Scene& scene, std::size_t triangle);

inline Point2 CentreOf(int x, int y) { return {x + 0.5, y + 0.5}; }

/// Edges as far as they lie before the eye: one that passes through its plane is cut far beyond any
/// target, one behind it is nothing.
using SeenEdges = std::array<std::optional<std::array<Point2, 2>>, 3>;

/// Pixels; infinity if no edge is visible.
double DistanceFrom(const SeenEdges& edges, Point2 p);

/// A scene's triangles under one model.
///
/// Domain:     a model with one sample a pixel, in its centre, that decides the scene
///             (exact::WhyNotDecided).
class ExactTriangles {
 public:
  ExactTriangles(const Scene& scene, const Profile& model);
  ~ExactTriangles();

  /// `covered` becomes 1 for every pixel of the area whose centre the triangle covers, else 0.
  ///
  /// Shape:      row-major over the area.
  void Cover(std::size_t triangle, const PixelRect& area, std::vector<std::uint8_t>& covered);
  /// Whether the triangle covers the pixel's centre: by another way than Cover().
  bool Covers(std::size_t triangle, int x, int y) const;
  /// Its edges in window space where the model places them, edge k from corner k to the next one.
  SeenEdges EdgesOf(std::size_t triangle) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_EXACT_TRIANGLES_H_
