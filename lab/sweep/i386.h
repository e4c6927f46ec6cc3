// Whether this machine runs programs of 32 bits.
#ifndef RASTERPROOF_LAB_SWEEP_I386_H_
#define RASTERPROOF_LAB_SWEEP_I386_H_

namespace rasterproof::lab {

/// Runs the smallest program for i386, once, and returns whether it ended as it should: a kernel
/// may be built without them, or a container not allow them.
bool RunsI386();

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_SWEEP_I386_H_
