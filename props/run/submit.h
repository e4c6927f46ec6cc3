// Submitting questions to a subject.
#ifndef RASTERPROOF_PROPS_RUN_SUBMIT_H_
#define RASTERPROOF_PROPS_RUN_SUBMIT_H_

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/question.h"
#include "core/subject.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// The questions of a check, and where its case comes from.
struct Request {
  const PlacedCase* placed = nullptr;
  const Check* check = nullptr;
  /// The drawings of the case's earlier checks, in the order of asking.
  const std::vector<std::shared_ptr<const Drawing>>* drawn = nullptr;
};

/// Puts the questions of some checks to the subject: their draws in as few calls as 2^20 samples,
/// vertices and triangles allow (those of kInOrderAlone each in its own), then the others. A draw
/// of kFacings is made of parts where the subject tells no facings (run/facing_draws.h).
///
/// Domain:     checks whose draws may share a call: more than one only if the company of each is
///             kAny and none draws onto the last target. Draws by_twin of a subject that has one,
///             in a check of kInOrderAlone.
/// Returns:    the answers to each, in their order. What the subject's own calls throw is no error
///             but a stop. Fewer if it broke down: the last one says so.
/// Error:      std::bad_alloc; SubjectDoesNotRun.
std::vector<Answers> Submit(Subject& subject, std::span<const Request> requests);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_SUBMIT_H_
