// The properties as RapidCheck properties. The only place that knows RapidCheck.
#ifndef RASTERPROOF_TESTS_PROPS_RAPIDCHECK_BRIDGE_H_
#define RASTERPROOF_TESTS_PROPS_RAPIDCHECK_BRIDGE_H_

#include <rapidcheck.h>

#include <cstdint>

#include "core/result.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "props/property.h"
#include "props/run/campaign.h"

namespace rasterproof::props {

/// Cases of the property's domains, drawn on the subject's lattice, with ShrinkCandidates as their
/// shrink tree. RapidCheck's random numbers feed the recipes; its size is not used.
///
/// Domain:     a subject that takes scenes of one of the property's domains.
rc::Gen<Case> CasesFor(const SubjectInfo& info, const Property& property);

/// Floats at hard places, where rc::gen::arbitrary<double> never goes: zeros of both signs,
/// subnormals, the ends of the range, powers of two and half pixels with their neighbours, and all
/// magnitudes log-uniformly; shrunk towards zero, whole numbers, short mantissas. Finite.
rc::Gen<double> HardFloats(Precision precision);

/// Runs the property under RapidCheck: its generation, its search through the shrink tree.
///
/// Returns:    as RunCampaign; failing_case is empty, for what RapidCheck draws has no name. `seed`
///             alone decides the cases: RC_PARAMS and the clock have no say.
/// Properties: at most `shrink_budget` cases are tried while shrinking; what RapidCheck still asks
///             for after that is answered with "passes".
PropertyResult CheckWithRapidCheck(Subject& subject, const Property& property,
                                   std::uint64_t seed = kDefaultSeed, std::uint64_t cases = 100,
                                   std::uint64_t shrink_budget = 2000);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_TESTS_PROPS_RAPIDCHECK_BRIDGE_H_
