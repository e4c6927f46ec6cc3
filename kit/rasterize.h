// Moved: include "library/rasterize.h". This name goes with version 0.3.
#ifndef RASTERPROOF_KIT_RASTERIZE_H_
#define RASTERPROOF_KIT_RASTERIZE_H_

#include "library/rasterize.h"

#endif  // RASTERPROOF_KIT_RASTERIZE_H_
