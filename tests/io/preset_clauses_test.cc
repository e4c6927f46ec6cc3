// Every key of every preset cites a row of the clause table.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/clauses/clauses.h"
#include "core/profile.h"
#include "core/profile_keys.h"
#include "core/square_presets.h"
#include "io/case_file.h"
#include "nlohmann/json.hpp"

namespace rasterproof::io {
namespace {

constexpr std::string_view kCanonical = "-canonical";

// "0.6" and "0x1.3333333333333p-1" are one value.
bool SameValue(const std::string& a, const std::string& b) {
  if (a == b) return true;
  char* end_a = nullptr;
  char* end_b = nullptr;
  const double x = std::strtod(a.c_str(), &end_a);
  const double y = std::strtod(b.c_str(), &end_b);
  return end_a != a.c_str() && *end_a == '\0' && end_b != b.c_str() && *end_b == '\0' && x == y;
}

// Keys and values of a profile, one a line as ProfileToJson writes them; texts without quotes.
std::vector<std::pair<std::string, std::string>> KeysOf(const Profile& profile) {
  std::vector<std::pair<std::string, std::string>> keys;
  std::istringstream lines(ProfileToJson(profile));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find('"');
    const std::size_t between = line.find("\": ");
    if (begin == std::string::npos || between == std::string::npos) continue;
    std::string value = line.substr(between + 3);
    if (value.ends_with(',')) value.pop_back();
    if (value.starts_with('"')) value = value.substr(1, value.size() - 2);
    keys.emplace_back(line.substr(begin + 1, between - begin - 1), value);
  }
  return keys;
}

// The clauses of the specification, its base's included.
std::vector<const Clause*> ClausesOf(const Specification& specification) {
  std::vector<const Clause*> clauses;
  for (const Clause& clause : specification.clauses) clauses.push_back(&clause);
  if (const Specification* base = FindSpecification(specification.base)) {
    for (const Clause& clause : base->clauses) clauses.push_back(&clause);
  }
  return clauses;
}

// Whether a row stands for the key, with this value or with any. A model's value is nobody's: its
// key is enough.
bool IsCited(const Specification& specification, const std::string& key, const std::string& value,
             bool is_model) {
  return std::ranges::any_of(ClausesOf(specification), [&](const Clause* clause) {
    return std::ranges::any_of(KeysOf(*clause), [&](const ClauseKey& one) {
      if (one.key != key) return false;
      return is_model || one.value.empty() || SameValue(std::string(one.value), value);
    });
  });
}

TEST(PresetClauses, EveryKeyOfEveryPresetCitesARow) {
  std::size_t checked = 0;
  for (const std::string_view name : kPresetProfiles) {
    const bool is_model = name.ends_with(kCanonical) || HasOneModel(*PresetProfile(name));
    std::string_view api = name;
    if (api.ends_with(kCanonical)) api.remove_suffix(kCanonical.size());
    const Specification* specification = SpecificationOf(api);
    if (specification == nullptr) continue;  // "real" is nobody's
    Profile renamed = *PresetProfile(name);
    renamed.name = "its keys, not its name";
    for (const auto& [key, value] : KeysOf(renamed)) {
      if (key == "name") continue;
      ++checked;
      EXPECT_TRUE(IsCited(*specification, key, value, is_model))
          << name << ": no clause of " << api << " stands for " << key << "=" << value;
    }
  }
  EXPECT_GE(checked, 3U * 7U);
}

TEST(PresetClauses, ClausesStandForKeysThatProfilesHave) {
  for (const Specification& specification : Specifications()) {
    for (const Clause& clause : specification.clauses) {
      for (const ClauseKey& one : KeysOf(clause)) {
        const std::string_view name = one.key.substr(0, one.key.find('.'));
        EXPECT_EQ(std::ranges::count(kProfileKeys, name, &ProfileKey::name), 1)
            << clause.id << ": " << one.key;
      }
    }
  }
}

// A preset that leaves a key out states its usual value by that: it is cited as well.
TEST(PresetClauses, WhatPresetsLeaveOutIsCitedToo) {
  constexpr auto kKeys = std::to_array<std::string_view>(
      {"contract", "subpixel_bits", "snap_rule", "snap_tolerance", "rounding", "tie_rule",
       "tie_ownership", "sample_locations", "y_axis", "coordinate_limit", "degenerate_triangles",
       "infinite_vertex", "nan_vertex", "nan_z", "guard_band", "transform_error",
       "translation_invariant", "centroid"});
  for (const char* api : {"gl", "vulkan", "d3d11", "webgpu"}) {
    for (const std::string_view key : kKeys) {
      EXPECT_TRUE(IsCited(*FindSpecification(api), std::string(key), "", /*is_model=*/true))
          << api << ": " << key;
    }
  }
}

// The members of a region as ProfileToJson writes them, in one line each: "must", "relation".
std::vector<std::pair<std::string, std::string>> KeysOfSquares(const Profile& profile) {
  const auto coverage = nlohmann::json::parse(ProfileToJson(profile)).at("coverage");
  std::vector<std::pair<std::string, std::string>> keys{
      {"coverage.flat", coverage.at("flat").get<std::string>()}};
  for (const char* bound : {"must", "may"}) {
    const auto& region = coverage.at(bound);
    if (region.is_null()) continue;
    const bool grows = region.at("half_width") != "0x0p+0";
    for (const auto& [key, value] : region.items()) {
      if (!grows && (key == "half_width" || key == "growth")) continue;  // of no effect
      keys.emplace_back(std::string("coverage.") + bound + "." + key, value.get<std::string>());
    }
  }
  return keys;
}

TEST(PresetClauses, EveryKeyOfEveryPresetOfSquaresCitesARow) {
  for (const SquarePresetInfo& preset : kSquarePresets) {
    const Specification* specification = SpecificationOf(preset.name);
    if (specification == nullptr) {
      EXPECT_EQ(preset.name, "voxel") << "a definition, of no specification";
      continue;
    }
    Profile renamed = *PresetProfile(preset.name);
    renamed.name = "its keys, not its name";
    auto keys = KeysOfSquares(renamed);
    for (const auto& [key, value] : keys) {
      EXPECT_TRUE(IsCited(*specification, key, value, /*is_model=*/false))
          << preset.name << ": no clause stands for " << key << "=" << value;
    }
    EXPECT_TRUE(IsCited(*specification, "contract", "squares", /*is_model=*/false)) << preset.name;
    renamed.squares.reset();
    renamed.contract = Contract::kSampleExact;
    Profile plain;
    plain.name = renamed.name;
    const auto usual = KeysOf(plain);
    for (const auto& [key, value] : KeysOf(renamed)) {
      if (key == "name" || std::ranges::count(usual, std::pair(key, value)) != 0) continue;
      EXPECT_TRUE(IsCited(*specification, key, value, /*is_model=*/false))
          << preset.name << ": no clause stands for " << key << "=" << value;
    }
  }
}

TEST(PresetClauses, AnUnknownKeyWouldBeMissed) {
  EXPECT_FALSE(IsCited(*FindSpecification("vulkan"), "no_such_key", "1", /*is_model=*/true));
  EXPECT_FALSE(IsCited(*FindSpecification("d3d11"), "snap_tolerance", "0.61", /*is_model=*/false));
  EXPECT_TRUE(IsCited(*FindSpecification("d3d11"), "snap_tolerance", "0x1.3333333333333p-1",
                      /*is_model=*/false));
}

}  // namespace
}  // namespace rasterproof::io
