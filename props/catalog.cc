#include <span>
#include <string_view>
#include <vector>

#include "props/properties/all.h"
#include "props/property.h"

namespace rasterproof::props {

std::span<const Property> Catalog() {
  static const std::vector<Property> all = [] {
    std::vector<Property> properties;
    for (const Property* property : kAllProperties) properties.push_back(*property);
    return properties;
  }();
  return all;
}

const Property* FindProperty(std::string_view name) {
  for (const Property& property : Catalog()) {
    if (property.name == name) return &property;
  }
  return nullptr;
}

}  // namespace rasterproof::props
