// What verbs ask of a subject: draws and campaigns. Cases are read by tool/load_case.h, scenes by
// tool/scene_source.h.
#ifndef RASTERPROOF_TOOL_SESSION_H_
#define RASTERPROOF_TOOL_SESSION_H_

#include <optional>
#include <string>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject.h"
#include "props/run/campaign_options.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {

/// Draws the scene on fresh counts of the subject's shape, by facing.
CoverageCounts Draw(Subject& subject, const Scene& scene, const DrawOptions& options = {});

/// What a draw of the scene by the subject can show of these counts: whether a sample is covered
/// where the draw is judged as it is shown (props/judging/as_shown.h), else all of it.
CoverageCounts ShownBy(const SubjectInfo& subject, const Scene& scene, CoverageCounts counts);

/// Draws, or gives nothing if the subject breaks down over it; then `reason` says how.
std::optional<CoverageCounts> DrawUnlessItFails(Subject& subject, const Scene& scene,
                                                const DrawOptions& options, std::string& reason);

/// Throws InputError unless the subject takes the scene; says what to do instead.
void RequireTakes(const Subject& subject, const Scene& scene, const std::string& place);

/// Error:      InputError if the subject draws another number of samples a pixel than a case has
///             that is judged by the profile. Rasterproof's own draw what they draw, whatever
///             profile they are judged by.
void RequireDrawsSamples(const Subject& subject, const Profile& profile, const std::string& place);

/// The options, with what a campaign on the subject takes from the command: an interrupt ends it;
/// one outside is stopped at its time limit, and made again by `make`.
props::CampaignOptions CampaignOn(const Subject& subject, props::CampaignOptions options,
                                  SubjectMaker make = {});

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SESSION_H_
