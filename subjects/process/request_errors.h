// What is wrong with a request, on the side that reads it.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_REQUEST_ERRORS_H_
#define RASTERPROOF_SUBJECTS_PROCESS_REQUEST_ERRORS_H_

#include <cstdint>
#include <string>

#include "core/call_end.h"
#include "core/error.h"

namespace rasterproof::subjects {

[[noreturn]] inline void Malformed(const std::string& where, const std::string& expected) {
  throw InputError("standard input: " + where, "not what a request looks like", "give " + expected);
}

/// What an array of a request holds. Readers of arrays blame a subject; here standard input is it.
template <class Read>
auto OfArray(std::uint64_t id, const std::string& what, const Read& read) {
  try {
    return read();
  } catch (const SubjectStop& stop) {
    throw InputError("standard input: request " + std::to_string(id) + ", its " + what, stop.what(),
                     "give arrays of the format NPY 1.0");
  }
}

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_REQUEST_ERRORS_H_
