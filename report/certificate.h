// The certificate: what was proved, exhausted, tested and measured about one subject.
#ifndef RASTERPROOF_REPORT_CERTIFICATE_H_
#define RASTERPROOF_REPORT_CERTIFICATE_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/authority.h"
#include "core/counters.h"
#include "core/result.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "report/json_writer.h"

namespace rasterproof::report {

/// A statement with its evidence. The four words are never mixed.
struct Evidence {
  std::string statement;
  std::string by;  ///< proof script, enumeration with its N, command
};

struct Certificate {
  std::string tool_version;
  SubjectInfo subject;
  std::string command;                             ///< the command line that issued it
  std::map<std::string, std::string> environment;  ///< compiler, flags, rounding, subnormals, ...
  std::uint64_t seed = 0;
  FailOn fail_on = FailOn::kStated;  ///< whether a lack of quality counts as a violation
  bool interrupted = false;  ///< someone ended the run early: not all that was asked was done
  /// What kept every property of the subject's contract from being put to the test; empty if
  /// nothing did. Properties that hold beside the contract are no evidence for it.
  std::string contract_untested;
  /// How little of it was, where that is little; empty else.
  std::string contract_thin;
  /// Statements about the subject's arithmetic; `by` names the script by its hash, and where it was
  /// run or that it was not.
  std::vector<Evidence> proved;
  std::vector<PropertyResult> tested;
  /// On real scenes, against the subject's own profile and real geometry.
  std::vector<SceneResult> measured;
  /// Which tier of the oracle decided how often, over scenes and all properties but those whose run
  /// ended with a case.
  TierCounts oracle_tiers;
  /// The command that replays a result's counterexample, by NameOf the result. Without one the page
  /// asks the reader to save the counterexample's case and to replay that file.
  std::map<std::string, std::string> replay;
  /// Where its files lie, as a path from the report page: one name. Empty: it has none.
  std::string folder;
};

/// Why a wrong sample of this measurement would be no violation: the scene was not drawn, or lies
/// beyond what the profile states, or the profile leaves more than one result legal, or it is not
/// the subject's own.
///
/// Returns:    empty if the subject's profile answers for every sample: the measurement is judged.
///             Everything else is observed, never judged.
std::string WhyNotJudged(const Certificate& certificate, const SceneResult& result);
bool IsJudged(const Certificate& certificate, const SceneResult& result);

/// What a certificate comes to.
struct Overall {
  Outcome outcome = Outcome::kInconclusive;  ///< kHolds, kViolated or kInconclusive
  std::string reason;                        ///< one line; empty if it just holds
};

/// The one place that decides it; JSON, JUnit, page, summary and exit status all read it.
///
/// Returns:    kViolated if a property is, one of quality only where fail_on says so, or a judged
///             scene has a wrong sample; else kInconclusive
///             if the run was interrupted, a property could not be judged, or nothing of the
///             contract was exercised, by no property and on no judged scene; else kHolds.
Overall OverallOf(const Certificate& certificate);

/// "holds", "violated" or "inconclusive".
std::string OverallVerdict(const Certificate& certificate);

/// What was not asked of the subject, with the reason, each once: properties and scenes that say so
/// of themselves.
std::vector<Evidence> NotApplicable(const Certificate& certificate);

/// What holds in every case of a world: "CoverageEqualsTheModel on triangles-7x7", by "all N of N
/// cases, M of which put it to the test".
std::vector<Evidence> Exhausted(const Certificate& certificate);

/// How often each tier of the oracle decided.
std::map<std::string, std::uint64_t> TiersByName(const Certificate& certificate);

/// What an outcome does not speak for: cases that the subject refused (unless the result's own
/// message says it), samples that were not judged. Empty if there are none.
std::string Reservations(const PropertyResult& result);

/// The result's message, and its reservations.
std::string Said(const PropertyResult& result);

/// The command that replays the counterexample of a result.
std::string ReplayCommand(const Certificate& certificate, const PropertyResult& result);

/// Writes the member "witness", as certificates and parts of campaigns have it.
void WriteWitness(JsonWriter& json, const Witness& witness);

/// JSON as docs/certificate.schema.json describes; counterexamples inline as case files. No times:
/// a campaign bounded by cases gives the same bytes however long it took.
std::string CertificateToJson(const Certificate& certificate);

/// The seconds that each property and each scene took, as JSON; of a campaign in parts their sum.
std::string TimesToJson(const Certificate& certificate);

/// Returns JUnit XML: one test case per property and per scene against the subject's own profile.
/// Results that are neither good nor bad are skipped, with the reason. An inconclusive certificate
/// is a separate error, since a file with nothing but skipped tests counts as green.
std::string JUnitXml(const Certificate& certificate);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_CERTIFICATE_H_
