// Finds the model that explains a subject best, from triangles on their own.
#ifndef RASTERPROOF_TOOL_SURVEY_FIT_H_
#define RASTERPROOF_TOOL_SURVEY_FIT_H_

#include <cstdint>
#include <vector>

#include "core/profile.h"
#include "core/subject.h"

namespace rasterproof::tool {

struct Fit {
  Profile model;  ///< snap, sample location and fill rule are fitted; the rest is declared
  std::uint64_t wrong = 0;
  std::uint64_t samples = 0;
};

/// Returns the few best models, best first. Of equally good ones, those with the declared snap come
/// first. Triangles that the subject refuses count for nothing.
///
/// Domain:     one sample a pixel.
std::vector<Fit> FitModels(Subject& subject, const Profile& declared, std::uint64_t triangles);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SURVEY_FIT_H_
