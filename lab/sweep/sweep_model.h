// How far what builds draw is from the model of the profile that their sources state.
#ifndef RASTERPROOF_LAB_SWEEP_SWEEP_MODEL_H_
#define RASTERPROOF_LAB_SWEEP_SWEEP_MODEL_H_

#include <string>
#include <vector>

#include "core/case.h"
#include "core/comparison.h"
#include "core/subject_info.h"
#include "lab/sweep/sweep_runner.h"
#include "props/compare/compare.h"

namespace rasterproof::lab {

/// What a profile lets one call with all of a case show, sample by sample (legal/allowed.h), ready
/// for any drawing. It convicts less than `check`, which asks one model to explain all samples.
/// Culling and scissor are off, as they are when builds are swept.
props::Judging ModelOfCase(const SubjectInfo& info, const Case& given);

/// How far the build's drawings are from these models, one a case.
Cell DistanceFromModel(const SweepRunner& runner, const SweepOutcome& outcome,
                       const std::vector<props::Judging>& models);

/// "0 of 51200 samples away from the model, in 0 of 200 cases", and what is not judged.
std::string DistanceText(const Cell& distance);

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_SWEEP_SWEEP_MODEL_H_
