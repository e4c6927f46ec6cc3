// What the legal models of one family say of one triangle: which samples it covers, leaves out, or
// decides by where its vertices lie.
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
#include "model/target_profile.h"

namespace rasterproof::legal {

/// What one choice of places says of a sample.
enum class Status : std::uint8_t {
  kOut,
  kIn,
  kFree  ///< no sentence decides it: the sample lies on an edge or at a vertex, for one
};

/// A sample that legal models decide differently for a triangle.
struct OpenSample {
  std::size_t triangle = 0;
  std::size_t sample = 0;           ///< index in counts of the target
  Point2 at;                        ///< in screen axes
  std::vector<std::size_t> corner;  ///< those of the triangle, 0 to 2, whose places decide it
  /// For each choice of these corners' places, the last corner's places fastest.
  std::vector<Status> by_choice;
  bool is_clipped = false;  ///< clipping may have moved the edge beside it
  /// The edge, from that corner to the next, that alone decides it, wherever clipping moved it.
  std::optional<std::size_t> moved_edge;
};

/// Open samples of a triangle, by index, and whether each is covered: some of it is not so.
using Exclusion = std::vector<std::pair<std::size_t, bool>>;

struct TriangleSamples {
  std::vector<std::size_t> covered;  ///< in every legal model
  std::vector<OpenSample> open;
  std::vector<Exclusion> exclusions;  ///< of samples beside edges that clipping moved
  bool covers_anything = false;       ///< nothing is stated of the triangle, at any sample
  /// +1 or -1: the facing in every legal model; 0: they differ, or it has no area.
  int facing = 0;
};

/// A scene, its profile and the places of one family, from which triangles are looked at.
class FamilyView {
 public:
  /// Domain:     as ChoicesOf; the scene and the profile outlive the view.
  FamilyView(const Scene& scene, const TargetProfile& profile, const Family& family);

  /// What the family's models say of the triangle at every sample, or, where `only` says which, at
  /// those alone.
  ///
  /// Shape:      `only` as counts of the target.
  TriangleSamples Of(std::size_t triangle, const std::vector<bool>* only = nullptr) const;
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
  bool OwnsByEdge() const {
    return !profile_.shares_edge_samples && profile_.freedom.ties == TieOwnership::kPerEdge;
  }
  std::size_t triangles() const { return scene_.triangles.size(); }
  int samples_per_pixel() const { return static_cast<int>(frame_.offsets.size()); }
  Point2 At(int x, int row, std::size_t s) const { return frame_.At(x, row, s); }

 private:
  Point2 OnScreen(const Vertex& v) const;

  const Scene& scene_;
  TargetProfile profile_;
  Family family_;
  exact::SampleFrame frame_;
  Choices choices_;
  bool has_rule_;
};

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_TRIANGLE_SAMPLES_H_
