// Asking for a draw, and judging it by what the profile allows at each sample.
//
// What is allowed is legal::Allowed's to say (legal/allowed.h). To judge whether one legal model
// explains all samples together, use OneLegalModelExplainsTheMesh.
#ifndef RASTERPROOF_PROPS_JUDGING_LEGAL_COUNTS_H_
#define RASTERPROOF_PROPS_JUDGING_LEGAL_COUNTS_H_

#include <cstdint>
#include <optional>
#include <string>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/question.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "legal/allowed.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// How a subject is asked for a scene, and what its answer is compared with.
struct Comparison {
  DrawQuestion question;
  legal::Sight sight;
};

/// Asks for the scene of the case: by facing where the profile names every vertex's place, else for
/// what one call shows. A mesh that is judged as it is shown (as_shown.h) shows only whether a
/// sample is covered.
Comparison ComparisonOf(const PlacedCase& c, const SubjectInfo& info, const DrawOptions& options);

/// Returns the verdict that every sample is allowed; `of` completes "coverage differs from the
/// model's ...".
///
/// Domain:     `allowed.why_not()` is empty.
Verdict AsAllowed(const legal::Allowed& allowed, const CoverageCounts& drawn,
                  std::uint64_t exercised, const std::string& of = "");

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_LEGAL_COUNTS_H_
