// What OpenGL 4.6 says of coverage.
#include <array>
#include <span>

#include "core/clauses/clauses.h"

namespace rasterproof {
namespace {

using enum Force;

constexpr auto kOpenGl = std::to_array<Clause>({
    {.id = "gl.point-sampling",
     .place = "14.6.1",
     .sentence = "\"Fragment centers that lie inside of this polygon are produced\".",
     .reading = "A sample strictly inside the placed triangle is covered, one strictly outside is "
                "not: the rule is said to determine which fragments are produced.",
     .keys = "contract=sample-exact",
     .shown_by = "SpecificationTies.SamplesOffEveryEdgeAreDecidedByEveryRule"},
    {.id = "gl.common-edge",
     .place = "14.6.1",
     .sentence = "Of two polygons on either side of a common edge with identical endpoints, "
                 "\"exactly one\" produces a fragment whose centre lies on it.",
     .reading = "One owner for each sample of a shared edge; it may be another one on the next "
                "edge, or at the next sample.",
     .keys = "tie_ownership=per-edge",
     .shown_by = "SpecificationTies.OneOfTwoSidesOwnsACommonEdge"},
    {.id = "gl.owner-not-named",
     .place = "14.6.1",
     .force = kSilent,
     .sentence = "Nothing says which of the two polygons it is.",
     .reading = "No tie rule is stated: the preset's rule is only the model that a set is named "
                "after.",
     .keys = "tie_rule"},
    {.id = "gl.lone-edge",
     .place = "14.6.1",
     .force = kSilent,
     .sentence = "Nothing is said about a centre on an edge that no second polygon has.",
     .reading = "Covered or not, as the implementation likes, sample by sample.",
     .keys = "tie_ownership=per-edge"},
    {.id = "gl.hub",
     .place = "14.6.1",
     .force = kSilent,
     .sentence = "Nothing is said about a centre on a vertex that three or more polygons share.",
     .reading = "The sentence speaks of two polygons and an edge: at a hub none, one or several "
                "may cover; once is what users want."},
    {.id = "gl.fold",
     .place = "14.6.1",
     .force = kSilent,
     .sentence = "Nothing is said about two polygons on the same side of their common edge.",
     .reading = "At a fold, a silhouette included, a sample on the edge may be covered by none, "
                "one or both."},
    {.id = "gl.t-junction",
     .place = "14.6.1",
     .force = kSilent,
     .sentence = "\"identical endpoints\" leaves out edges that overlap in part.",
     .reading = "Beside a T-junction nothing is required, even where no rounding moved it."},
    {.id = "gl.one-position",
     .place = "2.1, 13.8, 14.6.1",
     .force = kSilent,
     .sentence = "Vertices are processed \"in the same way\", clipping excepted; nothing says that "
                 "rounding brings one vertex to one place for every polygon that uses it.",
     .reading = "Polygons that share a vertex see one placed position; else \"identical "
                "endpoints\" would never be met.",
     .is_assumed = true},
    {.id = "gl.subpixel-bits",
     .place = "table 23.53, SUBPIXEL_BITS",
     .sentence = "The number of bits of subpixel precision in window x and y is at least 4.",
     .reading = "A grid of 1/16 pixel or finer, the same in both axes; a device reports its own.",
     .keys = "least_subpixel_bits=4; subpixel_bits"},
    {.id = "gl.rounding",
     .place = "13.8, 14",
     .force = kSilent,
     .sentence = "Nothing says how a window coordinate is brought to that precision.",
     .reading = "Any of the two grid points beside a coordinate; a coordinate on the grid stays.",
     .keys = "rounding=unspecified; snap_rule; snap_tolerance"},
    {.id = "gl.not-pixel-exact",
     .place = "A",
     .force = kAllowed,
     .sentence = "\"The OpenGL specification is not pixel exact\": implementations may differ.",
     .reading = "Images of two drivers are compared through what is required of each, never with "
                "each other."},
    {.id = "gl.float-accuracy",
     .place = "2.3.4.1",
     .force = kAllowed,
     .sentence = "Floating-point operations are accurate to \"about 1 part in 10^5\".",
     .reading = "The error of the divide and of the viewport transform is not stated closely "
                "enough to judge samples through an ordinary viewport.",
     .keys = "transform_error=null"},
    {.id = "gl.translation",
     .place = "14.2",
     .sentence = "A primitive moved by whole pixels gives the moved fragments, \"as long as "
                 "neither\" of the two is clipped.",
     .reading = "Whatever was chosen for rounding and ties is chosen again one pixel further; a "
                "rule that changes from tile to tile violates it.",
     .keys = "translation_invariant=true",
     .shown_by = "SpecificationTies.AMovedTriangleCoversTheMovedSamples"},
    {.id = "gl.translation-multisample",
     .place = "14.3.1",
     .force = kAllowed,
     .sentence = "The invariance of 14.2 is \"relaxed for all multisample rasterization\".",
     .reading = "With more than one sample a pixel nothing is required of a moved scene, since "
                "sample locations may depend on the pixel.",
     .keys = "sample_positions=vary"},
    {.id = "gl.clipping",
     .place = "13.7",
     .force = kAllowed,
     .sentence = "A polygon not wholly inside the clip volume is \"either clipped or discarded\"; "
                 "clipping may bring new vertices.",
     .reading = "New vertices are placed too, so edges of a clipped triangle may move; what lies "
                "far from both the old and the new edge is decided all the same.",
     .keys = "guard_band"},
    {.id = "gl.clip-point",
     .place = "13.7",
     .force = kSilent,
     .sentence = "Nothing says how near to the edge the vertex lies that clipping makes.",
     .reading = "It lies exactly on the edge and is then placed as any vertex, so an edge that "
                "leaves moves by less than a step; neighbours need not take the same one.",
     .keys = "guard_band",
     .is_assumed = true},
    {.id = "gl.clip-corner",
     .place = "13.7",
     .sentence = "A polygon that meets an edge of the clip volume's boundary must include a point "
                 "of that edge once it is clipped.",
     .reading = "The corner of the viewport is not cut off a triangle that contains it.",
     .keys = "guard_band"},
    {.id = "gl.viewport-bounds",
     .place = "13.8.1; table 23.54, VIEWPORT_BOUNDS_RANGE",
     .sentence = "The range that viewport corners are clamped to reaches at least [-32768, 32767].",
     .reading = "It bounds viewports, not vertices: taken as the range in which window "
                "coordinates are judged.",
     .keys = "coordinate_limit=32768"},
    {.id = "gl.facing",
     .place = "14.6.1",
     .sentence = "Facing is the sign of the area, \"clipped or unclipped\", in window coordinates.",
     .reading = "Near zero area, clipping and rounding may turn it: both facings are legal there; "
                "zero area is back-facing, since front needs a positive sign. Which winding is the "
                "front is state (FrontFace): one for all.",
     .keys = "front_face=unstated"},
    {.id = "gl.zero-area",
     .place = "14.6.1",
     .force = kSilent,
     .sentence = "Nothing says what a polygon of zero area covers, beyond what lies inside of it.",
     .reading = "It has no inside, but its edges may hold samples: it may cover those or nothing.",
     .keys = "degenerate_triangles=unspecified"},
    {.id = "gl.nan-infinity",
     .place = "2.3.4.1",
     .force = kAllowed,
     .sentence = "\"providing a NaN or an infinity yields unspecified results\".",
     .reading = "Said of commands' arguments; read for vertex positions alike, of which nothing "
                "else is said.",
     .keys = "nan_vertex=unspecified; nan_z=unspecified; infinite_vertex=unspecified"},
    {.id = "gl.no-termination",
     .place = "2.3.4.1",
     .sentence = "Such a value \"must not lead to GL interruption or termination\".",
     .reading = "A draw with it comes back."},
    {.id = "gl.framebuffer-bounds",
     .place = "14",
     .sentence = "Fragments that would lie outside the framebuffer are not produced.",
     .reading = "No sample outside the target is written, however large the triangle."},
    {.id = "gl.window-origin",
     .place = "14, 13.8.1",
     .sentence = "A fragment is located by its lower left corner, on whole coordinates.",
     .reading = "An adapter counts rows from the top, as buffers are stored, "
                "which turns y over; nothing that is required hangs on the direction of y.",
     .keys = "y_axis",
     .is_assumed = true},
    {.id = "gl.centre",
     .place = "14",
     .sentence = "A fragment's centre lies on half-integer coordinates.",
     .reading = "One sample a pixel, at (1/2, 1/2).",
     .keys = "sample_locations"},
    {.id = "gl.sample-points",
     .place = "14.3.1",
     .force = kAllowed,
     .sentence = "Sample points are exact positions; they \"cannot be queried\", may lie outside "
                 "the pixel, and may differ from pixel to pixel.",
     .reading =
         "Multisample positions are inferred, never taken from a table; meshes are judged at "
         "every sample away from their outline, singles at none.",
     .keys = "sample_locations; sample_positions=vary"},
    {.id = "gl.sample-position-query",
     .place = "14.3.1, GetMultisamplefv",
     .force = kAllowed,
     .sentence = "SAMPLE_POSITION gives where a sample is shaded, which need not be its sample "
                 "point, and may be true of some pixels only.",
     .reading = "What a driver reports is a hint for the search of positions, no evidence."},
    {.id = "gl.multisample-coverage",
     .place = "14.6.6",
     .sentence = "Coverage bits are 1 for the sample points that satisfy 14.6.1, else 0.",
     .reading = "Every sample is decided as a centre is: point sampling and common edges hold for "
                "each sample apart."},
    {.id = "gl.centroid",
     .place = "15.2",
     .force = kAllowed,
     .sentence = "A centroid input is sampled \"within the pixel covered by the primitive\".",
     .reading = "Any point of pixel and primitive will do. With one sample it is the centre, as "
                "GLSL 4.60 section 4.5 says.",
     .keys = "centroid=inside"},
    {.id = "gl.repeatability",
     .place = "A.3, rule 1",
     .sentence = "The same command on the same state gives an identical framebuffer each time.",
     .reading = "Equal draws give equal counts."},
    {.id = "gl.scissor",
     .place = "A.3, rule 2 and corollary 1",
     .sentence = "Scissor parameters, other than the enable, have no side effects on fragments.",
     .reading = "A scissor rectangle cuts, and changes nothing inside it."},
    {.id = "gl.batching",
     .place = "A.3",
     .force = kSilent,
     .sentence = "Nothing requires one call with many triangles to draw as many calls do.",
     .reading = "Repeatability is of equal commands: order and grouping of triangles, threads and "
                "tiles are not spoken of; users want them not to matter."},
    {.id = "gl.command-order",
     .place = "2.1",
     .sentence = "Commands are processed \"in the order in which they are received\".",
     .reading = "Without a depth test the last triangle on a sample stays."},
    {.id = "gl.barycentric",
     .place = "14.6.1",
     .sentence = "a, b and c each in [0, 1], a + b + c = 1, and p = a pa + b pb + c pc.",
     .reading = "Of exact numbers: no error is stated, so what a driver computes is judged by the "
                "bound that it states."},
    {.id = "gl.nv-conservative",
     .place = "GL_NV_conservative_raster, 14.6.X",
     .sentence = "A fragment for a pixel of which any portion is covered, edges and corners "
                 "included.",
     .reading = "Closed squares: touching counts, so the tie rule is out of use there.",
     .keys = "contract=squares; "
             "coverage.must.relation=intersects; coverage.must.square=closed; "
             "coverage.must.shape=closed; coverage.must.geometry=placed"},
    {.id = "gl.nv-conservative-zero-area",
     .place = "GL_NV_conservative_raster, 14.6.X and issue 2",
     .sentence = "\"Polygons with an area of zero generate no fragments\" even there.",
     .reading = "The opposite of Direct3D's tiers 2 and 3; of areas that rounding made zero the "
                "issue says that drawing them may be wished for.",
     .keys = "coverage.flat=nothing"},
});

}  // namespace

std::span<const Clause> OpenGlClauses() { return kOpenGl; }

}  // namespace rasterproof
