// Elimination: the drawings so far, and the models that still explain all of them.
#ifndef RASTERPROOF_PROPS_INFER_RACE_H_
#define RASTERPROOF_PROPS_INFER_RACE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"
#include "props/domains/bit_source.h"
#include "props/infer/infer.h"
#include "props/infer/model_space.h"
#include "props/infer/observer.h"

namespace rasterproof::props {

struct Experiment {
  Scene scene;
  CoverageCounts seen;
};

/// The models of a space, fewer after each experiment.
class Race {
 public:
  Race(Observer& observer, const ModelSpace& space, std::uint64_t seed)
      : observer_(observer), space_(space), seed_(seed), left_(space.models()) {}

  /// Draws the scene with the subject and removes the models that draw another picture. Returns
  /// whether it was drawn.
  bool Run(const Scene& scene);
  /// Runs triangles on which two remaining models differ until none is found for any pair.
  void Split();
  /// Runs triangles that are not aimed at a pair.
  void Check(int count);

  const std::vector<Model>& left() const { return left_; }
  /// The simplest of the models that were left last, and the experiment that refuted them all.
  struct LastRefuted {
    Model model;
    std::size_t experiment = 0;
  };
  const std::optional<LastRefuted>& last_refuted() const { return last_refuted_; }
  const std::vector<Experiment>& experiments() const { return experiments_; }

 private:
  bool Learn(const Scene& scene, CoverageCounts seen);
  bool SplitPair(const Model& a, const Model& b, int tries);
  void SplitAtRandom();

  Observer& observer_;
  const ModelSpace& space_;
  std::uint64_t seed_;
  std::uint64_t drawn_ = 0;  ///< cases drawn so far: the next one's index
  std::vector<Model> left_;
  std::vector<Experiment> experiments_;
  std::optional<LastRefuted> last_refuted_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_RACE_H_
