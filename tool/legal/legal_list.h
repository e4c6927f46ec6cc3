// A list of drawings for `legal --list`, as a file.
#ifndef RASTERPROOF_TOOL_LEGAL_LEGAL_LIST_H_
#define RASTERPROOF_TOOL_LEGAL_LEGAL_LIST_H_

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "tool/legal/cmd_legal.h"

namespace rasterproof::tool {

/// One drawing to judge, and the verdict that is expected.
struct ListedDrawing {
  std::string place;  ///< "list.json: drawings[2]"
  std::string name;
  LegalOptions options = {};  ///< the command line's, with what the entry says in their place
  bool is_legal = true;       ///< what is expected
  std::string reason = {};    ///< why it is not legal
  std::string owner = {};     ///< who fixes it; "": nobody
  std::optional<std::chrono::year_month_day> until = {};  ///< the last day on which that counts
};

/// Reads {"rasterproof_legal_list": 1, "drawings": [{"name", "scene", "image", "profile",
/// "background", "facings", "expected": "legal" | "illegal", "reason", "owner", "until":
/// "2027-01-31"}]}, or the array alone. Name and scene are required; a reason is, of what is
/// expected to be illegal; owner and until come together, facings with an image. Paths are relative
/// to the file's folder.
///
/// Error:      InputError with file, place, reason and remedy; unknown keys are errors, and so is a
///             drawing without an image where `base` names no subject.
std::vector<ListedDrawing> ReadLegalList(const std::string& path, const LegalOptions& base);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_LEGAL_LEGAL_LIST_H_
