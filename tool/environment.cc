#include "tool/environment.h"

#include "core/error.h"
#include "exact/environment.h"

namespace rasterproof::tool {

void RequireHonestEnvironment() {
  const exact::Environment environment = exact::InspectEnvironment();
  if (environment.Honest()) return;
  throw InputError(
      "floating-point environment", environment.Complaint(),
      "correct it and run again ('rasterproof doctor' shows it); there is no verdict without");
}

}  // namespace rasterproof::tool
