// What passes between the dispatcher of the rivals and the code of one SIMD target: plain data, as
// in library/kernels/kernel_table.h.
#ifndef RASTERPROOF_LIBRARY_RIVALS_RIVAL_TABLE_H_
#define RASTERPROOF_LIBRARY_RIVALS_RIVAL_TABLE_H_

#include "library/kernels/kernel_table.h"

namespace rasterproof::library::rivals {

/// By place in kRivals and by Sink; nullptr where there is no such kernel.
struct RivalTable {
  kernels::KernelFunction draw[18][5];
  kernels::KernelFunction homogeneous[5];  ///< of clip space, by Sink
};

extern const RivalTable kScalarRivals;
extern const RivalTable kAvx2Rivals;
extern const RivalTable kAvx512Rivals;

}  // namespace rasterproof::library::rivals

#endif  // RASTERPROOF_LIBRARY_RIVALS_RIVAL_TABLE_H_
