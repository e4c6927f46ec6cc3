// Which triangle wins a sample.
#ifndef RASTERPROOF_PROPS_CATALOG_WINNER_H_
#define RASTERPROOF_PROPS_CATALOG_WINNER_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// The winner of every sample is the last triangle that covers it by the model, or the first one,
/// as the subject declares.
Verdict WinnerFollowsTheDeclaredOrder(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WINNER_H_
