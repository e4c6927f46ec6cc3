#include "tests/props/planted_bugs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "exact/coverage.h"

namespace rasterproof::props {
namespace {

std::array<Vertex, 3> CornersOf(const Scene& scene, const Triangle& t) { return Corners(scene, t); }

CoverageCounts Alone(Subject& sound, const Scene& scene, const DrawOptions& options,
                     const CoverageCounts& shape) {
  CoverageCounts counts(shape.width, shape.height, shape.samples);
  DrawOnto(sound, scene, options, counts);
  return counts;
}

// Leaves out the triangles that `drops` names: by their index and their vertices.
using Drops = std::function<bool(std::size_t index, const Triangle&, const std::array<Vertex, 3>&,
                                 const Scene&)>;
DrawBug Dropping(Drops drops) {
  return [drops](Subject& sound, const Scene& scene, const DrawOptions& options,
                 CoverageCounts& counts) {
    Scene part = scene;
    part.triangles.clear();
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      const Triangle& triangle = scene.triangles[t];
      if (!drops(t, triangle, CornersOf(scene, triangle), scene)) {
        part.triangles.push_back(triangle);
      }
    }
    DrawOnto(sound, part, options, counts);
  };
}

// Draws a scene whose vertices were changed first.
DrawBug WithVertices(std::function<void(Vertex&)> change) {
  return [change](Subject& sound, const Scene& scene, const DrawOptions& options,
                  CoverageCounts& counts) {
    Scene changed = scene;
    std::ranges::for_each(changed.vertices, change);
    DrawOnto(sound, changed, options, counts);
  };
}

DrawBug WithOptions(std::function<void(DrawOptions&, const Scene&)> change) {
  return [change](Subject& sound, const Scene& scene, const DrawOptions& options,
                  CoverageCounts& counts) {
    DrawOptions changed = options;
    change(changed, scene);
    DrawOnto(sound, scene, changed, counts);
  };
}

// Every edge inclusive: >= in place of the tie rule.
void DrawInclusively(Subject& sound, const Scene& scene, const DrawOptions& options,
                     CoverageCounts& counts) {
  Profile profile = sound.Info().profile;
  profile.tie_rule.inclusive = true;
  counts += exact::Coverage(scene, profile, options);
}

void DrawBottomRight(Subject& sound, const Scene& scene, const DrawOptions& options,
                     CoverageCounts& counts) {
  Profile profile = sound.Info().profile;
  profile.tie_rule = *TieRuleFromName("bottom-right");
  counts += exact::Coverage(scene, profile, options);
}

// Ties of the snap go up for some triangles and to even for others: each is within half a step, but
// the two sides of an edge can part.
void SnapByParity(Subject& sound, const Scene& scene, const DrawOptions& options,
                  CoverageCounts& counts) {
  for (const Triangle& t : scene.triangles) {
    Profile profile = sound.Info().profile;
    Scene one = scene;
    one.triangles = {t};
    profile.snap.rule =
        std::max({t[0], t[1], t[2]}) % 2 == 0 ? SnapRule::kHalfUp : SnapRule::kNearestEven;
    counts += exact::Coverage(one, profile, options);
  }
}

bool IsBehind(const Vertex& v) { return v.w <= 0; }
bool LeavesTarget(const std::array<Vertex, 3>& v, const Scene& scene) {
  return std::ranges::any_of(v, [&](const Vertex& p) {
    return p.x < 0 || p.y < 0 || p.x > scene.width || p.y > scene.height;
  });
}

// Draws the triangles one by one and stops at the first that is not finite.
void StopAtTheFirstBadTriangle(Subject& sound, const Scene& scene, const DrawOptions& options,
                               CoverageCounts& counts) {
  Scene part = scene;
  part.triangles.clear();
  for (const Triangle& t : scene.triangles) {
    if (!std::ranges::all_of(CornersOf(scene, t), IsFinite)) break;
    part.triangles.push_back(t);
  }
  DrawOnto(sound, part, options, counts);
}

void TakeNonFiniteForZero(Vertex& v) {
  const auto finite = [](double x) { return std::isfinite(x) ? x : 0.0; };
  v = {finite(v.x), finite(v.y), v.z, std::isfinite(v.w) ? v.w : 1.0};
}

// Front is back in the right half of the target.
void TurnTheRightHalf(Subject& sound, const Scene& scene, const DrawOptions& options,
                      CoverageCounts& counts) {
  CoverageCounts drawn(counts.width, counts.height, counts.samples);
  DrawOnto(sound, scene, options, drawn);
  const auto width = static_cast<std::size_t>(drawn.width * drawn.samples);
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    if (2 * (k % width) >= width) std::swap(drawn.front[k], drawn.back[k]);
  }
  counts += drawn;
}

