// Prints an inference.
#ifndef RASTERPROOF_TOOL_INFER_INFER_TEXT_H_
#define RASTERPROOF_TOOL_INFER_INFER_TEXT_H_

#include <string>

#include "core/subject_info.h"
#include "props/infer/infer.h"

namespace rasterproof::tool {

/// Prints what was found of the subject, and writes it as JSON to the file, if one is named (in
/// place of the text to standard output: "-"). Returns the exit status of `infer`.
int TellInference(const props::Inference& inference, const SubjectInfo& info,
                  const std::string& json);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_INFER_INFER_TEXT_H_
