// The certificate: what was proved, exhausted, tested and measured about one subject.
//
// Certificate is the record. OverallOf() makes the one verdict of it that JSON, JUnit, page,
// summary and exit status share; CertificateToJson() and JUnitXml() write it. For the report page,
// see page.h; for several runs that are parts of one campaign, tool/certify/part_file.h.
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
#include "io/json_writer.h"

namespace rasterproof::report {

/// A statement and its evidence. Each list of a certificate holds evidence of one kind: what was
/// proved is never listed with what was only tested.
struct Evidence {
  std::string statement;
  std::string by;  ///< a proof script, "all N of N cases", or the reason why it was not asked
};

struct Certificate {
  std::string tool_version;
  SubjectInfo subject;
  std::string command;                             ///< the command line that issued it
  std::map<std::string, std::string> environment;  ///< compiler, flags, rounding, subnormals, ...
  std::uint64_t seed = 0;
  FailOn fail_on = FailOn::kStated;  ///< which violations fail the run
  bool interrupted = false;          ///< the run was ended before all was done
  /// Why no property of the subject's contract was tested; empty if one was. Other
  /// properties that hold are no evidence for the contract.
  std::string contract_untested;
  /// How little of the contract was tested; empty if it was enough.
  std::string contract_thin;
  /// What the subject shows or takes and nothing in the run asked for: "depths in clip space", and
  /// why. Empty if the run was interrupted.
  std::vector<Evidence> not_asked;
  /// Statements about the subject's arithmetic. `by` has the hash of the proof script, and where
  /// the script was run, or that it was not.
  std::vector<Evidence> proved;
  std::vector<PropertyResult> tested;
  /// The drawings of real scenes, compared with the subject's own profile and with real geometry.
  std::vector<SceneResult> measured;
  /// How often each tier of the oracle decided, summed over scenes and properties. A property whose
  /// run ended at a case is not in the sum.
  TierCounts oracle_tiers;
  /// The command that replays a result's counterexample, by NameOf() the result. Read it with
  /// ReplayCommand(), which also serves results without an entry.
  std::map<std::string, std::string> replay;
  /// What explains a violation, in words, by NameOf() the result; on the page alone.
  std::map<std::string, std::string> causes = {};
  /// The name of the folder of its files, beside the report page. Empty if it has none.
  std::string folder;
};

/// Returns why a wrong sample of this measurement is no violation, or an empty string if it is one.
///
/// A measurement is judged if the subject's profile answers for every sample of it. Otherwise it is
/// observed only: the scene was not drawn, it lies beyond what the profile states, the profile
/// leaves more than one result legal, or the measurement is against another profile than the
/// subject's own.
std::string WhyNotJudged(const Certificate& certificate, const SceneResult& result);
/// Returns whether WhyNotJudged() is empty.
bool IsJudged(const Certificate& certificate, const SceneResult& result);

/// The verdict of a whole certificate.
struct Overall {
  Outcome outcome = Outcome::kInconclusive;  ///< kHolds, kViolated or kInconclusive
  std::string reason;                        ///< one line; may be empty if it holds
};

/// Returns the verdict of the certificate, the first of these that applies:
///
/// kViolated      a property is violated, or a judged scene has a wrong sample. A property that
///                only quality asks for counts if `fail_on` says so.
/// kInconclusive  the run was interrupted, a property could not be judged, or nothing put the
///                contract to the test: no property, and no judged scene.
/// kHolds         otherwise.
Overall OverallOf(const Certificate& certificate);

/// Returns the word of OverallOf(): "holds", "violated" or "inconclusive".
std::string OverallVerdict(const Certificate& certificate);

/// Returns the scenes that were not drawn or not compared, each once, with the reason.
std::vector<Evidence> ScenesNotDrawn(const Certificate& certificate);

/// Returns the properties and scenes that do not apply to the subject, each once, with the reason.
std::vector<Evidence> NotApplicable(const Certificate& certificate);

/// Returns the properties that hold in every case of a world: "CoverageEqualsTheModel on
/// triangles-7x7", by "all N of N cases, M of which put it to the test".
std::vector<Evidence> Exhausted(const Certificate& certificate);

/// Returns the members of `oracle_tiers` by their names.
std::map<std::string, std::uint64_t> TiersByName(const Certificate& certificate);

/// Returns what the result's outcome does not cover: the cases that the subject refused, unless the
/// result's message names them, the samples that were not judged, and those in gaps of the scenes.
/// Empty if there are none.
std::string Reservations(const PropertyResult& result);
/// Returns how many samples lie in gaps that the scenes themselves have; empty if none is known.
std::string GapsText(const PropertyResult& result);

/// Returns the result's message followed by its Reservations().
std::string Said(const PropertyResult& result);

/// Returns the command that replays the counterexample of a result. If `replay` has none, it tells
/// the reader to save the counterexample's case and to replay that file.
std::string ReplayCommand(const Certificate& certificate, const PropertyResult& result);

/// Returns the certificate as JSON, in the form of docs/certificate.schema.json. Counterexamples
/// are in it as case files. It has no times, so that a campaign bounded by cases gives the same
/// bytes however long it took: for those, see TimesToJson().
std::string CertificateToJson(const Certificate& certificate);

/// Returns the seconds that each property and each scene took, as JSON. For a campaign in parts
/// these are the sums over the parts.
std::string TimesToJson(const Certificate& certificate);

/// Returns the certificate as JUnit XML, with a test case for each property and for each scene that
/// was measured against the subject's own profile.
///
/// Results that are neither good nor bad are skipped tests, with the reason. A build server takes a
/// file of skipped tests for green, so an inconclusive certificate has a test case more, an error.
std::string JUnitXml(const Certificate& certificate);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_CERTIFICATE_H_
