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
  std::vector<std::string> plugins;   ///< libraries that are timed beside them, in this process
  std::vector<std::string> programs;  ///< commands that are timed beside them, on a pipe
  bool limits = false;                ///< cliffs alone, of plugins too each in its own process
  std::string save;                   ///< folder for the case of each cliff; empty: none
  double budget = 60;                 ///< seconds for everything
  std::uint64_t seed = 1;
  std::string json;
  std::string svg;
  bool fingerprint = false;  ///< fingerprints alone
  std::string folder;        ///< of their pictures; empty: none are written
  std::string against;       ///< file of an earlier run: what changed since
  std::string from;          ///< file of a run that is not to be repeated; empty: it is run
  std::string command;       ///< as it was typed
  int width = 1920;          ///< of meshes
  int height = 1080;
};
int RunBench(const BenchOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_BENCH_CMD_BENCH_H_
