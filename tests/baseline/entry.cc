#include "tests/baseline/entry.h"

#include <exception>
#include <utility>

#include "props/property.h"
#include "props/run/campaign.h"

namespace rasterproof::baseline {

struct Trials::Parts {
  Record record;
  std::unique_ptr<Subject> subject;
  const props::Property* property = nullptr;
};

std::vector<std::string> PropertyNames() {
  std::vector<std::string> names;
  for (const props::Property& property : props::Catalog()) names.emplace_back(property.name);
  return names;
}

Trials::Trials(std::unique_ptr<Subject> raw, const std::string& property)
    : parts_(std::make_unique<Parts>()) {
  parts_->subject = Recording(std::move(raw), parts_->record);
  parts_->property = props::FindProperty(property);
}

Trials::~Trials() = default;

Case Trials::Draw(std::uint64_t seed, std::uint64_t index) const {
  return props::DrawCase(parts_->subject->Info(), *parts_->property, seed, index);
}

Tried Trials::Try(const Case& c) {
  parts_->record = {};
  Tried tried;
  try {
    tried.verdict = props::RunCase(*parts_->subject, *parts_->property, c);
  } catch (const std::exception& error) {
    tried.fault = error.what();
  }
  tried.record = parts_->record;
  return tried;
}

}  // namespace rasterproof::baseline
