// Process groups of child processes: no child outlives this process.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_GROUPS_H_
#define RASTERPROOF_SUBJECTS_PROCESS_GROUPS_H_

#include <sys/types.h>

namespace rasterproof::subjects {

/// Forks a child that leads a process group of its own, from any thread.
///
/// The group is killed when this process ends, in whatever way, SIGKILL included: a keeper, a
/// process that does nothing but wait for that, sees to it. It is killed by Interrupt() as well.
/// The child begins with default signals, none blocked; a parent that ignores SIGCHLD gets the
/// default, or it could not be told how a child ended. What left its group is not reached.
///
/// Returns:    as fork(): the child's number, 0 in the child, -1 with errno set if there is none.
pid_t ForkGroup();

/// Kills what is left of the group and waits for its leader. `status`: as waitpid's.
void EndGroup(pid_t group, int& status);

/// Kills every group, and no child is waited for from here on. For handlers of signals.
void Interrupt() noexcept;
bool Interrupted() noexcept;
/// A file that can be read once Interrupt() was called, for poll(). -1 before the first ForkGroup.
int InterruptedFile() noexcept;

/// The file under a number above 2, closed on exec: where a standard file was closed its number is
/// given to the next file, and a child would take that one for its own.
int AboveStandard(int file);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_GROUPS_H_
