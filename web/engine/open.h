// What a check is opened with, from JSON.
#ifndef RASTERPROOF_WEB_ENGINE_OPEN_H_
#define RASTERPROOF_WEB_ENGINE_OPEN_H_

#include <string>
#include <string_view>
#include <vector>

#include "core/subject_info.h"
#include "io/json_document.h"
#include "props/property.h"
#include "props/run/campaign_options.h"

namespace rasterproof::web {

struct Opened {
  SubjectInfo info;
  std::vector<const props::Property*> properties;
  bool is_whole_catalogue = false;
  props::CampaignOptions campaign;
  bool infers = false;
  bool explains = false;  ///< looks for causes
  std::string json;       ///< of this
};

/// Reads an object with the keys `subject` ({name, input: "float32" | "float64", coverage, visible,
/// shows: ["centroids", "values", "derivatives"] of fragments, takes: ["window", "clip", "culling",
/// "scissor"]}), `profile`, `properties`, `seed`, `cases`,
/// `shrink`, the most evaluations of shrinking, `infer`, whether to find the model, and `causes`,
/// whether to look for what explains the failures. All of them may be left out, as in a program's
/// description: window space, float32, counts, profile real; every property, seed 1, 1000 cases, no
/// model, no causes.
///
/// Error:      InputError with the place.
Opened OpenedFrom(const io::JsonValue& json);
Opened OpenedFrom(std::string_view json);

}  // namespace rasterproof::web

#endif  // RASTERPROOF_WEB_ENGINE_OPEN_H_
