// The models that are in the race, and what each of them draws.
#ifndef RASTERPROOF_PROPS_INFER_MODEL_SPACE_H_
#define RASTERPROOF_PROPS_INFER_MODEL_SPACE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/snap.h"
#include "props/infer/observer.h"

namespace rasterproof::props {

/// One model; the numbers are places in the tables of its ModelSpace.
struct Model {
  Snap snap;
  std::uint8_t rule = 0;     ///< 0 to 7: kConsistentRules; 8: inclusive
  std::uint8_t lattice = 0;  ///< which of the candidates for the sample locations

  friend bool operator==(const Model&, const Model&) = default;
};

inline constexpr std::uint8_t kInclusiveRule = 8;
FillRule RuleOf(std::uint8_t rule);

/// Where the samples may lie, given where they seem to lie under a grid that holds the integers.
struct LatticeCandidate {
  SampleLattice lattice;
  /// True if it explains the same sights only for models whose grid is half a pixel off.
  bool half_off = false;
};

/// All models of one y axis.
class ModelSpace {
 public:
  ModelSpace(YAxis y_axis, std::vector<LatticeCandidate> lattices);

  const std::vector<Model>& models() const { return models_; }
  const SampleLattice& LatticeOf(const Model& model) const {
    return lattices_[model.lattice].lattice;
  }
  YAxis y_axis() const { return y_axis_; }
  /// The model as a profile that promises it, named by what it is.
  Profile ProfileOf(const Model& model) const;

 private:
  YAxis y_axis_;
  std::vector<LatticeCandidate> lattices_;
  std::vector<Model> models_;
};

/// What models draw of one scene. Models that put its vertices on the same places share one draw.
class Prediction {
 public:
  /// Domain:     window space. `scene` and `space` must outlive the prediction.
  Prediction(const Scene& scene, const ModelSpace& space, FacingReport facing)
      : scene_(scene), space_(space), facing_(facing) {}

  const CoverageCounts& Of(const Model& model);

 private:
  struct Place {
    std::vector<double> coordinates;
    std::uint8_t lattice;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  struct Drawn {
    std::array<CoverageCounts, 9> by_rule;
    std::array<bool, 9> known{};
    bool has_ties = true;  ///< false: no sample lies on an edge, and all rules agree
  };

  CoverageCounts Draw(const Scene& snapped, const Model& model, std::uint8_t rule) const;

  const Scene& scene_;
  const ModelSpace& space_;
  FacingReport facing_;
  std::map<Place, Drawn> drawn_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_MODEL_SPACE_H_
