#include "report/bench_plot.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/json_writer.h"

namespace rasterproof::report {
namespace {

// The method that a reader would write first: what every other one is compared with by eye.
constexpr std::string_view kNaive = "textbook";

double PerMillion(std::uint64_t count, std::uint64_t of) {
  return of == 0 ? 0 : 1e6 * static_cast<double>(count) / static_cast<double>(of);
}

double WrongPerMillion(const BenchRow& row) {
  return PerMillion(row.against_real.wrong, row.box_pixels);
}

// Families in the order of their first row, each with its rows, cheapest first.
struct FamilyRows {
  std::string family;
  std::vector<const BenchRow*> rows;
};

std::vector<FamilyRows> ByFamily(const BenchResult& result) {
  std::vector<FamilyRows> families;
  for (const BenchRow& row : result.rows) {
    auto found = std::ranges::find(families, row.family, &FamilyRows::family);
    if (found == families.end()) found = families.insert(found, {row.family, {}});
    found->rows.push_back(&row);
  }
  for (FamilyRows& family : families) {
    // Rows of the same time keep their order: they lie in one array.
    std::ranges::sort(family.rows, {},
                      [](const BenchRow* row) { return std::pair(row->ratio, row); });
  }
  return families;
}

bool IsOnFront(const BenchRow& row, const std::vector<const BenchRow*>& rivals) {
  return std::ranges::none_of(rivals, [&](const BenchRow* rival) {
    const double wrong = WrongPerMillion(*rival);
    const bool no_worse = rival->ratio <= row.ratio && wrong <= WrongPerMillion(row);
    return no_worse && (rival->ratio < row.ratio || wrong < WrongPerMillion(row));
  });
}

// What the colour of its point tells.
std::string_view ArithmeticOf(const BenchRow& row) {
  return row.subject == kNaive ? kNaive : std::string_view(row.arithmetic);
}

double MedianRatio(const BenchRow& row) {
  return row.least_seconds > 0 ? row.ratio * row.median_seconds / row.least_seconds : 0;
}

void WriteDifference(JsonWriter& json, std::string_view key, const CoverageDifference& difference,
                     std::uint64_t box_pixels) {
  json.Key(key).BeginObject();
  json.Key("samples").Integer(difference.samples);
  json.Key("covered").Integer(difference.covered);
  json.Key("wrong").Integer(difference.wrong);
  json.Key("missing").Integer(difference.missing);
  json.Key("unexpected").Integer(difference.unexpected);
  json.Key("wrong_per_million_box_pixels").Rounded(PerMillion(difference.wrong, box_pixels));
  json.Key("wrong_per_million_covered").Rounded(PerMillion(difference.wrong, difference.covered));
  json.EndObject();
}

void WritePoint(JsonWriter& json, const BenchRow& row, const FamilyRows& family,
                const BenchResult& result) {
  const bool front = IsOnFront(row, family.rows);
  const std::string_view arithmetic = ArithmeticOf(row);
  // Names of the points that the eye looks for; a name at every point would hide them.
  const bool named = front || row.subject == result.baseline || arithmetic == kNaive ||
                     arithmetic == "fixed point";
  json.BeginObject();
  json.Key("family").Text(row.family);
  json.Key("subject").Text(row.subject);
  json.Key("ratio").Rounded(row.ratio);
  json.Key("wrong").Rounded(WrongPerMillion(row));
  json.Key("front").Bool(front);
  json.Key("arithmetic").Text(arithmetic);
  json.Key("label").Text(named ? row.subject : "");
  json.EndObject();
}

// How the points are drawn. Of each panel: the front's line, the points, the names of those that
// matter. Error is on a symmetric-logarithmic axis, which has a place for 0.
constexpr std::string_view kPanel = R"({
    "width": 420,
    "height": 250,
    "layer": [
      {
        "transform": [{"filter": "datum.front"}],
        "mark": {"type": "line", "interpolate": "step-after", "color": "#009e73", "opacity": 0.6}
      },
      {
        "mark": {"type": "point", "filled": true, "size": 75, "opacity": 0.85},
        "encoding": {
          "color": {"field": "arithmetic", "type": "nominal", "title": null,
                    "scale": {"domain": ["textbook", "float32", "float64", "fixed point", "exact",
                                         "other"],
                              "range": ["#d55e00", "#0072b2", "#56b4e9", "#e69f00", "#009e73",
                                        "#8a8f98"]}},
          "shape": {"field": "arithmetic", "type": "nominal", "title": null,
                    "scale": {"domain": ["textbook", "float32", "float64", "fixed point", "exact",
                                         "other"],
                              "range": ["diamond", "circle", "circle", "square", "triangle-up",
                                        "cross"]}}
        }
      },
      {
        "transform": [{"filter": "datum.arithmetic != 'textbook'"}],
        "mark": {"type": "text", "align": "left", "dx": 7, "dy": -8, "fontSize": 11,
                 "color": "#3a3f48"},
        "encoding": {"text": {"field": "label", "type": "nominal"}}
      },
      {
        "transform": [{"filter": "datum.arithmetic == 'textbook'"}],
        "mark": {"type": "text", "align": "left", "dx": 5, "dy": -22, "fontSize": 11,
                 "color": "#b84a00"},
        "encoding": {"text": {"field": "label", "type": "nominal"}}
      }
    ],
    "encoding": {
      "x": {"field": "ratio", "type": "quantitative",
            "scale": {"type": "log", "nice": false, "padding": 24},
            "axis": {"values": [0.01, 0.03, 0.1, 0.3, 1, 3], "format": "~g"},
            "title": "run time over the baseline's"},
      "y": {"field": "wrong", "type": "quantitative",
            "scale": {"type": "symlog", "constant": 0.3},
            "axis": {"values": [0, 1, 10, 100, 1000, 10000, 100000, 1000000], "format": ",d"},
            "title": "wrong samples per million box pixels"}
    }
  })";
