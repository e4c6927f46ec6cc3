// Process groups of child processes: no child outlives this process.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_GROUPS_H_
#define RASTERPROOF_SUBJECTS_PROCESS_GROUPS_H_

#include <sys/types.h>

namespace rasterproof::subjects {

/// Forks a child that leads its own process group, from any thread.
///
/// The group is killed when this process ends in any way, SIGKILL included: a keeper process, which
/// only waits for that, kills it. Interrupt() kills it as well. The child begins with default
/// signals, none blocked. A parent that ignores SIGCHLD gets the default handler, as otherwise it
/// could not learn how a child ended. A process that left its group is not killed.
///
/// Returns:    as fork(): the child's number, 0 in the child, -1 with errno set if there is none.
pid_t ForkGroup();

/// Kills the rest of the group and waits for its leader. `status`: as waitpid's.
void EndGroup(pid_t group, int& status);

/// Kills every group; from then on no child is waited for. For signal handlers.
void Interrupt() noexcept;
bool Interrupted() noexcept;
/// A file that can be read once Interrupt() was called, for poll(). -1 before the first ForkGroup.
int InterruptedFile() noexcept;

/// Moves the file to a number above 2, closed on exec. If a standard file was closed, the next file
/// opened gets its number, and a child would use that file as its standard one.
int AboveStandard(int file);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_GROUPS_H_
