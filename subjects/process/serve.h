// The other end of the pipe: a subject that answers requests.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_SERVE_H_
#define RASTERPROOF_SUBJECTS_PROCESS_SERVE_H_

#include <functional>
#include <iosfwd>
#include <string>

#include "core/subject.h"

namespace rasterproof::subjects {

/// Answers every request of `in` until it ends; `say` sends an answer at once. An exception of the
/// subject is reported as a refusal (InputError) or a fault (any other).
///
/// Error:      InputError if a request is malformed.
void Serve(Subject& subject, std::istream& in, const std::function<void(const std::string&)>& say);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_SERVE_H_
