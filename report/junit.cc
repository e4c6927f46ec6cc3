// The certificate for programs that read JUnit XML, as most build servers do.
#include <cstdint>
#include <sstream>
#include <string>

#include "fmt/format.h"
#include "pugixml.hpp"
#include "report/certificate.h"
#include "report/grounds.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

/// Totals that the format wants on the suite itself.
struct Totals {
  std::uint64_t tests = 0;
  std::uint64_t failures = 0;
  std::uint64_t errors = 0;
  std::uint64_t skipped = 0;
  double seconds = 0;
};

void Set(pugi::xml_node node, const char* attribute, std::string_view value) {
  node.append_attribute(attribute).set_value(CleanText(value).c_str());
}

pugi::xml_node AppendCase(pugi::xml_node suite, const Certificate& certificate,
                          const std::string& name, double seconds, Totals& totals) {
  pugi::xml_node test = suite.append_child("testcase");
  Set(test, "classname", certificate.subject.name);
  Set(test, "name", name);
  Set(test, "time", fmt::format("{:.3f}", seconds));
  ++totals.tests;
  totals.seconds += seconds;
  return test;
}

void Fail(pugi::xml_node test, const std::string& message, const std::string& text,
          Totals& totals) {
  pugi::xml_node failure = test.append_child("failure");
  Set(failure, "message", message);
  failure.append_child(pugi::node_pcdata).set_value(CleanText(text).c_str());
  ++totals.failures;
}

void Skip(pugi::xml_node test, const std::string& reason, Totals& totals) {
  Set(test.append_child("skipped"), "message", reason);
  ++totals.skipped;
}

// What is neither failed nor skipped and still wants to be read.
void Say(pugi::xml_node test, const std::string& text) {
  test.append_child("system-out")
      .append_child(pugi::node_pcdata)
      .set_value(CleanText(text + "\n").c_str());
}

void AppendProperty(pugi::xml_node suite, const Certificate& certificate,
                    const PropertyResult& result, Totals& totals) {
  pugi::xml_node test = AppendCase(suite, certificate, NameOf(result), result.seconds, totals);
  const std::string said = Said(result);
  switch (result.outcome) {
    case Outcome::kHolds:
      if (IsExhausted(result))
        Say(test, fmt::format("exhausted: all {0} of {0} cases", result.cases));
      if (result.cases_refused != 0 || result.not_judged != 0) Say(test, said);
      break;
    case Outcome::kViolated: {
      if (IsLackOfQuality(result, certificate.fail_on)) {
        Say(test, AuthorityText(result) + "; " + said);
        break;
      }
      std::string text = result.clause + "\n" + AuthorityText(result) + "\n" + said + "\n";
      if (result.counterexample && result.counterexample->verdict.witness) {
        const Witness& w = *result.counterexample->verdict.witness;
        text += fmt::format(
            "triangle {}, edge {}, pixel ({}, {}), sample {}: observed {}, "
            "expected {}\n",
            w.triangle, w.edge, w.x, w.y, w.sample, w.observed, w.expected);
      }
      text += "replay: " + ReplayCommand(certificate, result) + "\n";
      Fail(test, result.message.empty() ? "violated" : result.message, text, totals);
      break;
    }
    case Outcome::kNotExercised:
    case Outcome::kNotApplicable:
    case Outcome::kRefused:
    case Outcome::kInconclusive: {
      std::string reason(OutcomeName(result.outcome));
      if (!said.empty()) reason += ": " + said;
      Skip(test, reason, totals);
      break;
    }
  }
}

// Appends a scene against the subject's own profile as a separate test: otherwise the file could be
// green and the verdict not.
void AppendScene(pugi::xml_node suite, const Certificate& certificate, const SceneResult& result,
                 Totals& totals) {
  if (result.profile != certificate.subject.profile.name) return;
  const std::string name = fmt::format("SceneMatchesModel: {}", result.scene);
  pugi::xml_node test = AppendCase(suite, certificate, name, result.seconds, totals);
  const std::string why = WhyNotJudged(certificate, result);
  if (!why.empty()) {
    Skip(test, why, totals);
    return;
  }
  const CoverageDifference& difference = result.difference;
  if (difference.wrong == 0) return;
  const std::string message = fmt::format(
      "{} of {} samples wrong, {} missing, {} unexpected, against profile {}", difference.wrong,
      difference.samples, difference.missing, difference.unexpected, result.profile);
  Fail(test, message, message + "\n", totals);
}

// A file in which nothing failed is green wherever it is read, however much of it was skipped.
void AppendOverall(pugi::xml_node suite, const Certificate& certificate, Totals& totals) {
  const Overall overall = OverallOf(certificate);
  if (overall.outcome != Outcome::kInconclusive) return;
  pugi::xml_node test = AppendCase(suite, certificate, "CertificateIsConclusive", 0, totals);
  Set(test.append_child("error"), "message", "inconclusive: " + overall.reason);
  ++totals.errors;
}

// Behind all tests, where the format has room for it.
void AppendAssumptions(pugi::xml_node suite, const Certificate& certificate) {
  std::string text;
  for (const Evidence& one : AssumptionsUnder(certificate.subject.profile)) {
    text += fmt::format("{}assumed: {}: {}", text.empty() ? "" : "\n", one.statement, one.by);
  }
  if (!text.empty()) Say(suite, text);
}

}  // namespace

std::string JUnitXml(const Certificate& certificate) {
  pugi::xml_document document;
  pugi::xml_node header = document.append_child(pugi::node_declaration);
  Set(header, "version", "1.0");
  Set(header, "encoding", "UTF-8");
  pugi::xml_node suite = document.append_child("testsuites").append_child("testsuite");
  Set(suite, "name", certificate.subject.name);
  Totals totals;
  for (const PropertyResult& result : certificate.tested) {
    AppendProperty(suite, certificate, result, totals);
  }
  for (const SceneResult& result : certificate.measured) {
    AppendScene(suite, certificate, result, totals);
  }
  AppendOverall(suite, certificate, totals);
  AppendAssumptions(suite, certificate);
  Set(suite, "tests", std::to_string(totals.tests));
  Set(suite, "failures", std::to_string(totals.failures));
  Set(suite, "errors", std::to_string(totals.errors));
  Set(suite, "skipped", std::to_string(totals.skipped));
  Set(suite, "time", fmt::format("{:.3f}", totals.seconds));
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace rasterproof::report
