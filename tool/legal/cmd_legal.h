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
  bool counts = false;  ///< the levels of a picture are counts
  bool ids = false;     ///< `image` holds 1 + ids of triangles
  std::string facings;  ///< file: how many of `image`'s counts are front-facing; empty: unknown
  std::string visible = "any";  ///< which covering triangle `image` shows: any, last, first
  std::string list;             ///< file of drawings to judge; empty: one drawing
  std::string junit;            ///< of a list; empty: none
  std::string json;             ///< file; empty: none
  std::string save;             ///< case file for the part that no model explains
  bool resolved = false;        ///< `image` counts covered samples per pixel
  bool decided = false;         ///< judge no drawing
  std::string png;              ///< picture of where legal models differ; empty: none
  std::string mask;             ///< the same as a mask; empty: none
  /// Assumed where the profile states none; in units of 2^-24 of a coordinate.
  std::optional<double> transform_error = {};
  std::vector<int> view;  ///< the picture's part: column, row, width, height; empty: all
  int scale = 1;          ///< side of a pixel in it
};
int RunLegal(const LegalOptions& options);
/// The profile with the transform error that the options assume.
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
