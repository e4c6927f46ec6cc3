// Drives a fuzz target without libFuzzer, so that every compiler replays the seeds:
//
//     TARGET [-seconds=N] [-runs=N [-seed=S]] [FILE or FOLDER]...
//
// -seconds=N runs the inputs over and over for N seconds, to measure the target's speed. -runs=N
// adds N inputs of random bytes, the same for the same seed.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/fuzz_target.h"
#include "props/domains/bit_source.h"

// A target with its own options takes them here.
extern "C" __attribute__((weak)) int LLVMFuzzerInitialize(int* argc, char*** argv);

namespace {

using Input = std::vector<std::uint8_t>;

std::vector<std::filesystem::path> InputsOf(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

struct Options {
  std::uint64_t seconds = 0;
  std::uint64_t runs = 0;
  std::uint64_t seed = 1;
  std::vector<Input> inputs;
};

// Returns whether the word is the option followed by a number.
bool Takes(std::string_view word, std::string_view option, std::uint64_t& value) {
  if (!word.starts_with(option)) return false;
  const char* const end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data() + option.size(), end, value);
  if (error != std::errc() || stopped != end) {
    std::fprintf(stderr, "%s: no number\n", std::string(word).c_str());
    std::exit(2);
  }
  return true;
}

Options Parse(int argc, char** argv) {
  Options asked;
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    if (Takes(word, "-seconds=", asked.seconds) || Takes(word, "-runs=", asked.runs) ||
        Takes(word, "-seed=", asked.seed)) {
      continue;
    }
    for (const std::filesystem::path& path : InputsOf(argv[k])) {
      std::ifstream file(path, std::ios::binary);
      if (!file) {
        std::fprintf(stderr, "%s: cannot be read\n", path.c_str());
        std::exit(2);
      }
      asked.inputs.emplace_back(std::istreambuf_iterator<char>(file),
                                std::istreambuf_iterator<char>());
    }
  }
  return asked;
}

void Run(const Input& input) { LLVMFuzzerTestOneInput(input.data(), input.size()); }

void RunRandom(const Options& asked) {
  constexpr std::uint64_t kMostBytes = 128;
  for (std::uint64_t run = 0; run < asked.runs; ++run) {
    rasterproof::props::PhiloxSource random(asked.seed, run);
    Input input(1 + random.Bits(32) % kMostBytes);
    for (std::uint8_t& byte : input) byte = static_cast<std::uint8_t>(random.Bits(8));
    Run(input);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (LLVMFuzzerInitialize != nullptr) LLVMFuzzerInitialize(&argc, &argv);
  const Options asked = Parse(argc, argv);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  std::size_t runs = 0;
  double took = 0;
  do {
    for (const Input& input : asked.inputs) Run(input);
    runs += asked.inputs.size();
    took = std::chrono::duration<double>(Clock::now() - start).count();
  } while (!asked.inputs.empty() && took < static_cast<double>(asked.seconds));
  RunRandom(asked);
  std::printf("%zu inputs replayed\n", asked.inputs.size());
  if (asked.runs > 0) std::printf("%zu random inputs run\n", static_cast<std::size_t>(asked.runs));
  if (asked.seconds > 0) std::printf("%zu executions in %.2f s\n", runs, took);
  // A replay of nothing proves nothing.
  return asked.inputs.empty() && asked.runs == 0 ? 4 : 0;
}
