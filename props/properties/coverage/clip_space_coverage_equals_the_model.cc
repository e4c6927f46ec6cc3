// Clip-space triangles cover what the ray through the sample meets in front of the eye.
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/all.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"

namespace rasterproof::props {

constinit const Property kClipSpaceCoverageEqualsTheModel{
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
