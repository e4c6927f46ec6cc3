// What PDF and PostScript, GDAL, X11 and java.awt say of coverage: for surveys.
#include <array>
#include <span>

#include "core/clauses/clauses.h"

namespace rasterproof {
namespace {

using enum Force;

constexpr auto kPdf = std::to_array<Clause>({
    {.id = "pdf.pixel",
     .place = "6.5.3",
     .sentence = "A pixel is the half-open square i <= x < i + 1, j <= y < j + 1.",
     .reading = "Squares with their floor sides and without their ceiling sides.",
     .keys = "coverage.must.square=half-open; coverage.may.square=half-open",
     .shown_by = "SpecificationSquares.HalfOpenSquaresLeaveTheCeilingOut"},
    {.id = "pdf.shape",
     .place = "6.5.3",
     .sentence = "Shapes include \"the boundaries along their floor sides, but not along their "
                 "ceiling sides\".",
     .reading = "The shape is the interior moved by an infinitesimal towards its ceiling, as a tie "
                "rule does with samples.",
     .keys = "coverage.must.shape=half-open"},
    {.id = "pdf.fill",
     .place = "6.5.3",
     .sentence = "A fill paints every pixel whose square intersects the shape, however small the "
                 "intersection is.",
     .reading = "Any-part coverage of half-open squares by a half-open shape.",
     .keys = "contract=squares; y_axis=up; "
             "coverage.must.relation=intersects; coverage.must.geometry=given; "
             "coverage.may.relation=intersects; coverage.may.geometry=given",
     .shown_by = "SpecificationSquares.HalfOpenSquaresLeaveTheCeilingOut"},
    {.id = "pdf.empty-interior",
     .place = "6.5.3, note",
     .sentence = "A shape intersects every pixel that its boundary passes, \"even if the interior "
                 "of the filling region is empty\".",
     .reading = "A flat triangle paints the pixels along it, at least one pixel wide.",
     .keys = "coverage.flat=drawn; coverage.may.shape=closed"},
    {.id = "pdf.image",
     .place = "6.5.3",
     .sentence = "Of a sampled image only pixels \"whose centers lie within the region\" are "
                 "painted.",
     .reading = "Images are point-sampled, half-open as shapes are."},
    {.id = "pdf.glyph",
     .place = "6.5.3",
     .force = kAllowed,
     .sentence = "Glyphs are scan-converted by another algorithm, with hints.",
     .reading = "No statement about glyphs is judged."},
    {.id = "pdf.rounding",
     .place = "6.5.3",
     .sentence = "Coordinates are mapped into device space, \"but not rounded to device pixel "
                 "boundaries\".",
     .reading = "No grid: real geometry, up to the arithmetic of the implementation.",
     .keys = "subpixel_bits"},
});

constexpr auto kGdal = std::to_array<Clause>({
    {.id = "gdal.centre",
     .place = "gdal_rasterize, option -at",
     .sentence = "By default pixels are burned \"whose center point is within the polygon\".",
     .reading = "Point sampling at centres, in real geometry after the affine transform.",
     .keys = "contract=sample-exact"},
    {.id = "gdal.touching-centre",
     .place = "gdal_rasterize, option -at",
     .force = kAllowed,
     .sentence = "\"behavior is unspecified when the polygon is just touching the pixel center\".",
     .reading = "Every tie is open, shared or not.",
     .keys = "tie_ownership=open"},
    {.id = "gdal.all-touched",
     .place = "gdal_rasterize, option -at; pull request 6415",
     .sentence = "ALL_TOUCHED burns \"all pixels touched by lines or polygons\".",
     .reading =
         "Meant, by its author in 6415, as interiors that meet: contact with a border is not "
         "burned.",
     .keys = "contract=squares; "
             "coverage.must.relation=intersects; coverage.must.geometry=given; "
             "coverage.must.square=open; coverage.must.shape=open; "
             "coverage.may.relation=intersects; coverage.may.geometry=given",
     .shown_by = "SpecificationSquares.OpenSquaresNeedInteriors"},
    {.id = "gdal.all-touched-epsilon",
     .place = "pull requests 6415 and 7526",
     .force = kAllowed,
     .sentence = "Contact is told from overlap within a tolerance that has been changed once.",
     .reading = "Within that tolerance of a grid line both answers are met in the field: not "
                "judged.",
     .keys = "coverage.may.square=closed; coverage.may.shape=closed; "
             "coverage.must.growth=swept; coverage.must.half_width; "
             "coverage.may.growth=swept; coverage.may.half_width"},
    {.id = "gdal.flat",
     .place = "gdal_rasterize",
     .force = kSilent,
     .sentence = "Nothing is said about polygons without area.",
     .reading = "They may burn what they touch, or nothing.",
     .keys = "coverage.flat=free"},
    {.id = "gdal.arithmetic",
     .place = "issue 9822",
     .force = kSilent,
     .sentence = "No accuracy of the transform is stated; x86 and arm64 differ.",
     .reading = "Samples within rounding of an edge are not judged."},
});

constexpr auto kX11 = std::to_array<Clause>({
    {.id = "x11.centre",
     .place = "CreateGC, fill-rule",
     .sentence = "A pixel is inside if its centre is inside, the path being infinitely thin.",
     .reading = "Point sampling at centres; centres lie on whole coordinates in X11.",
     .keys = "contract=sample-exact; sample_locations"},
    {.id = "x11.boundary",
     .place = "CreateGC, fill-rule",
     .sentence = "On the boundary it is inside \"if and only if the polygon interior is "
                 "immediately to its right\".",
     .reading = "Left edges are in, right edges are out.",
     .keys = "tie_rule=top-left",
     .shown_by = "SpecificationTies.InteriorToTheRightIsTopLeft"},
    {.id = "x11.horizontal",
     .place = "CreateGC, fill-rule",
     .sentence = "Centres on a horizontal edge are inside if and only if the interior is "
                 "\"immediately below\".",
     .reading = "Top edges are in, bottom edges are out.",
     .keys = "tie_rule=top-left",
     .shown_by = "SpecificationTies.InteriorToTheRightIsTopLeft"},
    {.id = "x11.vertex",
     .place = "CreateGC, fill-rule",
     .force = kSilent,
     .sentence = "A centre on a vertex is not spoken of apart.",
     .reading = "The rule for boundaries is taken: immediately to the right there is one interior, "
                "except along a horizontal edge."},
    {.id = "x11.integers",
     .place = "FillPoly",
     .sentence = "Points are pairs of 16-bit integers.",
     .reading = "Nothing is rounded: the counts follow from the sentences above alone.",
     .keys = "subpixel_bits=0; fixed"},
});

constexpr auto kJava = std::to_array<Clause>({
    {.id = "java-awt.inside",
     .place = "Shape, definition of insideness",
     .sentence = "Inside, or exactly on the boundary where the space towards increasing x is "
                 "\"entirely inside the boundary\".",
     .reading = "Of Shape.contains: left edges are in.",
     .keys = "tie_rule=top-left",
     .shown_by = "SpecificationTies.InteriorToTheRightIsTopLeft"},
    {.id = "java-awt.horizontal",
     .place = "Shape, definition of insideness",
     .sentence = "Or on a horizontal boundary segment where the space towards increasing y is "
                 "inside.",
     .reading = "Of Shape.contains: top edges are in.",
     .keys = "tie_rule=top-left",
     .shown_by = "SpecificationTies.InteriorToTheRightIsTopLeft"},
    {.id = "java-awt.rendering",
     .place = "Graphics2D, Graphics",
     .force = kSilent,
     .sentence = "Filling \"the interior\" is said of rendering; that it goes by Shape.contains at "
                 "pixel centres is not.",
     .reading = "A fill is judged by the model that a survey states, not by Shape."},
    {.id = "java-awt.normalization",
     .place = "RenderingHints, KEY_STROKE_CONTROL",
     .force = kAllowed,
     .sentence = "Paths may be moved by up to half a pixel, unless VALUE_STROKE_PURE asks to leave "
                 "them unmodified; hints may be ignored.",
     .reading = "Only with STROKE_PURE is a fill worth a survey."},
});

}  // namespace

std::span<const Clause> PdfClauses() { return kPdf; }
std::span<const Clause> GdalClauses() { return kGdal; }
std::span<const Clause> X11Clauses() { return kX11; }
std::span<const Clause> JavaClauses() { return kJava; }

}  // namespace rasterproof
