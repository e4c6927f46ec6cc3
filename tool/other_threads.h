// The floating-point mode of threads that are already running.
#ifndef RASTERPROOF_TOOL_OTHER_THREADS_H_
#define RASTERPROOF_TOOL_OTHER_THREADS_H_

#include "core/float_mode.h"

namespace rasterproof::tool {

/// True where the mode of another thread can be set: on Linux, x86-64.
bool CanSetOtherThreads();

/// Sets the mode in every thread of this process but the caller: each is interrupted by a signal
/// whose handler writes the mode into the context that it returns to. Threads that block the signal
/// are left as they are. kTrapping sets nothing: no flag of another thread can be read.
///
/// Domain:     CanSetOtherThreads(); called by one thread.
void SetModeOfOtherThreads(FloatMode mode);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_OTHER_THREADS_H_
