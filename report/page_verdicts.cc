// What the page says first: a sentence, and the subjects in groups by what they state.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fmt/format.h"
#include "fmt/ranges.h"
#include "report/page_parts.h"
#include "report/real_profile.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

using Subjects = std::vector<const Certificate*>;

enum class Group : std::uint8_t { kExact, kNothing, kHomogeneous };

Group GroupOf(const Certificate& certificate) {
  const SubjectInfo& info = certificate.subject;
  if (info.takes_clip && !info.takes_window) return Group::kHomogeneous;
  return info.states_exact ? Group::kExact : Group::kNothing;
}

struct Heading {
  Group group;
  std::string_view anchor;
  std::string_view title;
  std::string_view intro;
};

// What comes from outside states a profile, and no more than that.
std::array<Heading, 3> Headings(bool is_survey) {
  const Heading naive{
      Group::kNothing, "states-nothing", "Naive, there to fail",
      "Plain arithmetic that claims nothing: a violation shows where it goes wrong."};
  const Heading asked{Group::kNothing, "states-a-profile", "States a profile",
                      "Held to the profile that it states. A violation is a finding."};
  return {
      {{Group::kExact, "states-exact", "States exact coverage",
        "States 0 wrong samples under its own profile. A violation would be a bug."},
       is_survey ? naive : asked,
       {Group::kHomogeneous, "homogeneous", "Homogeneous",
        is_survey ? "Takes triangles in clip space, by x, y and w. What does not claim to be exact "
                    "is there to fail."
                  : "Takes triangles in clip space, by x, y and w."}}};
}

std::size_t CountOf(const Subjects& subjects, Outcome outcome) {
  return static_cast<std::size_t>(std::ranges::count_if(
      subjects, [&](const Certificate* one) { return OverallOf(*one).outcome == outcome; }));
}

