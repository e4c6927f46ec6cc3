// Exceptions where the runtime has none: a throw keeps its message and ends the instance.
#ifndef RASTERPROOF_WEB_ENGINE_THROWING_H_
#define RASTERPROOF_WEB_ENGINE_THROWING_H_

namespace rasterproof::web {

/// Returns the text of what was thrown, which ends with a zero; empty: nothing was.
const char* LastMessage();

}  // namespace rasterproof::web

#endif  // RASTERPROOF_WEB_ENGINE_THROWING_H_
