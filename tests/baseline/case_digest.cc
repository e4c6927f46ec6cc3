#include "tests/baseline/case_digest.h"

#include "core/profile.h"
#include "core/sample_pattern.h"
#include "core/snap.h"
#include "core/tie_rule.h"

namespace rasterproof::baseline {
namespace {

// Structured bindings name every member: a new one does not compile until it is added.

void Add(const Vertex& v, Digest& digest) {
  const auto& [x, y, z, w] = v;
  digest.Number(x).Number(y).Number(z).Number(w);
}

void Add(const Snap& snap, Digest& digest) {
  const auto& [bits, rule, form, origin] = snap;
  digest.Integer(bits).Integer(static_cast<int>(rule)).Integer(static_cast<int>(form));
  digest.Number(origin);
}

void Add(const SamplePattern& lattice, Digest& digest) {
  digest.Word(lattice.locations.size());
  for (const Point2& at : lattice.locations) digest.Number(at.x).Number(at.y);
}

void Add(const TieRule& rule, Digest& digest) {
  const auto& [sign_x, sign_y, y_first, inclusive, exclusive] = rule;
  digest.Integer(sign_x).Integer(sign_y).Integer(y_first).Integer(inclusive).Integer(exclusive);
}

void Add(const Transform& transform, Digest& digest) {
  const auto& [precision, division, viewport, flips_y, map] = transform;
  digest.Integer(static_cast<int>(precision)).Integer(static_cast<int>(division));
  digest.Integer(static_cast<int>(viewport)).Integer(flips_y);
  if (map) digest.Number(map->x0).Number(map->y0).Number(map->dx).Number(map->dy);
}

void Add(const FixedInput& fixed, Digest& digest) {
  const auto& [integer_bits, fraction_bits, is_signed, wraps] = fixed;
  digest.Integer(integer_bits).Integer(fraction_bits).Integer(is_signed).Integer(wraps);
}

void Add(const MaxPrimitiveExtent& extent, Digest& digest) {
  const auto& [width, height] = extent;
  digest.Number(width).Number(height);
}

void Add(const WindowBox& box, Digest& digest) {
  const auto& [x0, y0, x1, y1] = box;
  digest.Number(x0).Number(y0).Number(x1).Number(y1);
}

void Add(const TargetModel& model, Digest& digest) {
  const auto& [max_width, max_height, snap, lattice, tie_rule] = model;
  digest.Integer(max_width).Integer(max_height);
  Add(snap, digest);
  Add(lattice, digest);
  Add(tie_rule, digest);
}

void Add(const SquareRegion& region, Digest& digest) {
  const auto& [relation, square, shape, geometry, growth, half_width] = region;
  digest.Integer(static_cast<int>(relation)).Integer(static_cast<int>(square));
  digest.Integer(static_cast<int>(shape)).Integer(static_cast<int>(geometry));
  digest.Integer(static_cast<int>(growth)).Number(half_width);
}

void Add(const GuardBand& band, Digest& digest) {
  if (const auto* box = std::get_if<WindowBox>(&band)) return Add(*box, digest);
  const auto* around = std::get_if<AroundTarget>(&band);
  digest.Number(around != nullptr ? around->pixels : -1);
}

void Add(const SquareRule& rule, Digest& digest);

template <class T>
void AddIfAny(const std::optional<T>& value, Digest& digest) {
  digest.Integer(value.has_value());
  if (value) Add(*value, digest);
}

void Add(const SquareRule& rule, Digest& digest) {
  AddIfAny(rule.must, digest);
  AddIfAny(rule.may, digest);
  digest.Integer(static_cast<int>(rule.flat));
}

void Add(const Profile& profile, Digest& digest) {
  const auto& [name, specification, snap, crossing, lattice, sample_positions, centroid, y_axis,
               tie_rule, front_face, contract, freedom, transform, coordinate_limit,
               degenerate_triangles, infinite_vertex, nan_vertex, nan_z, translation_invariant,
               edge_samples, targets, fixed, max_primitive_extent, guard_band, squares] = profile;
  static_cast<void>(name);
  static_cast<void>(specification);
  Add(snap, digest);
  Add(crossing, digest);
  Add(lattice, digest);
  digest.Integer(static_cast<int>(y_axis));
  Add(tie_rule, digest);
  digest.Integer(static_cast<int>(contract));
  digest.Number(freedom.snap_tolerance).Integer(freedom.any_rounding);
  digest.Integer(freedom.least_bits.value_or(-1)).Integer(static_cast<int>(freedom.ties));
  digest.Number(freedom.transform_error.value_or(-1));
  digest.Integer(static_cast<int>(nan_vertex)).Integer(static_cast<int>(nan_z));
  digest.Integer(translation_invariant);
  AddIfAny(transform, digest);
  digest.Number(coordinate_limit).Integer(static_cast<int>(degenerate_triangles));
  digest.Integer(static_cast<int>(infinite_vertex)).Integer(edge_samples);
  digest.Word(targets.size());
  for (const TargetModel& model : targets) Add(model, digest);
  AddIfAny(fixed, digest);
  AddIfAny(max_primitive_extent, digest);
  // As before there was a band that is not stated, so that what was written then still holds.
  const bool is_stated = StatesGuardBand(profile);
  digest.Integer(is_stated);
  if (is_stated) Add(*guard_band, digest);
  digest.Integer(static_cast<int>(sample_positions));
  AddIfAny(squares, digest);
  if (front_face != FrontFace::kPositiveArea) digest.Integer(static_cast<int>(front_face));
  if (centroid != Centroid::kUnstated) digest.Integer(static_cast<int>(centroid));
}

void AddTarget(const Scene& scene, Digest& digest) {
  digest.Integer(scene.width).Integer(scene.height).Integer(scene.clip_space);
  digest.Integer(static_cast<int>(scene.precision)).Word(scene.triangles.size());
}

}  // namespace

void Add(const DrawOptions& options, Digest& digest) {
  const auto& [cull, scissor, tile, threads] = options;
  digest.Integer(static_cast<int>(cull)).Integer(tile).Integer(threads);
  digest.Integer(scissor.has_value());
  if (!scissor) return;
  const auto& [x0, y0, x1, y1] = *scissor;
  digest.Integer(x0).Integer(y0).Integer(x1).Integer(y1);
}

void Add(const Scene& scene, Digest& digest) {
  const auto& [name, width, height, precision, clip_space, vertices, triangles] = scene;
  static_cast<void>(name);
  AddTarget(scene, digest);
  digest.Word(vertices.size());
  for (const Vertex& v : vertices) Add(v, digest);
  for (const Triangle& t : triangles) digest.Integer(t[0]).Integer(t[1]).Integer(t[2]);
}

void AddDrawn(const Scene& scene, Digest& digest) {
  AddTarget(scene, digest);
  for (const Triangle& t : scene.triangles) {
    for (const Vertex& v : Corners(scene, t)) Add(v, digest);
  }
}

void Add(const CoverageCounts& counts, Digest& digest) {
  digest.Integer(counts.width).Integer(counts.height).Integer(counts.samples);
  for (const std::uint32_t n : counts.front) digest.Word(n);
  for (const std::uint32_t n : counts.back) digest.Word(n);
}

std::uint64_t CaseDigest(const Case& c) {
  const auto& [scene, profile, options, origin] = c;
  static_cast<void>(origin);
  Digest digest;
  Add(scene, digest);
  Add(profile, digest);
  Add(options, digest);
  return digest.value();
}

}  // namespace rasterproof::baseline
