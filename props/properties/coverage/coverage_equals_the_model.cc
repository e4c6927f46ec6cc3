// Coverage is that of the profile's canonical model, in window space and in clip space.
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {

// Front and back counts equal those of the profile's canonical model at every sample.
extern constinit const Property kCoverageEqualsTheModel{
    .name = "CoverageEqualsTheModel",
    .group = "coverage",
    .clause =
        "A sample is covered if it is inside, or on a top or left edge (D3D11.3 functional "
        "specification 3.4.2.1 (top-left rule); the profile names the rule).",
    .required_by = kLegalModelClauses,
    .tolerance = kExact,
    .domains = kModelCoverage,
    .gate = {.judges_shared_edge_samples = true, .judges_degenerates = true, .asks_oracle = true},
    .ask = CompareWithTheModel,
    .blame = [](const PlacedCase& c, const Verdict& verdict,
                const Description&) { return BlameTriangles(c, verdict, c.options); },
};

// Clip-space triangles cover what the ray through the sample meets in front of the eye.
extern constinit const Property kClipSpaceCoverageEqualsTheModel{
    .name = "ClipSpaceCoverageEqualsTheModel",
    .group = "coverage",
    .clause =
        "A clip-space triangle covers what the ray through the sample meets in front of the "
        "eye (Olano and Greer 1997).",
    .tolerance = kExact,
    .domains = kClipSpace,
    .gate = {.space = Space::kClip,
             .judges_shared_edge_samples = true,
             .asks_oracle = true,
             .where = "no near clipping"},
    .ask = CompareWithTheModel,
    .blame = [](const PlacedCase& c, const Verdict& verdict,
                const Description&) { return BlameTriangles(c, verdict, c.options); },
};

}  // namespace rasterproof::props
