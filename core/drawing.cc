#include "core/drawing.h"

#include "core/error.h"

namespace rasterproof {

bool DrawOutcome::BrokeDown() const {
  try {
    Get();
    return false;
  } catch (const InputError&) {
    return false;
  } catch (...) {
    return true;
  }
}

}  // namespace rasterproof