constexpr std::string_view kConfig = R"({
    "font": "DejaVu Sans, Helvetica, Arial, sans-serif",
    "view": {"stroke": null},
    "axis": {"gridColor": "#eceef1", "domainColor": "#b8bdc6", "tickColor": "#b8bdc6",
             "labelColor": "#626975", "titleColor": "#3a3f48", "titleFontWeight": "normal",
             "labelFontSize": 11, "titleFontSize": 12, "titlePadding": 8},
    "header": {"labelFontSize": 14, "labelColor": "#23262d", "labelPadding": 4},
    "legend": {"labelFontSize": 12, "labelColor": "#3a3f48", "symbolSize": 90, "orient": "top"}
  })";

}  // namespace

std::string BenchToTable(const BenchResult& result) {
  std::string table = fmt::format(
      "Time: least of {} interleaved draws, thread CPU time, over that of {} (median in "
      "brackets).\n"
      "Wrong samples: against real geometry, and against the subject's own profile.\n",
      result.repetitions, result.baseline);
  for (const FamilyRows& family : ByFamily(result)) {
    const BenchRow& first = *family.rows.front();
    table += fmt::format("\n{}: {} triangles, {} box pixels, {} samples covered\n", family.family,
                         first.triangles, first.box_pixels, first.against_real.covered);
    table += fmt::format("  {:<28} {:>17} {:>12} {:>12} {:>9} {:>9} {:>9}\n", "subject", "time",
                         "wrong / M box", "/ M covered", "missing", "unexpected", "own wrong");
    for (const BenchRow* row : family.rows) {
      table += fmt::format("  {:<28} {:>8.3f} ({:>6.3f}) {:>13.4g} {:>12.4g} {:>9} {:>9} {:>9}\n",
                           row->subject, row->ratio, MedianRatio(*row), WrongPerMillion(*row),
                           PerMillion(row->against_real.wrong, row->against_real.covered),
                           row->against_real.missing, row->against_real.unexpected,
                           row->against_own.wrong);
    }
  }
  return table;
}

std::string BenchToJson(const BenchResult& result) {
  JsonWriter json;
  json.BeginObject();
  json.Key("rasterproof_bench").Integer(1);
  json.Key("baseline").Text(result.baseline);
  json.Key("repetitions").Integer(result.repetitions);
  json.Key("seed").Text(std::to_string(result.seed));
  json.Key("rows").BeginArray();
  for (const BenchRow& row : result.rows) {
    json.BeginObject();
    json.Key("family").Text(row.family);
    json.Key("subject").Text(row.subject);
    json.Key("triangles").Integer(row.triangles);
    json.Key("box_pixels").Integer(row.box_pixels);
    json.Key("ratio_least").Rounded(row.ratio);
    json.Key("ratio_median").Rounded(MedianRatio(row));
    WriteDifference(json, "against_own", row.against_own, row.box_pixels);
    WriteDifference(json, "against_real", row.against_real, row.box_pixels);
    json.EndObject();
  }
  json.EndArray();
  json.EndObject();
  return json.Finish();
}

std::string BenchPlotSpec(const BenchResult& result) {
  JsonWriter json;
  json.BeginObject();
  json.Key("$schema").Text("https://vega.github.io/schema/vega-lite/v5.json");
  json.Key("description").Text("Error against run time, every method from the same inputs");
  json.Key("background").Text("white");
  json.Key("data").BeginObject().Key("values").BeginArray();
  // Points are drawn in this order: the one that the eye compares with lies on top.
  for (const bool naive : {false, true}) {
    for (const FamilyRows& family : ByFamily(result)) {
      for (const BenchRow* row : family.rows) {
        if ((row->subject == kNaive) == naive) WritePoint(json, *row, family, result);
      }
    }
  }
  json.EndArray().EndObject();
  json.Key("facet").BeginObject();
  json.Key("field").Text("family").Key("type").Text("nominal").Key("title").Value("null");
  json.Key("sort").BeginArray();
  for (const FamilyRows& family : ByFamily(result)) json.Text(family.family);
  json.EndArray().EndObject();
  json.Key("columns").Integer(2);
  json.Key("bounds").Text("flush");
  json.Key("spacing").Integer(56);
  json.Key("spec").Value(kPanel);
  json.Key("config").Value(kConfig);
  json.EndObject();
  return json.Finish();
}

}  // namespace rasterproof::report
