#include "props/run/contract_evidence.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/draw_options.h"
#include "core/profile.h"
#include "exact/coverage.h"
#include "props/claims/contract_claims.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/property_domains.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kProbesOfAClaim = 24;

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
  for (const std::string_view name : ClaimsOf(info.profile.contract)) {
    const Property& claim = *FindProperty(name);
    if (DomainsFor(info, claim).empty()) continue;
    for (std::uint64_t n = 0; n < kProbesOfAClaim; ++n) {
      const Case c = DrawCase(info, claim, kDefaultSeed, n);
      if (RunCase(subject, claim, c).exercised != 0) return true;
    }
  }
  return false;
}

// A key of the profile, and how it reads when it is left out.
struct Key {
  std::string_view name;
  void (*leave_out)(Profile&);
};

constexpr auto kKeys = std::to_array<Key>(
    {{"fill_rule", [](Profile& p) { p.fill_rule = {}; }},
     {"overdraw", [](Profile& p) { p.overdraw = false; }},
     {"no_clip", [](Profile& p) { p.no_clip.reset(); }},
     {"crossing", [](Profile& p) { p.crossing = {}; }},
     {"fixed", [](Profile& p) { p.fixed.reset(); }},
     {"max_extent", [](Profile& p) { p.max_extent.reset(); }},
     {"zero_area", [](Profile& p) { p.zero_area = ZeroArea::kNothing; }},
     {"coordinate_limit", [](Profile& p) { p.coordinate_limit = Profile{}.coordinate_limit; }},
     {"snap_tolerance", [](Profile& p) { p.freedom.snap_tolerance = 0; }},
     {"any_tie_rule", [](Profile& p) { p.freedom.any_tie_rule = false; }},
     {"snap_form", [](Profile& p) { p.snap.form = SnapForm::kCoordinate; }},
     {"subpixel_bits", [](Profile& p) { p.snap = {}; }},
     {"targets", [](Profile& p) { p.targets.clear(); }},
     {"transform", [](Profile& p) { p.transform.reset(); }}});

// The keys that are set and that change things when they alone are left out; and if there are none,
// all that are set.
std::string KeysInTheWay(const SubjectInfo& info) {
  std::string alone;
  std::string together;
  for (const Key& key : kKeys) {
    SubjectInfo without = info;
    key.leave_out(without.profile);
    if (without.profile == info.profile) continue;
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
  return std::ranges::find(ClaimsOf(contract), result.property) != ClaimsOf(contract).end();
}

std::string Why(const SubjectInfo& info, std::uint64_t cases, std::uint64_t refused) {
  const std::string contract(ContractName(info.profile.contract));
  if (cases != 0 && refused == cases) {
    return "no claim of the contract " + contract +
           " was put to the test: the subject refused every case";
  }
  if (CanBePutToTheTest(info)) {
    return "no claim of the contract " + contract +
           " was put to the test by the cases that were drawn: raise --cases";
  }
  const std::string keys = KeysInTheWay(info);
  return "no claim of the profile's contract " + contract + " can be put to the test: " +
         (keys.empty() ? "the subject takes none of the scenes that its claims are about" : keys);
}

}  // namespace

ContractEvidence EvidenceOfContract(const SubjectInfo& info,
                                    std::span<const PropertyResult> results) {
  if (info.profile.contract == Contract::kNone) return {true, ""};
  std::uint64_t cases = 0;
  std::uint64_t refused = 0;
  for (const PropertyResult& result : results) {
    if (!IsOf(info.profile.contract, result)) continue;
    if (result.exercised != 0 || result.outcome == Outcome::kViolated) return {true, ""};
    cases += result.cases;
    refused += result.cases_refused;
  }
  return {false, Why(info, cases, refused)};
}

}  // namespace rasterproof::props
