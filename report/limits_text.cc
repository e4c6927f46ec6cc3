#include "report/limits_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "fmt/format.h"

namespace rasterproof::report {
namespace {

// The names behind the text, in lines of at most 100 columns.
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

// One row of numbers: there are thousands. NaN is no number of JSON.
void WritePoint(JsonWriter& json, const BenchPoint& point, bool is_cost) {
  const auto number = [](double x) {
    return std::isfinite(x) ? fmt::format("{:.6g}", x) : fmt::format("\"{}\"", x);
  };
  const std::string what = is_cost
                               ? fmt::format("{}, {}, {}", number(point.time.low),
                                             number(point.time.median), number(point.time.high))
                               : fmt::format("{}, {}, {}", point.wrong, number(point.displacement),
                                             number(point.share_of_bound));
  json.Value(fmt::format("[{}, {}, {}]", number(point.value), point.asked, what));
}

// The method by what tells it from others, and the parameter by its name.
void WriteWhose(JsonWriter& json, const BenchResult& result, std::uint32_t method,
                std::uint32_t parameter) {
  json.Key("method").Text(result.methods[method].name);
  json.Key("target").Text(result.methods[method].target);
  json.Key("sink").Text(result.methods[method].sink);
  json.Key("parameter").Text(result.parameters[parameter].name);
}

void WriteCurve(JsonWriter& json, const BenchResult& result, const BenchCurve& curve) {
  json.BeginObject();
  WriteWhose(json, result, curve.method, curve.parameter);
  json.Key("points").BeginArray();
  for (const BenchPoint& point : curve.points) {
    WritePoint(json, point, result.parameters[curve.parameter].is_cost);
  }
  json.EndArray();
  json.EndObject();
}

// Its exact value: cliffs are told to the last digit.
void WriteValue(JsonWriter& json, std::string_view key, double value) {
  if (std::isnan(value)) return;
  json.Key(key).Value(fmt::format("{:.17g}", value));
}

void WriteCliff(JsonWriter& json, const BenchResult& result, const BenchCliff& cliff) {
  json.BeginObject();
  WriteWhose(json, result, cliff.method, cliff.parameter);
  WriteValue(json, "proved_to", cliff.proved_to);
  WriteValue(json, "held_to", cliff.held_to);
  WriteValue(json, "first_failing", cliff.first_failing);
  json.Key("text").Text(CliffText(cliff));
  if (cliff.scene) {
    json.Key("case").BeginObject();
    json.Key("width").Integer(cliff.scene->width);
    json.Key("height").Integer(cliff.scene->height);
    json.Key("vertices").BeginArray();
    for (const Vertex& v : cliff.scene->vertices) {
      json.BeginArray().Exact(v.x).Exact(v.y);
      if (cliff.scene->clip_space) json.Exact(v.z).Exact(v.w);
      json.EndArray();
    }
    json.EndArray();
    json.Key("x").Integer(cliff.x);
    json.Key("y").Integer(cliff.y);
    json.EndObject();
  }
  json.EndObject();
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

void WriteLimits(JsonWriter& json, const BenchResult& result) {
  json.Key("parameters").BeginArray();
  for (const BenchParameter& parameter : result.parameters) {
    json.BeginObject();
    json.Key("name").Text(parameter.name);
    json.Key("summary").Text(parameter.summary);
    json.Key("unit").Text(parameter.unit);
    json.Key("cost").Bool(parameter.is_cost);
    json.EndObject();
  }
  json.EndArray();
  json.Key("curves").BeginArray();
  for (const BenchCurve& curve : result.curves) WriteCurve(json, result, curve);
  json.EndArray();
  json.Key("cliffs").BeginArray();
  for (const BenchCliff& cliff : result.cliffs) WriteCliff(json, result, cliff);
  json.EndArray();
}

}  // namespace rasterproof::report
