// Tests as JUnit XML, which most build servers read.
#ifndef RASTERPROOF_REPORT_JUNIT_SUITE_H_
#define RASTERPROOF_REPORT_JUNIT_SUITE_H_

#include <cstdint>
#include <span>
#include <string>

namespace rasterproof::report {

enum class JUnitOutcome : std::uint8_t { kPassed, kFailed, kError, kSkipped };

/// One test of a suite.
struct JUnitTest {
  std::string classname;
  std::string name;
  double seconds = 0;
  JUnitOutcome outcome = JUnitOutcome::kPassed;
  std::string message = {};  ///< why it did not pass, in one line
  std::string text = {};     ///< the failure in full
  std::string said = {};     ///< remarks of a test that neither failed nor was skipped
};

/// Returns the tests as one suite, with `said` after them.
std::string JUnitSuite(const std::string& name, std::span<const JUnitTest> tests,
                       const std::string& said);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_JUNIT_SUITE_H_
