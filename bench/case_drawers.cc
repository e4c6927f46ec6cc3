#include "bench/case_drawers.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "core/clock.h"

namespace rasterproof::bench {

std::uint32_t ParameterIn(BenchResult& result, const BenchParameter& parameter) {
  auto& known = result.parameters;
  const auto found = std::ranges::find(known, parameter.name, &BenchParameter::name);
  const auto at = static_cast<std::uint32_t>(found - known.begin());
  if (found == known.end()) known.push_back(parameter);
  return at;
}

std::uint32_t ParameterIn(BenchResult& result, const Parameter& parameter) {
  return ParameterIn(result, Described(parameter));
}

std::uint32_t MethodIn(BenchResult& result, const BenchMethod& method) {
  auto& known = result.methods;
  const auto found = std::ranges::find_if(known, [&](const BenchMethod& one) {
    return one.name == method.name && one.target == method.target && one.sink == method.sink;
  });
  const auto at = static_cast<std::uint32_t>(found - known.begin());
  if (found == known.end()) known.push_back(method);
  return at;
}

bool IsAsked(std::string_view name, std::span<const std::string> names) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

void ForEachDrawer(std::span<const std::unique_ptr<Contender>> contenders,
                   std::span<const std::string> names, double end, const std::string& what,
                   BenchResult& result,
                   const std::function<void(SceneDrawer& drawer, std::uint32_t method)>& call) {
  std::set<std::string> seen;
  for (const auto& contender : contenders) {
    if (!IsAsked(contender->method().name, names) || !contender->DrawsAlone() ||
        !seen.insert(contender->method().name).second)
      continue;
    if (WallSeconds() > end) {
      result.not_measured.push_back(what + ": " + contender->method().name);
      continue;
    }
    const std::unique_ptr<SceneDrawer> drawer = DrawerOf(*contender);
    call(*drawer, MethodIn(result, contender->method()));
  }
}

}  // namespace rasterproof::bench
