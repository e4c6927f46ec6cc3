// What a subject declares, against the models that explain it.
#ifndef RASTERPROOF_PROPS_INFER_DECLARATIONS_H_
#define RASTERPROOF_PROPS_INFER_DECLARATIONS_H_

#include <vector>

#include "core/profile.h"
#include "props/infer/infer.h"
#include "props/infer/observer.h"

namespace rasterproof::props {

/// Returns a verdict on each member of the declared model.
///
/// Agrees:     some remaining model has the declared value, and so has all the others' declared
///             values that are still open; or the declared freedom allows what was found; or the
///             contract promises nothing about single samples (then the verdict is an observation).
std::vector<DeclarationVerdict> VerifyDeclarations(const Profile& declared, FacingReport facing,
                                                   const std::vector<Profile>& remaining);

/// "down" or "up"; "[0x1p-1, 0x1p-1]" and so on: a profile's member for the reader.
std::string SnapText(const Snap& snap);
std::string LatticeText(const SampleLattice& lattice);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_DECLARATIONS_H_
