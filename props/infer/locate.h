// Finds a subject's sample locations, y axis and facings by large triangles whose vertices lie on
// every grid that holds the even integers.
#ifndef RASTERPROOF_PROPS_INFER_LOCATE_H_
#define RASTERPROOF_PROPS_INFER_LOCATE_H_

#include <string>
#include <vector>

#include "core/profile.h"
#include "props/infer/model_space.h"
#include "props/infer/observer.h"

namespace rasterproof::props {

struct Location {
  YAxis y_axis = YAxis::kDown;
  Cull culls = Cull::kNone;  ///< the side that never appeared
  std::vector<PatternCandidate> patterns;
  /// Its places are multiples of 1 / per_pixel: of 1/256, or coarser where the stated range of
  /// coordinates, sizes or targets is too small for that.
  int per_pixel = 256;
  /// Empty, or why no model can fit; then the rest is a guess.
  std::string complaint;
  Scene complaint_scene;
};

/// Returns why the stated limits leave no room for the experiments of Locate; empty if they do.
std::string TooLittleRoom(const SubjectInfo& info);

/// Draws four scenes and sets the meaning of facings in the observer.
Location Locate(Observer& observer);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_LOCATE_H_