// "5 hold, 1 violated".
std::string Counts(const Subjects& subjects) {
  std::vector<std::string> parts;
  if (const std::size_t n = CountOf(subjects, Outcome::kHolds); n != 0) {
    parts.push_back(fmt::format("{} {}", n, n == 1 ? "holds" : "hold"));
  }
  for (const Outcome outcome : {Outcome::kViolated, Outcome::kInconclusive}) {
    const std::size_t n = CountOf(subjects, outcome);
    if (n != 0) parts.push_back(fmt::format("{} {}", n, OutcomeName(outcome)));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

// Wrong samples over the scenes that count, and where most of them are.
struct Wrong {
  std::uint64_t samples = 0;
  std::uint64_t wrong = 0;
  const SceneResult* worst = nullptr;
};

enum class Counted : std::uint8_t { kJudged, kObserved };

// A scene may be there twice: under the subject's own profile, and that is the real one. A
// difference from the canonical model of a profile that leaves others legal is none.
Wrong WrongOf(const Certificate& certificate, std::string_view profile, Counted counted) {
  Wrong sum;
  for (const SceneResult& result : certificate.measured) {
    if (Find(certificate, result.scene, profile) != &result) continue;
    if (!result.applicable || !result.message.empty()) continue;
    if (counted == Counted::kJudged && !IsJudged(certificate, result)) continue;
    const std::uint64_t wrong = result.difference.wrong;
    sum.samples += result.difference.samples;
    sum.wrong += wrong;
    if (wrong != 0 && (sum.worst == nullptr || wrong > sum.worst->difference.wrong)) {
      sum.worst = &result;
    }
  }
  return sum;
}

std::string WrongCell(const Wrong& wrong) {
  if (wrong.samples == 0) return "<td class=\"number none\">–</td>";
  return fmt::format("<td class=\"number {}\" title=\"of {}\">{}</td>",
                     wrong.wrong == 0 ? "zero" : "wrong", Grouped(wrong.samples),
                     Grouped(wrong.wrong));
}

std::string WorstCell(const SceneResult* worst) {
  if (worst == nullptr) return "<td class=\"none most\">–</td>";
  return fmt::format(
      "<td class=\"most\"><span class=\"name\">{}</span> <span class=\"why\">{}</span></td>",
      Escaped(worst->scene), Grouped(worst->difference.wrong));
}

std::string Row(const Certificate& certificate) {
  const auto count = [&](Outcome outcome) {
    return static_cast<std::uint64_t>(
        std::ranges::count(certificate.tested, outcome, &PropertyResult::outcome));
  };
  const Overall overall = OverallOf(certificate);
  const Wrong own = WrongOf(certificate, certificate.subject.profile.name, Counted::kJudged);
  std::string row = fmt::format("<tr><th scope=\"row\">{}</th><td title=\"{}\">{}{}</td>",
                                Link(certificate), Escaped(overall.reason), Chip(overall.outcome),
                                certificate.interrupted ? " interrupted" : "");
  const auto lacks = static_cast<std::uint64_t>(std::ranges::count_if(
      certificate.tested,
      [&](const PropertyResult& result) { return IsLackOfQuality(result, certificate.fail_on); }));
  row += Number(count(Outcome::kHolds)) + Number(count(Outcome::kViolated) - lacks, "wrong") +
         Number(lacks) + Number(count(Outcome::kNotExercised) + count(Outcome::kInconclusive));
  row += WrongCell(own) + WorstCell(own.worst);
  return row + WrongCell(WrongOf(certificate, kRealProfile, Counted::kObserved)) + "</tr>\n";
}

std::string Table(const Subjects& subjects) {
  std::string html =
      "<div class=\"scroll\"><table class=\"sorts "
      "verdicts\"><thead><tr><th>subject</th><th>verdict</th>"
      "<th class=\"number\">hold</th><th class=\"number\">violated</th>"
      "<th class=\"number\">quality</th><th class=\"number\">open</th><th class=\"number\">wrong "
      "samples</th>"
      "<th>most on</th><th class=\"number\">off real geometry</th></tr></thead><tbody>\n";
  for (const Certificate* one : subjects) html += Row(*one);
  return html + "</tbody></table></div>\n";
}

std::string GroupHtml(const Heading& heading, const Subjects& subjects) {
  if (subjects.empty()) return {};
  const std::string summary =
      fmt::format("<strong>{}</strong> <span class=\"why\">{}: {}</span>", heading.title,
                  Several(subjects.size(), "subject"), Counts(subjects));
  return fmt::format("<div id=\"{}\" class=\"group\">\n{}</div>\n", heading.anchor,
                     Folded(summary, fmt::format("<p>{}</p>\n", heading.intro) + Table(subjects),
                            subjects.size() <= kMostUnfolded));
}

std::string OneSubject(const Certificate& certificate) {
  const Overall overall = OverallOf(certificate);
  const std::string name = Escaped(certificate.subject.name);
  std::string text;
  if (overall.outcome == Outcome::kHolds) {
    text = fmt::format("{} holds all that it states.", name);
    if (!certificate.contract_thin.empty())
      text += " But " + Escaped(certificate.contract_thin) + ".";
  } else {
    text =
        fmt::format("{} is {}: {}.", name, OutcomeName(overall.outcome), Escaped(overall.reason));
  }
  return text;
}

std::string ManySubjects(const Subjects& subjects) {
  return subjects.size() == CountOf(subjects, Outcome::kHolds)
             ? fmt::format("All {} subjects hold what they state.", subjects.size())
             : fmt::format("Of {} subjects: {}.", subjects.size(), Counts(subjects));
}

// Naive methods that fail are no bad news: the run shows what they are there for.
std::string Naive(const Subjects& methods) {
  const std::size_t violated = CountOf(methods, Outcome::kViolated);
  if (violated != methods.size()) {
    return fmt::format("Of {}, there to fail, {} {} found wrong.",
                       Several(methods.size(), "naive method"), violated,
                       violated == 1 ? "was" : "were");
  }
  return violated == 1
             ? "The naive method, there to fail, was found wrong."
             : fmt::format("All {} naive methods, there to fail, were found wrong.", violated);
}

std::string Survey(const Subjects& subjects) {
  Subjects exact;
  Subjects others;
  for (const Certificate* one : subjects) {
    (one->subject.states_exact ? exact : others).push_back(one);
  }
  std::string text;
  if (!exact.empty() && CountOf(exact, Outcome::kHolds) == exact.size()) {
    text = exact.size() == 1
               ? "The subject that states exact coverage holds. "
               : fmt::format("All {} subjects that state exact coverage hold. ", exact.size());
  } else if (!exact.empty()) {
    text = fmt::format("Of {} that state exact coverage: {}. ", Several(exact.size(), "subject"),
                       Counts(exact));
  }
  return others.empty() ? text : text + Naive(others);
}

}  // namespace

std::string VerdictSentence(const Page& page) {
  if (page.certificates.empty()) return "No subject was certified.";
  Subjects subjects;
  for (const Certificate& one : page.certificates) subjects.push_back(&one);
  std::string text = page.is_survey         ? Survey(subjects)
                     : subjects.size() == 1 ? OneSubject(*subjects.front())
                                            : ManySubjects(subjects);
  if (std::ranges::any_of(page.certificates, &Certificate::interrupted)) {
    text += " The run was interrupted: this is what is known so far.";
  }
  return text;
}

std::string VerdictGroups(const Page& page) {
  std::string html;
  for (const Heading& heading : Headings(page.is_survey)) {
    Subjects subjects;
    for (const Certificate& one : page.certificates) {
      if (GroupOf(one) == heading.group) subjects.push_back(&one);
    }
    html += GroupHtml(heading, subjects);
  }
  if (html.empty()) return {};
  return html +
         ColumnKey({{"hold, violated", "properties of the catalogue with this outcome"},
                    {"quality", "properties violated that no clause requires"},
                    {"open", "properties that were not exercised or could not be judged"},
                    {"wrong samples",
                     "samples of the scenes that the subject's own profile judges, drawn otherwise "
                     "than the exact oracle has it"},
                    {"most on", "the scene with most of them"},
                    {"off real geometry",
                     "the same against exact real geometry: observed, not judged, where the "
                     "subject's profile is another"}});
}

}  // namespace rasterproof::report
