#include "tool/known_failures.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "core/quoted.h"
#include "core/suggestion.h"
#include "fmt/format.h"
#include "io/json_document.h"
#include "io/output.h"
#include "props/cause/cause.h"
#include "props/cause/cause_text.h"
#include "props/property.h"

namespace rasterproof::tool {
namespace {

using std::chrono::year_month_day;

constexpr std::array<std::string_view, 2> kListKeys{"rasterproof_known_failures", "failures"};
constexpr std::array<std::string_view, 5> kEntryKeysOfKnown{"property", "owner", "until", "subject",
                                                            "cause"};

std::string ReadCauseName(const io::JsonValue& value) {
  const std::string name(value.RequireString());
  const std::vector<std::string_view> names = props::CauseNames();
  if (std::ranges::find(names, name) != names.end()) return name;
  throw value.Error(Quoted(name) + " is no cause",
                    Suggestion(name, names) + "docs/causes.md has" + ListedNames(names));
}

KnownFailure ReadKnownFailure(const io::JsonValue& object) {
  object.RequireObject(kEntryKeysOfKnown);
  KnownFailure known;
  known.place = object.Place();
  known.property = object.Get("property").RequireString();
  if (props::FindProperty(known.property) == nullptr) {
    throw object.Get("property")
        .Error(Quoted(known.property) + " is no property",
               "'rasterproof list properties' names all");
  }
  known.owner = object.Get("owner").RequireName();
  if (known.owner.empty())
    throw object.Get("owner").Error("names nobody", "name the failure's owner");
  known.until = ReadDay(object.Get("until"));
  if (const auto subject = object.Find("subject")) known.subject = subject->RequireString();
  if (const auto cause = object.Find("cause")) known.cause = ReadCauseName(*cause);
  return known;
}

std::string EntryText(const KnownFailure& known) {
  std::string text = known.property;
  if (!known.cause.empty()) text += " by " + known.cause;
  return text;
}

std::string Line(std::string_view word, const Findings& found, const std::string& what) {
  return fmt::format("{:<16} {:<10} {}\n", word, found.subject, what);
}

}  // namespace

year_month_day ReadDay(const io::JsonValue& value) {
  const std::string_view text = value.RequireString();
  constexpr std::string_view kForm = "dddd-dd-dd";
  const bool has_form =
      text.size() == kForm.size() && std::ranges::equal(text, kForm, [](char c, char form) {
        return form == 'd' ? c >= '0' && c <= '9' : c == form;
      });
  const auto number = [&](std::size_t first, std::size_t digits) {
    int n = 0;
    for (const char c : text.substr(first, digits)) n = 10 * n + (c - '0');
    return n;
  };
  if (has_form) {
    const year_month_day day{std::chrono::year{number(0, 4)},
                             std::chrono::month{static_cast<unsigned>(number(5, 2))},
                             std::chrono::day{static_cast<unsigned>(number(8, 2))}};
    if (day.ok()) return day;
  }
  throw value.Error(Quoted(text) + " is no date", "write year, month and day: \"2027-01-31\"");
}

std::string DayText(year_month_day day) {
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()),
                     static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
}

std::vector<KnownFailure> ReadKnownFailures(const std::string& path) {
  const std::string text = io::ReadFile(path);
  const io::JsonDocument document(text, path == "-" ? "standard input" : path);
  const io::JsonValue root = document.root();
  root.RequireObject(kListKeys);
  root.Get("rasterproof_known_failures").RequireInteger(1, 1);  // the version
  std::vector<KnownFailure> known;
  for (const io::JsonValue item : root.Get("failures").RequireArray())
    known.push_back(ReadKnownFailure(item));
  return known;
}

bool IsKnown(const std::vector<KnownFailure>& known, year_month_day today,
             const std::string& subject, const std::string& property) {
  return std::ranges::any_of(known, [&](const KnownFailure& entry) {
    return entry.property == property && entry.cause.empty() && entry.until >= today &&
           (entry.subject.empty() || entry.subject == subject);
  });
}

void ApplyKnownFailures(const std::vector<KnownFailure>& known, year_month_day today,
                        Findings& found) {
  for (const KnownFailure& entry : known) {
    if (!entry.subject.empty() && entry.subject != found.subject) continue;
    if (entry.until < today) {
      const auto is_its = [&](const Finding& f) { return f.result.property == entry.property; };
      if (std::ranges::none_of(found.all, is_its)) continue;
      ++found.expired;
      found.notes +=
          Line("expired", found,
               fmt::format("{}: expired; {} was to fix it by {}; fix it or set a later day ({})",
                           EntryText(entry), entry.owner, DayText(entry.until), entry.place));
      continue;
    }
    bool was_asked = false;
    bool is_violated = false;
    bool is_judged = false;
    for (Finding& finding : found.all) {
      if (finding.result.property != entry.property) continue;
      was_asked = true;
      is_judged = is_judged || finding.result.outcome == Outcome::kHolds;
      if (finding.result.outcome != Outcome::kViolated) continue;
      const std::string cause =
          finding.cause ? props::NameOfCause(found.causes.all[*finding.cause]) : std::string();
      if (!entry.cause.empty() && cause != entry.cause) continue;
      is_violated = true;
      finding.is_known = true;
    }
    if (is_violated) {
      found.notes += Line("known", found,
                          fmt::format("{}: {} fixes it by {}", EntryText(entry), entry.owner,
                                      DayText(entry.until)));
    } else if (was_asked && is_judged) {
      found.notes += Line("passes", found,
                          fmt::format("{} passes now; tell {}, and remove it from the list ({})",
                                      EntryText(entry), entry.owner, entry.place));
    }
  }
}

year_month_day Today() {
  return std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
}

}  // namespace rasterproof::tool
