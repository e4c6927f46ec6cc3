#include "report/limits_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "fmt/format.h"

namespace rasterproof::report {
namespace {

// Returns the text followed by the names, in lines of at most 100 columns.
std::string Indented(const std::string& text, const std::vector<std::string>& names) {
  constexpr std::size_t kColumns = 98;
  std::string all;
  std::string line = "  " + text;
  for (const std::string& name : names) {
    const std::string next = &name == &names.back() ? name : name + ", ";
    if (line.size() + next.size() > kColumns) {
      all += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
      line = "    ";
    }
    line += next;
  }
  return all + line + "\n";
}

std::string SectionOf(const BenchResult& result, std::uint32_t at) {
  const BenchParameter& parameter = result.parameters[at];
  // Methods of which the same is said stand together.
  std::vector<std::pair<std::string, std::vector<std::string>>> lines;
  for (const BenchCliff& cliff : result.cliffs) {
    if (cliff.parameter != at) continue;
    const std::string text = CliffText(cliff);
    auto line = std::ranges::find(lines, text, &decltype(lines)::value_type::first);
    if (line == lines.end()) line = lines.insert(line, {text, {}});
    line->second.push_back(result.methods[cliff.method].name);
  }
  if (lines.empty()) return "";
  std::string section;
  for (const auto& [text, names] : lines) section += Indented(text + ": ", names);
  const std::string unit = parameter.unit == "1" ? "" : "; in " + parameter.unit;
  return fmt::format("\n{}: {}{}.\n{}", parameter.name, parameter.summary, unit, section);
}

}  // namespace

std::string ValueText(double value) {
  const auto power_of = [](double x) { return x == std::ldexp(1.0, std::ilogb(x)); };
  if (value >= 1 && value < 0x1p20) return fmt::format("{:.17g}", value);
  if (power_of(value)) return fmt::format("2^{}", std::ilogb(value));
  if (value < 0x1p53 && power_of(value - 1)) return fmt::format("2^{} + 1", std::ilogb(value - 1));
  if (value < 0x1p53 && power_of(value + 1)) return fmt::format("2^{} - 1", std::ilogb(value + 1));
  return value < 0x1p53 ? fmt::format("{:.17g}", value) : fmt::format("{:.6g}", value);
}

std::string CliffText(const BenchCliff& cliff) {
  const bool is_proved = !std::isnan(cliff.proved_to);
  const bool is_failing = !std::isnan(cliff.first_failing);
  std::string text = is_proved ? "proved to " + ValueText(cliff.proved_to) : "nothing proved";
  if (!is_failing) return text + ", seen holding to " + ValueText(cliff.held_to);
  text += ", first seen failing at " + ValueText(cliff.first_failing);
  if (is_proved && cliff.first_failing <= cliff.proved_to) {
    return text + ", which contradicts the proof";
  }
  if (!is_proved && std::isnan(cliff.held_to)) return text + ", the least value tried";
  if (is_proved && cliff.first_failing > cliff.proved_to + 1) text += ", not proved between";
  if (!is_proved && !std::isnan(cliff.held_to)) {
    text += ", seen holding at " + ValueText(cliff.held_to);
  }
  return text;
}

std::string LimitsToTable(const BenchResult& result) {
  std::string table =
      "Up to which value each method is right, by its own model: the hardest triangles known of\n"
      "2^k - 1, 2^k, 2^k + 1 and 3 2^(k - 1) are drawn until one fails; what is between is "
      "bisected.\n";
  for (std::size_t at = 0; at < result.parameters.size(); ++at) {
    table += SectionOf(result, static_cast<std::uint32_t>(at));
  }
  return table;
}

}  // namespace rasterproof::report
