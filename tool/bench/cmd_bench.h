// The verb bench.
#ifndef RASTERPROOF_TOOL_BENCH_CMD_BENCH_H_
#define RASTERPROOF_TOOL_BENCH_CMD_BENCH_H_

#include <cstdint>
#include <string>
#include <vector>

namespace rasterproof::tool {

struct BenchOptions {
  std::vector<std::string> families;  ///< names; empty: all, unless there are scenes
  std::vector<std::string> scenes;    ///< scene files or meshes
  std::vector<std::string> subjects;  ///< built-in methods and kernels by name; empty: all
  std::vector<std::string> plugins;   ///< libraries to time too, in this process
  std::vector<std::string> programs;  ///< commands to time too, on a pipe
  bool values = false;                ///< only measure interpolated values
  bool growth = false;                ///< only measure costs over triangles, target and threads
  bool limits = false;                ///< only find cliffs, each plugin in its own process
  std::string save;                   ///< folder for the case of each cliff; empty: none
  std::string target;                 ///< instruction set of all kernels; empty: see bench.h
  double budget = 60;                 ///< seconds for everything
  std::uint64_t seed = 1;
  std::string json;
  std::string svg;
  bool fingerprint = false;  ///< fingerprints alone
  std::string folder;        ///< for their pictures; empty: none
  std::string against;       ///< file of an earlier run to compare with
  std::string from;          ///< file of a finished run to report; empty: run
  std::string command;       ///< as it was typed
  int width = 1920;          ///< of meshes
  int height = 1080;
};

/// How many processes want a processor, a mean over a minute; NaN where the system does not say.
double LoadOfMachine();

/// The subjects that run in their own processes: outside subjects by name, and commands.
std::vector<std::string> ProgramNames(const BenchOptions& options);

int RunBench(const BenchOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_BENCH_CMD_BENCH_H_
