// rasterproof legal --list: whether legal models explain the drawings of a list, each its own.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/clock.h"
#include "core/error.h"
#include "fmt/format.h"
#include "io/output.h"
#include "legal/joint.h"
#include "report/grounds.h"
#include "report/junit_suite.h"
#include "report/text.h"
#include "tool/exit_status.h"
#include "tool/interrupt.h"
#include "tool/known_failures.h"
#include "tool/legal/broken_rules.h"
#include "tool/legal/cmd_legal.h"
#include "tool/legal/legal_hints.h"
#include "tool/legal/legal_list.h"
#include "tool/legal/legality.h"
#include "tool/resolve.h"

namespace rasterproof::tool {
namespace {

// What becomes of a drawing, the word of its line, and how the summary counts it.
enum class ListResult : std::uint8_t {
  kLegal,
  kKnown,
  kNotLegal,
  kPasses,
  kExpired,
  kBroken,
  kOpen
};
constexpr std::array<std::string_view, 7> kListWords{
    "legal", "known", "not legal", "passes", "expired", "breaks down", "not judged"};
constexpr std::array<std::string_view, 7> kListCounted{"legal",          "not legal as expected",
                                                       "not legal",      "unexpectedly legal",
                                                       "past their day", "broke down",
                                                       "not judged"};

struct ListLine {
  std::string name;
  ListResult result = ListResult::kLegal;
  std::string text = {};   // after the name, in one line
  std::string whole = {};  // of what is not legal: all that is known
  std::string compared = {};
  std::string assumed = {};  // lines
  double seconds = 0;
  std::uint64_t not_judged = 0;  // samples
};

// SubjectsByProfile by their profile: a list names few.
using SubjectsByProfile = std::map<std::string, std::unique_ptr<Subject>>;

Subject* SubjectForList(const LegalOptions& options, SubjectsByProfile& subjects) {
  if (options.subject.empty()) return nullptr;
  std::unique_ptr<Subject>& subject = subjects[options.profile];
  if (!subject) subject = MakeSubject(options.subject, options.profile);
  return subject.get();
}

// Reads all that is read of each drawing, so that nothing is judged of a list with a fault.
void RequireReadable(const std::vector<ListedDrawing>& list, SubjectsByProfile& subjects) {
  for (const ListedDrawing& listed : list) {
    try {
      const Subject* subject = SubjectForList(listed.options, subjects);
      const JudgedScene judged = LoadJudgedScene(listed.options, subject);
      if (subject == nullptr) ReadDrawing(listed.options, judged);
    } catch (const SubjectDoesNotRun&) {
      throw;
    } catch (const InputError& error) {
      throw InputError(listed.place + " (" + listed.name + ")", error.what(), "nothing was judged");
    }
  }
}

std::string MendsText(const ListedDrawing& listed) {
  if (!listed.until) return "";
  return fmt::format("; {} fixes it by {}", listed.owner, DayText(*listed.until));
}

void CompareWithExpected(const ListedDrawing& listed, bool is_legal,
                         std::chrono::year_month_day today, ListLine& line) {
  if (listed.until && *listed.until < today) {
    line.result = ListResult::kExpired;
    line.text = fmt::format("expired: {} was to fix it by {}; fix it or set a later day ({})",
                            listed.owner, DayText(*listed.until), listed.place);
  } else if (listed.is_legal) {
    line.result = is_legal ? ListResult::kLegal : ListResult::kNotLegal;
  } else if (is_legal) {
    line.result = ListResult::kPasses;
    line.text = fmt::format("it is legal, but expected to be illegal: {}; remove \"expected\" ({})",
                            listed.reason, listed.place);
  } else {
    line.result = ListResult::kKnown;
    line.text = listed.reason + MendsText(listed);
  }
}

ListLine JudgeListed(const ListedDrawing& listed, SubjectsByProfile& subjects,
                     std::chrono::year_month_day today) {
  ListLine line{.name = listed.name};
  Subject* const subject = SubjectForList(listed.options, subjects);
  const JudgedScene judged = LoadJudgedScene(listed.options, subject);
  const auto& [scene, profile, saved] = judged;
  const OneCall drawn =
      subject != nullptr ? DrawInOneCall(*subject, scene) : ReadDrawing(listed.options, judged);
  const auto [verdict, compared, broken] = JudgeDrawing(judged, drawn);
  line.not_judged = verdict.not_judged;
  line.text = fmt::format("profile {}; {}", profile.name, SearchText(verdict, profile));
  const int samples = profile.pattern.samples();
  if (verdict.core) {
    line.text =
        fmt::format("profile {}; {}; {}", profile.name, CoreLine(*verdict.core, scene, samples),
                    BrokenRuleText(broken, profile));
    line.whole = CoreText(*verdict.core, scene, samples) + BrokenRuleLines(broken, profile);
  }
  line.compared = "compared: " + compared;
  line.assumed = report::AssumptionLines(profile) + AssumedErrorLine(listed.options);
  line.text += "; " + line.compared;
  for (const std::string& hint : HintsOf(listed.options, judged, drawn, verdict))
    line.text += "; hint: " + hint;
  if (verdict.legality == legal::Legality::kNotJudged) {
    line.result = ListResult::kOpen;
    line.text += fmt::format("; {} samples are not judged", verdict.not_judged);
  } else {
    CompareWithExpected(listed, verdict.legality == legal::Legality::kLegal, today, line);
  }
  return line;
}

// Where the subject gives no drawing, the others of the list are judged still.
ListLine JudgeUnlessItBreaks(const ListedDrawing& listed, SubjectsByProfile& subjects,
                             std::chrono::year_month_day today) {
  const double start = WallSeconds();
  ListLine line;
  try {
    line = JudgeListed(listed, subjects, today);
  } catch (const SubjectStop& stop) {
    if (Interrupted()) throw;
    const bool broke = IsBreakdown(stop.stop());
    line = {.name = listed.name,
            .result = broke ? ListResult::kBroken : ListResult::kOpen,
            .text = broke                      ? stop.what()
                    : EndsTheCall(stop.stop()) ? fmt::format("too slow: {}", stop.what())
                                               : fmt::format("refused: {}", stop.what())};
    subjects.erase(listed.options.profile);  // the next drawing gets a new one
  }
  line.seconds = WallSeconds() - start;
  return line;
}

int StatusOfResult(ListResult result) {
  if (result == ListResult::kLegal || result == ListResult::kKnown) return kExitHolds;
  return result == ListResult::kOpen ? kExitInconclusive : kExitViolated;
}

std::string ListLineText(const ListLine& line) {
  return fmt::format("{:<12} {}: {}\n", kListWords[static_cast<std::size_t>(line.result)],
                     line.name, line.text);
}

std::string ListSummary(const std::vector<ListLine>& lines) {
  std::array<std::size_t, kListCounted.size()> counts{};
  std::uint64_t samples = 0;
  for (const ListLine& line : lines) {
    ++counts[static_cast<std::size_t>(line.result)];
    if (line.result == ListResult::kOpen) samples += line.not_judged;
  }
  std::string text = fmt::format("{} drawing{}: ", lines.size(), lines.size() == 1 ? "" : "s");
  std::string_view comma;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] == 0) continue;
    text += fmt::format("{}{} {}", comma, counts[k], kListCounted[k]);
    comma = "; ";
  }
  if (samples != 0) text += fmt::format(" ({} samples)", samples);
  return text + "\n";
}

