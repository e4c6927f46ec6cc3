// What the page says of values beside the certificates: methods with their bounds, and causes.
#include <memory>
#include <string>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "core/result.h"
#include "core/subject.h"
#include "fmt/format.h"
#include "props/cause/evidence.h"
#include "props/cause/value_mistakes.h"
#include "reference/value_figures.h"
#include "reference/value_methods.h"
#include "report/certificate.h"
#include "report/page.h"
#include "tool/certify/certify.h"
#include "tool/resolve.h"

namespace rasterproof::tool {
namespace {

constexpr double kSecondsACause = 4;

std::string Listed(std::string list, bool holds, const char* what) {
  if (!holds) return list;
  return list.empty() ? what : list + ", " + what;
}

std::string CauseOf(Subject& subject, const PropertyResult& result) {
  const auto failed = props::FailedBy(result, subject.Info());
  if (!failed || !props::IsAboutShownNumbers(failed->property->gate.shows)) return "";
  const props::ValueMistake mistake = props::FindValueMistake(subject, *failed, kSecondsACause);
  if (mistake.name.empty()) return "";
  std::string text = "it " + mistake.what.front();
  for (std::size_t k = 1; k < mistake.what.size(); ++k) text += ", or it " + mistake.what[k];
  return text + fmt::format(" ({0} of {0} numbers): {1}", mistake.numbers, mistake.name);
}

}  // namespace

std::vector<report::ValueMethodRow> ValueMethodRows() {
  std::vector<report::ValueMethodRow> rows;
  for (const reference::ValueMethod& method : reference::ValueMethods()) {
    report::ValueMethodRow& row = rows.emplace_back();
    row.name = method.name;
    row.computes = method.computes;
    row.conditions = method.conditions;
    row.a_step = method.conditions_a_step;
    row.ulps = method.ulps;
    row.largest = reference::LargestRatiosOf(method.name);
    row.promises = Listed(row.promises, method.equal_stay_equal, "equal");
    row.promises = Listed(row.promises, method.exact_at_vertices, "vertices");
    row.promises = Listed(row.promises, method.stays_in_hull, "hull");
    row.proof = method.ulps != 0 ? "exact sums" : "reference/proofs/value_methods.g";
  }
  return rows;
}

void ExplainValues(std::vector<report::Certificate>& certificates, Progress& progress) {
  for (report::Certificate& certificate : certificates) {
    if (!certificate.subject.fragments.shows_values) continue;
    progress.Stage("explaining values of " + certificate.subject.name);
    for (const PropertyResult& result : certificate.tested) {
      if (result.outcome != Outcome::kViolated) continue;
      try {
        const std::unique_ptr<Subject> subject = MakeSubject(certificate.subject.name);
        const std::string cause = CauseOf(*subject, result);
        if (!cause.empty()) certificate.causes[NameOf(result)] = cause;
      } catch (const InputError&) {
        return;  // it refuses now what it took, and the page has a cause less
      } catch (const SubjectStop&) {
        return;
      }
    }
  }
}

}  // namespace rasterproof::tool
