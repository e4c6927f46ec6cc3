#include "reference/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/tie_rule.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"
#include "reference/homogeneous.h"
#include "reference/method.h"
#include "reference/plan_kernel.h"
#include "reference/plan_scene.h"
#include "reference/rasterize.h"
#include "reference/whole_scene.h"

namespace rasterproof::reference {
namespace {

/// Every combination of stages of one arithmetic; bit 0 snap, 1 clip, 2 cull, 3 tie rule.
constexpr std::size_t kStageSets = 16;
constexpr PlanStages StagesOf(std::size_t set) {
  return {(set & 1) != 0, (set & 2) != 0, (set & 4) != 0, (set & 8) != 0};
}
constexpr std::size_t SetOf(const PlanStages& stages) {
  return (stages.snap ? 1U : 0U) | (stages.clip ? 2U : 0U) | (stages.cull ? 4U : 0U) |
         (stages.ties ? 8U : 0U);
}
template <class T, std::size_t... kSets>
constexpr std::array<PlanDraw, kStageSets> KernelsOf(std::index_sequence<kSets...>) {
  return {&DrawPlanned<T, StagesOf(kSets)>...};
}
template <class T>
constexpr std::array<PlanDraw, kStageSets> kKernels =
    KernelsOf<T>(std::make_index_sequence<kStageSets>{});

/// One arithmetic and the scenes it is exact for, in units u = 2^-lattice of the scene.
///
/// The samples tested lie in the triangle's closed box, so with sides w and h of the box in units
/// every difference of coordinates is at most max(w, h), each product of the direct form at most
/// w h, and so is |E|, twice the area of a triangle in the box. All are integers: what fits the
/// significand (or the integer type) is exact. Floats also need u^2 to be no less than the smallest
/// subnormal. Proof: proofs/exactness.g.
struct Rung {
  std::string_view name;
  double limit;  ///< largest integer whose predecessors are all representable
  std::string_view limit_text;
  int finest_lattice;
  const std::array<PlanDraw, kStageSets>* kernels;
};
constexpr std::array<Rung, 4> kRungs{{
    {"float32 direct", 0x1p24, "2^24", 74, &kKernels<float>},
    {"int32 direct", 0x1p31 - 1, "2^31 - 1", 31, &kKernels<std::int32_t>},
    {"float64 direct", 0x1p53, "2^53", 537, &kKernels<double>},
    // The largest double below 2^63.
    {"int64 direct", 0x1p63 - 0x1p10, "2^63 - 2^10", 62, &kKernels<std::int64_t>},
}};

std::string Text(double x) {
  std::array<char, 32> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.10g", x);
  return buffer.data();
}

struct InUnits {
  double largest, side, area;
  explicit InUnits(const SceneExtent& e)
      : largest(std::ldexp(e.largest, e.lattice)),
        side(std::ldexp(std::max(e.widest, e.tallest), e.lattice)),
        area(std::ldexp(e.largest_area, 2 * e.lattice)) {}
};

bool IsExactFor(const Rung& rung, const SceneExtent& extent) {
  const InUnits units(extent);
  return extent.lattice <= rung.finest_lattice && units.largest <= rung.limit &&
         units.side <= rung.limit && units.area <= rung.limit;
}

std::string VectorsText(const Scene& scene) {
  return "coordinates are float32, and " + std::to_string(scene.triangles.size()) +
         " triangles are enough for vectors: exact at any extent";
}

std::string ExtentText(const SceneExtent& extent) {
  const InUnits units(extent);
  return "coordinates are multiples of 2^-" + std::to_string(extent.lattice) +
         " px: in these units at most " + Text(units.largest) + ", longest box side " +
         Text(units.side) + ", largest box area " + Text(units.area);
}

/// The exact kernels for every finite double: spans where the table's kernel serves the profile,
/// homogeneous edges with w = 1 for the other rules, lattices and axes.
template <bool kSnap>
void DrawBySpans(const Scene& scene, const Profile& profile, const DrawOptions& options,
                 CoverageCounts& counts) {
  RasterOptions raster;
  static_cast<DrawOptions&>(raster) = options;
  Rasterize(kSnap ? SnapScene(scene, {profile, scene}) : scene, *FindMethod("spans-exact"), raster,
            counts);
}
template <bool kSnap>
void DrawWide(const Scene& scene, const Profile& profile, const DrawOptions& options,
              CoverageCounts& counts) {
  DrawHomogeneousExact(kSnap ? SnapScene(scene, {profile, scene}) : scene, profile, options,
                       counts);
}
bool SpansServe(const Profile& profile) {
  return profile.tie_rule == kTopLeft && profile.y_axis == YAxis::kDown &&
         profile.pattern == SamplePattern{};
}

void DrawSnappedProjection(const Scene& scene, const Profile& profile, const DrawOptions& options,
                           CoverageCounts& counts) {
  const Scene window = SnapProjected(scene, profile);
  (SpansServe(profile) ? DrawBySpans<false> : DrawWide<false>)(window, profile, options, counts);
}

void AddOutputReasons(Plan& plan, const Needs& needs) {
  const auto add = [&plan](std::string stage, bool needed) {
    plan.reasons.push_back(
        {std::move(stage), needed ? "kept" : "left out",
         needed ? "asked for: RasterizeFragments computes it" : "not asked for"});
  };
  add("barycentrics", needs.barycentrics);
  add("depth", needs.depth);
  add("wireframe", needs.edge_distance);
}

Plan PlanClipSpace(const Scene& scene, const Profile& profile, const DrawOptions& options,
                   const Needs& needs) {
  const auto behind =
      std::ranges::count_if(scene.vertices, [](const Vertex& v) { return !(v.w > 0); });
  const std::string count = std::to_string(behind) + " of " +
                            std::to_string(scene.vertices.size()) + " vertices have w <= 0";
  Plan plan;
  if (profile.snap.IsNone()) {
    plan.arithmetic = "homogeneous exact";
    plan.draw = &DrawHomogeneousExact;
    plan.reasons = {{"edge arithmetic", plan.arithmetic,
                     "clip space: (V_j x V_i) . p needs no division; " + count},
                    {"snap", "left out", "the profile has no subpixel grid"},
                    {"clip", "left out", "homogeneous edges are defined at and behind w = 0"}};
  } else {
    plan.arithmetic = SpansServe(profile) ? "spans-exact" : "wide exact";
    plan.draw = &DrawSnappedProjection;
    plan.reasons = {
        {"edge arithmetic", plan.arithmetic,
         "window space after the division; its lattice is the profile's, its extent open"},
        {"snap", "kept",
         "x / w is put on the 2^-" + std::to_string(profile.snap.bits) + " grid exactly; " + count},
        {"clip", "kept", "boxes are clamped to the draw area"}};
  }
  plan.reasons.push_back({"cull", options.cull == Cull::kNone ? "left out" : "kept",
                          options.cull == Cull::kNone ? "no culling asked for" : "asked for"});
  plan.reasons.push_back(
      {"tie rule", "kept", "samples may lie on edges: not examined in clip space"});
  AddOutputReasons(plan, needs);
  return plan;
}

/// What a plan of some rung leaves out, kept one by one.
void AddStageVariants(Plan& plan, const Profile& profile, const PlanStages& stages,
                      const std::array<PlanDraw, kStageSets>& kernels) {
  const auto add = [&](std::string_view stage, bool PlanStages::* member) {
    if (stages.*member) return;
    PlanStages with = stages;
    with.*member = true;
    plan.variants.push_back({std::string(stage), kernels[SetOf(with)]});
  };
  if (!profile.snap.IsNone()) add("snap", &PlanStages::snap);
  add("clip", &PlanStages::clip);
  add("cull", &PlanStages::cull);
  add("tie rule", &PlanStages::ties);
}

PlanReason SnapReason(const Profile& profile, const SceneExtent& extent, bool kept) {
  if (profile.snap.IsNone()) return {"snap", "left out", "the profile has no subpixel grid"};
  const std::string grid = "the profile's 2^-" + std::to_string(profile.snap.bits) + " grid";
  if (kept) return {"snap", "kept", "some coordinate is not on " + grid};
  return {"snap", "left out",
          "every coordinate is on " + grid + " (lattice of scene and samples 2^-" +
              std::to_string(extent.lattice) + ")"};
}

PlanReason ClipReason(bool kept, const SceneExtent& extent, const DrawOptions& options) {
  if (!kept) return {"clip", "left out", "no box holds a sample outside the draw area"};
  return {"clip", "kept",
          extent.inside_area ? std::to_string(options.threads) + " threads clip to bands of rows"
                             : "some box holds samples outside the draw area"};
}

/// The tie rule can go only where number theory says so; see SampleCanLieOnAnEdge.
bool TiesAreImpossible(const Scene& scene, const Profile& profile, const SceneExtent& extent) {
  constexpr int kFinest = 40;
  if (extent.lattice > kFinest || InUnits(extent).largest > std::ldexp(1.0, kFinest)) return false;
  return !SampleCanLieOnAnEdge(scene, profile, extent.lattice);
}

Plan PlanWindowSpace(const Scene& scene, const Profile& profile, const DrawOptions& options,
                     const Needs& needs) {
  const SceneExtent extent = MeasureScene(scene, profile, options);
  const auto rung = std::ranges::find_if(
      kRungs, [&](const Rung& candidate) { return IsExactFor(candidate, extent); });
  PlanStages stages;
  stages.snap = !profile.snap.IsNone() && !extent.on_grid;
  // Vectors beat the rungs where there is enough to draw, and are exact whatever the extent.
  const bool spans = SpansServe(profile);
  const bool vectors = spans && KernelsPay(scene) &&
                       KernelsTake(stages.snap ? SnapScene(scene, {profile, scene}) : scene);
  const bool planned = !vectors && rung != kRungs.end();
  // The kernels of the table clip and break ties in every case.
  stages.clip = !planned || options.threads != 1 || !extent.inside_area;
  stages.cull = options.cull != Cull::kNone;
  stages.ties = !planned || !TiesAreImpossible(scene, profile, extent);

  Plan plan;
  if (planned) {
    plan.arithmetic = rung->name;
    plan.draw = (*rung->kernels)[SetOf(stages)];
    AddStageVariants(plan, profile, stages, *rung->kernels);
    plan.reasons.push_back({"edge arithmetic", plan.arithmetic,
                            ExtentText(extent) + ": all <= " + std::string(rung->limit_text)});
  } else {
    plan.arithmetic = spans ? "spans-exact" : "wide exact";
    plan.draw = stages.snap ? (spans ? DrawBySpans<true> : DrawWide<true>)
                            : (spans ? DrawBySpans<false> : DrawWide<false>);
    plan.reasons.push_back({"edge arithmetic", plan.arithmetic,
                            vectors
                                ? VectorsText(scene)
                                : ExtentText(extent) + ": beyond int64 (2^63) and float64 (2^53)"});
    if (!stages.snap && !profile.snap.IsNone()) {
      plan.variants.push_back({"snap", spans ? DrawBySpans<true> : DrawWide<true>});
    }
  }
  plan.variants.push_back({"everything", profile.snap.IsNone() ? DrawWide<false> : DrawWide<true>});
  plan.reasons.push_back(SnapReason(profile, extent, stages.snap));
  plan.reasons.push_back(ClipReason(stages.clip, extent, options));
  plan.reasons.push_back({"cull", stages.cull ? "kept" : "left out",
                          stages.cull ? "asked for" : "no culling asked for"});
  plan.reasons.push_back(
      {"tie rule", stages.ties ? "kept" : "left out",
       stages.ties ? "a sample of the grid can lie on an edge, or it is not proved that none can"
                   : "on every edge E = 0 has no solution: 2^" + std::to_string(extent.lattice) +
                         " gcd(dX, dY) does not divide its constant"});
  plan.reasons.push_back({"perspective", "left out", "window space: every w is 1"});
  AddOutputReasons(plan, needs);
  return plan;
}

// What places vertices or drops triangles before any kernel, each thing that the profile states.
std::string PlacingText(const Scene& scene, const Profile& profile) {
  std::string text;
  const auto add = [&](const std::string& what) {
    text += (text.empty() ? "the profile " : " and ") + what;
  };
  if (profile.fixed) {
    const std::string bits = std::to_string(profile.fixed->integer_bits) + "." +
                             std::to_string(profile.fixed->fraction_bits);
    add(profile.fixed->wraps ? "wraps coordinates of " + bits + " bits"
                             : "takes integers of " + bits + " bits");
  }
  if (profile.max_primitive_extent) add("drops large triangles");
  if (TakesToWindow(profile, scene)) add("takes vertices to the window itself");
  return text + ": not examined";
}

// What is placed or dropped is so before any kernel, and the extent of the rest is not examined.
Plan PlanPlaced(const Scene& scene, const Profile& profile, const Needs& needs) {
  Plan plan;
  plan.arithmetic = "wide exact";
  plan.draw = &DrawWide<true>;
  plan.reasons = {{"edge arithmetic", plan.arithmetic, PlacingText(scene, profile)},
                  {"snap", "kept", "coordinates are placed before they are drawn"},
                  {"clip", "kept", "boxes are clamped to the draw area"},
                  {"cull", "kept", "facings are those of the placed triangles"},
                  {"tie rule", "kept", "samples may lie on edges: not examined"},
                  {"perspective", "left out", "window space: every w is 1"}};
  AddOutputReasons(plan, needs);
  return plan;
}

InputError Unplanned(const Profile& profile, const std::string& reason, const std::string& remedy) {
  return {"profile \"" + profile.name + "\"", reason, remedy};
}

void RequireKernelFor(const Scene& scene, const Profile& profile) {
  if (!profile.scanline_rounding.IsNone()) {
    throw Unplanned(
        profile, "it rounds where edges cross rows, and no kernel of the plan does",
        "leave out scanline_rounding, or draw by the oracle (coverage --subject exact)");
  }
  if (IsHomogeneous(scene, profile) && !PlacesClipSpace(profile)) {
    throw Unplanned(profile, "its fixed-point input or its largest extent is of window space",
                    "give vertices [x, y]");
  }
  const TargetProfile resolved(profile, scene);
  if (resolved.snap != profile.snap || resolved.pattern != profile.pattern ||
      resolved.tie_rule != profile.tie_rule) {
    throw Unplanned(profile, "it says something else of targets of this size",
                    "resolve it first: TargetProfile(profile, scene)");
  }
}

}  // namespace

Plan MakePlan(const Scene& scene, const Profile& profile, const DrawOptions& options,
              const Needs& needs) {
  RequireKernelFor(scene, profile);
  const bool owns_transform = TakesToWindow(profile, scene);
  if (!PlacesClipSpace(profile) || owns_transform) return PlanPlaced(scene, profile, needs);
  return scene.clip_space ? PlanClipSpace(scene, profile, options, needs)
                          : PlanWindowSpace(scene, profile, options, needs);
}

}  // namespace rasterproof::reference
