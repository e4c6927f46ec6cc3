#include "lab/sweep/sweep_blame.h"

#include <cxxabi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "io/output.h"

namespace rasterproof::lab {
namespace {

using Kind = Choice::Kind;

// Behind the names of symbols that were local: another file may have a global one of that name.
constexpr std::string_view kWasLocal = ".rasterproof";
constexpr std::size_t kMostFunctions = 400;

std::string Demangled(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  return status == 0 ? name.get() : symbol;
}

// Functions as written stay functions of their own, and callers rely on nothing but the calling
// convention: with -fipa-ra they know which registers a callee leaves alone.
std::vector<std::string> ApartFlags(const Choices& choices) {
  std::vector<std::string> flags{"-S", "-fno-inline", "-ffunction-sections"};
  if (!ToolchainOf(choices).is_gcc) return flags;
  for (const char* flag :
       {"-fno-ipa-ra", "-fno-ipa-cp", "-fno-ipa-sra", "-fno-ipa-icf", "-fno-partial-inlining",
        "-fno-toplevel-reorder", "-fno-section-anchors"}) {
    flags.emplace_back(flag);
  }
  return flags;
}

// clang passes arguments of local functions in its own way, which need not be the same twice,
// unless something out of its sight may call them, too. For C: the headers of C++ have too many
// functions.
std::string WithFunctionsKept(const std::string& source) {
  return fmt::format(
      "#pragma clang attribute push(__attribute__((annotate(\"kept\"))), apply_to = function)\n"
      "#include \"{}\"\n#pragma clang attribute pop\n",
      std::filesystem::absolute(source).string());
}

// A file's functions, compiled one way, as an object.
struct Half {
  std::string object;
  std::vector<std::string> functions;
  std::vector<std::string> symbols;  ///< these and the data
};

class Exchange {
 public:
  Exchange(SweepRunner& runner, const Choices& choices, const std::vector<std::size_t>& cases)
      : runner_(runner), cases_(cases) {
    for (const Choice& c : choices) {
      if (c.kind == Kind::kTarget) target_.push_back(c);
      if (c.kind != Kind::kLinkFlag) compile_.push_back(c);
      if (c.kind == Kind::kTarget || c.kind == Kind::kLinkFlag) link_.push_back(c);
    }
  }

  SweepBlame Find() {
    const std::vector<std::string>& sources = runner_.settings().sources;
    std::vector<std::string> base;
    for (const std::string& source : sources) base.push_back(runner_.Compile(source, target_));
    if (Differs(base)) {
      return {"", "",
              "the flags of the link alone change it, whatever the files are compiled with"};
    }
    for (std::size_t k = 0; k < sources.size(); ++k) {
      std::vector<std::string> mixed = base;
      mixed[k] = runner_.Compile(sources[k], compile_);
      if (Differs(mixed)) return FindFunction(sources[k], base, k);
    }
    return {"", "", "no file changes it alone"};
  }

 private:
  bool Differs(const std::vector<std::string>& objects) {
    const std::string program = runner_.Link(objects, link_);
    const bool differs = runner_.Compare(program, target_, cases_).Differs();
    std::filesystem::remove(program);
    return differs;
  }

  Half Apart(const std::string& source, const Choices& choices, bool with_locals) {
    const Toolchain tools = ToolchainOf(choices);
    std::string compiled = source;
    if (with_locals && !tools.is_gcc) {
      compiled = runner_.folder().NewPath(".c");
      io::WriteFile(compiled, WithFunctionsKept(source));
    }
    const std::string path = runner_.Compile(compiled, choices, ApartFlags(choices));
    const ExchangeableAssembly assembly = MakeExchangeable(io::ReadFile(path), with_locals);
    io::WriteFile(path, assembly.text);
    Half half{runner_.folder().NewPath(".o"), {}, {}};
    std::vector<std::string> assemble{tools.c, "-c", path, "-o", half.object};
    if (!tools.is_base_target) {
      assemble.insert(assemble.end(), tools.flags.begin(), tools.flags.end());
    }
    runner_.Run(assemble);
    std::vector<std::string> command{Objcopy()};
    const std::set<std::string> locals(assembly.was_local.begin(), assembly.was_local.end());
    const auto renamed = [&](const std::string& name) {
      return locals.contains(name) ? fmt::format("{}{}", name, kWasLocal) : name;
    };
    for (const std::string& name : locals) {
      command.insert(command.end(), {"--redefine-sym", fmt::format("{}={}", name, renamed(name))});
    }
    command.push_back(half.object);
    runner_.Run(command);
    for (const std::string& name : assembly.functions) half.functions.push_back(renamed(name));
    half.symbols = half.functions;
    for (const std::string& name : assembly.objects) half.symbols.push_back(renamed(name));
    return half;
  }

  // The base's half with that function of the other half: of two definitions the linker takes the
  // one that is not weak.
  std::vector<std::string> Exchanged(const Half& base, const Half& other,
                                     const std::string& function) {
    const std::string ours = runner_.folder().NewPath(".o");
    const std::string theirs = runner_.folder().NewPath(".o");
    runner_.Run({Objcopy(), "--weaken-symbol", function, base.object, ours});
    std::string names;
    for (const std::string& symbol : other.symbols) {
      if (symbol != function) names += symbol + "\n";
    }
    std::vector<std::string> command{Objcopy()};
    if (!names.empty()) {  // an empty list is an error of objcopy's
      const std::string list = runner_.folder().NewPath(".txt");
      io::WriteFile(list, names);
      command.push_back("--weaken-symbols=" + list);
    }
    command.insert(command.end(), {other.object, theirs});
    runner_.Run(command);
    return {ours, theirs};
  }

