/* Moved: include "library/rasterproof_rasterize.h". This name goes with version 0.3. */
#ifndef RASTERPROOF_KIT_RASTERPROOF_RASTERIZE_H_
#define RASTERPROOF_KIT_RASTERPROOF_RASTERIZE_H_

#include "library/rasterproof_rasterize.h"

#endif /* RASTERPROOF_KIT_RASTERPROOF_RASTERIZE_H_ */
