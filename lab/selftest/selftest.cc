#include "lab/selftest/selftest.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <utility>

#include "fmt/format.h"
#include "io/json_writer.h"
#include "props/property.h"
#include "props/run/campaign.h"

namespace rasterproof::lab {
namespace {

using Clock = std::chrono::steady_clock;

// A case or two of every domain first, and then four times as many in each round.
constexpr std::uint64_t kFirstRound = 32;
constexpr std::uint64_t kGrowth = 4;
// A legal variant passes only by running to the end, three times over: a mutant seldom does.
constexpr std::uint64_t kLegalSeeds = 3;

std::uint64_t LegalCases(std::uint64_t cases) { return std::max<std::uint64_t>(1, cases / 10); }

double Median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// What the counterexample says, without the numbers that a reader of the table can't use.
std::string SeenText(const PropertyResult& violation) {
  const std::optional<Witness>& witness = violation.counterexample->verdict.witness;
  if (!witness || witness->observed.empty()) return violation.message;
  std::string text =
      TextOfValue(witness->observed) + "; expected " + TextOfValue(witness->expected);
  std::ranges::replace(text, '|', '/');
  constexpr std::size_t kLongest = 90;
  if (text.size() > kLongest) text = text.substr(0, kLongest - 3) + "...";
  return text;
}

std::string KillRow(const HuntResult& result) {
  const std::string& change = result.mutant.change;
  const std::string source =
      result.mutant.source.empty() ? "" : fmt::format(" ({})", result.mutant.source);
  const std::string name = result.mutant.name.substr(result.mutant.name.find(':') + 1);
  if (!result.hunt.violation) {
    return fmt::format("| {} | {}{} | **survived** | {} | | |\n", name, change, source,
                       result.hunt.cases);
  }
  const PropertyResult& violation = *result.hunt.violation;
  const Scene& scene = violation.counterexample->value.scene;
  return fmt::format("| {} | {}{} | {} | {} | {} in {}x{} | {} |\n", name, change, source,
                     violation.property, result.hunt.cases, scene.triangles.size(), scene.width,
                     scene.height, SeenText(violation));
}

// Figures over the mutants for which `counts` holds.
template <class Counts>
std::string MutantFigures(const std::vector<HuntResult>& results, std::string_view what,
                          Counts counts) {
  std::vector<double> cases, triangles, widths, heights;
  std::set<std::string> properties;
  std::size_t mutants = 0, small = 0;
  for (const HuntResult& result : results) {
    if (result.mutant.legal || !counts(result.mutant)) continue;
    ++mutants;
    if (!result.hunt.violation) continue;
    const Scene& scene = result.hunt.violation->counterexample->value.scene;
    cases.push_back(static_cast<double>(result.hunt.cases));
    triangles.push_back(static_cast<double>(scene.triangles.size()));
    widths.push_back(scene.width);
    heights.push_back(scene.height);
    properties.insert(result.hunt.violation->property);
    if (scene.triangles.size() <= 2 && scene.width <= 16 && scene.height <= 16) ++small;
  }
  if (mutants == 0) return "";
  return fmt::format(
      "- {}: {} of {} killed, by {} properties; median {:.0f} cases to the kill; median "
      "counterexample {:.0f} triangles in {:.0f}x{:.0f}; {} have at most 2 triangles in 16x16\n",
      what, cases.size(), mutants, properties.size(), Median(cases), Median(triangles),
      Median(widths), Median(heights), small);
}

std::string LegalFigures(const std::vector<HuntResult>& results, std::uint64_t legal_cases) {
  std::set<std::string> variants;
  std::set<std::uint64_t> seeds;
  std::uint64_t cases = 0, exercised = 0, inconclusive = 0;
  std::string violations;
  for (const HuntResult& result : results) {
    if (!result.mutant.legal) continue;
    variants.insert(result.mutant.name);
    seeds.insert(result.seed);
    cases += result.hunt.cases;
    exercised += result.hunt.exercised;
    inconclusive += result.hunt.inconclusive;
    if (result.AsItShould()) continue;
    violations +=
        fmt::format("  - {} under seed {} violates {}: {}\n", result.mutant.name, result.seed,
                    result.hunt.violation->property, result.hunt.violation->message);
  }
  if (variants.empty()) return "";
  return fmt::format(
      "- legal variants: {} under {} seeds each, {} cases a property; {} violations in {} cases, "
      "{} of which put a property to the test{}\n{}",
      variants.size(), seeds.size(), legal_cases, std::ranges::count(violations, '\n'), cases,
      exercised, inconclusive == 0 ? "" : fmt::format("; {} runs inconclusive", inconclusive),
      violations);
}

}  // namespace

Hunt HuntBug(Subject& subject, const props::CampaignOptions& options,
             std::span<const std::string> killers) {
  const Clock::time_point start = Clock::now();
  Hunt hunt;
  std::vector<const props::Property*> applicable;
  for (const props::Property& property : props::Catalog()) applicable.push_back(&property);
  const auto run = [&](const props::Property& property, std::uint64_t first, std::uint64_t last) {
    props::CampaignOptions campaign = options;
    campaign.first_case = first;
    campaign.cases = last - first;
    if (options.progress) {
      campaign.progress = [&](std::uint64_t done) { options.progress(hunt.cases + done); };
    }
    return props::RunCampaign(subject, property, campaign);
  };
  for (std::uint64_t done = 0, round = kFirstRound; done < options.cases && !hunt.violation;
       done += round, round *= kGrowth) {
    std::vector<const props::Property*> again;
    for (const props::Property* property : applicable) {
      PropertyResult result = run(*property, done, std::min(done + round, options.cases));
      if (result.outcome == Outcome::kNotApplicable) continue;
      again.push_back(property);
      hunt.cases += result.cases;
      hunt.exercised += result.cases_exercised;
      if (result.outcome == Outcome::kInconclusive) ++hunt.inconclusive;
      // No clause names the caller's floating-point mode; what is drawn in others was planted so.
      const bool is_of_quality = property->gate.shows == props::Shows::kFloatModes ||
                                 std::ranges::find(killers, property->name) != killers.end();
      if (!IsFailure(result, is_of_quality ? FailOn::kQuality : FailOn::kStated)) continue;
      hunt.violation = std::move(result);
      break;
    }
    applicable = std::move(again);
  }
  hunt.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return hunt;
}

std::vector<HuntTask> HuntTasks(const std::vector<subjects::MutantInfo>& mutants,
                                std::uint64_t seed, std::uint64_t cases) {
  std::vector<HuntTask> tasks;
  for (const subjects::MutantInfo& mutant : mutants) {
    if (!mutant.legal) {
      tasks.push_back({mutant, seed, cases});
      continue;
    }
    for (std::uint64_t k = 0; k < kLegalSeeds; ++k)
      tasks.push_back({mutant, seed + k, LegalCases(cases)});
  }
  return tasks;
}

HuntResult RunHunt(const HuntTask& task, const std::function<void(std::uint64_t)>& progress) {
  props::CampaignOptions options;
  options.seed = task.seed;
  options.cases = task.cases;
  options.progress = progress;
  return {task.mutant, task.seed,
          HuntBug(*subjects::MakeMutant(task.mutant.name), options, task.mutant.killers)};
}

std::string SelftestText(const std::vector<HuntResult>& results, std::uint64_t cases,
                         double seconds) {
  std::string text =
      "| mutant | a sound rasterizer, but | killed by | after cases | shrunken triangles, target | "
      "seen there |\n| --- | --- | --- | --- | --- | --- |\n";
  for (const HuntResult& result : results) {
    if (!result.mutant.legal) text += KillRow(result);
  }
  text += fmt::format("\nAt most {} cases a property, {:.0f} s in all.\n\n", cases, seconds);
  using Info = subjects::MutantInfo;
  text += MutantFigures(results, "mutants", [](const Info& info) { return !info.is_late; });
  text += MutantFigures(results, "late mutants", [](const Info& info) { return info.is_late; });
  return text + LegalFigures(results, LegalCases(cases));
}

std::string SelftestJson(const std::vector<HuntResult>& results) {
  io::JsonWriter json;
  json.BeginObject().Key("rasterproof_selftest").Integer(1).Key("results").BeginArray();
  for (const HuntResult& result : results) {
    json.BeginObject().Key("name").Text(result.mutant.name);
    json.Key("legal").Bool(result.mutant.legal).Key("late").Bool(result.mutant.is_late);
    json.Key("seed").Integer(result.seed).Key("cases").Integer(result.hunt.cases);
    json.Key("inconclusive").Integer(result.hunt.inconclusive);
    json.Key("seconds").Rounded(result.hunt.seconds);
    json.Key("violated").Bool(result.hunt.violation.has_value());
    if (result.hunt.violation) {
      const PropertyResult& violation = *result.hunt.violation;
      const Scene& scene = violation.counterexample->value.scene;
      json.Key("property").Text(violation.property);
      json.Key("case").Text(violation.counterexample->failing_case);
      json.Key("triangles").Integer(scene.triangles.size());
      json.Key("width").Integer(scene.width).Key("height").Integer(scene.height);
      json.Key("message").Text(violation.message);
    }
    json.EndObject();
  }
  return json.EndArray().EndObject().Finish();
}

}  // namespace rasterproof::lab
