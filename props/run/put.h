// Putting questions to a subject.
#ifndef RASTERPROOF_PROPS_RUN_PUT_H_
#define RASTERPROOF_PROPS_RUN_PUT_H_

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/question.h"
#include "core/subject.h"
#include "props/property.h"
#include "props/run/judged_case.h"

namespace rasterproof::props {

/// The questions of a check, and where its case comes from.
struct Request {
  const JudgedCase* judged = nullptr;
  const Check* check = nullptr;
  /// The drawings of the case's earlier checks, in the order of asking.
  const std::vector<std::shared_ptr<const Drawing>>* drawn = nullptr;
};

/// Puts the questions of some checks to the subject, their draws in one call, the others after it.
///
/// A draw of kFacings is made of parts where the subject tells no facings: of one that counts, the
/// triangles that face one way by the canonical model of the profile that it is judged by (in clip
/// space by their quotients on its grid) in one call, the others in another; else every triangle by
/// itself, so that overlaps show, unless the mesh is too large for that (judging/as_shown.h). A
/// triangle of no area counts as front: it should cover nothing. Where the profile leaves other
/// models legal the facing is a guess (judging/free_choices.h).
///
/// Domain:     checks whose draws may share a call: more than one only if the company of each is
///             kAny and none draws onto the last target.
/// Returns:    the answers to each, in their order. What the subject's own calls throw is no error
///             but a stop. Fewer if it broke down: the last one says so.
/// Error:      std::bad_alloc.
std::vector<Answers> Put(Subject& subject, std::span<const Request> requests);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_PUT_H_
