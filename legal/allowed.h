// What a profile lets one drawing of a scene show, sample by sample: the one place that says it.
//
// Whoever asks "which counts may this sample have?" asks Allowed. Whether ONE legal model explains
// all samples together is a harder question: see JudgeJointly (joint.h), which convicts more.
#ifndef RASTERPROOF_LEGAL_ALLOWED_H_
#define RASTERPROOF_LEGAL_ALLOWED_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/drawing.h"
#include "core/subject_info.h"
#include "core/witness.h"
#include "exact/placed_scene.h"

namespace rasterproof::legal {

/// What is compared of a drawing.
struct Sight {
  /// kFacingCounts: counts by facing, where the profile names the front; kCounts: how often in all;
  /// any other: whether at all.
  CoverageKind coverage = CoverageKind::kFacingCounts;
  /// Which of several triangles a primitive id names. Nothing: ids are not compared.
  std::optional<Visible> ids = {};
};

/// The counts that legal models of a placed scene's profile allow at each sample.
///
/// Where the profile names every vertex's place, they run from a least to a most count, by facing:
/// equal where one model is legal; apart on edges whose samples may be shared or whose owner is
/// free, on the segments of triangles without area, and wherever nothing is stated of a triangle
/// or the contract states one side alone. Elsewhere they are the counts that some legal model has,
/// and facings are not compared.
///
/// Each sample is allowed by itself: a drawing that is allowed everywhere may still have no one
/// model. Copies share what was computed.
class Allowed {
 public:
  /// Cost:       by places that are stated as exact::Coverage, twice where counts differ; else as
  ///             DecidedSamples().
  /// Domain:     `options` cull and cut nothing where places are free.
  explicit Allowed(const exact::PlacedScene& placed, const Sight& sight = {},
                   const DrawOptions& options = {});

  /// Why nothing is known of this scene under its profile. Empty: all else may be asked.
  const std::string& why_not() const { return why_not_; }
  /// Whether counts run from a least to a most count. False: they are those of legal models.
  bool IsByPlaces() const { return canonical_ != nullptr; }

  bool Allows(const CoverageCounts& drawn, std::size_t k) const;
  bool AllowsAll(const CoverageCounts& drawn) const;
  /// The samples that are not allowed, in their order.
  std::vector<std::size_t> Wrong(const CoverageCounts& drawn) const;
  /// By primitive id where ids are compared and one model is legal, else by counts.
  std::vector<std::size_t> Wrong(const Drawing& drawn) const;
  /// At how many samples the two have no count in common, whether or not a drawing shows it.
  ///
  /// Domain:     the same target and sight.
  std::uint64_t Apart(const Allowed& other) const;

  std::uint32_t Least(std::size_t k) const;
  /// kUnbounded where nothing bounds it.
  std::uint32_t Most(std::size_t k) const;
  static constexpr std::uint32_t kUnbounded = std::numeric_limits<std::uint32_t>::max();
  /// How many triangles there are of which nothing is stated, at any sample.
  std::uint32_t Unstated() const { return unstated_; }
  /// The counts of the canonical model, as they are seen.
  ///
  /// Domain:     IsByPlaces().
  const CoverageCounts& Canonical() const { return *canonical_; }
  /// The allowed counts nearest to the drawn ones; of sample k alone, front and back.
  ///
  /// Domain:     IsByPlaces().
  CoverageCounts Nearest(const CoverageCounts& drawn) const;
  std::array<std::uint32_t, 2> NearestAt(const CoverageCounts& drawn, std::size_t k) const;
  /// The counts that legal models have there.
  ///
  /// Domain:     not IsByPlaces().
  CountSet CountsAt(std::size_t k) const { return {(*numbers_)[k]}; }

 private:
  using Counts = std::shared_ptr<const CoverageCounts>;

  void FindRange(const exact::PlacedScene& placed, const DrawOptions& options);
  // How many triangles may cover the sample or not, and be counted on either side.
  std::uint32_t Loose(std::size_t k) const { return loose_ ? loose_->front[k] : 0; }
  // Whether no more are counted than the most of each side and the loose ones.
  bool IsAtMost(std::uint32_t front, std::uint32_t back, std::size_t k) const;

  Sight sight_;
  std::string why_not_;
  std::uint32_t unstated_ = 0;
  Counts canonical_;  ///< null: not by places
  Counts least_;
  Counts most_;   ///< without what is loose
  Counts loose_;  ///< in `front`: triangles that may be counted on either side; null: none
  std::shared_ptr<const std::vector<std::uint64_t>> numbers_;  ///< as Decided::counts
  std::shared_ptr<const std::vector<std::int32_t>> ids_;       ///< where ids are compared
};

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_ALLOWED_H_
