// The numbers that properties have subjects interpolate.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_VALUE_CHANNELS_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_VALUE_CHANNELS_H_

#include <cstddef>
#include <vector>

#include "core/channel.h"
#include "core/scene.h"
#include "core/value_rule.h"

namespace rasterproof::props {

/// The channels of the scene; if it has none, channels that we choose: numbers that differ from
/// vertex to vertex, equal ones, nearly equal ones, ones that cancel, large ones and small ones, of
/// the interpolations and places that the rule states. All are numbers of float32.
std::vector<Channel> ChannelsFor(const Scene& scene, const ValueRule& rule);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_VALUE_CHANNELS_H_
