// What WebGPU says of coverage.
#include <array>
#include <span>

#include "core/clauses/clauses.h"

namespace rasterproof {
namespace {

using enum Force;

constexpr auto kWebGpu = std::to_array<Clause>({
    {.id = "webgpu.point-sampling",
     .place = "23.2.5.4, step 5",
     .sentence = "All pixel centres \"enclosed into the polygon\" are included.",
     .reading = "A centre strictly inside is covered, one strictly outside is not.",
     .keys = "contract=sample-exact",
     .shown_by = "SpecificationTies.SamplesOffEveryEdgeAreDecidedByEveryRule"},
    {.id = "webgpu.edge",
     .place = "23.2.5.4, step 5",
     .force = kAllowed,
     .sentence = "Of a pixel centre on the polygon's edge, \"whether or not it's included is not "
                 "defined\".",
     .reading = "A sample of a shared edge may be covered by none, one or both; no pair of "
                "polygons is spoken of at all.",
     .keys = "tie_ownership=open; tie_rule",
     .shown_by = "SpecificationTies.WebGpuLeavesEveryEdgeOpen"},
    {.id = "webgpu.precision",
     .place = "23.2.5, 23.2.5.4",
     .force = kSilent,
     .sentence = "No number of subpixel bits is given; a note says only that edges are a \"subject "
                 "of precision for the rasterizer\".",
     .reading = "The grid may be as coarse as whole pixels: what the preset can still require is "
                "little, and a device's own number narrows it.",
     .keys = "least_subpixel_bits=0; subpixel_bits"},
    {.id = "webgpu.rounding",
     .place = "23.2.5",
     .force = kSilent,
     .sentence = "No rounding of framebuffer coordinates is named.",
     .reading = "Any of the two grid points beside a coordinate; a coordinate on the grid stays.",
     .keys = "rounding=unspecified; snap_rule; snap_tolerance"},
    {.id = "webgpu.one-position",
     .place = "23.2.5",
     .force = kSilent,
     .sentence = "Nothing says that a vertex is placed alike for every polygon that uses it.",
     .reading = "Polygons that share a vertex see one placed position.",
     .is_assumed = true},
    {.id = "webgpu.hub",
     .place = "23.2.5.4",
     .force = kSilent,
     .sentence = "Nothing is said about vertices apart from edges.",
     .reading = "A centre on a vertex is on an edge: open."},
    {.id = "webgpu.float-accuracy",
     .place = "23.2.5, steps 1 and 2",
     .force = kSilent,
     .sentence = "The divide and the viewport map are formulas without an error.",
     .reading = "Samples are judged where the window position is exact whatever was fused or "
                "rounded.",
     .keys = "transform_error=null"},
    {.id = "webgpu.viewport-rounding",
     .place = "Rasterization state, setViewport, queue timeline steps",
     .force = kAllowed,
     .sentence = "The viewport's corner and size are rounded \"to some uniform precision, no less "
                 "precise than integer rounding\".",
     .reading = "Only viewports of whole numbers place vertices predictably.",
     .keys = "transform_error=null"},
    {.id = "webgpu.translation",
     .place = "23.2.5",
     .force = kSilent,
     .sentence = "Nothing is said about moved primitives.",
     .reading = "A moved scene may cover other samples: at most quality.",
     .keys = "translation_invariant=false"},
    {.id = "webgpu.clipping",
     .place = "23.2.4",
     .force = kAllowed,
     .sentence = "Edges that meet the clip volume's boundary are reconnected along it, which may "
                 "bring new vertices.",
     .reading = "New vertices are placed too, so edges of a clipped triangle may move.",
     .keys = "guard_band; coordinate_limit"},
    {.id = "webgpu.clip-point",
     .place = "23.2.4",
     .force = kSilent,
     .sentence = "Nothing says how near to the edge the vertex lies that clipping makes.",
     .reading = "It lies exactly on the edge and is then placed as any vertex, so an edge that "
                "leaves moves by less than a step; neighbours need not take the same one.",
     .keys = "guard_band",
     .is_assumed = true},
    {.id = "webgpu.clip-corner",
     .place = "23.2.4",
     .sentence = "The clipped polygon must include a point of an edge of the boundary that it "
                 "meets.",
     .reading = "The corner of the viewport is not cut off a triangle that contains it.",
     .keys = "guard_band"},
    {.id = "webgpu.facing",
     .place = "23.2.5.4, step 3",
     .sentence = "The sign of the area in framebuffer coordinates; zero is back-facing for both "
                 "windings.",
     .reading =
         "Of the placed polygon; near zero area both facings are legal. Which winding is the "
         "front is state of the pipeline: one for all.",
     .keys = "front_face=unstated"},
    {.id = "webgpu.zero-area",
     .place = "23.2.5.4",
     .force = kSilent,
     .sentence = "Nothing says what a polygon of zero area covers.",
     .reading = "It encloses nothing, and centres on its edges are open.",
     .keys = "degenerate_triangles=unspecified"},
    {.id = "webgpu.non-finite",
     .place = "23.2.2 to 23.2.5",
     .force = kSilent,
     .sentence = "Nothing is said about positions that are NaN or infinite.",
     .reading = "What such a triangle covers is not judged.",
     .keys = "nan_vertex=unspecified; nan_z=unspecified; infinite_vertex=unspecified"},
    {.id = "webgpu.independent-primitives",
     .place = "23.2.5",
     .sentence = "\"Each primitive in primitiveList is processed independently.\"",
     .reading = "What a triangle covers depends on no other triangle of the call, nor on their "
                "order."},
    {.id = "webgpu.scissor",
     .place = "23.2.5, last step",
     .sentence = "Points outside the scissor rectangle are removed after rasterization.",
     .reading = "A scissor rectangle cuts, and changes nothing inside it."},
    {.id = "webgpu.origin",
     .place = "23.2.5",
     .sentence = "Framebuffer coordinates start from the top left corner; a unit is a pixel.",
     .reading = "y points down, rows are counted from the top.",
     .keys = "y_axis=down"},
    {.id = "webgpu.samples",
     .place = "23.2.5, standard sample patterns",
     .sentence = "1 and 4 samples lie where a table says, and implementations must use it.",
     .reading = "Direct3D's and Vulkan's places. Step 5 of 23.2.5.4 still calls multisample "
                "locations implementation-defined: the table, which says must, is taken.",
     .keys = "sample_locations",
     .shown_by = "SpecificationPatterns.WebGpuHasOneAndFourSamples"},
    {.id = "webgpu.centroid",
     .place = "WGSL, Interpolation",
     .force = kAllowed,
     .sentence = "A centroid input is evaluated at a point that \"lies within all the samples "
                 "covered by the fragment\"; the value is one for all of them.",
     .reading = "No point lies within several samples: any of pixel and primitive will do, as in "
                "the APIs beneath. With one sample it is the centre, where that sample lies.",
     .keys = "centroid=inside",
     .is_assumed = true},
    {.id = "webgpu.barycentric",
     .place = "23.2.5.3",
     .sentence = "Each in [0, 1], their sum 1, and p the sum of b_i p_i.",
     .reading = "Of exact numbers: no error is stated."},
});

}  // namespace

std::span<const Clause> WebGpuClauses() { return kWebGpu; }

}  // namespace rasterproof