  SweepBlame FindFunction(const std::string& source, std::vector<std::string> objects,
                          std::size_t k) {
    const auto untold = [&](std::string_view why) {
      return SweepBlame{source, "", fmt::format("in {}, {}: not told apart", source, why)};
    };
    const bool with_locals = ToolchainOf(compile_).is_gcc || source.ends_with(".c");
    try {
      const Half base = Apart(source, target_, with_locals);
      const Half other = Apart(source, compile_, with_locals);
      objects[k] = base.object;
      if (Differs(objects)) return untold("the base draws otherwise without inlining");
      objects[k] = other.object;
      if (!Differs(objects)) return untold("inlined");
      objects.push_back("");
      std::size_t tried = 0;
      for (const std::string& function : other.functions) {
        if (std::ranges::find(base.functions, function) == base.functions.end()) continue;
        if (++tried > kMostFunctions) break;
        const auto differs_with = [&](const Half& half) {
          const std::vector<std::string> halves = Exchanged(base, half, function);
          objects[k] = halves.front();
          objects.back() = halves.back();
          return Differs(objects);
        };
        if (!differs_with(other)) continue;
        if (differs_with(base)) return untold("its functions share data of their own");
        std::string name = function;
        if (name.ends_with(kWasLocal)) name.resize(name.size() - kWasLocal.size());
        return {source, Demangled(name),
                with_locals ? "" : "with the local functions that it calls"};
      }
      return untold("no function changes it alone");
    } catch (const BuildFailure& failure) {
      return untold(fmt::format("its functions can't be linked one by one ({})", failure.what()));
    }
  }

  std::string Objcopy() const { return ToolchainOf(target_).objcopy; }

  SweepRunner& runner_;
  const std::vector<std::size_t>& cases_;
  Choices target_;  ///< in both builds
  Choices compile_;
  Choices link_;
};

std::string_view Trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

// What follows the directive on the line, up to a comment; nothing if it is another line.
std::string_view After(std::string_view line, std::string_view directive) {
  line = Trimmed(line.substr(0, line.find('#')));
  if (!line.starts_with(directive)) return "";
  line.remove_prefix(directive.size());
  return line.empty() || (line.front() != ' ' && line.front() != '\t') ? "" : Trimmed(line);
}

// `.section NAME,"axG",@progbits,KEY,comdat` without its group.
std::string WithoutGroup(std::string line) {
  constexpr std::string_view kGroup = ",comdat";
  if (!line.ends_with(kGroup) || line.find(".section") == std::string::npos) return line;
  line.resize(line.size() - kGroup.size());
  line.resize(line.rfind(','));
  const std::size_t flags = line.find(",\"");
  const std::size_t group = line.find('G', flags);
  if (flags != std::string::npos && group != std::string::npos) line.erase(group, 1);
  return line;
}

}  // namespace

ExchangeableAssembly MakeExchangeable(std::string_view assembly, bool with_local_functions) {
  ExchangeableAssembly made;
  std::set<std::string, std::less<>> globals;
  std::set<std::string, std::less<>> commons;
  std::vector<std::pair<std::string, bool>> symbols;  // and whether it is a function
  std::istringstream lines{std::string(assembly)};
  for (std::string line; std::getline(lines, line);) {
    for (const char* directive : {".globl", ".global", ".weak"}) {
      const std::string_view name = After(line, directive);
      if (!name.empty()) globals.emplace(name);
    }
    // Zeros that the linker allots: both halves share them once they are global.
    if (const std::string_view zeros = After(line, ".local"); !zeros.empty()) {
      commons.emplace(zeros);
      continue;
    }
    if (const std::string_view weak = After(line, ".weak"); !weak.empty()) {
      line = fmt::format("\t.globl\t{}", weak);
    }
    // A second name of a constructor: as data, it stays the one of its half.
    if (const std::string_view alias = After(line, ".set"); !alias.empty()) {
      symbols.emplace_back(alias.substr(0, alias.find(',')), false);
    }
    const std::string_view type = After(line, ".type");
    const std::size_t comma = type.find(',');
    if (comma != std::string_view::npos) {
      const bool is_function = type.ends_with("function");
      if (is_function || type.ends_with("object")) {
        symbols.emplace_back(type.substr(0, comma), is_function);
      }
    }
    made.text += WithoutGroup(line) + "\n";
  }
  for (const auto& [name, is_function] : symbols) {
    const bool is_global = globals.contains(name);
    if (name.starts_with(".L")) continue;  // a label, not a symbol
    if (!is_global && is_function && !with_local_functions) continue;
    if (!is_global) made.was_local.push_back(name);
    if (commons.contains(name)) continue;
    if (!is_global) made.text += fmt::format("\t.globl\t{}\n", name);
    (is_function ? made.functions : made.objects).push_back(name);
  }
  return made;
}

SweepBlame Blame(SweepRunner& runner, const Choices& choices,
                 const std::vector<std::size_t>& cases) {
  Choices target;
  std::ranges::copy_if(choices, std::back_inserter(target),
                       [](const Choice& c) { return c.kind == Kind::kTarget; });
  if (!target.empty() && runner.OutcomeOf(target).Differs()) {
    return {"", "",
            "objects of two processors can't be linked together: file and function not told apart"};
  }
  for (const Choice& c : choices) {
    if (c.kind == Kind::kFlag && c.value == "-flto") {
      return {"", "", "the files are optimized as one at the link: not told apart"};
    }
  }
  try {
    return Exchange(runner, choices, cases).Find();
  } catch (const BuildFailure& failure) {
    return {"", "", fmt::format("the files can't be linked one by one ({})", failure.what())};
  }
}

}  // namespace rasterproof::lab
