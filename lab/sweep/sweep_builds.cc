#include "lab/sweep/sweep_builds.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "fmt/format.h"
#include "lab/sweep/i386.h"

namespace rasterproof::lab {
namespace {

using Kind = Choice::Kind;

// A program that builds or runs, and the package of Debian 12 that has it.
struct Tool {
  std::string_view name;
  std::string_view package;
};
constexpr std::array kTools{
    Tool{"gcc", "gcc"},
    Tool{"g++", "g++"},
    Tool{"clang", "clang"},
    Tool{"clang++", "clang"},
    Tool{"clang-19", "clang-19 (apt.llvm.org)"},
    Tool{"clang++-19", "clang-19 (apt.llvm.org)"},
    Tool{"aarch64-linux-gnu-gcc", "gcc-aarch64-linux-gnu"},
    Tool{"aarch64-linux-gnu-g++", "g++-aarch64-linux-gnu"},
    Tool{"qemu-aarch64", "qemu-user"},
};

std::string PathOf(std::string_view name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = fmt::format("{}/{}", folder, name);
    if (!folder.empty() && access(file.c_str(), X_OK) == 0) return file;
  }
  return "";
}

std::string Missing(std::string_view name) {
  if (!PathOf(name).empty()) return "";
  const auto* const tool =
      std::ranges::find_if(kTools, [&](const Tool& t) { return t.name == name; });
  return fmt::format("there is no {}; package {} has it", name, tool->package);
}

// Whether this processor runs programs of that level. Builds by name alone would end by a signal.
bool HasLevel([[maybe_unused]] std::string_view level) {
#if defined(__x86_64__)
  if (level == "x86-64-v2") return __builtin_cpu_supports("x86-64-v2") != 0;
  if (level == "x86-64-v3") return __builtin_cpu_supports("x86-64-v3") != 0;
  return level != "x86-64-v4" || __builtin_cpu_supports("x86-64-v4") != 0;
#else
  return false;
#endif
}

// What the level has and those below it lack.
std::string_view ExtensionsOf(std::string_view level) {
  if (level == "x86-64-v2") return "SSE4.2";
  if (level == "x86-64-v3") return "AVX2 and FMA";
  return level == "x86-64-v4" ? "AVX-512" : "";
}

Choice Flag(std::string_view value) { return {Kind::kFlag, std::string(value)}; }
Choice LinkFlag(std::string_view value) { return {Kind::kLinkFlag, std::string(value)}; }

Choices Flags(std::string_view words) {
  Choices flags;
  std::istringstream in{std::string(words)};
  for (std::string word; in >> word;) flags.push_back(Flag(word));
  return flags;
}

// -fassociative-math does nothing without the two.
constexpr std::string_view kAssociative = "-fassociative-math -fno-signed-zeros -fno-trapping-math";
constexpr std::array<std::string_view, 5> kMathParts{"-freciprocal-math", "-fno-signed-zeros",
                                                     "-ffinite-math-only", "-fno-math-errno",
                                                     "-fno-trapping-math"};
constexpr std::string_view kFast = "-ffast-math";
constexpr std::string_view kUnsafe = "-funsafe-math-optimizations";

std::string ValueOf(const Choices& choices, Kind kind, std::string usual) {
  for (const Choice& c : choices) {
    if (c.kind == kind) usual = c.value;
  }
  return usual;
}

Choices Joined(const Choices& a, const Choices& b) {
  Choices all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

// "-march=" of "-march=x86-64-v3", "-O" of "-O3": a later flag with it replaces an earlier one.
std::string_view KeyOf(std::string_view flag) {
  if (flag.starts_with("-O")) return "-O";
  return flag.substr(0, flag.find('=') + 1);
}

bool IsReplaced(std::string_view flag, const Choices& choices) {
  return std::ranges::any_of(choices, [&](const Choice& c) {
    return c.kind == Kind::kFlag && !KeyOf(flag).empty() && KeyOf(c.value) == KeyOf(flag);
  });
}

InputError NoBuild(const std::string& word) {
  return {fmt::format("--build: '{}'", word), "is no flag, compiler or target",
          "write gcc, clang, clang-19, i386, aarch64, or flags that begin with -"};
}

// The last of the words that begins in one of these ways; empty if none does.
std::string LastWord(const std::string& words, std::initializer_list<std::string_view> begins) {
  std::string last;
  std::istringstream in(words);
  for (std::string word; in >> word;) {
    if (std::ranges::any_of(begins,
                            [&](std::string_view begin) { return word.starts_with(begin); }))
      last = word;
  }
  return last;
}

bool AllowsUnsafeMath(const std::string& words) {
  const std::string math =
      LastWord(words, {"-ffast-math", "-fno-fast-math", "-funsafe-math-optimizations",
                       "-fno-unsafe-math-optimizations"});
  return math.empty() ? LastWord(words, {"-O"}) == "-Ofast" : !math.starts_with("-fno-");
}

// What a compiler does without the flag. Unsafe mathematics contracts everywhere; else gcc does
// not in the modes of ISO C, but does in C++. With -ansi that depends on the source's language.
std::string UsualContraction(bool is_gcc, const std::string& words) {
  if (AllowsUnsafeMath(words)) return "-ffp-contract=fast";
  if (!is_gcc) return "-ffp-contract=on";
  const std::string standard = LastWord(words, {"-std=", "-ansi"});
  if (standard == "-ansi")
    throw InputError(fmt::format("--build: '{}'", words),
                     "with -ansi gcc contracts in C++ and does not in C",
                     "write -std=c90 or -std=c++98 instead, or add -ffp-contract=off or =fast");
  const bool is_iso_c = (standard.starts_with("-std=c") && !standard.starts_with("-std=c++")) ||
                        standard.starts_with("-std=iso");
  return is_iso_c ? "-ffp-contract=off" : "-ffp-contract=fast";
}

bool IsGivenToBoth(const Choice& choice, const Choices& choices) {
  return choice.kind == Kind::kLinkFlag &&
         std::ranges::find(choices, Choice{Kind::kFlag, choice.value}) != choices.end();
}

}  // namespace

std::vector<SweepBuild> SingleBuilds() {
  const Choices clang{{Kind::kCompiler, "clang"}};
  const Choices clang19{{Kind::kCompiler, "clang-19"}};
  const Choices aarch64{{Kind::kTarget, "aarch64"}};
  std::vector<SweepBuild> builds{{{"compiler"}, clang}, {{"compiler"}, clang19}};
  for (const char* level : {"-O0", "-O1", "-O3"}) builds.push_back({{"level"}, Flags(level)});
  for (const char* march : {"-march=x86-64-v2", "-march=x86-64-v3", "-march=x86-64-v4"}) {
    builds.push_back({{"processor"}, Flags(march)});
  }
  const std::array contracts{Flags("-ffp-contract=on"), Flags("-ffp-contract=fast")};
  for (const Choices& contract : contracts) builds.push_back({{"contraction"}, contract});
  for (const char* march : {"-march=x86-64-v3", "-march=x86-64-v4"}) {
    if (!HasLevel("x86-64-v4") && std::string_view(march).ends_with("v4")) continue;
    for (const Choices& compiler : {Choices{}, clang, clang19}) {
      for (const Choices& contract : contracts) {
        std::vector<std::string> axes{"processor", "contraction"};
        if (!compiler.empty()) axes.emplace_back("compiler");
        builds.push_back({axes, Joined(compiler, Joined(Flags(march), contract))});
      }
    }
  }
  builds.push_back({{"math"}, {Flag(kFast), LinkFlag(kFast)}});
  builds.push_back({{"math"}, {Flag(kUnsafe), LinkFlag(kUnsafe)}});
  builds.push_back({{"math"}, Flags(kAssociative)});
  for (const std::string_view part : kMathParts) builds.push_back({{"math"}, Flags(part)});
  builds.push_back({{"math at link"}, {LinkFlag(kFast)}});
  builds.push_back({{"link time"}, {Flag("-flto"), LinkFlag("-flto")}});
  builds.push_back({{"target"}, {{Kind::kTarget, "i386"}, Flag("-mfpmath=387")}});
  builds.push_back({{"target"}, aarch64});
  for (const Choices& contract : contracts) {
    builds.push_back({{"target", "contraction"}, Joined(aarch64, contract)});
  }
  return builds;
}

std::vector<SweepBuild> PairsOf(const std::vector<SweepBuild>& builds) {
  // An instruction set of one processor is none of another's.
  const auto share = [](const SweepBuild& a, const SweepBuild& b) {
    return std::ranges::any_of(a.axes, [&](const std::string& axis) {
      return std::ranges::find(b.axes, axis) != b.axes.end() ||
             (axis == "processor" && std::ranges::find(b.axes, "target") != b.axes.end()) ||
             (axis == "target" && std::ranges::find(b.axes, "processor") != b.axes.end()) ||
             (axis == "math" && std::ranges::find(b.axes, "math at link") != b.axes.end());
    });
  };
  std::vector<SweepBuild> pairs;
  for (std::size_t i = 0; i < builds.size(); ++i) {
    for (std::size_t k = i + 1; k < builds.size(); ++k) {
      if (share(builds[i], builds[k])) continue;
      SweepBuild& pair = pairs.emplace_back(builds[i]);
      pair.axes.insert(pair.axes.end(), builds[k].axes.begin(), builds[k].axes.end());
      pair.choices = Joined(pair.choices, builds[k].choices);
    }
  }
  return pairs;
}

SweepBuild BuildFrom(const std::string& words, const std::string& cflags) {
  SweepBuild build;
  std::istringstream in(words);
  for (std::string word; in >> word;) {
    if (word.starts_with('-')) {
      build.choices.push_back(Flag(word));
      build.choices.push_back(LinkFlag(word));
    } else if (word == "i386" || word == "aarch64") {
      build.choices.push_back({Kind::kTarget, word});
    } else if (word.starts_with("clang")) {
      // A C++ source is compiled by the compiler's C++ name.
      if (word.starts_with("clang++")) word.erase(5, 2);
      if (word != "clang" && word != "clang-19") throw NoBuild(word);
      build.choices.push_back({Kind::kCompiler, word});
    } else if (word != "gcc" && word != "g++") {
      throw NoBuild(word);
    }
  }
  const std::string all = cflags.empty() ? words : cflags + " " + words;
  const std::string level = LastWord(all, {"-O"});
  if (LastWord(words, {"-O"}).empty()) build.choices.push_back(Flag(level.empty() ? "-O0" : level));
  if (LastWord(words, {"-ffp-contract="}).empty()) {
    const bool is_gcc = ValueOf(build.choices, Kind::kCompiler, "gcc") == "gcc";
    const std::string contract = LastWord(all, {"-ffp-contract="});
    build.choices.push_back(Flag(contract.empty() ? UsualContraction(is_gcc, all) : contract));
  }
  return build;
}

Toolchain ToolchainOf(const Choices& choices) {
  const std::string compiler = ValueOf(choices, Kind::kCompiler, "gcc");
  const std::string target = ValueOf(choices, Kind::kTarget, "x86-64");
  Toolchain tools{"gcc", "g++", {}, {}, compiler == "gcc", target == "x86-64"};
  if (!tools.is_gcc) {
    tools.c = compiler;
    tools.cxx = compiler == "clang" ? "clang++" : "clang++" + compiler.substr(5);
  }
  if (target == "x86-64") tools.flags = {"-march=x86-64"};
  // The processor's registers alone: -mfpmath=387 is a choice.
  if (target == "i386") tools.flags = {"-m32", "-march=i686", "-msse2", "-mfpmath=sse"};
  if (target == "aarch64") {
    if (tools.is_gcc) {
      tools.c = "aarch64-linux-gnu-gcc";
      tools.cxx = "aarch64-linux-gnu-g++";
    } else {
      tools.flags = {"--target=aarch64-linux-gnu"};
    }
    tools.emulator = {"qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"};
    tools.objcopy = "aarch64-linux-gnu-objcopy";
  }
  return tools;
}

std::string BuildName(const Choices& choices) {
  const Toolchain tools = ToolchainOf(choices);
  std::string name = tools.c;
  std::vector<std::string> flags = tools.flags;
  flags.insert(flags.end(), kBaseFlags.begin(), kBaseFlags.end());
  for (const std::string& flag : flags) {
    if (!IsReplaced(flag, choices)) name += " " + flag;
  }
  for (const Choice& c : choices) {
    if (c.kind == Kind::kFlag) name += " " + c.value;
    if (c.kind != Kind::kLinkFlag || IsGivenToBoth(c, choices)) continue;
    name += fmt::format(" ({} at link time)", c.value);
  }
  return name;
}

std::string ChoicesText(const Choices& choices) {
  std::string text;
  for (const Choice& c : choices) {
    if (IsGivenToBoth(c, choices)) continue;
    if (!text.empty()) text += ' ';
    if (c.kind == Kind::kCompiler) text += "compiler ";
    if (c.kind == Kind::kTarget) text += "target ";
    text += c.value;
    if (c.kind == Kind::kLinkFlag) text += " (at link time)";
  }
  return text;
}

std::string WhatIsMissing(const Choices& choices, bool has_cxx) {
  const Toolchain tools = ToolchainOf(choices);
  std::vector<std::string> names{tools.c};
  if (has_cxx) names.push_back(tools.cxx);
  if (!tools.emulator.empty()) {
    names.push_back(tools.emulator.front());
    names.emplace_back(has_cxx ? "aarch64-linux-gnu-g++" : "aarch64-linux-gnu-gcc");
  }
  for (const std::string& name : names) {
    if (std::string missing = Missing(name); !missing.empty()) return missing;
  }
  if (ValueOf(choices, Kind::kTarget, "x86-64") == "i386" && !RunsI386())
    return "this machine runs no programs of i386";
  for (const Choice& c : choices) {
    constexpr std::string_view kMarch = "-march=";
    if (c.value.starts_with(kMarch) && !HasLevel(c.value.substr(kMarch.size()))) {
      const std::string level = c.value.substr(kMarch.size());
      return fmt::format("this processor lacks {} ({})", level, ExtensionsOf(level));
    }
  }
  return "";
}

std::string ToolsText() {
  std::string text;
  for (const Tool& tool : kTools) {
    const std::string path = PathOf(tool.name);
    text +=
        fmt::format("sweep: {:<23}{}\n", tool.name,
                    path.empty() ? fmt::format("missing; package {} has it", tool.package) : path);
  }
  return text;
}

std::vector<Choices> FinerChoices(const Choices& choices) {
  Choices finer;
  bool has_parts = false;
  for (const Choice& c : choices) {
    if (c.kind != Kind::kFlag || (c.value != kFast && c.value != kUnsafe)) {
      finer.push_back(c);
      continue;
    }
    has_parts = true;
    for (const Choice& part : Flags(kAssociative)) finer.push_back(part);
    finer.push_back(Flag("-freciprocal-math"));
    if (c.value == kUnsafe) continue;
    for (const char* part : {"-ffinite-math-only", "-fno-math-errno", "-ffp-contract=fast"}) {
      finer.push_back(Flag(part));
    }
  }
  if (!has_parts) return {choices};
  // What the link does has a row of its own; here what the files do comes first.
  Choices of_files;
  std::ranges::copy_if(finer, std::back_inserter(of_files),
                       [](const Choice& c) { return c.kind != Kind::kLinkFlag; });
  Choices with_unsafe = finer;
  with_unsafe.push_back(Flag(kUnsafe));
  return {of_files, finer, with_unsafe, choices};
}

}  // namespace rasterproof::lab