// A triangle without area covers the pixel of its first vertex.
void DotDegenerates(Subject& sound, const Scene& scene, const DrawOptions& options,
                    CoverageCounts& counts) {
  DrawOnto(sound, scene, options, counts);
  for (const Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> v = CornersOf(scene, t);
    const bool flat = std::ranges::all_of(v, IsFinite) &&
                      exact::Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])}) == 0;
    const bool shown = v[0].x >= 0 && v[0].y >= 0 && v[0].x < scene.width && v[0].y < scene.height;
    if (flat && shown) {
      ++counts.back[counts.Index(static_cast<int>(v[0].x), static_cast<int>(v[0].y))];
    }
  }
}

void CallEveryTriangleFront(Subject& sound, const Scene& scene, const DrawOptions& options,
                            CoverageCounts& counts) {
  CoverageCounts drawn = Alone(sound, scene, options, counts);
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    drawn.front[k] += std::exchange(drawn.back[k], 0);
  }
  counts += drawn;
}

void OverwriteCounts(Subject& sound, const Scene& scene, const DrawOptions& options,
                     CoverageCounts& counts) {
  counts = Alone(sound, scene, options, counts);
}

// A span that runs one pixel past the scissor, or into the next row.
void RunPastTheScissor(Subject& sound, const Scene& scene, const DrawOptions& options,
                       CoverageCounts& counts) {
  DrawOnto(sound, scene, options, counts);
  const PixelRect rect = options.scissor.value_or(PixelRect{0, 0, scene.width, scene.height});
  const std::size_t k = counts.Index(rect.x1, rect.y0);
  if (k < counts.size()) ++counts.front[k];
}

std::vector<PlantedBug> EdgePlantedBugs() {
  const auto value = [](ValueBug bug) {
    Bug planted;
    planted.value = std::move(bug);
    return planted;
  };
  return {
      {"EdgeSignIsRightOutsideItsBand", "the absolute value", "spans-exact",
       value([](double e, Point2, Point2, Point2) { return std::fabs(e); })},
      {"EdgeErrorStaysWithinItsBound", "half the mantissa", "spans-exact",
       value([](double e, Point2, Point2, Point2) { return e * (1 + 0x1p-26); })},
      {"EdgeErrorStaysWithinItsBound", "float32 where float64 is stated", "f64-direct",
       value([](double e, Point2, Point2, Point2) { return double{static_cast<float>(e)}; })},
      {"ReversedEdgeChangesSign", "a bias towards inside", "spans-exact",
       value([](double e, Point2, Point2, Point2) { return e + 0x1p-10 * std::fabs(e); })},
      {"CyclicRotationKeepsTheArea", "an anchor that matters", "spans-exact",
       value([](double e, Point2 a, Point2, Point2) { return e + 0x1p-10 * a.x; })},
      {"EdgeIsZeroAtItsEnds", "a constant bias", "spans-exact",
       value([](double e, Point2, Point2, Point2) { return e + 0x1p-10; })},
      {"IntegerTranslationKeepsEdgeValues", "the position itself enters", "spans-exact",
       value([](double e, Point2, Point2, Point2 p) { return e + 0x1p-10 * p.x; })},
      {"PowerOfTwoScalingScalesEdgeValues", "a constant bias", "spans-exact",
       value([](double e, Point2, Point2, Point2) { return e + 0x1p-10; })},
      {"MirrorNegatesEdgeValues", "a constant bias", "spans-exact",
       value([](double e, Point2, Point2, Point2) { return e + 0x1p-10; })},
      {"LiftedTrianglesCoverLikeProjectedOnes",
       "no division at all",
       "hom-exact",
       {.draw = WithVertices([](Vertex& v) { v.w = 1; })}},
      {"ScalingClipVerticesKeepsCoverage",
       "w clamped",
       "hom-exact",
       {.draw = WithVertices([](Vertex& v) { v.w = std::min(v.w, 4.0); })}},
  };
}

