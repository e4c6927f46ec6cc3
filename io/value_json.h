// A profile's statement about values, and the channels of a scene, as JSON.
#ifndef RASTERPROOF_IO_VALUE_JSON_H_
#define RASTERPROOF_IO_VALUE_JSON_H_

#include <cstddef>
#include <vector>

#include "core/channel.h"
#include "core/scene.h"
#include "core/value_rule.h"
#include "io/json_document.h"
#include "io/json_writer.h"

namespace rasterproof::io {

/// Error:      both readers: InputError names the value at fault.
ValueRule ValueRuleFromJson(const JsonValue& value);
void WriteValueRule(JsonWriter& json, const ValueRule& rule);

/// The channels of a scene of so many vertices.
std::vector<Channel> ChannelsFromJson(const JsonValue& list, std::size_t vertices,
                                      Precision precision);
void WriteChannels(JsonWriter& json, const std::vector<Channel>& channels);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_VALUE_JSON_H_
