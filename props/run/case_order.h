// Which cases a run of a property takes, in which order: chosen ones between the drawn ones.
#ifndef RASTERPROOF_PROPS_RUN_CASE_ORDER_H_
#define RASTERPROOF_PROPS_RUN_CASE_ORDER_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/subject_info.h"
#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/property.h"

namespace rasterproof::props {

/// A case that was chosen once, because few others find what it finds. Its name keeps its meaning:
/// DOMAIN:INDEX@kFirstCasesSeed.
struct FirstCase {
  std::string_view domain;
  std::uint64_t index = 0;
};

inline constexpr std::uint64_t kFirstCasesSeed = 1;

/// The chosen cases, the one that finds most first. scripts/first_cases says how they were chosen.
std::span<const FirstCase> FirstCases();

/// The cases of a run, numbered from 0. Of a property with more than 20 turns of domains every
/// third case is the next of FirstCases() that is of a domain with the 14th turn or a later one, as
/// long as there are any; the others are drawn under the seed, by NameOfCase. So a run of few cases
/// has the first 13 domains and what finds most in the others, which it would not reach. Properties
/// with fewer turns have no chosen cases: a run of 20 reaches them all.
///
/// Properties: worked out from the number alone, so that shards and replays agree. Different
///             numbers have different names, but for a property whose FirstIndex is 0.
class CaseOrder {
 public:
  CaseOrder(const SubjectInfo& info, const Property& property, std::uint64_t seed);

  /// Whether the subject takes scenes of none of the property's domains: then there is no case.
  bool IsEmpty() const { return domains_.empty(); }
  CaseName Name(std::uint64_t number) const;
  /// The place of the case's domain in DomainsFor().
  std::size_t PlaceOf(std::uint64_t number) const;

 private:
  struct Chosen {
    CaseName name;
    std::size_t place = 0;
  };

  // Whether the case is a chosen one, and which of the chosen or the drawn ones it is.
  struct Turn {
    bool is_chosen = false;
    std::uint64_t number = 0;
  };
  Turn TurnOf(std::uint64_t number) const;

  std::vector<const Domain*> domains_;
  std::uint64_t first_index_;
  std::uint64_t seed_;
  std::vector<Chosen> chosen_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_CASE_ORDER_H_
