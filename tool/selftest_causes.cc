// rasterproof selftest --causes: is what was planted in a mutant what explains its violation?
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/hash_text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "props/cause/cause.h"
#include "subjects/mutants/mutants.h"
#include "tool/causes.h"
#include "tool/expected_causes.h"
#include "tool/selftest.h"

namespace rasterproof::tool {
namespace {

constexpr double kPatience = 100;  // what is found may not depend on the clock

enum class Named : std::uint8_t { kRight, kWrong, kNone };

bool IsAmong(std::string_view name, std::string_view names) {
  for (std::size_t from = 0; from <= names.size();) {
    const std::size_t end = std::min(names.find('|', from), names.size());
    if (names.substr(from, end - from) == name) return true;
    from = end + 1;
  }
  return false;
}

Named Judged(const CauseFound& found) {
  const std::string_view expected = ExpectedCauses(found.mutant.name);
  if (found.name.empty()) return Named::kNone;
  return IsAmong(found.name, expected) ? Named::kRight : Named::kWrong;
}

struct Figures {
  // of mutants with a suspect, and of those without
  std::array<std::size_t, 3> with{};
  std::array<std::size_t, 3> without{};
};

std::string FiguresLine(std::string_view half, const Figures& f) {
  const auto [right, wrong, none] = f.with;
  return fmt::format(
      "- {}: {} mutants with a suspect, {} named right, {} wrong, {} not named; {} without one, {} "
      "rightly not named, {} named all the same\n",
      half, right + wrong + none, right, wrong, none, f.without[0] + f.without[1] + f.without[2],
      f.without[2], f.without[0] + f.without[1]);
}

}  // namespace

CauseFound FindCauseOf(const HuntResult& result, const props::MakesSubject& make) {
  CauseFound found{result.mutant, {}, {}};
  if (!result.hunt.violation) return found;
  const auto failed = FailedBy(*result.hunt.violation, make()->Info());
  if (!failed) return found;
  const props::Explanation explanation = props::Explain(make, {&*failed, 1}, kPatience);
  found.property = failed->property->name;
  if (explanation.causes.empty()) return found;
  const props::Cause& cause = explanation.causes.front();
  found.name = cause.name;
  found.what = fmt::format("{}", fmt::join(cause.what, " / "));
  if (!cause.only_with.empty())
    found.what += fmt::format(" (only with {})", fmt::join(cause.only_with, ", "));
  return found;
}

std::string CausesTable(std::span<const CauseFound> all) {
  constexpr std::array<std::string_view, 3> kWords{"right", "WRONG", "none"};
  std::string text =
      "| mutant | half | planted | found | | what | property |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n";
  std::array<Figures, 2> halves;
  for (const CauseFound& found : all) {
    const std::string_view expected = ExpectedCauses(found.mutant.name);
    // What splits the mutants in halves has nothing to do with what they are.
    const auto half = static_cast<std::size_t>(Fnv1a(found.mutant.name) % 2);
    const auto named = static_cast<std::size_t>(Judged(found));
    ++(expected.empty() ? halves[half].without : halves[half].with)[named];
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", found.mutant.name,
                        half == 0 ? "tuned" : "counted", expected, found.name, kWords[named],
                        found.what, found.property);
  }
  return text + "\n" + FiguresLine("half that suspects were tuned on", halves[0]) +
         FiguresLine("other half", halves[1]);
}

}  // namespace rasterproof::tool
