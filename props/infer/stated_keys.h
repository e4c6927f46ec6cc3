// Compares a subject's statements with the models that explain it.
#ifndef RASTERPROOF_PROPS_INFER_STATED_KEYS_H_
#define RASTERPROOF_PROPS_INFER_STATED_KEYS_H_

#include <vector>

#include "core/profile.h"
#include "props/infer/infer.h"
#include "props/infer/observer.h"

namespace rasterproof::props {

/// Returns a verdict on each member of the stated model.
///
/// Agrees:     some remaining model has the stated value and the other stated values that are
///             still open; or the stated freedom allows the value found; or the
///             contract states nothing about single samples (then the verdict is an observation).
std::vector<StatementVerdict> VerifyStatements(const Profile& stated, FacingReport facing,
                                               const std::vector<Profile>& remaining);

/// "down" or "up"; "[0x1p-1, 0x1p-1]" and so on: a profile's member for the reader.
std::string SnapText(const Snap& snap);
std::string PatternText(const SamplePattern& pattern);
/// "8 subpixel bits, nearest-even of x; top-left; samples [128/256, 128/256]; y down".
std::string ModelText(const Profile& profile);
/// The model that is nearest, whether it fits or not: "8 subpixel bits, ...; differs in 0.01 % of
/// samples: no model fits".
std::string InferredText(const Inference& inference);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_STATED_KEYS_H_
