// What `sweep` builds: compilers, targets and flags, one axis at a time.
#ifndef RASTERPROOF_LAB_SWEEP_SWEEP_BUILDS_H_
#define RASTERPROOF_LAB_SWEEP_SWEEP_BUILDS_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterproof::lab {

/// One choice by which a build differs from the base, which is gcc for x86-64 with kBaseFlags.
struct Choice {
  enum class Kind : std::uint8_t {
    kCompiler,  ///< "clang", "clang-19"
    kTarget,    ///< "i386", "aarch64"
    kFlag,      ///< given when a source is compiled
    kLinkFlag   ///< given when the program is linked
  };
  Kind kind = Kind::kFlag;
  std::string value;

  friend auto operator<=>(const Choice&, const Choice&) = default;
};
using Choices = std::vector<Choice>;

inline constexpr std::array<std::string_view, 2> kBaseFlags{"-O2", "-ffp-contract=off"};

/// A row of the table: the base changed along these axes.
struct SweepBuild {
  std::vector<std::string> axes;
  Choices choices;
};

/// Builds along one axis each, and those in which contraction meets an instruction set that has
/// fused multiply-add: neither of the two changes anything without the other.
std::vector<SweepBuild> SingleBuilds();

/// Each two of the builds that share no axis, as one.
std::vector<SweepBuild> PairsOf(const std::vector<SweepBuild>& builds);

/// A build in the user's words, apart by blanks: "clang -O3 -ffast-math". Words that begin with "-"
/// are flags, to compile and to link; the others name the compiler (gcc, clang, clang-19, or these
/// of C++) or the target (i386, aarch64). It has none of the base's flags: of optimisation and
/// contraction it has as flags what the words say, else what `cflags` do, else what the compiler
/// does without a flag. Throws InputError for any other word, and where that depends on the
/// language of the source (-ansi).
SweepBuild BuildFrom(const std::string& words, const std::string& cflags);

/// The compiler and target of a build, and what their programs are called.
struct Toolchain {
  std::string c;                      ///< "gcc"
  std::string cxx;                    ///< "g++"
  std::vector<std::string> flags;     ///< of the target, to compile and to link
  std::vector<std::string> emulator;  ///< before the program's name; empty: it runs as it is
  bool is_gcc = true;
  bool is_base_target = true;
  std::string objcopy = "objcopy";  ///< for objects of the target
};
Toolchain ToolchainOf(const Choices& choices);

/// "gcc -O2 ... ": compiler, target and flags of a build in the words of a command line.
std::string BuildName(const Choices& choices);
/// The choices alone: "-march=x86-64-v3 -ffp-contract=fast", "compiler clang".
std::string ChoicesText(const Choices& choices);

/// What is missing to make and run the build, with the package of Debian that has it; empty if
/// nothing is.
std::string WhatIsMissing(const Choices& choices, bool has_cxx);

/// A line for each compiler and emulator that `sweep` looks for: where it is, or which package has
/// it.
std::string ToolsText();

/// Lists of choices to take the place of these, finer ones first: -ffast-math as its parts.
std::vector<Choices> FinerChoices(const Choices& choices);

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_SWEEP_SWEEP_BUILDS_H_
