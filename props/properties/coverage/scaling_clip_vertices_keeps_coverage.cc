// A clip-space vertex times a positive power of two, in x, y and w, changes no sample.
//
// It changes no sign: the edges V_j x V_i are only multiplied by it.
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/profile.h"
#include "core/scene.h"
#include "core/ulp.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace scaling_clip_vertices_keeps_coverage {

constexpr std::array<double, 7> kFactors{2, 1, 0x1p-3, 16, 0.5, 0x1p6, 4};

bool IsExact(double product, double x, double factor, Precision precision) {
  return std::isfinite(product) && product / factor == x &&
         (precision == Precision::kFloat64 || IsFloat32(product));
}

// Scales each vertex by its own factor; returns nothing if a product is not exact.
std::optional<Scene> Scaled(const Scene& scene) {
  Scene scaled = scene;
  for (std::size_t i = 0; i < scaled.vertices.size(); ++i) {
    Vertex& v = scaled.vertices[i];
    const double factor = kFactors[i % kFactors.size()];
    const Vertex product{v.x * factor, v.y * factor, v.z, v.w * factor};
    if (!IsExact(product.x, v.x, factor, scene.precision) ||
        !IsExact(product.y, v.y, factor, scene.precision) ||
        !IsExact(product.w, v.w, factor, scene.precision)) {
      return std::nullopt;
    }
    v = product;
  }
  return scaled;
}

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  const std::optional<Scene> scaled = Scaled(c.scene);
  if (!scaled || !WithinLimits(*scaled, c.profile)) {
    return NotExercised("a scaled vertex is not exact or beyond the limit");
  }
  return CompareVariations(c, {{*scaled, "that of the unscaled vertices"}});
}

}  // namespace scaling_clip_vertices_keeps_coverage

extern constinit const Property kScalingClipVerticesKeepsCoverage{
    .name = "ScalingClipVerticesKeepsCoverage",
    .group = "coverage",
    .clause =
        "A homogeneous edge needs no division: multiplying a clip-space vertex by a "
        "positive number changes no sign (McCool, Wales and Moule, Graphics Hardware 2001).",
    .tolerance = kExact,
    .domains = kClipSpace,
    .gate = {.space = Space::kClip, .where = "the scaled coordinates are exact"},
    .ask = scaling_clip_vertices_keeps_coverage::Ask,
};

}  // namespace rasterproof::props
