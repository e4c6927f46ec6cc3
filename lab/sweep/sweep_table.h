// What a sweep found, as a comparison.
#ifndef RASTERPROOF_LAB_SWEEP_SWEEP_TABLE_H_
#define RASTERPROOF_LAB_SWEEP_SWEEP_TABLE_H_

#include <cstdint>

#include "core/comparison.h"
#include "lab/sweep/sweep.h"
#include "lab/sweep/sweep_runner.h"

namespace rasterproof::lab {

/// The builds, those that draw alike side by side, by the base and by the model; with what makes
/// each differ.
ComparisonTable SweepTable(const SweepRunner& runner, const Sweep& sweep, std::uint64_t seed);

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_SWEEP_SWEEP_TABLE_H_
