#include "props/run/contract_evidence.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/draw_options.h"
#include "core/profile.h"
#include "core/profile_keys.h"
#include "exact/coverage.h"
#include "props/properties/contract_properties.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/property_domains.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kProbesOfAProperty = 24;

// Draws the canonical model: what it can't be asked, no subject of the profile can.
class ModelSubject final : public Subject {
 public:
  explicit ModelSubject(SubjectInfo info) : info_(std::move(info)) {
    info_.coverage = CoverageKind::kFacingCounts;
  }
  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    counts += exact::Coverage(scene, info_.profile, options);
  }

 private:
  SubjectInfo info_;
};

bool CanBePutToTheTest(const SubjectInfo& info) {
  ModelSubject subject(info);
  for (const std::string_view name : PropertiesOf(info.profile.contract)) {
    const Property& property = *FindProperty(name);
    if (DomainsFor(info, property).empty()) continue;
    for (std::uint64_t n = 0; n < kProbesOfAProperty; ++n) {
      const Case c = DrawCase(info, property, kDefaultSeed, n);
      if (RunCase(subject, property, c).exercised != 0) return true;
    }
  }
  return false;
}

// The keys that are set and that change things when they alone are left out; and if there are none,
// all that are set.
std::string KeysInTheWay(const SubjectInfo& info) {
  std::string alone;
  std::string together;
  for (const ProfileKey& key : kProfileKeys) {
    SubjectInfo without = info;
    key.member.copy(Profile{}, without.profile);
    if ((key.marks & kHinders) == 0 || without.profile == info.profile) continue;
    const auto add = [&](std::string& keys, std::string_view joint) {
      keys += (keys.empty() ? "" : std::string(joint)) + std::string(key.name);
    };
    add(together, ", ");
    if (CanBePutToTheTest(without)) add(alone, " or ");
  }
  if (!alone.empty()) return "its key " + alone + " stands in the way";
  return together.empty() ? "" : "its keys " + together + " stand in the way";
}

bool IsOf(Contract contract, const PropertyResult& result) {
  return std::ranges::find(PropertiesOf(contract), result.property) != PropertiesOf(contract).end();
}

std::string Why(const SubjectInfo& info, std::uint64_t cases, std::uint64_t refused) {
  const std::string contract(ContractName(info.profile.contract));
  if (cases != 0 && refused == cases) {
    return "no property of the contract " + contract +
           " was tested: the subject refused every case";
  }
  if (CanBePutToTheTest(info)) {
    return "no property of the contract " + contract + " was exercised: raise --cases";
  }
  const std::string keys = KeysInTheWay(info);
  return "no property of the profile's contract " + contract +
         " can be tested: " + (keys.empty() ? "the subject takes no scenes of their kinds" : keys);
}

bool StatesOwners(Contract contract) {
  return contract == Contract::kSampleExact || contract == Contract::kWatertight ||
         contract == Contract::kClosed;
}

// Of the results of drawn cases alone: nothing was counted of the others.
std::string WhyThin(Contract contract, std::span<const PropertyResult> results) {
  std::uint64_t ties = 0;
  bool is_counted = false;
  for (const PropertyResult& result : results) {
    if (!IsOf(contract, result) || result.exercised == 0) continue;
    if (!result.world.empty()) return "";
    const NearEdgeCounts near_edge = result.NearEdge();
    is_counted = is_counted || near_edge.samples != 0;
    ties += near_edge.on_edge;
  }
  if (!StatesOwners(contract) || !is_counted || ties >= kFewestTies) return "";
  return "thin: " + std::to_string(ties) + " samples on an edge test the contract " +
         std::string(ContractName(contract)) + ", fewer than " + std::to_string(kFewestTies);
}

}  // namespace

ContractEvidence EvidenceOfContract(const SubjectInfo& info,
                                    std::span<const PropertyResult> results) {
  if (info.profile.contract == Contract::kNone) return {true, ""};
  std::uint64_t cases = 0;
  std::uint64_t refused = 0;
  for (const PropertyResult& result : results) {
    if (!IsOf(info.profile.contract, result)) continue;
    if (result.exercised != 0 || result.outcome == Outcome::kViolated) {
      return {true, "", WhyThin(info.profile.contract, results)};
    }
    cases += result.cases;
    refused += result.cases_refused;
  }
  return {false, Why(info, cases, refused)};
}

}  // namespace rasterproof::props
