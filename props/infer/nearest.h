// The model with the fewest wrong samples, if no model explains all.
#ifndef RASTERPROOF_PROPS_INFER_NEAREST_H_
#define RASTERPROOF_PROPS_INFER_NEAREST_H_

#include <cstdint>
#include <span>
#include <vector>

#include "props/infer/infer.h"
#include "props/infer/model_space.h"
#include "props/infer/observer.h"
#include "props/infer/race.h"

namespace rasterproof::props {

/// Returns the model with the fewest wrong samples over the experiments; among equals a model of
/// the stated snap, then the simplest.
///
/// It compares models whose snap rounds coordinates, not differences, and models of the stated
/// snap. The race halves: the worse half of the models sees only a part of the experiments.
///
/// Domain:     experiments that aim at no pair of models; at least one, and at least one model.
NearestModel Nearest(const Observer& observer, const ModelSpace& space,
                     std::span<const Experiment> experiments, Model* nearest);

/// Returns the models of the whole space with the fewest wrong samples, the best first; among
/// equals the simplest. The race halves.
///
/// Domain:     at least one experiment; any of them, aimed or not.
std::vector<Model> NearestModels(const Observer& observer, const ModelSpace& space,
                                 std::span<const Experiment> experiments, std::size_t most);

/// Draws aimless triangles (directed.h). Those that the subject refuses are left out.
std::vector<Experiment> AimlessExperiments(Observer& observer, std::uint64_t seed, int count);

/// The first experiment that the model does not explain; nullptr if it explains all.
const Experiment* FirstAgainst(const Model& model, const Observer& observer,
                               const ModelSpace& space, std::span<const Experiment> experiments);

/// The patterns of a race, and those that a rasterizer without a model may seem to have: the stated
/// one, centres, corners, and centres less what fixed-point code takes off to break ties.
std::vector<PatternCandidate> WithUsualPatterns(std::vector<PatternCandidate> patterns,
                                                const SamplePattern& stated);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_NEAREST_H_
