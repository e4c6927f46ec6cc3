// Channels of a request's scene, as it is written.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_CHANNELS_H_
#define RASTERPROOF_SUBJECTS_PROCESS_CHANNELS_H_

#include <vector>

#include "core/channel.h"
#include "core/scene.h"
#include "subjects/process/text.h"

namespace rasterproof::subjects {

/// Returns whether they are the same, bit for bit: -0 is not 0, and a NaN is the same NaN.
bool HaveTheSameChannels(const Scene& a, const Scene& b);

/// Adds a line for each channel, with its numbers or, as an array, before them.
void AddChannels(TextWriter& text, const std::vector<Channel>& channels, bool as_arrays);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_CHANNELS_H_
