// The verb infer.
#ifndef RASTERPROOF_TOOL_INFER_CMD_INFER_H_
#define RASTERPROOF_TOOL_INFER_CMD_INFER_H_

#include <cstdint>
#include <string>

namespace rasterproof::tool {

struct InferOptions {
  std::string subject = "spans-exact";
  std::string profile;  ///< verified instead of the subject's own
  std::uint64_t seed = 1;
  std::string json;  ///< file; empty: none
};
int RunInfer(const InferOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_INFER_CMD_INFER_H_
