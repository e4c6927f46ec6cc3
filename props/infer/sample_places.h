// The places of samples, pixel by pixel, independent of any model.
#ifndef RASTERPROOF_PROPS_INFER_SAMPLE_PLACES_H_
#define RASTERPROOF_PROPS_INFER_SAMPLE_PLACES_H_

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/profile.h"
#include "props/infer/observer.h"

namespace rasterproof::props {

/// Edges are moved in steps of this fraction of a pixel: a place is known to within one step.
inline constexpr int kPlaceSteps = 32;

/// Where a pixel shows one of its samples: from x / 32 to (x + 1) / 32 of it, and so along y.
struct SeenPlace {
  int column = 0;
  int row = 0;  ///< from the top
  int x = 0;
  int y = 0;
};

struct SamplePlaces {
  /// The place of each sample, in the first pixel that shows it.
  std::vector<SeenPlace> samples;
  /// Two samples that seem to lie in one place.
  std::optional<std::array<int, 2>> sharing;
  /// A sample that lies elsewhere in another pixel, by two steps or more, and the two pixels.
  struct Moved {
    int sample = 0;
    std::array<SeenPlace, 2> seen;
  };
  std::optional<Moved> varying;
};

/// Draws half planes whose edges advance over a small target, and records where each sample of each
/// pixel is reached. The subject's grid moves an edge equally far in every pixel, so that places
/// differ only if samples do; differences of less than 1/16 of a pixel may go unseen.
///
/// Domain:     a subject that takes what TooLittleRoom asks for; `y_axis` as Locate found it.
/// Returns:    nothing if some sample is never covered, or the subject breaks off.
std::optional<SamplePlaces> FindSamplePlaces(Observer& observer, YAxis y_axis);

/// Lines for readers: the places, and what they share or where they vary.
std::vector<std::string> PlacesText(const SamplePlaces& places);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_SAMPLE_PLACES_H_
