#include "tests/report/sample_bench.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace rasterproof::report {
namespace {

BenchMethod Method(const std::string& name, const std::string& kind, bool is_proved) {
  BenchMethod method;
  method.name = name;
  method.summary = "how " + name + " draws";
  method.kind = kind;
  method.target = kind == "exact" ? "avx2" : "compiler";
  method.sink = "facing";
  method.model = kind == "fixed point" ? "snapped8" : "real";
  method.is_proved = is_proved;
  method.coordinate_limit = 16384;
  method.vertex_bytes = 8;
  method.pixel_bits = 64;
  return method;
}

BenchFamily Family(const std::string& name) {
  BenchFamily family;
  family.name = name;
  family.summary = "Triangles of " + name;
  family.width = 256;
  family.height = 128;
  family.is_random = true;
  family.largest_coordinate = 256;
  family.triangles = 1000;
  family.covered = 20'000;
  family.judged_triangles = 1000;
  family.judged_covered = 20'000;
  family.boundary_pairs = 10'000;
  family.shared_pairs = 3000;
  family.distances.pairs = {1, 2, 3, 4, 9990};
  family.baseline = 0;
  family.twin = 1;
  family.rounds = 3;
  return family;
}

// Times of 10 us a draw times the ratio, with an interval of 1 %.
BenchRow Row(std::uint32_t family, std::uint32_t method, double ratio, std::uint64_t wrong) {
  BenchRow row;
  row.family = family;
  row.method = method;
  row.seconds = {1e-5 * ratio, 1.01e-5 * ratio, 0.99e-5 * ratio};
  row.time = {0.99e-5 * ratio, 1e-5 * ratio, 1.01e-5 * ratio};
  row.wall_median = 1.1e-5 * ratio;
  row.ratio = {0.99 * ratio, ratio, 1.01 * ratio};
  row.is_judged = true;
  row.drawing_wrong = wrong;
  row.real.missing = wrong;
  row.own.missing = wrong;
  if (wrong != 0) {
    row.real.displacement = row.own.displacement = 0.015;
    row.real.worst = row.own.worst =
        BenchWitness{7, {{{1.1, 2, 0, 1}, {9.25, 3, 0, 1}, {4, 11.7, 0, 1}}}, 5, 4, 0.015};
  }
  row.judged_triangles = 900;
  row.boundary_pairs = 10'000;
  row.real.beside_edges = row.own.beside_edges = wrong;
  row.values.edge = 0.001;
  row.values.edge_share_of_bound = 0.1;
  return row;
}

// A crowd of like methods: their names must not cover each other.
void AddCrowd(BenchResult& result) {
  for (std::uint32_t k = 0; k < 12; ++k) {
    const auto method = static_cast<std::uint32_t>(result.methods.size());
    result.methods.push_back(
        Method("crowd-" + std::to_string(k), k % 2 == 0 ? "float64" : "float32", false));
    result.rows.push_back(Row(0, method, 0.29 - 0.021 * k, 3 + 2 * k));
  }
}

Scene CliffScene() {
  Scene scene;
  scene.name = "cliff";
  scene.width = 8;
  scene.height = 8;
  scene.vertices = {{0.1, 0, 0, 1}, {7, 1, 0, 1}, {3, 7, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  scene.precision = Precision::kFloat64;
  return scene;
}

// The crowd but its last two end alike, kernel-exact nowhere; f32-direct and the first of the crowd
// are one line, the last but one is another.
void AddLimits(BenchResult& result) {
  constexpr std::uint32_t kFirstOfCrowd = 6;
  const auto methods = static_cast<std::uint32_t>(result.methods.size());
  result.parameters = {{"steps", "Longer walks, the rest kept", "pixels", false},
                       {"pixels", "Larger triangles", "pixels", true},
                       {"w", "w of one corner over that of the others", "1", false}};
  for (std::uint32_t k = 1; k < 11; ++k) {
    result.parameters.push_back(
        {"grid-" + std::to_string(k), "Larger sides on a grid", "pixels", false});
  }
  const auto add_curves = [&](std::uint32_t method, double error) {
    BenchCurve errors{method, 0, {}};
    BenchCurve costs{method, 1, {}};
    for (const double value : {2.0, 64.0, 4096.0, 16777217.0}) {
      BenchPoint point{value, 1000, value > 64 ? 12U : 0U, value > 64 ? error : 0, value / 1e8, {}};
      // Float32 has no corners that far.
      if (value <= 4096 || result.methods[method].kind != "float32") errors.points.push_back(point);
      point = {value, 1000, 0, 0, std::numeric_limits<double>::quiet_NaN(), {}};
      point.time = {0.9e-9 * value, 1e-9 * value / error, 1.1e-9 * value};
      costs.points.push_back(point);
    }
    result.curves.push_back(errors);
    result.curves.push_back(costs);
  };
  add_curves(2, 0.25);
  for (std::uint32_t k = kFirstOfCrowd; k < methods; ++k) {
    add_curves(k, k == methods - 1 ? 0.001 : k == methods - 2 ? 0.01 : 0.25);
  }
  result.cliffs.push_back({2, 0, 64, 2048, 2049, CliffScene(), 3, 2});
  result.cliffs.emplace_back().method = kFirstOfCrowd;  // nothing is known
  for (std::uint32_t parameter = 2; parameter < result.parameters.size(); ++parameter) {
    for (std::uint32_t method = kFirstOfCrowd; method < methods - 2; ++method) {
      result.cliffs.push_back(
          {method, parameter, 94906265, 94906265, 94906266, CliffScene(), 3, 2});
    }
    result.cliffs.push_back({methods - 1, parameter, 4096, 8192, 8193, CliffScene(), 3, 2});
    BenchCliff& endless = result.cliffs.emplace_back();
    endless.method = 3;
    endless.parameter = parameter;
    endless.proved_to = endless.held_to = 16384;
  }
}

}  // namespace

BenchResult SampleBench() {
  BenchResult result;
  result.setting = {
      "a processor, 2 processors", "g++ 12", "-O2", "abc", "rasterproof bench", "2026-01-02",
      18446744073709551615U,       true};
  result.methods = {Method("f32-incremental", "float32", false),
                    Method("f32-incremental again", "float32", false),
                    Method("f32-direct", "float32", false),
                    Method("kernel-exact", "exact", true),
                    Method("i64-snap8", "fixed point", true),
                    Method("mine.so", "yours", false)};
  result.methods[5].is_users = true;
  result.methods[5].times_requests = true;
  result.families = {Family("small"), Family("large")};
  for (const std::uint32_t family : {0U, 1U}) {
    result.rows.push_back(Row(family, 0, 1, 5));
    result.rows.push_back(Row(family, 1, 1.001, 5));
    result.rows.push_back(Row(family, 2, 0.3, 2));
    result.rows.push_back(Row(family, 3, 0.5, 0));
    result.rows.push_back(Row(family, 4, 0.8, 0));
    result.rows.push_back(Row(family, 5, 0.4, 1));
  }
  result.rows[6].is_judged = false;
  result.rows[6].real = result.rows[6].own = {};
  result.rows[6].drawing_wrong.reset();
  result.left_out = {{1, 5, "it draws elsewhere"}};
  AddCrowd(result);
  AddLimits(result);
  result.stages = {{"transform", "in float32", 12, 10'000, 0.001},
                   {"snap", "to 1/256 pixel", 300, 10'000, 0.0027}};
  result.fingerprints = {{2, "1 ulp", 77,
                          "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGA"
                          "hKmMIQAAAABJRU5ErkJg"
                          "gg=="}};
  return result;
}

}  // namespace rasterproof::report
