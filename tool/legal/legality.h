// A drawing that the joint verdict judges: where it comes from, and how the verdict reads.
#ifndef RASTERPROOF_TOOL_LEGAL_LEGALITY_H_
#define RASTERPROOF_TOOL_LEGAL_LEGALITY_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/drawing.h"
#include "core/error.h"
#include "core/scene.h"
#include "core/subject.h"
#include "io/case_file.h"
#include "legal/joint.h"
#include "tool/exit_status.h"
#include "tool/legal/broken_rules.h"
#include "tool/legal/cmd_legal.h"

namespace rasterproof::tool {

/// What one call shows of a scene.
struct OneCall {
  Drawing drawing;
  bool is_mask = false;    ///< its counts say whether a sample is covered, not how often
  bool has_counts = true;  ///< else the primitive ids are judged
  bool last_is_visible = true;
  bool any_is_visible = false;  ///< which of several triangles is visible is not known
  bool has_facings = false;     ///< its counts are by facing, or visible_front is known
  /// Of ids: whether the visible triangle shows its front.
  std::vector<bool> visible_front = {};
  bool is_picture = false;  ///< a mask that was read from a file
  /// Of a picture: the colours of its corners that are not the background, RRGGBB.
  std::vector<std::string> corners = {};

  /// Points into this.
  legal::Observed Observed() const;
};

/// A scene, and the profile whose models are legal for its drawing.
struct JudgedScene {
  Scene scene;
  Profile profile;
  std::optional<io::CaseDrawing> drawing = {};  ///< of a case file that holds one
};

/// The error for zero or several drawings.
InputError NotOneDrawing();

/// Loads what the options name: a mesh, a scene or a case. The profile is the options', or the
/// case's, or the subject's own.
///
/// Error:      InputError if there is no drawing, none of them states a profile, the subject
///             does not take the scene, or the joint verdict is not for this scene and profile.
JudgedScene LoadJudgedScene(const LegalOptions& options, const Subject* subject);
/// The same of a case that was read from the options' file.
JudgedScene JudgedSceneOf(const LegalOptions& options, io::CaseFile file, const Subject* subject);

/// Reads the image that the options name, and its facings; without an image, the case's drawing.
OneCall ReadDrawing(const LegalOptions& options, const JudgedScene& judged);

/// The verdict on a drawing, and what was compared, in words that say what was not: "counts; ...".
struct Judgement {
  legal::JointVerdict verdict;
  std::string compared;
  std::vector<BrokenRule> broken = {};  ///< if it is not legal: at least one
};

/// Returns whether one legal model explains the drawing, its facings too if it has any. Where the
/// profile does not say which side is the front, either may be.
Judgement JudgeDrawing(const JudgedScene& judged, const OneCall& drawn);

/// The exit status of one verdict.
int StatusOf(legal::Legality legality);

/// "legal", "not legal" or "not judged".
std::string LegalityName(legal::Legality legality);
/// A grid and a tie rule: "8 subpixel bits, tie rule top-left".
std::string FamilyText(const legal::Family& family, const Profile& profile);
/// What became of the search for a model, in a part of a sentence.
std::string SearchText(const legal::JointVerdict& verdict, const Profile& profile);

/// Draws all triangles of the scene in one call.
///
/// Error:      as Subject::Show.
OneCall DrawInOneCall(Subject& subject, const Scene& scene);

/// Why no legal model explains what was seen: a head, a line for each of the first samples and
/// vertices.
std::string CoreText(const legal::Core& core, const Scene& scene, int samples);
/// The head and the first sample, in one line.
std::string CoreLine(const legal::Core& core, const Scene& scene, int samples);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_LEGAL_LEGALITY_H_
