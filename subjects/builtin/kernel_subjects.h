// The fast kernels and the plan as subjects.
#ifndef RASTERPROOF_SUBJECTS_BUILTIN_KERNEL_SUBJECTS_H_
#define RASTERPROOF_SUBJECTS_BUILTIN_KERNEL_SUBJECTS_H_

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/subject.h"

namespace rasterproof::subjects {

/// "kernel-tiles", ..., "planned". The exact kernel is what spans-exact draws float32 by.
std::vector<std::string> KernelSubjectNames();

/// Returns the subject of that name, or nullptr. It holds no state: threads may share it.
std::unique_ptr<Subject> MakeKernelSubject(std::string_view name);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_BUILTIN_KERNEL_SUBJECTS_H_
