// One triangle in the legal models of one family: the samples it covers, those it does not cover,
// and those that depend on the places of its vertices.
#ifndef RASTERPROOF_LEGAL_TRIANGLE_SAMPLES_H_
#define RASTERPROOF_LEGAL_TRIANGLE_SAMPLES_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "core/vertex.h"
#include "exact/sample_frame.h"
#include "legal/choices.h"
#include "legal/owners.h"
#include "model/target_profile.h"

namespace rasterproof::legal {

/// The status of a sample under one choice of places.
enum class Status : std::uint8_t {
  kOut,
  kIn,
  kFree  ///< no rule decides it: for example, the sample lies on an edge or at a vertex
};

/// A sample that legal models decide differently for a triangle.
struct OpenSample {
  std::size_t triangle = 0;
  std::size_t sample = 0;           ///< index in counts of the target
  Point2 at;                        ///< in screen axes
  std::vector<std::size_t> corner;  ///< the corners, 0 to 2, whose places decide it
  /// For each choice of these corners' places, the last corner's places fastest.
  std::vector<Status> by_choice;
  bool is_clipped = false;  ///< clipping may have moved the edge next to it
  /// The edge, from that corner to the next, that alone decides it after clipping moved the edge.
  std::optional<std::size_t> moved_edge;
};

/// Open samples of a triangle, by index, with a coverage that they can't all have together.
using Exclusion = std::vector<std::pair<std::size_t, bool>>;

struct TriangleSamples {
  std::vector<std::size_t> covered;  ///< in every legal model
  std::vector<OpenSample> open;
  std::vector<Exclusion> exclusions;  ///< of samples next to edges that clipping moved
  bool covers_anything = false;       ///< nothing is stated of the triangle, at any sample
  /// +1 or -1: the facing in every legal model; 0: they differ, or it has no area.
  int facing = 0;
};

/// Derives each triangle's samples from a scene, its profile and the places of one family.
class FamilyView {
 public:
  /// Domain:     as ChoicesOf; the scene and the profile outlive the view.
  FamilyView(const Scene& scene, const TargetProfile& profile, const Family& family);

  /// Returns the triangle's samples in the family's models: all of them, or just those that `only`
  /// marks.
  ///
  /// Shape:      `only` as counts of the target.
  TriangleSamples Of(std::size_t triangle, const std::vector<bool>* only = nullptr) const;
  /// Returns the facing that the triangle has in every model of the family, or 0. It is 0 of one
  /// that leaves the target where there is a grid: clipping makes vertices there, which are moved
  /// too.
  int SideOf(std::size_t triangle) const;
  const Choices& choices() const { return choices_; }
  std::size_t VertexOf(std::size_t triangle, std::size_t corner) const {
    return static_cast<std::size_t>(scene_.triangles[triangle][corner]);
  }
  const std::vector<Point2>& PlacesOf(std::size_t triangle, std::size_t corner) const {
    return choices_.Of(VertexOf(triangle, corner));
  }
  std::size_t PositionOf(std::size_t triangle, std::size_t corner) const {
    return choices_.position[VertexOf(triangle, corner)];
  }
  /// Whether each sample on a common edge has one owner, chosen sample by sample.
  bool OwnsByEdge() const { return OwnersOfTies(profile_) == TieOwnership::kPerEdge; }
  /// Whether the profile may leave out a triangle for its facing or its extent.
  bool MayDrop() const {
    return profile_.culls != Cull::kNone || profile_.max_primitive_extent.has_value();
  }
  std::size_t triangles() const { return scene_.triangles.size(); }
  int samples_per_pixel() const { return static_cast<int>(frame_.offsets.size()); }
  Point2 At(int x, int row, std::size_t s) const { return frame_.At(x, row, s); }

 private:
  Point2 OnScreen(const Vertex& v) const;
  // Whether all places of the corners are within the target.
  bool IsInTarget(std::size_t triangle) const;

  const Scene& scene_;
  TargetProfile profile_;
  Family family_;
  exact::SampleFrame frame_;
  Choices choices_;
  bool has_rule_;
};

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_TRIANGLE_SAMPLES_H_
