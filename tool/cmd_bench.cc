// rasterproof bench: error against run time, every method from the same inputs in one run.
#include <memory>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "fmt/format.h"
#include "io/output.h"
#include "report/bench_plot.h"
#include "subjects/builtin/builtin.h"
#include "tool/asked.h"
#include "tool/commands.h"
#include "tool/progress.h"
#include "tool/session.h"

namespace rasterproof::tool {

int RunBench(const BenchOptions& options) {
  RequireHonestEnvironment();
  std::vector<std::unique_ptr<Subject>> owned;
  std::vector<Subject*> subjects;
  const std::vector<std::string> names =
      options.subjects.empty() ? subjects::BuiltinNames() : options.subjects;
  for (const std::string& name : names) {
    auto subject = MakeSubject(name);
    const SubjectInfo& info = subject->Info();
    // The four families are window space; canonical order changes which way an edge is walked, not
    // its cost.
    if (options.subjects.empty() && (!info.takes_window || name.ends_with(":canonical"))) continue;
    subjects.push_back(subject.get());
    owned.push_back(std::move(subject));
  }
  bench::BenchOptions bench_options;
  bench_options.repetitions = options.repetitions;
  bench_options.seed = options.seed;
  BenchResult result;
  {
    Progress progress;
    progress.Stage("bench");
    bench_options.progress = [&](const std::string& stage) { progress.Stage(stage); };
    result = bench::RunBench(subjects, bench_options);
  }
  if (!options.json.empty()) io::WriteFile(options.json, report::BenchToJson(result));
  if (!options.plot.empty()) io::WriteFile(options.plot, report::BenchPlotSpec(result));
  io::WriteStandardOutput(report::BenchToTable(result));
  return kExitHolds;
}

}  // namespace rasterproof::tool
