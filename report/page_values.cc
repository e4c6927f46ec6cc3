// What the page says of values: three questions, each answered by the properties that decide it.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fmt/format.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

struct Question {
  std::string_view asks;
  std::string_view reads;  // how the verdict is read
  std::span<const std::string_view> properties;
};

constexpr auto kOfTrust = std::to_array<std::string_view>(
    {"ValuesStayWithinTheirError", "EqualValuesStayEqual", "VerticesKeepTheirValues",
     "ValuesStayInTheHull", "ValuesAlongAnEdgeDependOnItsEnds",
     "FlatValuesComeFromTheProvokingVertex"});
constexpr auto kOfSwimming = std::to_array<std::string_view>(
    {"ValuesStayWithinTheirError", "ClipBarycentricsStayWithinTheirError",
     "ClipDepthsStayWithinTheirError", "DepthsAreOfTheirFormat"});
constexpr auto kOfSlopes = std::to_array<std::string_view>(
    {"DerivativesStayWithinTheirError", "QuadDifferencesEqualDifferencesOfValues"});
constexpr std::array<Question, 3> kQuestions{
    {{"Which interpolation may I trust, at what cost?",
      "Build on what is stated and holds: the stated error, and what is promised to the bit. The "
      "cost of a form is measured by bench --values: a page with its record shows it under \"Which "
      "interpolation may I trust\".",
      kOfTrust},
     {"My texture swims: weights or division?",
      "The cause says which. affine-weights, exchanged-weights and weights-by-w: the weights. "
      "missing-division: the division. If all of these hold, it is neither: look at derivatives, "
      "which choose the texture's level. Where values hold and barycentrics do not, only the "
      "barycentrics are wrong, and the other way round.",
      kOfSwimming},
     {"Is my du/dx right?",
      "Yes, if both hold. DerivativesStayWithinTheirError compares them with the plane's, or with "
      "the differences over quads that the profile states; "
      "QuadDifferencesEqualDifferencesOfValues compares them with the subject's own values.",
      kOfSlopes}}};

const PropertyResult* ResultOf(const Certificate& certificate, std::string_view property) {
  const auto found = std::ranges::find_if(certificate.tested, [&](const PropertyResult& result) {
    return result.property == property && result.world.empty();
  });
  return found == certificate.tested.end() ? nullptr : &*found;
}

// The largest error over what is allowed: of what held, and of the counterexample.
std::string LargestRatio(const PropertyResult& result) {
  double ratio = result.worst_ratio;
  bool is_in_ulps = false;
  if (result.counterexample) {
    const auto& numbers = result.counterexample->verdict.numbers;
    if (!numbers || numbers->list.empty()) return "";
    ratio = std::max(ratio, std::fabs(numbers->list.front().off));
    is_in_ulps = numbers->is_in_ulps;
  }
  if (ratio == 0) return "";
  return fmt::format("{:.3g}{}", ratio, is_in_ulps ? " ulps of 0" : "");
}

// The cause; else what the run said.
std::string WordsOn(const Certificate& certificate, const PropertyResult& result) {
  const auto cause = certificate.causes.find(NameOf(result));
  if (cause != certificate.causes.end()) return cause->second;
  return Said(result);
}

std::string AnswerRowsOf(const Certificate& certificate, const Question& question) {
  std::string rows;
  for (const std::string_view property : question.properties) {
    const PropertyResult* const result = ResultOf(certificate, property);
    if (result == nullptr || result->outcome == Outcome::kNotApplicable) continue;
    rows += fmt::format(
        "<tr><th scope=\"row\" class=\"name\">{}</th><td><span "
        "class=\"name\">{}</span></td><td>{}</td>"
        "<td class=\"number\" title=\"{}\">{}</td><td class=\"remark\">{}</td></tr>\n",
        Escaped(certificate.subject.name), Breakable(property), Chip(certificate, *result),
        Escaped(result->tolerance), LargestRatio(*result), Escaped(WordsOn(certificate, *result)));
  }
  return rows;
}

// What no row stands for: properties that do not apply, and why.
std::string NotApplicableList(const std::vector<const Certificate*>& subjects,
                              const Question& question) {
  std::string items;
  std::size_t count = 0;
  for (const Certificate* one : subjects) {
    for (const std::string_view property : question.properties) {
      const PropertyResult* const result = ResultOf(*one, property);
      if (result == nullptr || result->outcome != Outcome::kNotApplicable) continue;
      ++count;
      items +=
          fmt::format("<li>{}, <span class=\"name\">{}</span>: not asked: {}</li>\n",
                      Escaped(one->subject.name), Breakable(property), Escaped(result->message));
    }
  }
  if (count == 0) return "";
  return Folded(fmt::format("{} not asked, and why", Several(count, "verdict")),
                "<ul class=\"plain\">\n" + items + "</ul>\n", false);
}

