// What Vulkan says of coverage.
#include <array>
#include <span>

#include "core/clauses/clauses.h"

namespace rasterproof {
namespace {

using enum Force;

constexpr auto kVulkan = std::to_array<Clause>({
    {.id = "vulkan.point-sampling",
     .place = "Basic Polygon Rasterization",
     .sentence = "Coverage bits of sample points that \"lie inside of this polygon\" are 1, other "
                 "bits are 0.",
     .reading = "A sample strictly inside the placed triangle is covered, one strictly outside is "
                "not.",
     .keys = "contract=sample-exact",
     .shown_by = "SpecificationTies.SamplesOffEveryEdgeAreDecidedByEveryRule"},
    {.id = "vulkan.common-edge",
     .place = "Basic Polygon Rasterization",
     .sentence = "Of two polygons on either side of a common edge with identical endpoints, "
                 "\"exactly one\" must cover a sample point on it.",
     .reading = "One owner for each sample of a shared edge; which one may depend on the edge, the "
                "sample and the tile.",
     .keys = "tie_ownership=per-edge",
     .shown_by = "SpecificationTies.OneOfTwoSidesOwnsACommonEdge"},
    {.id = "vulkan.owner-not-named",
     .place = "Basic Polygon Rasterization",
     .force = kSilent,
     .sentence = "Nothing says which of the two polygons it is.",
     .reading = "No tie rule is stated: the preset's rule is only the model that a set is named "
                "after.",
     .keys = "tie_rule"},
    {.id = "vulkan.lone-edge",
     .place = "Basic Polygon Rasterization",
     .force = kSilent,
     .sentence = "Nothing is said about a sample on an edge that no second polygon has.",
     .reading = "Covered or not, as the implementation likes, sample by sample.",
     .keys = "tie_ownership=per-edge"},
    {.id = "vulkan.hub",
     .place = "Basic Polygon Rasterization",
     .force = kSilent,
     .sentence = "Nothing is said about a sample on a vertex that three or more polygons share.",
     .reading = "At a hub none, one or several may cover; once is what users want."},
    {.id = "vulkan.fold",
     .place = "Basic Polygon Rasterization",
     .force = kSilent,
     .sentence = "Nothing is said about two polygons on the same side of their common edge.",
     .reading = "At a fold, a silhouette included, a sample on the edge may be covered by none, "
                "one or both."},
    {.id = "vulkan.t-junction",
     .place = "Basic Polygon Rasterization",
     .force = kSilent,
     .sentence = "\"identical endpoints\" leaves out edges that overlap in part.",
     .reading = "Beside a T-junction nothing is required."},
    {.id = "vulkan.one-position",
     .place = "Controlling the Viewport; Basic Polygon Rasterization",
     .force = kSilent,
     .sentence = "Nothing says that a vertex is placed alike for every polygon that uses it.",
     .reading = "Polygons that share a vertex see one placed position; else \"identical "
                "endpoints\" would never be met.",
     .is_assumed = true},
    {.id = "vulkan.subpixel-bits",
     .place = "Controlling the Viewport; Required Limits, subPixelPrecisionBits",
     .sentence = "Framebuffer x and y retain subPixelPrecisionBits fractional bits: at least 4, "
                 "and 8 in the 2026 roadmap profile.",
     .reading = "A grid of that many bits, the same in both axes; a device reports its own number.",
     .keys = "least_subpixel_bits=4; subpixel_bits"},
    {.id = "vulkan.rounding",
     .place = "Controlling the Viewport",
     .force = kSilent,
     .sentence = "The bits are \"retained\"; no rounding is named.",
     .reading = "Any of the two grid points beside a coordinate; a coordinate on the grid stays.",
     .keys = "rounding=unspecified; snap_rule; snap_tolerance"},
    {.id = "vulkan.not-pixel-exact",
     .place = "Appendix: Invariance",
     .force = kAllowed,
     .sentence = "\"The Vulkan specification is not pixel exact.\"",
     .reading = "Images of two devices are compared through what is required of each, never with "
                "each other."},
    {.id = "vulkan.float-accuracy",
     .place = "Floating-Point Computation; Controlling the Viewport",
     .force = kSilent,
     .sentence = "The divide and the viewport transform are given as formulas; no error is stated "
                 "for them.",
     .reading = "Samples are judged where the window position is exact whatever was fused or "
                "rounded; through an ordinary viewport they are not judged.",
     .keys = "transform_error=null"},
    {.id = "vulkan.translation",
     .place = "Appendix: Invariance, note after rule 7",
     .force = kAllowed,
     .sentence = "OpenGL's rule for primitives moved by whole pixels \"does not apply to Vulkan\", "
                 "by intention.",
     .reading = "A moved scene may cover other samples: at most quality.",
     .keys = "translation_invariant=false"},
    {.id = "vulkan.clipping",
     .place = "Primitive Clipping",
     .force = kAllowed,
     .sentence = "A polygon not wholly inside the clip volume is \"either clipped or discarded\"; "
                 "that may bring new vertices.",
     .reading = "New vertices are placed too, so edges of a clipped triangle may move; a guard "
                "band is neither required nor named.",
     .keys = "guard_band"},
    {.id = "vulkan.clip-point",
     .place = "Primitive Clipping",
     .force = kSilent,
     .sentence = "Nothing says how near to the edge the vertex lies that clipping makes.",
     .reading = "It lies exactly on the edge and is then placed as any vertex, so an edge that "
                "leaves moves by less than a step; neighbours need not take the same one.",
     .keys = "guard_band",
     .is_assumed = true},
    {.id = "vulkan.clip-corner",
     .place = "Primitive Clipping",
     .sentence = "A polygon that meets an edge of the clip volume's boundary must include a point "
                 "of that edge once it is clipped.",
     .reading = "The corner of the viewport is not cut off a triangle that contains it.",
     .keys = "guard_band"},
    {.id = "vulkan.viewport-bounds",
     .place = "Limits; Required Limits, viewportBoundsRange",
     .sentence = "The corners of a viewport must lie in a range that holds at least [-8192, 8191], "
                 "and [-15360, 15359] from Vulkan 1.4 on.",
     .reading = "It bounds viewports, not vertices, and is no word against clipping; the preset's "
                "limit is the range of 16 integer bits, within which coordinates are judged.",
     .keys = "coordinate_limit"},
    {.id = "vulkan.facing",
     .place = "Basic Polygon Rasterization, VkFrontFace",
     .sentence = "Facing is the sign of the area, \"clipped or unclipped\"; what is not "
                 "front-facing is back-facing, \"including zero-area triangles\".",
     .reading = "Near zero area, clipping and rounding may turn it: both facings are legal there. "
                "Which winding is the front is state of the pipeline: one for all.",
     .keys = "front_face=unstated"},
    {.id = "vulkan.zero-area",
     .place = "Basic Polygon Rasterization",
     .force = kSilent,
     .sentence = "Outside conservative rasterization nothing says what a triangle of zero area "
                 "covers.",
     .reading = "It has no inside, but its edges may hold samples: it may cover those or nothing.",
     .keys = "degenerate_triangles=unspecified"},
    {.id = "vulkan.nan-infinity",
     .place = "General Requirements; Floating-Point Computation",
     .force = kAllowed,
     .sentence = "\"providing a NaN or Inf yields unspecified results\"; support for either is "
                 "optional in computations.",
     .reading = "Said of commands' arguments; read for vertex positions alike, of which nothing "
                "else is said.",
     .keys = "nan_vertex=unspecified; nan_z=unspecified; infinite_vertex=unspecified"},
    {.id = "vulkan.no-termination",
     .place = "General Requirements",
     .sentence = "Such a value must not lead to \"interruption or termination\".",
     .reading = "A draw with it comes back."},
    {.id = "vulkan.framebuffer-origin",
     .place = "Rasterization",
     .sentence = "A fragment is located by its upper left corner, on whole coordinates.",
     .reading = "y points down, rows are counted from the top.",
     .keys = "y_axis=down"},
    {.id = "vulkan.single-sample",
     .place = "Multisampling",
     .sentence = "Single-sample rendering is a multisample mode with one sample in the centre of "
                 "each pixel.",
     .reading = "One sample a pixel, at (1/2, 1/2).",
     .keys = "sample_locations"},
    {.id = "vulkan.sample-points",
     .place = "Multisampling",
     .force = kAllowed,
     .sentence = "Sample points lie inside or on the boundary of the pixel's unit square, and "
                 "\"may differ\" from pixel to pixel.",
     .reading = "Without standard locations positions are inferred, each pixel apart.",
     .keys = "sample_locations; sample_positions=vary"},
    {.id = "vulkan.standard-samples",
     .place = "Multisampling, Standard Sample Locations; Limits, standardSampleLocations",
     .sentence = "Where standardSampleLocations is true (required from Vulkan 1.4 on), 1, 2, 4, 8 "
                 "and 16 samples lie where a table says.",
     .reading = "The same places as in Direct3D, from the pixel's upper left corner.",
     .keys = "sample_locations; sample_positions=stated",
     .shown_by = "SpecificationPatterns.StandardLocationsOfVulkanAreThoseOfDirect3D"},
    {.id = "vulkan.centroid",
     .place = "Interpolation Decorations",
     .force = kAllowed,
     .sentence = "A centroid input's position must also \"fall within the bounds of the "
                 "primitive\".",
     .reading = "Any point of fragment and primitive will do. With one sample it is the "
                "centre, as the section says.",
     .keys = "centroid=inside"},
    {.id = "vulkan.repeatability",
     .place = "Appendix: Invariance, rule 1",
     .sentence = "The same command on the same state gives an identical framebuffer each time.",
     .reading = "Equal draws give equal counts."},
    {.id = "vulkan.scissor",
     .place = "Appendix: Invariance, rule 2 and corollary 1; Scissor Test",
     .sentence = "Scissor parameters have no side effects on the generation of fragments.",
     .reading = "A scissor rectangle cuts, and changes nothing inside it."},
    {.id = "vulkan.batching",
     .place = "Appendix: Invariance",
     .force = kSilent,
     .sentence = "Nothing requires one call with many triangles to draw as many calls do.",
     .reading = "Order and grouping of triangles, threads and tiles are not spoken of; users want "
                "them not to matter."},
    {.id = "vulkan.rasterization-order",
     .place = "Rasterization Order",
     .sentence = "Colour writes of primitives at one sample execute in primitive order.",
     .reading = "Without a depth test the last triangle on a sample stays."},
    {.id = "vulkan.barycentric",
     .place = "Basic Polygon Rasterization",
     .sentence = "a, b and c each in [0, 1], a + b + c = 1, and p = a pa + b pb + c pc.",
     .reading = "Of exact numbers: no error is stated, so what a driver computes is judged by the "
                "bound that it states."},
    {.id = "vulkan.overestimate",
     .place = "Conservative Rasterization",
     .sentence = "A fragment if the primitive covers any portion of the pixel, \"including its "
                 "edges and corners\".",
     .reading = "Closed squares against the placed triangle: touching counts.",
     .keys = "contract=squares; "
             "coverage.must.relation=intersects; coverage.must.square=closed; "
             "coverage.must.shape=closed; coverage.must.geometry=placed",
     .shown_by = "SpecificationSquares.ClosedSquaresCountATouch"},
    {.id = "vulkan.overestimate-ties",
     .place = "Conservative Rasterization",
     .sentence = "The tie rule \"does not apply\" and fragments on shared edges are generated for "
                 "every polygon.",
     .reading = "Both neighbours cover the pixels that their edge passes or touches.",
     .shown_by = "SpecificationSquares.ClosedSquaresCountATouch"},
    {.id = "vulkan.overestimate-growth",
     .place = "Conservative Rasterization; Limits, primitiveOverestimationSize",
     .force = kAllowed,
     .sentence = "The primitive may grow by up to primitiveOverestimationSize at each edge, a size "
                 "that results may \"only approximate\".",
     .reading = "No upper bound that could be violated: only a missing pixel is."},
    {.id = "vulkan.underestimate",
     .place = "Conservative Rasterization",
     .sentence = "A fragment only if the whole pixel, \"including its edges and corners\", is "
                 "covered.",
     .reading = "Closed squares, wholly within the closed triangle.",
     .keys = "contract=squares; coverage.flat=nothing; "
             "coverage.may.relation=contains; coverage.may.square=closed; "
             "coverage.may.shape=closed; coverage.may.geometry=placed",
     .shown_by = "SpecificationSquares.InnerCoverageIsTheMiddlePixel"},
    {.id = "vulkan.conservative-zero-area",
     .place = "Conservative Rasterization; Limits, degenerateTrianglesRasterized",
     .sentence = "Triangles of zero area once placed are culled or drawn, as the device reports; "
                 "those of zero area before may be culled regardless.",
     .reading = "The device says which; drawn ones are back-facing and cover every pixel that a "
                "vertex or an edge touches.",
     .keys = "coverage.flat=free"},
});

}  // namespace

std::span<const Clause> VulkanClauses() { return kVulkan; }

}  // namespace rasterproof
