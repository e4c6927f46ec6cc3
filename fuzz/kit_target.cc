// The target of kit/fuzz.h.
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/subject.h"
#include "fuzz/fuzz_target.h"
#include "kit/fuzz.h"

namespace rasterproof::kit {

struct FuzzTarget::Parts {
  fuzz::Bound bound;
};

FuzzTarget::FuzzTarget(std::unique_ptr<Subject> subject,
                       std::initializer_list<std::string_view> properties) {
  std::vector<std::string_view> names(properties);
  if (names.empty()) names = fuzz::ContractPropertiesOf(*subject);
  for (const std::string_view name : names) fuzz::RequireApplies(*subject, name);
  parts_ = std::make_unique<const Parts>(fuzz::Bound(std::move(subject), names));
}

FuzzTarget::~FuzzTarget() = default;

int FuzzTarget::Run(std::span<const std::uint8_t> bytes) const {
  return parts_->bound.PutToTheTest(bytes);
}

}  // namespace rasterproof::kit