std::vector<PlantedBug> IncrementalPlantedBugs() {
  const auto stepping = [](SteppingBug bug) {
    Bug planted;
    planted.stepping = std::move(bug);
    return planted;
  };
  return {
      {"SteppingStaysWithinItsBound", "dX added where it is subtracted", "spans-exact",
       stepping([](std::vector<double>& e, Step step) {
         if (!step.along_y) return;
         for (double& value : e) value = 2 * e[0] - value;
       })},
      {"SteppingStaysWithinItsBound", "one step too many", "spans-exact",
       stepping([](std::vector<double>& e, Step) {
         for (std::size_t n = 0; n + 1 < e.size(); ++n) e[n] = e[n + 1];
       })},
      {"SteppingStaysWithinItsBound", "an entry left out", "spans-exact",
       stepping([](std::vector<double>& e, Step) { e.pop_back(); })},
      {"SteppingEqualsDirectWhereExact", "one ulp", "i64-snap8",
       stepping([](std::vector<double>& e, Step) {
         for (std::size_t n = 1; n < e.size(); ++n) e[n] = std::nextafter(e[n], 0x1p60);
       })},
      {"LongSteppingStaysWithinItsBound", "a step is lost after 4096", "spans-exact",
       stepping([](std::vector<double>& e, Step) {
         for (std::size_t n = e.size() - 1; n > 4096; --n) e[n] = e[n - 1];
       })},
      {"TileSizeKeepsCoverage",
       "the last column is no tile's",
       "spans-exact",
       {.draw = WithOptions([](DrawOptions& options, const Scene& scene) {
          if (options.tile == 5) options.scissor = PixelRect{0, 0, scene.width - 1, scene.height};
        })}},
      {"TargetWidthKeepsCoverage",
       "odd widths lose a column",
       "spans-exact",
       {.draw = WithOptions([](DrawOptions& options, const Scene& scene) {
          options.scissor = PixelRect{0, 0, scene.width - scene.width % 2, scene.height};
        })}},
      {"TargetHeightKeepsCoverage",
       "odd heights lose a row",
       "spans-exact",
       {.draw = WithOptions([](DrawOptions& options, const Scene& scene) {
          options.scissor = PixelRect{0, 0, scene.width, scene.height - scene.height % 2};
        })}},
      {"ThreadCountKeepsCoverage",
       "the third thread starves",
       "spans-exact",
       {.draw = WithOptions([](DrawOptions& options, const Scene& scene) {
          if (options.threads == 3) {
            options.scissor = PixelRect{0, 0, scene.width, scene.height - scene.height / 3};
          }
        }),
        .states_threads = true}},
  };
}

