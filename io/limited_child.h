// Work on input that may be built to crash or to take the machine, in a process of its own.
#ifndef RASTERPROOF_IO_LIMITED_CHILD_H_
#define RASTERPROOF_IO_LIMITED_CHILD_H_

#include <cstdint>
#include <functional>
#include <string>

namespace rasterproof::io {

struct ChildLimits {
  std::uint64_t bytes = 0;    ///< of address space, beyond what this process has
  std::uint64_t seconds = 0;  ///< of processor time
};

/// What `make` returns, called in a fork of this process; it ends with this one at the latest, and
/// says nothing on standard error.
///
/// Error:      InputError that `make` threw; InputError that names `place` if it threw anything
///             else, crashed or passed a limit.
std::string MakeInChild(const ChildLimits& limits, const std::string& place,
                        const std::function<std::string()>& make);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_LIMITED_CHILD_H_
