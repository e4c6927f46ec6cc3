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
};

/// "holds", "violated" or "inconclusive" (nothing exercised).
std::string OverallVerdict(const Certificate& certificate);

/// JSON as docs/certificate.schema.json describes; counterexamples inline as case files.
std::string CertificateToJson(const Certificate& certificate);

/// JUnit XML: one test case per property; not applicable and not exercised are skipped, with the
/// reason.
std::string JUnitXml(const Certificate& certificate);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_CERTIFICATE_H_
