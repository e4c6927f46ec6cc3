// A rasterizer without faults of its own: the oracle in every output kind and space, with every
// manner that a verdict has to cope with.
#ifndef RASTERPROOF_TESTS_BASELINE_MODEL_SUBJECT_H_
#define RASTERPROOF_TESTS_BASELINE_MODEL_SUBJECT_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/subject.h"

namespace rasterproof::baseline {

/// Where its vertices come from, and what is free about them.
enum class ModelSpace : std::uint8_t {
  kWindow,     ///< window space on a grid of 1/256 pixel
  kClip,       ///< window and clip space, no grid
  kTransform,  ///< clip space through a transform of its own
  kFixed,      ///< integers of 12.4 bits
  kFreeSnap    ///< window space, any grid point at most 0.6 steps off
};

/// What it does with some scenes. Which ones their corners say, never how many came before.
enum class ModelManner : std::uint8_t {
  kSound,
  kRefuses,     ///< a third of the scenes, or a twelfth where each triangle is a scene
  kBreaksDown,  ///< over one scene in sixteen: a fault, a hang, a foreign exception, no time left
  kNanBarycentrics  ///< some barycentrics and depths are no numbers
};

struct ModelSettings {
  CoverageKind coverage = CoverageKind::kFacingCounts;
  ModelSpace space = ModelSpace::kWindow;
  ModelManner manner = ModelManner::kSound;
};

/// "model:mask:clip:refuses".
std::string ModelName(const ModelSettings& settings);
/// The combinations that tell something of their own.
std::vector<ModelSettings> AllModels();
std::unique_ptr<Subject> MakeModel(const ModelSettings& settings);

}  // namespace rasterproof::baseline

#endif  // RASTERPROOF_TESTS_BASELINE_MODEL_SUBJECT_H_
