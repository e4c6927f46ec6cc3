// Work in a separate process on input that may be built to crash it or to exhaust the machine.
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

/// Returns the result of `make`, called in a fork of this process. The fork ends with this process
/// at the latest, and writes nothing to standard error.
///
/// Error:      InputError that `make` threw; InputError that names `place` if it threw anything
///             else, crashed or passed a limit.
std::string MakeInChild(const ChildLimits& limits, const std::string& place,
                        const std::function<std::string()>& make);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_LIMITED_CHILD_H_
