// Whether the oracle may judge here.
#ifndef RASTERPROOF_TOOL_ENVIRONMENT_H_
#define RASTERPROOF_TOOL_ENVIRONMENT_H_

namespace rasterproof::tool {

/// Throws InputError if the floating-point environment would make the oracle lie.
void RequireHonestEnvironment();

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_ENVIRONMENT_H_