report::JUnitTest TestOfLine(const ListLine& line, const std::string& classname) {
  report::JUnitTest test{.classname = classname, .name = line.name, .seconds = line.seconds};
  test.said = line.compared;
  if (!line.assumed.empty()) test.said += "\n" + line.assumed.substr(0, line.assumed.size() - 1);
  switch (line.result) {
    case ListResult::kLegal:
      break;
    case ListResult::kKnown:
      test.outcome = report::JUnitOutcome::kSkipped;
      test.message = "not legal, as expected: " + line.text;
      break;
    case ListResult::kOpen:
      test.outcome = report::JUnitOutcome::kError;  // skipped, it would look as good as known
      test.message = "not judged: " + line.text;
      break;
    case ListResult::kNotLegal:
    case ListResult::kPasses:
    case ListResult::kExpired:
    case ListResult::kBroken:
      test.outcome = report::JUnitOutcome::kFailed;
      test.message =
          fmt::format("{}: {}", kListWords[static_cast<std::size_t>(line.result)], line.text);
      test.text = test.message + "\n" + line.whole + line.assumed;
      break;
  }
  return test;
}

std::string ListXml(const std::vector<ListLine>& lines, const LegalOptions& options) {
  std::vector<report::JUnitTest> tests;
  for (const ListLine& line : lines)
    tests.push_back(TestOfLine(line, options.subject.empty() ? "legal" : options.subject));
  return report::JUnitSuite("legal " + options.list, tests,
                            ListSummary(lines) + AssumedErrorLine(options));
}

}  // namespace

int JudgeList(const LegalOptions& options) {
  if (!options.scene.path.empty()) {
    throw InputError("--list", "the list already names the scenes",
                     "leave out " + options.scene.path);
  }
  io::RequireFileCanBe(options.junit);
  const std::vector<ListedDrawing> list = ReadLegalList(options.list, options);
  SubjectsByProfile subjects;
  RequireReadable(list, subjects);
  const std::chrono::year_month_day today = Today();
  std::vector<ListLine> lines;
  int status = kExitHolds;
  for (const ListedDrawing& listed : list) {
    lines.push_back(JudgeUnlessItBreaks(listed, subjects, today));
    status = WorseStatus(status, StatusOfResult(lines.back().result));
    if (options.junit != "-")
      io::WriteStandardOutput(report::CleanText(ListLineText(lines.back())));
  }
  if (!options.junit.empty()) io::WriteOutput(options.junit, ListXml(lines, options));
  if (options.junit != "-") {
    io::WriteStandardOutput(report::CleanText(ListSummary(lines)) + AssumedErrorLine(options));
  }
  return status;
}

}  // namespace rasterproof::tool
