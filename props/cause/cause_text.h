// What explains violations, in words.
#ifndef RASTERPROOF_PROPS_CAUSE_CAUSE_TEXT_H_
#define RASTERPROOF_PROPS_CAUSE_CAUSE_TEXT_H_

#include <string>

#include "props/cause/cause.h"

namespace rasterproof::props {

/// The cause's section of docs/causes.md: "truncation", or "none".
std::string NameOfCause(const Cause& cause);

/// What was found, without its section: "your answers equal those of ...".
std::string CauseText(const Cause& cause, const Causes& causes);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CAUSE_CAUSE_TEXT_H_