std::string Answers(const std::vector<const Certificate*>& subjects, const Question& question) {
  std::string rows;
  for (const Certificate* one : subjects) rows += AnswerRowsOf(*one, question);
  const std::string rest = NotApplicableList(subjects, question);
  if (rows.empty()) return "<p>None of the properties that decide it was asked.</p>\n" + rest;
  return "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>subject</th><th>decided "
         "by</th>"
         "<th>verdict</th><th class=\"number\">error / allowed</th><th>cause, or what was said</th>"
         "</tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n" + rest;
}

std::string BoundText(const ValueMethodRow& row, std::size_t format) {
  if (row.ulps != 0) return fmt::format("{} ulp", row.ulps);
  return row.a_step == 0
             ? fmt::format("{:.4g}", row.conditions[format])
             : fmt::format("{:.4g} + {:.4g} a step", row.conditions[format], row.a_step);
}

std::string LargestText(double largest) {
  return std::isnan(largest) ? "–" : fmt::format("{:.3f}", largest);
}

std::string MethodTable(const std::vector<ValueMethodRow>& methods) {
  if (methods.empty()) return {};
  const bool has_cost = std::ranges::any_of(
      methods, [](const ValueMethodRow& row) { return row.nanoseconds.has_value(); });
  std::string rows;
  for (const ValueMethodRow& row : methods) {
    rows += fmt::format(
        "<tr><th scope=\"row\" class=\"name\">{}</th><td><code>{}</code></td>"
        "<td class=\"number\">{}</td><td class=\"number\">{}</td>"
        "<td class=\"number\">{}</td><td class=\"number\">{}</td><td>{}</td><td>{}</td>",
        Escaped(row.name), Escaped(row.computes), BoundText(row, 0), LargestText(row.largest[0]),
        BoundText(row, 1), LargestText(row.largest[1]), Escaped(row.promises), Escaped(row.proof));
    if (has_cost) {
      rows += row.nanoseconds ? fmt::format("<td class=\"number\">{:.3g}</td>", *row.nanoseconds)
                              : "<td class=\"number none\">–</td>";
    }
    rows += "</tr>\n";
  }
  return Folded(
      fmt::format("{} methods, each with its proved bound", methods.size()),
      fmt::format(
          "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>method</th>"
          "<th>computes</th><th class=\"number\">bound, float32</th><th class=\"number\">largest / "
          "bound</th><th class=\"number\">bound, float64</th><th class=\"number\">largest / "
          "bound</th><th>to the bit</th><th>proof</th>{}</tr></thead><tbody>\n",
          has_cost ? "<th class=\"number\">ns a pixel</th>" : "") +
          rows + "</tbody></table></div>\n" +
          ColumnKey({{"bound",
                      "2^-24 (float64: 2^-53) times the condition of the value, or ulps: the most "
                      "it is off"},
                     {"largest / bound", "the largest error that searches found, over the bound"},
                     {"to the bit", "equal values stay equal, vertices keep theirs, the hull"}}),
      true);
}

std::string NotAskedList(const std::vector<const Certificate*>& subjects) {
  std::string items;
  for (const Certificate* one : subjects) {
    for (const Evidence& evidence : one->not_asked) {
      const bool is_of_values = evidence.statement.find("values") != std::string::npos ||
                                evidence.statement.find("derivatives") != std::string::npos ||
                                evidence.statement.find("depth") != std::string::npos ||
                                evidence.statement.find("barycentrics") != std::string::npos;
      if (!is_of_values) continue;
      items +=
          fmt::format("<li>{}: {} <span class=\"why\">{}</span></li>\n", Escaped(one->subject.name),
                      Escaped(evidence.statement), Escaped(evidence.by));
    }
  }
  if (items.empty()) return {};
  return "<h3>Not asked</h3>\n<ul class=\"plain\">\n" + items + "</ul>\n";
}

}  // namespace

std::string ValuesSection(const std::vector<Certificate>& certificates,
                          const std::vector<ValueMethodRow>& methods) {
  std::vector<const Certificate*> subjects;
  for (const Certificate& one : certificates) {
    if (one.subject.fragments.shows_values) subjects.push_back(&one);
  }
  const std::size_t without = certificates.size() - subjects.size();
  std::string html;
  if (without != 0) {
    html += fmt::format("<p class=\"why\">{} {} no values: nothing was asked of them.</p>\n",
                        Several(without, "subject"), without == 1 ? "shows" : "show");
  }
  if (!subjects.empty()) {
    for (const Question& question : kQuestions) {
      html += fmt::format("<h3>{}</h3>\n<p>{}</p>\n", question.asks, question.reads);
      html += Answers(subjects, question);
      if (&question == &kQuestions.front()) html += MethodTable(methods);
    }
    html += NotAskedList(subjects);
  }
  return Section("values", "Values",
                 "What covered samples hold: weights, attributes, depths and derivatives, each "
                 "against the exact number.",
                 html);
}

}  // namespace rasterproof::report
