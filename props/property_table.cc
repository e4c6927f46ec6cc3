#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "props/property.h"

namespace rasterproof::props {

// The build makes these of the files in properties/.
extern const Property* const kAllProperties[];
extern const std::size_t kNumberOfProperties;

std::span<const Property> Catalog() {
  static const std::vector<Property> all = [] {
    std::vector<Property> properties;
    for (std::size_t k = 0; k < kNumberOfProperties; ++k) properties.push_back(*kAllProperties[k]);
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
