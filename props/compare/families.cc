#include "props/compare/families.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "props/compare/yardsticks.h"
#include "props/run/description.h"
#include "props/run/property_domains.h"

namespace rasterproof::props {
namespace {

// By DomainTheme.
constexpr auto kThemes = std::to_array<Theme>({
    {"ordinary", "It covers the samples that exact geometry covers."},
    {"near edges",
     "Every sample gets the sign that exact arithmetic gives it, zero included; the tie rule "
     "decides on the edge alone."},
    {"long and thin",
     "A sliver covers the samples that exact geometry covers, often none, and none next to its "
     "line."},
    {"magnitudes",
     "Products that overflow, underflow or cancel decide nothing: the sign is that of the exact "
     "value, up to the stated limit."},
    {"snapping",
     "Every vertex goes to the grid point that the profile names, ties included, and neighbours "
     "agree on it."},
    {"no area, not finite",
     "A triangle without area or with a vertex that is not finite covers nothing; its neighbours "
     "are drawn as without it."},
    {"meshes",
     "Every sample inside is covered exactly once, at hubs too; what is closed cancels. Where "
     "triangles are inverted, front minus back does so."},
    {"calls and targets",
     "What a triangle covers depends neither on its neighbours in the call nor on the target's "
     "size or tiles."},
    {"pixel sides", "Corners and edges on the sides of pixels decide no sample but their own."},
    {"clip space",
     "The part in front of the eye is covered, and no vertex with w <= 0 is projected."},
});
constexpr Theme kSmallWorlds{"small worlds",
                             "Every case of the world is covered as exact geometry says."};

// Most worlds have small scenes: one is drawn if it has at most this many times the cases of a
// domain.
constexpr std::uint64_t kMostOfWorld = 100;
// A cell in which no case fails is excused if it has more excused cases than this for each other.
constexpr std::uint64_t kMostExcusedForEach = 20;

// Empty: it is drawn.
std::string WhyNotDrawn(const Family& family, const SubjectInfo& info, const FamilyPlan& plan) {
  if (family.scene != nullptr) {
    return Takes(info, *family.scene) ? "" : "the subject does not take the scene";
  }
  if (const Domain* domain = family.domain; domain != nullptr) {
    if (domain->is_stated != nullptr && !domain->is_stated(info.profile)) {
      return "the profile says nothing about the family";
    }
    return Suits(*domain, info) ? "" : "the subject takes no scene of the family";
  }
  if ((family.world->cases - 1) / kMostOfWorld >= plan.cases) {
    return "the world has " + std::to_string(family.world->cases) + " cases, more than " +
           std::to_string(kMostOfWorld) + " times as many as a domain is given";
  }
  if (family.world->pixels > plan.most_pixels) {
    return "the world's targets are larger than the report draws: compare draws them";
  }
  return WhyNotGiven(*family.world, info);
}

// Hardly any case was compared, and under another seed none might be.
void ExcuseIfFew(Cell& cell) {
  if (cell.Fails() || cell.excused <= kMostExcusedForEach * cell.cases) return;
  cell.excused += std::exchange(cell.cases, 0);
  cell.samples = 0;
}

}  // namespace

std::vector<Family> Families() {
  std::vector<Family> families;
  for (const Domain& domain : Domains()) {
    families.push_back(
        {domain.name, domain.summary, &kThemes[static_cast<std::size_t>(domain.theme)], &domain});
  }
  std::ranges::sort(families, {}, [](const Family& family) {
    return std::pair(family.domain->theme, family.domain->in_theme);
  });
  for (const World& world : Worlds()) {
    families.push_back({world.name, world.summary, &kSmallWorlds, nullptr, &world});
  }
  return families;
}

std::vector<Cell> CompareFamily(Subject& subject, const Family& family,
                                std::span<const Yardstick> yardsticks, const FamilyPlan& plan) {
  const Description description = DescriptionOf(subject);
  if (const std::string why = WhyNotDrawn(family, description.info, plan); !why.empty()) {
    return std::vector<Cell>(yardsticks.size(), {.excused = 1, .why = why});
  }
  Row row;
  row.cases = family.world != nullptr   ? family.world->cases
              : family.scene != nullptr ? 1
                                        : plan.cases;
  row.at = [&](std::uint64_t index) {
    const std::string name(family.name);
    if (family.scene != nullptr) return Case{*family.scene, description.info.profile, {}, name};
    Case c = DrawCase(description.info, family.world != nullptr ? NameOfCase(*family.world, index)
                                                                : CaseName{name, index, plan.seed});
    c.options = {};
    return c;
  };
  row.draw = [&](const CaseAtHand& at) { return DrawToJudge(subject, description, at.placed()); };
  std::vector<Cell> cells = CompareRow(row, yardsticks, plan.limits);
  for (Cell& cell : cells) {
    cell.is_exhausted = family.world != nullptr && cell.cases == row.cases;
    ExcuseIfFew(cell);
  }
  return cells;
}

}  // namespace rasterproof::props
