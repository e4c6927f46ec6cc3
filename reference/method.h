// The table of methods: every way of evaluating edge functions that the field uses.
#ifndef RASTERPROOF_REFERENCE_METHOD_H_
#define RASTERPROOF_REFERENCE_METHOD_H_

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/evaluators.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "core/vertex.h"

namespace rasterproof::reference {

/// Drawing options and the one choice that belongs to the method, not to the caller of a subject.
struct RasterOptions : DrawOptions {
  /// Evaluate every edge from its lexicographically smaller end, so that both triangles of a shared
  /// edge see the same number. Float methods only; exact ones have no use for it.
  bool canonical_edges = false;
};

using Corners3 = std::array<Vertex, 3>;

/// The samples of one triangle that a draw may count, and the counts of its facing.
struct FillTarget {
  PixelRect box;          ///< where edge evaluation starts: of the triangle and the target alone
  PixelRect area;         ///< the part of the box that is drawn: scissor and band
  std::uint32_t* counts;  ///< of the whole target, row-major, one sample a pixel
  int width;              ///< of the target
};

/// What a method does at each stage of rasterize.cc, which calls them in this order.
struct Stages {
  /// Where the vertices lie: as given, snapped, divided by w. Nothing: no triangle is drawn.
  std::optional<Corners3> (*place)(const Corners3& given) = nullptr;
  /// The pixels of the target whose samples the triangle can cover.
  PixelRect (*box)(const Corners3& v, const PixelRect& target) = nullptr;
  /// The sign of the area: +1 front (counter-clockwise on screen), -1 back, 0 covers nothing.
  int (*facing)(const Corners3& v, const RasterOptions& options) = nullptr;
  /// Adds one to each sample of `to.area` that the triangle covers, ties by the method's rule.
  ///
  /// Domain:     v turns counter-clockwise on screen: E > 0 inside, of each of its edges.
  void (*fill)(const Corners3& v, const RasterOptions& options, const FillTarget& to) = nullptr;
};

/// One row of the table.
struct Method {
  std::string_view name;     ///< "f32-direct"
  std::string_view summary;  ///< one line
  /// Number format, profile (its own), window or clip space; whether it claims to be exact
  /// inside its proven domain, and what is proved of its edge arithmetic.
  SubjectInfo info;
  bool can_be_canonical = false;
  /// Its values are stepped down from the corner of the box, then across: EdgeEvaluator::Steps goes
  /// one way and promises nothing of that.
  bool steps_from_corner = false;
  Stages stages;
  /// Draws a whole scene at once, with the same counts as the stages, and returns true; or returns
  /// false, and the stages draw it. nullptr: they always do.
  bool (*whole)(const Scene& scene, const RasterOptions& options, CoverageCounts& counts) = nullptr;
  const EdgeEvaluator* edges = nullptr;
  /// The same with canonical edges; nullptr unless can_be_canonical.
  const EdgeEvaluator* canonical_edges = nullptr;
};

/// Every method, cheapest arithmetic first.
std::span<const Method> Methods();
/// nullptr if there is none of that name.
const Method* FindMethod(std::string_view name);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_METHOD_H_
