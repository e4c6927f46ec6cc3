// SIGINT, SIGTERM and SIGHUP, for verbs that say what they know so far.
#ifndef RASTERPROOF_TOOL_INTERRUPT_H_
#define RASTERPROOF_TOOL_INTERRUPT_H_

namespace rasterproof::tool {

/// From here on the first SIGINT, SIGTERM or SIGHUP sets Interrupted() and calls `then` in the
/// handler, such as subjects::Interrupt, which kills the subjects outside: a caller that waits for
/// their answers gets kTooSlow. The second one ends the command at once. A signal that was ignored
/// when the command started stays ignored.
void CatchInterrupts(void (*then)() noexcept);

/// Whether SIGINT, SIGTERM or SIGHUP has arrived: end soon, and say what is known so far.
bool Interrupted() noexcept;

/// 128 + the number of the signal that arrived, as a shell tells it; 0: none did.
int InterruptStatus() noexcept;

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_INTERRUPT_H_
