// Whether a run put the contract to the test that the profile states.
#ifndef RASTERPROOF_PROPS_RUN_CONTRACT_EVIDENCE_H_
#define RASTERPROOF_PROPS_RUN_CONTRACT_EVIDENCE_H_

#include <cstdint>
#include <span>
#include <string>

#include "core/result.h"
#include "core/subject_info.h"

namespace rasterproof::props {

/// Fewer samples exactly on an edge than this say little of who owns them: of eight kinds of edges
/// (horizontal and vertical ones and the diagonal halves, either way) each sample meets one; at 32
/// one kind was met by none in 1 run of 70, (7/8)^32.
inline constexpr std::uint64_t kFewestTies = 32;

struct ContractEvidence {
  /// Some property of the contract was put to the test, or the contract is `none` and states
  /// nothing.
  bool is_exercised = false;
  /// Else: a sentence that says what prevents it, by the profile's key where it is one.
  std::string why;
  /// Where it is exercised by fewer than kFewestTies samples on edges, and the contract is one that
  /// says who owns them: a sentence with the number. Empty for given cases, which are not counted.
  std::string thin = {};
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
