// The models in the race, and their drawings.
#ifndef RASTERPROOF_PROPS_INFER_MODEL_SPACE_H_
#define RASTERPROOF_PROPS_INFER_MODEL_SPACE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/snap.h"
#include "legal/allowed.h"
#include "props/infer/observer.h"

namespace rasterproof::props {

/// One model; the numbers are places in the tables of its ModelSpace.
struct Model {
  Snap snap;
  std::uint8_t rule = 0;     ///< 0 to 7: kConsistentRules; 8: inclusive; 9: exclusive
  std::uint8_t pattern = 0;  ///< which of the candidates for the sample locations

  friend bool operator==(const Model&, const Model&) = default;
};

inline constexpr std::uint8_t kInclusiveRule = 8;
inline constexpr std::uint8_t kRuleCount = 10;
TieRule RuleOf(std::uint8_t rule);

/// Candidates for the sample locations, from the apparent ones under a grid with the integers.
struct PatternCandidate {
  SamplePattern pattern;
  /// True if it explains the same sights only for models whose grid is half a pixel off.
  bool half_off = false;
};

/// All models of one y axis that never draw the same side.
class ModelSpace {
 public:
  /// `stated`: keys that no experiment tests, such as fixed-point input. All snaps that move no
  /// coordinate of such an input count as one model, the one without a snap.
  ModelSpace(YAxis y_axis, Cull culls, std::vector<PatternCandidate> patterns,
             const Profile& stated);

  const std::vector<Model>& models() const { return models_; }
  const SamplePattern& PatternOf(const Model& model) const {
    return patterns_[model.pattern].pattern;
  }
  YAxis y_axis() const { return y_axis_; }
  Cull culls() const { return culls_; }
  const Profile& stated() const { return stated_; }
  /// Returns a profile that states the model and all other stated keys, named after the model.
  Profile ProfileOf(const Model& model) const;

 private:
  YAxis y_axis_;
  Cull culls_;
  std::vector<PatternCandidate> patterns_;
  Profile stated_;
  std::vector<Model> models_;
};

/// Whether a snap moves no coordinate of the profile's fixed-point input.
bool MovesNothing(const Snap& snap, const Profile& profile);

/// The models' drawings of one scene. Models that put its vertices in the same places share one.
class Prediction {
 public:
  /// Domain:     window space. `scene` and `space` must outlive the prediction.
  Prediction(const Scene& scene, const ModelSpace& space, FacingReport facing)
      : scene_(scene), space_(space), facing_(facing) {}

  /// The model's own drawing, by facing if the subject tells them.
  const CoverageCounts& Of(const Model& model) { return Under(model).Canonical(); }
  /// Whether the observed drawing is legal under the model and the stated profile's freedom about
  /// edge_samples and triangles of zero area.
  bool Explains(const Model& model, const CoverageCounts& seen);
  /// Whether no picture is legal under both.
  bool Parts(const Model& a, const Model& b);

 private:
  struct Placed {
    std::vector<double> coordinates;
    std::uint8_t pattern;
    friend auto operator<=>(const Placed&, const Placed&) = default;
  };
  struct Drawn {
    Scene snapped;
    std::array<std::optional<legal::Allowed>, kRuleCount> by_rule;
    bool has_ties = true;  ///< false: no sample lies on an edge, and all rules agree
  };

  Drawn& On(const Model& model);
  const legal::Allowed& Under(const Model& model);
  const legal::Allowed& ByRule(Drawn& drawn, const Model& model, std::uint8_t rule) const;
  legal::Allowed AllowedBy(const Scene& snapped, const Model& model, std::uint8_t rule) const;

  const Scene& scene_;
  const ModelSpace& space_;
  FacingReport facing_;
  std::map<Placed, Drawn> drawn_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_MODEL_SPACE_H_
