// How a draw of a process ended, as values.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_OUTCOMES_H_
#define RASTERPROOF_SUBJECTS_PROCESS_OUTCOMES_H_

#include <cstddef>
#include <exception>
#include <functional>
#include <string>

#include "core/drawing.h"

namespace rasterproof::subjects {

/// What the work throws; nullptr if it throws nothing.
std::exception_ptr Thrown(const std::function<void()>& work);

/// Whether the draw ended with a SubjectHang.
bool IsHang(const DrawOutcome& outcome);

/// What the draw threw says; "" if it threw nothing.
std::string FaultText(const DrawOutcome& outcome);

/// The least n of [low, high] that does it, if all above do as well.
///
/// Domain:     low <= high; high is known to do it.
std::size_t LeastThat(std::size_t low, std::size_t high,
                      const std::function<bool(std::size_t)>& does);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_OUTCOMES_H_
