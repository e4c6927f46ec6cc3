// Whether a run put the contract to the test that the profile states.
#ifndef RASTERPROOF_PROPS_RUN_CONTRACT_EVIDENCE_H_
#define RASTERPROOF_PROPS_RUN_CONTRACT_EVIDENCE_H_

#include <span>
#include <string>

#include "core/result.h"
#include "core/subject_info.h"

namespace rasterproof::props {

struct ContractEvidence {
  /// Some property of the contract was put to the test, or the contract is `none` and states
  /// nothing.
  bool is_exercised = false;
  /// Else: a sentence that says what stands in the way, by the profile's key where it is one.
  std::string why;
};

/// Judges a run over the whole catalogue: states that hold beside the contract (equal draws are
/// equal, nothing is written outside) are no evidence for it. See contract_properties.h.
///
/// Domain:     the results of one subject, in any order; of a run that left out no property.
/// Cost:       none where it is exercised; else a few cases for each key of the profile.
ContractEvidence EvidenceOfContract(const SubjectInfo& info,
                                    std::span<const PropertyResult> results);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_CONTRACT_EVIDENCE_H_
