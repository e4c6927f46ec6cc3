// The verb legal.
#ifndef RASTERPROOF_TOOL_LEGAL_CMD_LEGAL_H_
#define RASTERPROOF_TOOL_LEGAL_CMD_LEGAL_H_

#include <optional>
#include <string>
#include <vector>

#include "core/profile.h"
#include "tool/scene_source.h"

namespace rasterproof::tool {

/// Whether one legal model explains a drawing, or what all legal models agree on.
struct LegalOptions {
  SceneOptions scene;
  std::string image;    ///< counts as text, or a picture; empty: `subject` draws
  std::string subject;  ///< empty: `image` is given
  std::string profile;  ///< empty: the subject's own
  std::string background = "000000";
  bool counts = false;          ///< the levels of a picture are counts
  bool ids = false;             ///< the numbers of `image` are 1 + ids of triangles
  std::string facings;          ///< how many of what `image` shows are front-facing; empty: unknown
  std::string visible = "any";  ///< of those that cover a sample: any, last, first
  std::string list;             ///< file of drawings to judge; empty: one drawing
  std::string junit;            ///< of a list; empty: none
  std::string json;             ///< file; empty: none
  std::string save;             ///< the part that no model explains, as a case file
  bool resolved = false;        ///< `image` shows how many of a pixel's samples are covered
  bool decided = false;         ///< no drawing is judged
  std::string png;              ///< where legal models differ; empty: none
  std::string mask;             ///< the same as grey levels of data; empty: none
  /// In roundings of float32: the profile states none, and the verdict rests on this.
  std::optional<double> transform_error = {};
  std::vector<int> view;  ///< of that picture: column, row, width, height; empty: the target
  int scale = 1;          ///< side of a pixel in it
};
int RunLegal(const LegalOptions& options);
/// The profile, with the error of the transform from clip space that the options assume.
Profile WithAssumptions(Profile profile, const LegalOptions& options);
/// The line that says what is assumed; empty if nothing is.
std::string AssumedErrorLine(const LegalOptions& options);
/// What `legal --list` does.
int JudgeList(const LegalOptions& options);
/// What `legal --resolved` does.
int JudgeResolved(const LegalOptions& options);
/// What `legal --decided` does.
int TellDecided(const LegalOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_LEGAL_CMD_LEGAL_H_
