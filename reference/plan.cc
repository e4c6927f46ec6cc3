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

/// Every combination of stages of one arithmetic; bit 0 snap, 1 clip.
constexpr std::size_t SetOf(const PlanStages& stages) {
  return (stages.snap ? 1U : 0U) | (stages.clip ? 2U : 0U);
}
using StageKernels = std::array<PlanDraw, 4>;
template <class T>
constexpr StageKernels kKernels{&DrawPlanned<T, {false, false}>, &DrawPlanned<T, {true, false}>,
                                &DrawPlanned<T, {false, true}>, &DrawPlanned<T, {true, true}>};

/// One arithmetic and the scenes it is exact for, in units u = 2^-lattice of the scene.
///
/// The samples tested lie in the triangle's closed box, so with sides w and h of the box in units
/// every difference of coordinates is at most max(w, h), each product of the direct form at most
/// w h, and so is |E|, twice the area of a triangle in the box. All are integers: what fits the
/// integer type is exact. Proof: proofs/exactness.g.
struct Rung {
  std::string_view name;
  double limit;
  std::string_view limit_text;
  int finest_lattice;
  const StageKernels* kernels;
};
constexpr std::array<Rung, 2> kRungs{{
    {"int32 direct", 0x1p31 - 1, "2^31 - 1", 31, &kKernels<std::int32_t>},
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

PlanReason CullReason(const DrawOptions& options) {
  if (options.cull == Cull::kNone) return {"cull", "left out", "no culling asked for"};
  return {"cull", "kept", "asked for"};
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
  plan.reasons.push_back(CullReason(options));
  AddOutputReasons(plan, needs);
  return plan;
}

/// What a plan of some rung leaves out, kept one by one.
void AddStageVariants(Plan& plan, const Profile& profile, const PlanStages& stages,
                      const StageKernels& kernels) {
  const auto add = [&](std::string_view stage, bool PlanStages::* member) {
    if (stages.*member) return;
    PlanStages with = stages;
    with.*member = true;
    plan.variants.push_back({std::string(stage), kernels[SetOf(with)]});
  };
  if (!profile.snap.IsNone()) add("snap", &PlanStages::snap);
  add("clip", &PlanStages::clip);
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
  if (!extent.inside_area) return {"clip", "kept", "some box holds samples outside the draw area"};
  return {"clip", "kept",
          options.threads == 1
              ? "the kernel has no other form"
              : std::to_string(options.threads) + " threads clip to bands of rows"};
}

Plan PlanWindowSpace(const Scene& scene, const Profile& profile, const DrawOptions& options,
                     const Needs& needs) {
  const SceneExtent extent = MeasureScene(scene, profile, options);
  // Where the spans serve the profile they beat every rung, and are exact whatever the extent.
  const bool spans = SpansServe(profile);
  const auto rung = spans ? kRungs.end() : std::ranges::find_if(kRungs, [&](const Rung& one) {
    return IsExactFor(one, extent);
  });
  const bool planned = rung != kRungs.end();
  PlanStages stages;
  stages.snap = !profile.snap.IsNone() && !extent.on_grid;
  stages.clip = !planned || options.threads != 1 || !extent.inside_area;

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
                            spans ? "samples are the pixels' centres under the top-left rule: the "
                                    "fastest, and exact at any extent"
                                  : ExtentText(extent) + ": beyond int64 (2^63)"});
    if (!stages.snap && !profile.snap.IsNone()) {
      plan.variants.push_back({"snap", spans ? DrawBySpans<true> : DrawWide<true>});
    }
  }
  plan.variants.push_back({"everything", profile.snap.IsNone() ? DrawWide<false> : DrawWide<true>});
  plan.reasons.push_back(SnapReason(profile, extent, stages.snap));
  plan.reasons.push_back(ClipReason(stages.clip, extent, options));
  plan.reasons.push_back(CullReason(options));
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
    throw Unplanned(profile, "its fixed-point input or its largest extent needs window space",
                    "give vertices [x, y]");
  }
  const TargetProfile resolved(profile, scene);
  if (resolved.snap != profile.snap || resolved.pattern != profile.pattern ||
      resolved.tie_rule != profile.tie_rule) {
    throw Unplanned(profile, "it has another model for targets of this size",
                    "resolve it first: TargetProfile(profile, scene)");
  }
  if (profile.culls != Cull::kNone) {
    throw Unplanned(profile, "it always culls one side, which kernels are asked for draw by draw",
                    "leave culls out, and give the draw the option cull");
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
