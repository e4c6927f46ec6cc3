#include "props/vectors/stated_world.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "core/error.h"
#include "core/quoted.h"
#include "props/domains/case_name.h"

namespace rasterproof::props {
namespace {

constexpr int kMostIntegerBits = 6;  // a target of 64 pixels
constexpr int kMostFractionBits = 8;
constexpr int kMostWorldBits = 10;

// -1: the letter is no digit.
int DigitOf(char letter) { return letter >= '0' && letter <= '9' ? letter - '0' : -1; }

}  // namespace

std::string StatedWorld::Name() const {
  return (has_sign ? "s" : "u") + std::to_string(integer_bits) + "." +
         std::to_string(fraction_bits);
}

std::uint64_t StatedWorld::Numbers() const {
  return std::uint64_t{1} << (integer_bits + fraction_bits + (has_sign ? 1 : 0));
}

std::uint64_t StatedWorld::Cases() const {
  const std::uint64_t points = Numbers() * Numbers();
  return points * points * points;
}

StatedWorld ParseStatedWorld(const std::string& text) {
  StatedWorld world;
  std::string digits = text;
  if (!digits.empty() && (digits[0] == 'u' || digits[0] == 's')) {
    world.has_sign = digits[0] == 's';
    digits.erase(0, 1);
  }
  if (digits.size() == 3 && digits[1] == '.') {
    world.integer_bits = DigitOf(digits[0]);
    world.fraction_bits = DigitOf(digits[2]);
    const bool are_bits = world.integer_bits >= 1 && world.integer_bits <= kMostIntegerBits &&
                          world.fraction_bits >= 0 && world.fraction_bits <= kMostFractionBits;
    const int all = world.integer_bits + world.fraction_bits + (world.has_sign ? 1 : 0);
    if (are_bits && all <= kMostWorldBits) return world;
  }
  throw InputError("--world " + Quoted(text, 40), "it is not a world",
                   "give the bits of a coordinate before and after the point, as 3.2 or, with a "
                   "sign, s3.2: 1 to 6 and 0 to 8, at most 10 with the sign");
}

Case CaseOfStatedWorld(const StatedWorld& world, std::uint64_t index, const Profile& profile) {
  const std::uint64_t numbers = world.Numbers();
  const double least = world.has_sign ? -std::ldexp(1.0, world.integer_bits) : 0.0;
  Case c;
  c.profile = profile;
  c.origin = ToText({world.Name(), index, 0});
  c.scene.name = world.Name();
  c.scene.width = c.scene.height = 1 << world.integer_bits;
  const auto coordinate = [&](std::uint64_t number) {
    return least + std::ldexp(static_cast<double>(number), -world.fraction_bits);
  };
  for (int corner = 0; corner < 3; ++corner) {
    const double x = coordinate(index % numbers);
    index /= numbers;
    c.scene.vertices.push_back({x, coordinate(index % numbers)});
    index /= numbers;
  }
  c.scene.triangles = {{0, 1, 2}};
  return c;
}

}  // namespace rasterproof::props
