// What a sweep found, as text and as JSON.
#ifndef RASTERPROOF_LAB_SWEEP_SWEEP_TEXT_H_
#define RASTERPROOF_LAB_SWEEP_SWEEP_TEXT_H_

#include <cstdint>
#include <string>

#include "lab/sweep/sweep.h"
#include "lab/sweep/sweep_runner.h"

namespace rasterproof::lab {

/// A row a build, the groups that draw alike, what makes builds differ, and how many do.
std::string SweepText(const SweepRunner& runner, const Sweep& sweep, std::uint64_t seed);
/// The same as JSON.
std::string SweepJson(const SweepRunner& runner, const Sweep& sweep, std::uint64_t seed);

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_SWEEP_SWEEP_TEXT_H_
