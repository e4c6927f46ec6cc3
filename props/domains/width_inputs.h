// For a subject with fixed-point input: the inputs at which an edge function needs its last bit.
#ifndef RASTERPROOF_PROPS_DOMAINS_WIDTH_INPUTS_H_
#define RASTERPROOF_PROPS_DOMAINS_WIDTH_INPUTS_H_

#include <string>
#include <string_view>

#include "core/subject_info.h"
#include "props/domains/worlds.h"

namespace rasterproof::props {

/// The world edge-widths: case k is the witness of value k of exact::EdgeWidths, on a target of at
/// most 1024 x 1024 pixels. It is no world of Worlds(): whoever states a fixed-point input is given
/// it, whatever else is run. FindWorld finds it.
const World& WidthInputs();

/// Whether the property is put to these inputs, beside the cases of its domains.
bool IsPutToWidthInputs(std::string_view property, const SubjectInfo& info);

/// "E takes 33 bits on a target of 1024 x 1024; the 49 inputs that need the last bit of each value
/// were drawn".
///
/// Domain:     WhyNotGiven(WidthInputs(), info) is empty.
std::string WidthInputsText(const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_WIDTH_INPUTS_H_
