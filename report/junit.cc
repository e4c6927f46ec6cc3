// The certificate for programs that read JUnit XML, as most build servers do.
#include <string>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/certificate.h"
#include "report/grounds.h"
#include "report/junit_suite.h"

namespace rasterproof::report {
namespace {

// A test of the certificate's suite that passes, until more is known of it.
JUnitTest TestOf(const Certificate& certificate, std::string name, double seconds) {
  return {.classname = certificate.subject.name, .name = std::move(name), .seconds = seconds};
}

JUnitTest TestOfProperty(const Certificate& certificate, const PropertyResult& result) {
  JUnitTest test = TestOf(certificate, NameOf(result), result.seconds);
  const std::string said = Said(result);
  switch (result.outcome) {
    case Outcome::kHolds:
      if (IsExhausted(result))
        test.said = fmt::format("exhausted: all {0} of {0} cases", result.cases);
      if (result.cases_refused != 0 || result.not_judged != 0)
        test.said += (test.said.empty() ? "" : "\n") + said;
      break;
    case Outcome::kViolated: {
      if (IsLackOfQuality(result, certificate.fail_on)) {
        test.said = AuthorityText(result) + "; " + said;
        break;
      }
      test.outcome = JUnitOutcome::kFailed;
      test.message = result.message.empty() ? "violated" : result.message;
      test.text = result.clause + "\n" + AuthorityText(result) + "\n" + said + "\n";
      if (result.counterexample && result.counterexample->verdict.witness) {
        const Witness& w = *result.counterexample->verdict.witness;
        test.text += fmt::format(
            "triangle {}, edge {}, pixel ({}, {}), sample {}: observed {}, "
            "expected {}\n",
            w.triangle, w.edge, w.x, w.y, w.sample, TextOfValue(w.observed),
            TextOfValue(w.expected));
      }
      test.text += "replay: " + ReplayCommand(certificate, result) + "\n";
      break;
    }
    case Outcome::kNotExercised:
    case Outcome::kNotApplicable:
    case Outcome::kRefused:
    case Outcome::kInconclusive:
      test.outcome = JUnitOutcome::kSkipped;
      test.message = std::string(OutcomeName(result.outcome)) + (said.empty() ? "" : ": " + said);
      break;
  }
  return test;
}

// A scene against the subject's own profile is a test of its own: otherwise the file could be green
// and the verdict not.
JUnitTest TestOfScene(const Certificate& certificate, const SceneResult& result) {
  JUnitTest test =
      TestOf(certificate, fmt::format("SceneMatchesModel: {}", result.scene), result.seconds);
  const std::string why = WhyNotJudged(certificate, result);
  const CoverageDifference& difference = result.difference;
  if (!why.empty()) {
    test.outcome = JUnitOutcome::kSkipped;
    test.message = why;
  } else if (difference.wrong != 0) {
    test.outcome = JUnitOutcome::kFailed;
    test.message = fmt::format(
        "{} of {} samples wrong, {} missing, {} unexpected, against profile {}", difference.wrong,
        difference.samples, difference.missing, difference.unexpected, result.profile);
    test.text = test.message + "\n";
  }
  return test;
}

// After all tests, where the format has room for it.
std::string AssumptionsOf(const Certificate& certificate) {
  std::string text;
  for (const Evidence& one : AssumptionsUnder(certificate.subject.profile)) {
    text += fmt::format("{}assumed: {}: {}", text.empty() ? "" : "\n", one.statement, one.by);
  }
  return text;
}

}  // namespace

std::string JUnitXml(const Certificate& certificate) {
  std::vector<JUnitTest> tests;
  for (const PropertyResult& result : certificate.tested)
    tests.push_back(TestOfProperty(certificate, result));
  for (const SceneResult& result : certificate.measured) {
    if (result.profile == certificate.subject.profile.name)
      tests.push_back(TestOfScene(certificate, result));
  }
  // A file in which nothing failed is green wherever it is read, however much of it was skipped.
  const Overall overall = OverallOf(certificate);
  if (overall.outcome == Outcome::kInconclusive) {
    JUnitTest& test = tests.emplace_back(TestOf(certificate, "CertificateIsConclusive", 0));
    test.outcome = JUnitOutcome::kError;
    test.message = "inconclusive: " + overall.reason;
  }
  return JUnitSuite(certificate.subject.name, tests, AssumptionsOf(certificate));
}

}  // namespace rasterproof::report
