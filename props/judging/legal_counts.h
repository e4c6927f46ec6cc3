// How often the legal models of a profile cover the samples of a scene.
#ifndef RASTERPROOF_PROPS_JUDGING_LEGAL_COUNTS_H_
#define RASTERPROOF_PROPS_JUDGING_LEGAL_COUNTS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/question.h"
#include "core/scene.h"
#include "core/verdict.h"
#include "model/target_profile.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// Returns why the counts of legal models are not known, or nothing if they are.
std::optional<std::string> WhyNoLegalCounts(const Scene& scene, const TargetProfile& profile);

/// The coverage by facing if the profile has one model. Otherwise the counts that some legal model
/// has at each sample; facings are ignored.
class LegalCounts {
 public:
  /// Makes the counts of another scene on the case's target and profile, culling and scissor off.
  ///
  /// Domain:     window space; no WhyNoLegalCounts.
  LegalCounts(const Scene& scene, const PlacedCase& c);

  /// The samples that no legal model of the one covers as some legal model of the other does.
  std::uint64_t Apart(const LegalCounts& other) const;

  /// Asks for the scene: by facing where one model is legal, else for what one call shows.
  static DrawQuestion QuestionOf(const Scene& scene, const PlacedCase& c);
  /// The samples that no legal model covers as they were drawn, in their order. By facing where one
  /// model is legal.
  std::vector<std::size_t> Wrong(const CoverageCounts& drawn, bool counts) const;
  /// Violated if no legal model covers some sample as it was drawn. `counts`: whether the subject
  /// counts; else 1 stands for any number but 0.
  Verdict VerdictOn(const CoverageCounts& drawn, bool counts, std::uint64_t exercised,
                    const std::string& of) const;

 private:
  Verdict JudgeBySample(const CoverageCounts& drawn, bool counts, std::uint64_t exercised,
                        const std::string& of) const;

  std::optional<CoverageCounts> only_;
  std::vector<std::uint64_t> numbers_;  ///< as legal::Decided::counts
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_LEGAL_COUNTS_H_
