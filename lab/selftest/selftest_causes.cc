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
#include "lab/selftest/selftest.h"
#include "props/cause/cause.h"
#include "props/cause/evidence.h"
#include "subjects/mutants/mutants.h"

namespace rasterproof::lab {
namespace {

constexpr double kLongestSearch = 800;  // seconds: what is found may not depend on the clock

// A circumstance says that no suspect explains it, and what was seen to make the draws right: where
// something else was planted it is no cause named wrong.
enum class Named : std::uint8_t { kRight, kWrong, kCircumstance, kNone };
constexpr std::size_t kOutcomes = 4;

bool IsAmong(std::string_view name, std::string_view names) {
  for (std::size_t from = 0; from <= names.size();) {
    const std::size_t end = std::min(names.find('|', from), names.size());
    if (names.substr(from, end - from) == name) return true;
    from = end + 1;
  }
  return false;
}

Named Judged(const CauseFound& found) {
  const std::string_view expected = found.mutant.causes;
  if (found.name.empty()) return Named::kNone;
  if (IsAmong(found.name, expected)) return Named::kRight;
  return found.is_circumstance ? Named::kCircumstance : Named::kWrong;
}

struct Figures {
  // of mutants with a suspect, and of those without
  std::array<std::size_t, kOutcomes> with{};
  std::array<std::size_t, kOutcomes> without{};
};

std::string FiguresLine(std::string_view half, const Figures& f) {
  const auto [right, wrong, circumstance, none] = f.with;
  const auto& w = f.without;
  return fmt::format(
      "- {}: {} mutants with a suspect, {} named right, {} wrong, {} by a circumstance alone, {} "
      "not named; {} without one, {} rightly not named, {} by a circumstance alone, {} named "
      "wrong\n",
      half, right + wrong + circumstance + none, right, wrong, circumstance, none,
      w[0] + w[1] + w[2] + w[3], w[3], w[2], w[0] + w[1]);
}

}  // namespace

CauseFound FindCauseOf(const HuntResult& result) {
  CauseFound found{.mutant = result.mutant};
  if (!result.hunt.violation) return found;
  const auto make = [&] { return subjects::MakeMutant(result.mutant.name); };
  const auto failed = props::FailedBy(*result.hunt.violation, make()->Info());
  if (!failed) return found;
  const props::Causes causes = props::FindCauses(make, {&*failed, 1}, kLongestSearch);
  found.property = failed->property->name;
  if (causes.all.empty()) return found;
  const props::Cause& cause = causes.all.front();
  found.name = cause.name;
  found.is_circumstance = cause.kind == props::CauseKind::kCircumstance;
  found.what = fmt::format("{}", fmt::join(cause.what, " / "));
  if (cause.rests_on_few) found.what += fmt::format(" (too few: {})", cause.wrong_scenes);
  if (!cause.only_with.empty())
    found.what += fmt::format(" (only with {})", fmt::join(cause.only_with, ", "));
  return found;
}

std::string CausesTable(std::span<const CauseFound> all) {
  constexpr std::array<std::string_view, kOutcomes> kWords{"right", "WRONG", "circumstance",
                                                           "none"};
  std::string text =
      "| mutant | half | planted | found | | what | property |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n";
  std::array<Figures, 2> halves;
  for (const CauseFound& found : all) {
    const std::string_view expected = found.mutant.causes;
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

}  // namespace rasterproof::lab
