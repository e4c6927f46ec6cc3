#include "tool/bench/fingerprints.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/bench.h"
#include "fmt/format.h"
#include "io/base64.h"
#include "io/image.h"
#include "io/output.h"
#include "report/palette.h"

namespace rasterproof::tool {
namespace {

// In the order of bench::SampleOwner.
constexpr std::array kColours{report::kCoveredTwice, report::kBlue, report::kVermilion,
                              report::kUncovered};

// "mine.so-2^-12.png", without what a file's name can't have.
std::string FileName(const std::string& method, const std::string& step) {
  std::string name = method + "-" + step + ".png";
  std::ranges::replace(name, '/', '_');
  std::ranges::replace(name, ' ', '-');
  return name;
}

std::string CountsCell(const BenchFingerprint& print) {
  if (print.places == BenchFingerprint{}.places) return fmt::format("{}", print.wrong);
  return fmt::format("{} of {}", print.wrong, print.places);
}

// Places of the first contender of each name; twins are the same method again.
std::vector<std::uint32_t> OnePerName(
    std::span<const std::unique_ptr<bench::Contender>> contenders) {
  std::vector<std::uint32_t> places;
  std::set<std::string> names;
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    const std::string& name = contenders[k]->method().name;
    if (bench::IsTwin(name) || name == bench::kFloor || !names.insert(name).second) continue;
    places.push_back(static_cast<std::uint32_t>(k));
  }
  return places;
}

void Add(const bench::Fingerprint& print, std::uint32_t method, const bench::FingerprintStep& step,
         const std::string& folder, BenchResult& result) {
  const std::string png = FingerprintPng(print);
  BenchFingerprint& record = result.fingerprints.emplace_back();
  record.method = method;
  record.step = step.name;
  record.wrong = print.Wrong();
  record.places = print.drawn.size();
  record.png = io::ToBase64(png);
  if (folder.empty()) return;
  io::WriteFile(folder + "/" + FileName(result.methods[method].name, record.step), png);
}

}  // namespace

std::string FingerprintPng(const bench::Fingerprint& print) {
  constexpr int kSide = bench::FingerprintPlaces::kSide;
  const int scale = kSide / print.side;
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < kSide; ++y) {
    for (const auto* owners : {&print.drawn, &print.exact}) {
      for (int x = 0; x < kSide; ++x) {
        const int at = y / scale * print.side + x / scale;
        pixels.push_back(static_cast<std::uint8_t>((*owners)[static_cast<std::size_t>(at)]));
      }
    }
  }
  return io::EncodePalettePng(2 * kSide, kSide, pixels, kColours);
}

std::vector<std::string> RunFingerprints(
    std::span<const std::unique_ptr<bench::Contender>> contenders,
    std::span<const bench::FingerprintStep> steps, const std::string& folder, BenchResult& result) {
  if (!folder.empty()) io::MakeFolder(folder);
  for (std::size_t k = result.methods.size(); k < contenders.size(); ++k) {
    result.methods.push_back(contenders[k]->method());
  }
  std::vector<std::string> without;
  for (const bench::FingerprintStep& step : steps) {
    bench::FingerprintPlaces places(step);
    for (const std::uint32_t k : OnePerName(contenders)) {
      bench::Contender& contender = *contenders[k];
      const std::string& name = contender.method().name;
      std::optional<std::string> why = places.WhyNot(contender);
      if (!why) {
        try {
          Add(places.Of(contender), k, step, folder, result);
        } catch (const std::exception& error) {
          if (!contender.method().is_users) throw;
          why = error.what();
        }
      }
      if (!why) continue;
      without.push_back(
          fmt::format("{} has no fingerprint at steps of {}: {}", name, step.name, *why));
    }
  }
  return without;
}

std::string FingerprintTable(const BenchResult& result) {
  std::vector<std::string> steps;
  std::vector<std::uint32_t> methods;
  std::map<std::pair<std::uint32_t, std::string>, std::string> cells;
  for (const BenchFingerprint& print : result.fingerprints) {
    if (std::ranges::find(steps, print.step) == steps.end()) steps.push_back(print.step);
    if (std::ranges::find(methods, print.method) == methods.end()) methods.push_back(print.method);
    cells[{print.method, print.step}] = CountsCell(print);
  }
  std::string text =
      "Places of an edge's end, of 65,536, where a sample differs from the method's own model, by "
      "the step between places:\n";
  std::string head = fmt::format("{:<29}{:<18}", "method", "model");
  for (const std::string& step : steps) head += fmt::format("{:>16}", step);
  text += head + '\n';
  for (const std::uint32_t method : methods) {
    const BenchMethod& described = result.methods[method];
    text += fmt::format("{:<29}{:<18}", described.name, described.model);
    for (const std::string& step : steps) {
      const auto cell = cells.find({method, step});
      text += fmt::format("{:>16}", cell == cells.end() ? "-" : cell->second);
    }
    text += '\n';
  }
  return text;
}

}  // namespace rasterproof::tool
