// Passes over what a case is made of: triangles, vertices, target, options.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/ulp.h"
#include "props/shrink/passes.h"

namespace rasterproof::props {
namespace {

bool SameBits(const Vertex& a, const Vertex& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z) &&
         bits(a.w) == bits(b.w);
}

Case WithVertexReplaced(Case c, std::int32_t old_index, std::int32_t new_index) {
  for (Triangle& t : c.scene.triangles) std::ranges::replace(t, old_index, new_index);
  return WithoutUnusedVertices(std::move(c));
}

void MergeEqualVertices(Attempts& attempts) {
  Case merged = attempts.Current();
  const std::vector<Vertex>& v = merged.scene.vertices;
  for (Triangle& t : merged.scene.triangles) {
    for (std::int32_t& index : t) {
      const Vertex& mine = v[static_cast<std::size_t>(index)];
      const auto first =
          std::ranges::find_if(v, [&](const Vertex& u) { return SameBits(u, mine); });
      index = static_cast<std::int32_t>(first - v.begin());
    }
  }
  attempts.Try(WithoutUnusedVertices(std::move(merged)));
}

// Takes whole pixels off the left or the top. Exact or not at all: vertices must not move against
// the samples.
bool MoveWholePixels(Scene& scene, int dx, int dy) {
  for (Vertex& v : scene.vertices) {
    const double x = v.x - dx * v.w;
    const double y = v.y - dy * v.w;
    const bool exact =
        x + dx * v.w == v.x && y + dy * v.w == v.y && v.x - x == dx * v.w && v.y - y == dy * v.w;
    if (!exact || (scene.precision == Precision::kFloat32 && !(IsFloat32(x) && IsFloat32(y)))) {
      return false;
    }
    v.x = x;
    v.y = y;
  }
  return true;
}

void ClampScissor(Case& c, int dx, int dy) {
  if (!c.options.scissor) return;
  PixelRect& r = *c.options.scissor;
  r.x0 = std::clamp(r.x0 - dx, 0, c.scene.width);
  r.x1 = std::clamp(r.x1 - dx, r.x0, c.scene.width);
  r.y0 = std::clamp(r.y0 - dy, 0, c.scene.height);
  r.y1 = std::clamp(r.y1 - dy, r.y0, c.scene.height);
}

enum class CropSide { kLeft, kTop, kRight, kBottom };

bool TryCrop(Attempts& attempts, CropSide side, int pixels) {
  Case c = attempts.Current();
  const bool across = side == CropSide::kLeft || side == CropSide::kRight;
  int& extent = across ? c.scene.width : c.scene.height;
  if (pixels <= 0 || pixels >= extent) return false;
  extent -= pixels;
  // With y up the first row in window space is the last one of the buffer; vertices need not move
  // to lose rows of large y, whichever way they are stored.
  const int dx = side == CropSide::kLeft ? pixels : 0;
  const int dy = side == CropSide::kTop ? pixels : 0;
  if ((dx != 0 || dy != 0) && !MoveWholePixels(c.scene, dx, dy)) return false;
  ClampScissor(c, dx, dy);
  return attempts.Try(std::move(c));
}

// Removes what belongs to vertices of index -1 from a list that has one of each vertex.
template <class T>
void KeepUsed(std::vector<T>& each, const std::vector<std::int32_t>& moved) {
  if (each.size() != moved.size()) return;
  std::size_t used = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (moved[i] >= 0) each[used++] = each[i];
  }
  each.resize(used);
}

}  // namespace

Case WithoutUnusedVertices(Case c) {
  Scene& scene = c.scene;
  std::vector<std::int32_t> moved(scene.vertices.size(), -1);
  for (const Triangle& t : scene.triangles) {
    for (const std::int32_t index : t) moved[static_cast<std::size_t>(index)] = 0;
  }
  for (Channel& channel : scene.channels) KeepUsed(channel.values, moved);
  KeepUsed(scene.vertices, moved);
  std::int32_t used = 0;
  for (std::int32_t& index : moved) index = index < 0 ? index : used++;
  for (Triangle& t : scene.triangles) {
    for (std::int32_t& index : t) index = moved[static_cast<std::size_t>(index)];
  }
  return c;
}

// Delta debugging: ever smaller runs of triangles, and at each place again as long as it helps.
void RemoveTriangles(Attempts& attempts) {
  for (std::size_t run = attempts.Current().scene.triangles.size(); run >= 1; run /= 2) {
    std::size_t at = 0;
    while (at < attempts.Current().scene.triangles.size() && !attempts.Exhausted()) {
      Case c = attempts.Current();
      std::vector<Triangle>& triangles = c.scene.triangles;
      const std::size_t end = std::min(triangles.size(), at + run);
      triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(at),
                      triangles.begin() + static_cast<std::ptrdiff_t>(end));
      if (!attempts.Try(WithoutUnusedVertices(std::move(c)))) at += run;
    }
  }
}

void MergeVertices(Attempts& attempts) {
  attempts.Try(WithoutUnusedVertices(attempts.Current()));
  MergeEqualVertices(attempts);
  // Collapsing pairs is quadratic: only where few are left.
  constexpr std::size_t kMostVertices = 12;
  if (attempts.Current().scene.vertices.size() > kMostVertices) return;
  for (std::int32_t i = 1; i < static_cast<std::int32_t>(attempts.Current().scene.vertices.size());
       ++i) {
    for (std::int32_t j = 0; j < i && !attempts.Exhausted(); ++j) {
      if (attempts.Try(WithVertexReplaced(attempts.Current(), i, j))) break;
    }
  }
}

void CropTarget(Attempts& attempts) {
  for (const CropSide side :
       {CropSide::kRight, CropSide::kBottom, CropSide::kLeft, CropSide::kTop}) {
    const bool across = side == CropSide::kLeft || side == CropSide::kRight;
    const Scene& scene = attempts.Current().scene;
    for (int pixels = (across ? scene.width : scene.height) - 1; pixels >= 1; pixels /= 2) {
      while (!attempts.Exhausted() && TryCrop(attempts, side, pixels)) {
      }
    }
  }
}

void ResetOptions(Attempts& attempts) {
  Case c = attempts.Current();
  c.options = DrawOptions{};
  if (attempts.Try(std::move(c))) return;
  const auto with = [&](auto change) {
    Case changed = attempts.Current();
    change(changed.options);
    attempts.Try(std::move(changed));
  };
  with([](DrawOptions& options) { options.cull = Cull::kNone; });
  with([](DrawOptions& options) { options.scissor.reset(); });
  with([](DrawOptions& options) { options.tile = 0; });
  with([](DrawOptions& options) { options.threads = 1; });
}

void RunPasses(Attempts& attempts) {
  RemoveTriangles(attempts);
  MergeVertices(attempts);
  CropTarget(attempts);
  ResetOptions(attempts);
  SimplifyAllCoordinates(attempts);
  SimplifyEachCoordinate(attempts);
}

}  // namespace rasterproof::props
