// What Direct3D 11.3 and 12 say of coverage.
#include <array>
#include <span>

#include "core/clauses/clauses.h"

namespace rasterproof {
namespace {

using enum Force;

constexpr auto k11 = std::to_array<Clause>({
    {.id = "d3d11.point-sampling",
     .place = "3.4.2 and its figure",
     .sentence = "\"Any pixel sample locations which fall inside the triangle are drawn.\"",
     .reading = "A sample strictly inside the placed triangle is covered, one strictly outside is "
                "not.",
     .keys = "contract=sample-exact",
     .shown_by = "SpecificationFigures.TrianglesOfDirect3D11Section342"},
    {.id = "d3d11.top-left",
     .place = "3.4.2.1",
     .sentence = "A sample on an edge is inside if the edge is a top edge (exactly horizontal, "
                 "above the others) or a left edge.",
     .reading = "Decided by position alone: neighbours, tiles and order do not enter.",
     .keys = "tie_rule=top-left; tie_ownership=stated",
     .shown_by = "SpecificationFigures.TrianglesOfDirect3D11Section342"},
    {.id = "d3d11.two-edges",
     .place = "3.4.2.1",
     .sentence = "Where two edges of a triangle touch the centre, it is inside if both are top or "
                 "left.",
     .reading = "At a hub exactly one triangle of a mesh covers: the one that the shifted sample "
                "lies in.",
     .keys = "tie_ownership=stated",
     .shown_by = "SpecificationFigures.TrianglesOfDirect3D11Section342"},
    {.id = "d3d11.eight-bits",
     .place = "3.4.1, 15.16",
     .sentence = "x and y are snapped to fixed point with \"EXACTLY 8 bits\" of fraction, 16 of "
                 "integer.",
     .reading = "No coarser and no finer grid is legal.",
     .keys = "subpixel_bits=8"},
    {.id = "d3d11.nearest-even",
     .place = "3.2.4.1 and its figure; 15.16",
     .sentence = "The reference conversion rounds to nearest even.",
     .reading = "It names the canonical model; the next clause says how far others may be off.",
     .keys = "snap_rule=nearest-even",
     .shown_by = "SpecificationFigures.ConversionOfDirect3D11Section3241"},
    {.id = "d3d11.snap-tolerance",
     .place = "3.2.4.1",
     .force = kAllowed,
     .sentence = "\"0.6f ULP tolerance in the integer result\" against the exact n 2^f.",
     .reading = "0.6 of a grid step, from the float32 position after clip, divide and viewport.",
     .keys = "snap_tolerance=0.6; rounding=stated"},
    {.id = "d3d11.truncation",
     .place = "15, summary of changes; 3.2.4.1",
     .sentence = "Direct3D 10 allowed truncation, 11 \"requires round-to-nearest even\".",
     .reading = "It sits ill with the tolerance of 0.6; the tolerance is taken, since it is the "
                "wider one.",
     .keys = "snap_tolerance=0.6"},
    {.id = "d3d11.range",
     .place = "3.2.4.1, 15.6.1, 15.16",
     .sentence = "16.8 fixed point: values beyond [-32768, 32767 + 255/256] go to the nearest end.",
     .reading = "Coordinates are judged up to 32767 + 255/256 on either side of zero; beyond it a "
                "vertex goes to the nearest end, or an implementation clips first.",
     .keys = "coordinate_limit=32767.99609375"},
    {.id = "d3d11.one-position",
     .place = "3.4.1",
     .force = kSilent,
     .sentence = "Nothing says that a vertex off the grid snaps to one place for every triangle "
                 "that uses it.",
     .reading = "Triangles that share a vertex see one snapped position; each within the "
                "tolerance would otherwise be enough for cracks.",
     .is_assumed = true},
    {.id = "d3d11.snap-after-clip",
     .place = "3.4.1",
     .sentence = "Snapping comes after clipping, divide and viewport, and after any expansion of "
                 "primitives.",
     .reading = "A clipped triangle's new vertices snap as well: its edges may move.",
     .keys = "guard_band"},
    {.id = "d3d11.clip-point",
     .place = "3.4.1, 15.4",
     .force = kSilent,
     .sentence = "Nothing says how near to the edge the vertex lies that clipping makes.",
     .reading = "It lies exactly on the edge and is then placed as any vertex, so an edge that "
                "leaves moves by less than a step; neighbours need not take the same one.",
     .keys = "guard_band",
     .is_assumed = true},
    {.id = "d3d11.guard-band",
     .place = "15.4, 15.6",
     .force = kAllowed,
     .sentence = "x and y are clipped to w, or to an \"arbitrarily wider range\" of a guard band.",
     .reading = "Outside the viewport edges may move, or not; rendering is cut to the viewport "
                "either way.",
     .keys = "guard_band"},
    {.id = "d3d11.transform",
     .place = "15.5, 15.6",
     .sentence = "The divide and the viewport scale are done in float32, by given formulas.",
     .reading = "Neither the order of the operations nor fusing is fixed, so through an ordinary "
                "viewport the position is not known to the last bit.",
     .keys = "transform_error=null"},
    {.id = "d3d11.nan",
     .place = "15.16.1, 15.4",
     .sentence = "A primitive of which x, y or z is NaN after the viewport \"is discarded\".",
     .reading = "It covers nothing, z included.",
     .keys = "nan_vertex=nothing; nan_z=nothing"},
    {.id = "d3d11.w",
     .place = "15.16.1, 15.4",
     .force = kAllowed,
     .sentence = "\"No validation of w is done\", while 15.4 discards what comes out of clipping "
                 "with a NaN in w.",
     .reading = "A NaN in w gives NaN after the divide: nothing is covered by either sentence.",
     .keys = "nan_vertex=nothing"},
    {.id = "d3d11.infinity",
     .place = "15.4, 15.16.1",
     .force = kAllowed,
     .sentence = "Infinities \"may or may not result in a discarded primitive\", or x and y are "
                 "clamped to the furthest representable position.",
     .reading = "What such a triangle covers is not judged.",
     .keys = "infinite_vertex=unspecified"},
    {.id = "d3d11.cull-after-snap",
     .place = "3.4.1, 15.11",
     .sentence = "Culling is applied after vertices have been snapped.",
     .reading = "Facing is the sign of the snapped area. Which winding is the front is state "
                "(FrontCounterClockwise): one for all.",
     .keys = "front_face=unstated"},
    {.id = "d3d11.zero-area",
     .place = "15.11.1; 3.4.2",
     .sentence = "\"Zero area geometry is considered back facing.\"",
     .reading = "It has no inside, and none of its edges has an interior to its right or below: "
                "filled, it covers nothing.",
     .keys = "degenerate_triangles=nothing"},
    {.id = "d3d11.origin",
     .place = "3.3.1",
     .sentence = "The origin is the upper left corner; centres are offset by (0.5, 0.5).",
     .reading = "y points down; one sample a pixel, at (1/2, 1/2).",
     .keys = "y_axis=down; sample_locations"},
    {.id = "d3d11.scissor",
     .place = "15.7, 15.6",
     .sentence = "Pixels outside the scissor rectangle, and outside the viewport, are discarded.",
     .reading = "A scissor rectangle cuts, and changes nothing inside it; nothing is written "
                "outside the target."},
    {.id = "d3d11.standard-samples",
     .place = "19.2.4 and its figures, 19.2.5",
     .sentence = "Standard patterns for 1, 2, 4, 8 and 16 samples on a grid of 1/16; those for 1, "
                 "4 and 8 are required.",
     .reading = "Positions from the centre of the pixel, in sixteenths, in the order of the "
                "figures.",
     .keys = "sample_locations; sample_positions=stated",
     .shown_by = "SpecificationPatterns.PatternsOfDirect3D11Section1924"},
    {.id = "d3d11.multisample-coverage",
     .place = "3.5.4",
     .sentence = "With more samples, coverage tests are done \"for each sample location within a "
                 "pixel\".",
     .reading = "The rules of 3.4.2 hold for each sample apart."},
    {.id = "d3d11.centroid",
     .place = "3.5.5",
     .sentence = "Centroid is the centre if all samples are covered, else the first covered sample "
                 "in the order of indices.",
     .reading = "Exact: \"Centroid behaves exactly as follows\".",
     .keys = "centroid=direct3d"},
    {.id = "d3d11.translation",
     .place = "3.4",
     .force = kSilent,
     .sentence = "Nothing is said about moved primitives.",
     .reading = "On the grid it follows from the rules; off the grid, and within the tolerance, it "
                "does not.",
     .keys = "translation_invariant=false"},
    {.id = "d3d11.repeatability",
     .place = "3.5.4.1.1",
     .force = kSilent,
     .sentence = "The one invariance that is stated is of shader outputs under sample frequency; "
                 "of equal draws nothing is said.",
     .reading = "Within the tolerance, two equal draws could differ: a difference is quality."},
    {.id = "d3d11.interpolator",
     .place = "15.16.2",
     .sentence = "Interpolators are set up from snapped positions, and follow the floating-point "
                 "rules.",
     .reading = "Barycentrics are those of the snapped triangle; no error of the whole is stated."},
});

constexpr auto k12 = std::to_array<Clause>({
    {.id = "d3d12.must-cover",
     .place = "Conservative Rasterization, Overview",
     .sentence = "\"if any part of a primitive overlaps any part of a pixel, then that pixel must "
                 "be rasterized\", by the floating-point vertices.",
     .reading = "Must: pixels whose square meets the float triangle, not the snapped one, for "
                "triangles that have area once snapped.",
     .keys = "contract=squares; "
             "coverage.must.relation=intersects; coverage.must.geometry=given",
     .shown_by = "SpecificationSquares.OnlyTheFourMiddlePixels"},
    {.id = "d3d12.may-cover-tier-1",
     .place = "Conservative Rasterization, Rasterization Rules",
     .force = kAllowed,
     .sentence = "Other pixels only within an uncertainty region of at most half a pixel \"in the "
                 "fixed point domain\".",
     .reading = "May: pixels whose square meets the snapped triangle swept by a square of half "
                "width 1/2.",
     .keys = "coverage.may.relation=intersects; coverage.may.geometry=placed; "
             "coverage.may.growth=swept; coverage.may.half_width=0.5",
     .shown_by = "SpecificationSquares.OnlyTheFourMiddlePixels"},
    {.id = "d3d12.may-cover-tier-2",
     .place = "Conservative Rasterization, Tier 2, Smaller Outer Uncertainty Region",
     .force = kAllowed,
     .sentence = "From tier 2 on the region is at most 1/256 of a pixel.",
     .reading = "May: the snapped triangle swept by a square of half width 1/256.",
     .keys = "coverage.may.relation=intersects; coverage.may.geometry=placed; "
             "coverage.may.growth=swept; coverage.may.half_width=0x1p-8",
     .shown_by = "SpecificationSquares.OnlyTheMiddlePixel"},
    {.id = "d3d12.least-uncertainty",
     .place = "Conservative Rasterization, Rasterization Rules",
     .sentence = "The region is never smaller than 1/512 of a pixel.",
     .reading = "Half a grid step is what rounding to nearest can move a vertex."},
    {.id = "d3d12.top-left-at-least",
     .place = "Conservative Rasterization, Rasterization Rules and figure consras5",
     .sentence = "At that smallest region the top-left rule holds where its edges or corners fall "
                 "on pixel borders; a cut corner counts as the two edges at its vertex.",
     .reading = "Border contact on the left or top of the region covers the pixel.",
     .shown_by = "SpecificationSquares.ThirteenPixelsByTheTopLeftRule"},
    {.id = "d3d12.border-contact",
     .place = "Conservative Rasterization, Overview",
     .force = kAllowed,
     .sentence = "Where an edge or corner falls along a pixel's, the top-left rule is "
                 "\"implementation-specific\" at any larger region.",
     .reading = "A pixel that is only touched may be covered or not.",
     .keys = "coverage.must.square=open; coverage.must.shape=open; "
             "coverage.may.square=closed; coverage.may.shape=closed"},
    {.id = "d3d12.flat-tier-1",
     .place = "Conservative Rasterization, Overview and Tier 1",
     .force = kAllowed,
     .sentence = "Triangles that are flat, or become flat by snapping, \"may or may not be "
                 "culled\".",
     .reading = "Tier 1: what they cover is not judged below may.",
     .keys = "coverage.flat=free"},
    {.id = "d3d12.flat-tier-2",
     .place = "Conservative Rasterization, Tier 2, Degenerate Triangle Culling",
     .sentence = "From tier 2 on flat triangles \"must not be culled\", unless indices repeat.",
     .reading = "They cover at least one pixel, those that the float triangle meets.",
     .keys = "coverage.flat=drawn",
     .shown_by = "SpecificationSquares.AFlatTriangleStillMeetsPixels"},
    {.id = "d3d12.flat-back-facing",
     .place = "Conservative Rasterization, Overview",
     .sentence = "Flat triangles are back-facing and take vertex 0's values.",
     .reading = "As zero area in Direct3D 11.3, 15.11.1."},
    {.id = "d3d12.inner-coverage",
     .place = "Conservative Rasterization, InnerCoverage",
     .sentence = "InnerCoverage is set only for a pixel that is \"entirely inside\" the triangle, "
                 "by the floating-point vertices.",
     .reading =
         "No false inner pixel. A pixel that touches a side from within may be left out, and "
         "the specification's own test (consras7) expects that it is.",
     .keys = "contract=squares; coverage.flat=nothing; "
             "coverage.may.relation=contains; coverage.may.square=closed; "
             "coverage.may.shape=open; coverage.may.geometry=given",
     .shown_by = "SpecificationSquares.InnerCoverageIsTheMiddlePixel"},
    {.id = "d3d12.inner-omission",
     .place = "Conservative Rasterization, InnerCoverage",
     .force = kAllowed,
     .sentence = "A fully covered pixel may be left out only if it meets an inner region of at "
                 "most 1/256 of a pixel.",
     .reading = "Within the inner boundary of the swept snapped triangle it must be set.",
     .keys = "coverage.must.relation=contains; coverage.must.square=closed; "
             "coverage.must.shape=open; coverage.must.geometry=placed; "
             "coverage.must.growth=swept; coverage.must.half_width=0x1p-8",
     .shown_by = "SpecificationSquares.InnerCoverageIsTheMiddlePixel"},
    {.id = "d3d12.all-samples",
     .place = "Conservative Rasterization, Multisampling",
     .sentence = "All samples of a rasterized pixel are covered.",
     .reading = "Sample positions play no part; centroid is the centre."},
    {.id = "d3d12.sample-positions",
     .place = "Programmable Sample Positions",
     .force = kAllowed,
     .sentence = "An application may set positions in sixteenths of a pixel from its centre, over "
                 "grids of 1 x 1 or 2 x 2 pixels.",
     .reading = "A pattern may differ between four neighbouring pixels.",
     .keys = "sample_locations"},
});

}  // namespace

std::span<const Clause> Direct3D11Clauses() { return k11; }
std::span<const Clause> Direct3D12Clauses() { return k12; }

}  // namespace rasterproof
