// The certificate: what was proved, exhausted, tested and measured about one subject.
#ifndef RASTERPROOF_REPORT_CERTIFICATE_H_
#define RASTERPROOF_REPORT_CERTIFICATE_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/subject.h"

namespace rasterproof::report {

/// A claim with the evidence behind it. The four words are never mixed.
struct Evidence {
  std::string claim;
  std::string by;  ///< proof script, enumeration with its N, command
};

struct Certificate {
  std::string tool_version;
  SubjectInfo subject;
  bool claims_exact = false;
  std::string command;                             ///< the command line that issued it
  std::map<std::string, std::string> environment;  ///< compiler, flags, rounding, subnormals, ...
  std::uint64_t seed = 0;
  std::vector<Evidence> proved;
  std::vector<Evidence> exhausted;
  std::vector<PropertyResult> tested;
  std::vector<SceneResult>
      measured;  ///< on real scenes, against the subject's own profile and real geometry
  std::map<std::string, std::uint64_t>
      oracle_tiers;  ///< which tier of the oracle decided how often
  std::vector<Evidence>
      not_applicable;  ///< what was not asked of this subject, and why: never green
  /// The command that replays a property's counterexample, by property. Without one the reader is
  /// told to save the counterexample's case and to replay that file.
  std::map<std::string, std::string> replay;
};

/// Returns whether the subject's profile answers for this measurement: a sample-exact contract (or
/// the claim to be exact), the subject's own profile, a scene within its limits. Everything else is
/// observed, never judged.
bool IsJudged(const Certificate& certificate, const SceneResult& result);

/// "violated" if a property is, or a judged scene has a wrong sample; "holds" if nothing is
/// violated and something was exercised; else "inconclusive".
std::string OverallVerdict(const Certificate& certificate);

/// The properties that do not apply to the subject, with the reason, each once: those of
/// `not_applicable` and those among `tested` that say so of themselves.
std::vector<Evidence> NotApplicable(const Certificate& certificate);

/// The command that replays the counterexample of a result.
std::string ReplayCommand(const Certificate& certificate, const PropertyResult& result);

/// JSON as docs/certificate.schema.json describes; counterexamples inline as case files.
std::string CertificateToJson(const Certificate& certificate);

/// JUnit XML: one test case per property; not applicable and not exercised are skipped, with the
/// reason.
std::string JUnitXml(const Certificate& certificate);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_CERTIFICATE_H_
