#include "report/junit_suite.h"

#include <cstddef>
#include <sstream>
#include <string_view>

#include "fmt/format.h"
#include "pugixml.hpp"
#include "report/text.h"

namespace rasterproof::report {
namespace {

void Set(pugi::xml_node node, const char* attribute, std::string_view value) {
  node.append_attribute(attribute).set_value(CleanText(value).c_str());
}

void AppendText(pugi::xml_node node, const std::string& text) {
  node.append_child(pugi::node_pcdata).set_value(CleanText(text).c_str());
}

void AppendTest(pugi::xml_node suite, const JUnitTest& one) {
  pugi::xml_node test = suite.append_child("testcase");
  Set(test, "classname", one.classname);
  Set(test, "name", one.name);
  Set(test, "time", fmt::format("{:.3f}", one.seconds));
  switch (one.outcome) {
    case JUnitOutcome::kPassed:
      break;
    case JUnitOutcome::kFailed: {
      pugi::xml_node failure = test.append_child("failure");
      Set(failure, "message", one.message);
      AppendText(failure, one.text);
      break;
    }
    case JUnitOutcome::kError:
      Set(test.append_child("error"), "message", one.message);
      break;
    case JUnitOutcome::kSkipped:
      Set(test.append_child("skipped"), "message", one.message);
      break;
  }
  if (!one.said.empty()) AppendText(test.append_child("system-out"), one.said + "\n");
}

}  // namespace

std::string JUnitSuite(const std::string& name, std::span<const JUnitTest> tests,
                       const std::string& said) {
  pugi::xml_document document;
  pugi::xml_node header = document.append_child(pugi::node_declaration);
  Set(header, "version", "1.0");
  Set(header, "encoding", "UTF-8");
  pugi::xml_node suite = document.append_child("testsuites").append_child("testsuite");
  Set(suite, "name", name);
  std::size_t failures = 0;
  std::size_t errors = 0;
  std::size_t skipped = 0;
  double seconds = 0;
  for (const JUnitTest& one : tests) {
    AppendTest(suite, one);
    failures += one.outcome == JUnitOutcome::kFailed ? 1 : 0;
    errors += one.outcome == JUnitOutcome::kError ? 1 : 0;
    skipped += one.outcome == JUnitOutcome::kSkipped ? 1 : 0;
    seconds += one.seconds;
  }
  if (!said.empty()) AppendText(suite.append_child("system-out"), said + "\n");
  // Totals that the format wants on the suite itself.
  Set(suite, "tests", std::to_string(tests.size()));
  Set(suite, "failures", std::to_string(failures));
  Set(suite, "errors", std::to_string(errors));
  Set(suite, "skipped", std::to_string(skipped));
  Set(suite, "time", fmt::format("{:.3f}", seconds));
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace rasterproof::report
