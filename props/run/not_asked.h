// What a subject shows or takes, and a run did not put to the test.
#ifndef RASTERPROOF_PROPS_RUN_NOT_ASKED_H_
#define RASTERPROOF_PROPS_RUN_NOT_ASKED_H_

#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "props/judging/gate.h"

namespace rasterproof::props {

/// "barycentrics, depths in clip space", "no property judges them".
struct NotAskedOf {
  std::string what;
  std::string why;  ///< may be empty
};

/// Returns the outputs that the subject shows, by what properties ask a subject to show.
std::vector<Shows> OutputsOf(const Subject& subject);

/// Returns what no property was asked about: outputs, in each space that the subject takes and a
/// drawing of which was judged nowhere in the run, and targets larger than every one judged.
///
/// Domain:     the results of one subject, of a run over the whole catalogue.
/// Properties: counts what was drawn (PropertyResult::draws), and goes by the gates of the
///             catalogue for which property judges what.
std::vector<NotAskedOf> NotAsked(const SubjectInfo& info, std::span<const Shows> outputs,
                                 std::span<const PropertyResult> results);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_NOT_ASKED_H_
