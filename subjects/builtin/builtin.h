// The reference's rasterizers as subjects.
#ifndef RASTERPROOF_SUBJECTS_BUILTIN_BUILTIN_H_
#define RASTERPROOF_SUBJECTS_BUILTIN_BUILTIN_H_

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/subject.h"

namespace rasterproof::subjects {

/// Names of every built-in subject: each method, "METHOD:canonical" where the method can be, the
/// fast kernels and the plan.
std::vector<std::string> BuiltinNames();

/// True of the names that MakeBuiltin makes a subject of.
bool IsBuiltin(std::string_view name);

/// Returns the subject of that name, or nullptr.
std::unique_ptr<Subject> MakeBuiltin(std::string_view name);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_BUILTIN_BUILTIN_H_
