// What a draw returns of the outputs that are wanted.
#ifndef RASTERPROOF_CORE_SHOWN_OUTPUTS_H_
#define RASTERPROOF_CORE_SHOWN_OUTPUTS_H_

#include "core/drawing.h"
#include "core/subject_info.h"

namespace rasterproof {

/// The outputs that the job wants, without centroids, values and derivatives that the subject does
/// not show, or for which the scene has no channels.
inline Outputs ShownOutputs(const DrawJob& job, const SubjectInfo& info) {
  const FragmentInfo& shows = info.fragments;
  Outputs wants = job.wants;
  wants.centroids = wants.centroids && shows.shows_centroids;
  wants.values = wants.values && shows.shows_values && !job.scene->channels.empty();
  wants.derivatives = wants.values && wants.derivatives && shows.shows_derivatives;
  return wants;
}

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SHOWN_OUTPUTS_H_
