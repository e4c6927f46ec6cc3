// Clip-space triangles cover what the ray through the sample meets in front of the eye.
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"

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
             .judges_overdraw = true,
             .asks_oracle = true,
             .where = "no near clipping"},
    .ask = [](const Case& c, const Description&) { return CompareWithTheModel(c); },
    .blame = [](const Case& c, const Verdict& verdict,
                const Description&) { return BlameTriangles(c, verdict, c.options); },
};

}  // namespace rasterproof::props
