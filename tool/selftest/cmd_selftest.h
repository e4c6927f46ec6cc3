// The verb selftest.
#ifndef RASTERPROOF_TOOL_SELFTEST_CMD_SELFTEST_H_
#define RASTERPROOF_TOOL_SELFTEST_CMD_SELFTEST_H_

#include <cstdint>
#include <string>
#include <vector>

namespace rasterproof::tool {

struct SelftestOptions {
  std::vector<std::string> only;  ///< names; empty: every mutant and legal variant
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;  ///< most cases a property
  std::string json;
  int jobs = 1;         ///< mutants and variants at once
  bool causes = false;  ///< also explain each mutant's violation
};
int RunSelftest(const SelftestOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SELFTEST_CMD_SELFTEST_H_