std::vector<PlantedBug> CoveragePlantedBugs() {
  using Corners3 = std::array<Vertex, 3>;
  return {
      {"CoverageEqualsTheModel", "every edge inclusive", "spans-exact", {.draw = DrawInclusively}},
      {"CoverageEqualsTheModel",
       "vertices off by 2^-9",
       "spans-exact",
       {.draw = WithVertices([](Vertex& v) { v.x += 0x1p-9; })}},
      {"CoverageEqualsTheModel",
       "no top edges",
       "spans-exact",
       {.draw =
            [](Subject& sound, const Scene& scene, const DrawOptions& options,
               CoverageCounts& counts) {
              Profile profile = sound.Info().profile;
              profile.tie_rule.sign_y = -1;
              counts += exact::Coverage(scene, profile, options);
            }}},
      {"ClipSpaceCoverageEqualsTheModel",
       "triangles across the eye are lost",
       "hom-exact",
       {.draw = Dropping([](std::size_t, const Triangle&, const Corners3& v, const Scene&) {
          return std::ranges::any_of(v, IsBehind);
        })}},
      {"EmbeddedMeshSamplesAreCoveredOnce",
       "every edge inclusive",
       "spans-exact",
       {.draw = DrawInclusively}},
      {"SharedEdgeSamplesAreCoveredOnce",
       "every edge inclusive",
       "spans-exact",
       {.draw = DrawInclusively}},
      {"SignedCoverageEqualsTheWindingNumber",
       "every edge inclusive",
       "spans-exact",
       {.draw = DrawInclusively}},
      {"OneLegalModelExplainsTheMesh",
       "shared vertices snapped up for one triangle, down for the other",
       "i32-snap4",
       {.draw = SnapByParity,
        .states = [](Profile& profile) { profile.freedom.snap_tolerance = 0.6; }}},
      {"OneLegalModelExplainsTheMesh",
       "every edge inclusive",
       "spans-exact",
       {.draw = DrawInclusively,
        .states = [](Profile& profile) { profile.freedom.ties = TieOwnership::kAxisAligned; }}},
      {"OpenTiesAreCoveredOnce",
       "every edge inclusive, owners left open",
       "spans-exact",
       {.draw = DrawInclusively,
        .states = [](Profile& profile) { profile.freedom.ties = TieOwnership::kPerEdge; }}},
      {"CoverageKeepsToItsSideOfTheModel",
       "no top edges, stated over",
       "spans-exact",
       {.draw = DrawBottomRight,
        .states = [](Profile& profile) { profile.contract = Contract::kAtLeastModel; }}},
      {"CoverageKeepsToItsSideOfTheModel",
       "every edge inclusive, stated under",
       "spans-exact",
       {.draw = DrawInclusively,
        .states = [](Profile& profile) { profile.contract = Contract::kAtMostModel; }}},
      {"ClosedMeshCancels",
       "every triangle is front",
       "spans-exact",
       {.draw = CallEveryTriangleFront}},
      {"ClosedSurfaceAroundTheEyeIsSeenEquallyOften",
       "triangles across the eye are lost",
       "hom-exact",
       {.draw = Dropping([](std::size_t, const Triangle&, const Corners3& v, const Scene&) {
          return std::ranges::any_of(v, IsBehind);
        })}},
      {"VertexRotationKeepsCoverage",
       "the first vertex must not be the rightmost",
       "spans-exact",
       {.draw = Dropping([](std::size_t, const Triangle&, const Corners3& v, const Scene&) {
          return v[0].x > v[1].x && v[0].x > v[2].x;
        })}},
      {"ReversalSwapsFacing",
       "back faces are culled unasked",
       "spans-exact",
       {.draw = WithOptions([](DrawOptions& options, const Scene&) {
          if (options.cull == Cull::kNone) options.cull = Cull::kBack;
        })}},
      {"TriangleOrderKeepsCoverage",
       "every third triangle is lost",
       "spans-exact",
       {.draw = Dropping([](std::size_t t, const Triangle&, const Corners3&, const Scene&) {
          return t % 3 == 0;
        })}},
      {"DuplicatedVerticesKeepCoverage",
       "indices must ascend",
       "spans-exact",
       {.draw = Dropping([](std::size_t, const Triangle& t, const Corners3&, const Scene&) {
          return t[0] > t[1];
        })}},
      {"DegenerateTrianglesCoverNothing",
       "a dot for each",
       "spans-exact",
       {.draw = DotDegenerates}},
      {"ScissorOnlyCutsCoverage",
       "the right edge is inclusive",
       "spans-exact",
       {.draw = WithOptions([](DrawOptions& options, const Scene& scene) {
          if (options.scissor) options.scissor->x1 = std::min(options.scissor->x1 + 1, scene.width);
        })}},
      {"NeighboursAreClippedAlike",
       "what leaves the target is lost",
       "spans-exact",
       {.draw = Dropping([](std::size_t, const Triangle&, const Corners3& v, const Scene& scene) {
          return LeavesTarget(v, scene);
        })}},
      {"NeighboursAreClippedAlike",
       "triangles across the eye are lost",
       "hom-exact",
       {.draw = Dropping([](std::size_t, const Triangle&, const Corners3& v, const Scene&) {
          return std::ranges::any_of(v, IsBehind);
        })}},
      {"FacingIsOneAtAllSamples",
       "the right half sees the other facing",
       "spans-exact",
       {.draw = TurnTheRightHalf}},
      {"CullingRemovesOneFacing",
       "front for back",
       "spans-exact",
       {.draw = WithOptions([](DrawOptions& options, const Scene&) {
          if (options.cull != Cull::kNone) {
            options.cull = options.cull == Cull::kFront ? Cull::kBack : Cull::kFront;
          }
        })}},
      {"IntegerTranslationMovesCoverage",
       "negative coordinates wrap",
       "spans-exact",
       {.draw = Dropping([](std::size_t, const Triangle&, const Corners3& v, const Scene&) {
          return std::ranges::any_of(v, [](const Vertex& p) { return p.x < 0; });
        })}},
  };
}

std::vector<PlantedBug> ExtremePlantedBugs() {
  return {
      {"DrawStaysInsideItsTarget",
       "a span runs past the scissor",
       "spans-exact",
       {.draw = RunPastTheScissor}},
      {"DrawStaysInsideItsTarget",
       "counts are overwritten",
       "spans-exact",
       {.draw = OverwriteCounts}},
      {"NonFiniteTrianglesCoverNothing",
       "NaN is taken for zero",
       "spans-exact",
       {.draw = WithVertices(TakeNonFiniteForZero)}},
      {"BadTrianglesPoisonNoOthers",
       "the first bad triangle ends the draw",
       "spans-exact",
       {.draw = StopAtTheFirstBadTriangle}},
      {"EqualDrawsGiveEqualCounts",
       "counts are overwritten",
       "spans-exact",
       {.draw = OverwriteCounts}},
  };
}

}  // namespace

std::vector<PlantedBug> PlantedBugs() {
  std::vector<PlantedBug> all;
  for (const std::vector<PlantedBug>& part :
       {EdgePlantedBugs(), IncrementalPlantedBugs(), BarycentricPlantedBugs(),
        CoveragePlantedBugs(), WireframePlantedBugs(), ExtremePlantedBugs(), OutputPlantedBugs(),
        SquarePlantedBugs()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace rasterproof::props
