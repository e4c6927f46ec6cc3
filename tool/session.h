// What several verbs share: reading cases, drawing them, and commands to type again. Scenes are
// read by tool/scene_source.h.
// Names of subjects, profiles and properties are resolved by tool/resolve.h.
#ifndef RASTERPROOF_TOOL_SESSION_H_
#define RASTERPROOF_TOOL_SESSION_H_

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject.h"
#include "io/case_file.h"
#include "props/domains/case_name.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "tool/case_choice.h"
#include "tool/outside.h"

namespace rasterproof::tool {

/// A saved or generated case with the subject and the property it is about.
struct LoadedCase {
  Case value;
  std::unique_ptr<Subject> subject;
  const props::Property* property = nullptr;  ///< nullptr: none was named
  std::string replay;                         ///< the command that loads it again
  /// The file, if it holds a drawing that no subject drew, and no subject is to draw its scene:
  /// then nothing else is set.
  std::optional<io::CaseFile> drawing = std::nullopt;
};
/// A subject that only the file names is one of this program's own: the built-in ones, the oracle,
/// planted bugs and legal variants, the type of kit/main.h. Any other is for the user to name.
///
/// Returns:    the case. `make` makes its subject, if given, in place of the one of the choice's
///             name.
/// Error:      InputError if the choice is of no case or of two, or lacks what its case needs; with
///             the command to type where the file names a subject outside.
LoadedCase LoadCaseOrDrawing(const CaseChoice& choice, std::string_view verb,
                             const SubjectMaker& make = {});
/// The same, of a case that a subject draws.
LoadedCase LoadCase(const CaseChoice& choice, std::string_view verb, const SubjectMaker& make = {});

/// The option that names the subject on a command line, quoted for a shell: "--exec './a b'".
std::string SubjectOption(const std::string& name);

/// True of a case that is given as JSON in place of its path.
bool IsCaseText(const std::string& path);

/// The command that runs the verb on the choice's case, quoted for a shell.
std::string CommandFor(std::string_view verb, const CaseChoice& choice);

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
