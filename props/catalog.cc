#include <span>
#include <string_view>
#include <vector>

#include "props/claims/all.h"
#include "props/property.h"

namespace rasterproof::props {

std::span<const Property> Catalog() {
  static const std::vector<Property> all = [] {
    std::vector<Property> claims;
    for (const Property* claim : kAllClaims) claims.push_back(*claim);
    return claims;
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
