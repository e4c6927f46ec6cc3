// What `legal --save` writes, and the command that judges it again.
#ifndef RASTERPROOF_TOOL_LEGAL_SAVED_CORE_H_
#define RASTERPROOF_TOOL_LEGAL_SAVED_CORE_H_

#include <string>

#include "core/subject.h"
#include "legal/joint.h"
#include "tool/legal/cmd_legal.h"
#include "tool/legal/legality.h"

namespace rasterproof::tool {

/// Writes options.save, a case on the whole target: the core's triangles alone, if the subject's
/// drawing of them is not legal either; else all of them. An image can't be drawn again: its case
/// has all triangles and the drawing.
///
/// Domain:     the drawing is not legal, and `core` says why; `subject` is null of an image.
/// Returns:    the command that judges the case, with the same verdict.
std::string SaveCore(const LegalOptions& options, const JudgedScene& judged, const OneCall& drawn,
                     const legal::Core& core, Subject* subject);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_LEGAL_SAVED_CORE_H_
