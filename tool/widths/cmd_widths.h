// The verb widths.
#ifndef RASTERPROOF_TOOL_WIDTHS_CMD_WIDTHS_H_
#define RASTERPROOF_TOOL_WIDTHS_CMD_WIDTHS_H_

#include <string>

namespace rasterproof::tool {

/// How many bits the values of an integer edge function take.
struct WidthsOptions {
  std::string fixed;  ///< "12.4"
  bool is_signed = true;
  std::string target;                  ///< "4096x4096"
  std::string samples = "standard-1";  ///< or a list, as the profile key sample_locations
  int tile = 8;
  std::string json;  ///< file; empty: none
  std::string save;  ///< folder for the inputs as cases; empty: none
};
int RunWidths(const WidthsOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_WIDTHS_CMD_WIDTHS_H_
