// rasterproof bench --values: error against run time of interpolated values.
#include <cstdint>
#include <string>

#include "bench/values/value_bench.h"
#include "core/bench_result.h"
#include "io/output.h"
#include "report/bench_json.h"
#include "report/value_text.h"
#include "tool/bench/cmd_bench.h"
#include "tool/bench/values.h"
#include "tool/progress.h"

namespace rasterproof::tool {

void PrintValues(const BenchOptions& options, BenchResult& result) {
  {
    Progress progress;
    bench::ValueBenchOptions values;
    values.families = options.families;
    values.seed = options.seed;
    if (!result.setting.is_quick) {
      values.covered *= 8;
      values.judged *= 8;
      values.rounds = 41;
    }
    values.progress = [&](const std::string& stage) { progress.Stage(stage); };
    result.value_families.clear();  // those of the record that is added to
    result.value_rows.clear();
    result.value_limits.clear();
    bench::RunValues(values, result);
  }
  // A record that is added to keeps its own.
  if (options.from.empty()) result.setting.load_after = LoadOfMachine();
  if (!options.json.empty()) io::WriteFile(options.json, report::BenchToJson(result));
  io::WriteStandardOutput(report::ValuesToTable(report::AsRecorded(result)));
}

}  // namespace rasterproof::tool
