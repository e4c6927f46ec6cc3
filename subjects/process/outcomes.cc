#include "subjects/process/outcomes.h"

#include <exception>

#include "core/subject_errors.h"

namespace rasterproof::subjects {

std::exception_ptr Thrown(const std::function<void()>& work) {
  try {
    work();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

bool IsHang(const DrawOutcome& outcome) {
  try {
    outcome.Get();
    return false;
  } catch (const SubjectHang&) {
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

std::string FaultText(const DrawOutcome& outcome) {
  try {
    outcome.Get();
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::size_t LeastThat(std::size_t low, std::size_t high,
                      const std::function<bool(std::size_t)>& does) {
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (does(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return high;
}

}  // namespace rasterproof::subjects
