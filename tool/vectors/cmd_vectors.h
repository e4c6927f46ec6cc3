// The verbs vectors generate and verify.
#ifndef RASTERPROOF_TOOL_VECTORS_CMD_VECTORS_H_
#define RASTERPROOF_TOOL_VECTORS_CMD_VECTORS_H_

#include <cstdint>
#include <string>

namespace rasterproof::tool {

/// Cases as files, for test benches that do not run this program.
struct GenerateOptions {
  std::string profile;
  std::uint64_t seed = 1;
  int level = 1;
  std::uint64_t cases = 0;       ///< 0: as many as the level has
  std::string world;             ///< "3.2": every triangle of it; empty: drawn cases
  bool yes = false;              ///< accept a world of any size
  bool values = false;           ///< with values of channels
  std::string format = "jsonl";  ///< or "c", "readmemh"
  std::string output = "-";      ///< file; of readmemh a folder
};
int RunGenerate(const GenerateOptions& options);

/// Judges what a rasterizer covered of the cases of such a file.
struct VerifyOptions {
  std::string vectors;
  std::string answers;  ///< file; empty: `subject` draws
  std::string subject;  ///< empty: `answers` is given
  bool alone = false;   ///< each triangle was drawn in its own call
  std::uint64_t shown = 20;
};
int RunVerify(const VerifyOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_VECTORS_CMD_VECTORS_H_
