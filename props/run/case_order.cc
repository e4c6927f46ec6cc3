#include "props/run/case_order.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "props/run/property_domains.h"

namespace rasterproof::props {
namespace {

// A run of so many cases has few: 13 are drawn ones, 7 chosen ones.
constexpr std::size_t kFewCases = 20;
constexpr std::size_t kDrawnOfFew = 13;
// The second of three cases is a chosen one.
constexpr std::uint64_t kOneIn = 3;

}  // namespace

CaseOrder::CaseOrder(const SubjectInfo& info, const Property& property, std::uint64_t seed)
    : domains_(DomainsFor(info, property)), first_index_(FirstIndex(property.name)), seed_(seed) {
  if (domains_.size() <= kFewCases) return;
  for (const FirstCase& first : FirstCases()) {
    const auto domain =
        std::find_if(domains_.begin() + kDrawnOfFew, domains_.end(),
                     [&](const Domain* each) { return each->name == first.domain; });
    if (domain == domains_.end()) continue;
    chosen_.push_back({{std::string(first.domain), first.index, kFirstCasesSeed},
                       static_cast<std::size_t>(domain - domains_.begin())});
  }
}

CaseOrder::Turn CaseOrder::TurnOf(std::uint64_t number) const {
  if (number >= kOneIn * chosen_.size()) return {false, number - chosen_.size()};
  const std::uint64_t chosen_before = (number + 1) / kOneIn;
  const bool is_chosen = number % kOneIn == 1;
  return {is_chosen, is_chosen ? chosen_before : number - chosen_before};
}

CaseName CaseOrder::Name(std::uint64_t number) const {
  const Turn turn = TurnOf(number);
  if (turn.is_chosen) return chosen_[static_cast<std::size_t>(turn.number)].name;
  return NameOfCase(domains_, first_index_, seed_, turn.number);
}

std::size_t CaseOrder::PlaceOf(std::uint64_t number) const {
  const Turn turn = TurnOf(number);
  return turn.is_chosen ? chosen_[static_cast<std::size_t>(turn.number)].place
                        : static_cast<std::size_t>(turn.number % domains_.size());
}

}  // namespace rasterproof::props
