// What one call shows, to be judged by the joint verdict, and how that verdict reads.
#ifndef RASTERPROOF_TOOL_LEGALITY_H_
#define RASTERPROOF_TOOL_LEGALITY_H_

#include <cstddef>
#include <string>

#include "core/drawing.h"
#include "core/scene.h"
#include "core/subject.h"
#include "legal/joint.h"

namespace rasterproof::tool {

/// What one call shows of a scene.
struct OneCall {
  Drawing drawing;
  bool is_mask = false;    ///< its counts say whether a sample is covered, not how often
  bool has_counts = true;  ///< else the primitive ids are judged
  bool last_is_visible = true;

  /// Points into this.
  legal::Observed Observed() const;
};

/// Draws all triangles of the scene in one call.
///
/// Error:      as Subject::Show.
OneCall DrawInOneCall(Subject& subject, const Scene& scene);

/// Why no legal model explains what was seen: a head, a line for each of the first samples and
/// vertices.
std::string CoreText(const legal::Core& core, const Scene& scene, std::size_t samples);
/// The head and the first sample, in one line.
std::string CoreLine(const legal::Core& core, const Scene& scene, std::size_t samples);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_LEGALITY_H_
