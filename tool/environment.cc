#include "tool/environment.h"

#include "core/error.h"
#include "exact/environment.h"

namespace rasterproof::tool {

void RequireHonestEnvironment() {
  const exact::Environment environment = exact::InspectEnvironment();
  if (environment.Honest()) return;
  throw InputError("floating-point environment", environment.Complaint(),
                   "mend it and run again (rasterproof doctor shows it); no verdict is given here");
}

}  // namespace rasterproof::tool
