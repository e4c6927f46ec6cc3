// triangle.sv as a plugin, by Verilator's model of it. In a folder of its own, with V for
// /usr/share/verilator/include and ROOT for the folder of kit/:
//
//     verilator --cc --build -CFLAGS "-O2 -fPIC" -Mdir obj ROOT/kit/examples/verilog/triangle.sv
//     c++ -std=c++20 -O2 -shared -fPIC -I ROOT -I obj -isystem V -isystem V/vltstd
//         ROOT/kit/examples/verilog/plugin.cc V/verilated.cpp V/verilated_threads.cpp
//         obj/Vtriangle__ALL.a -o unit.so -pthread
//     rasterproof check --plugin ./unit.so
#include <cstddef>
#include <cstdint>

#include "Vtriangle.h"
#include "kit/rasterproof_plugin.h"

double sc_time_stamp() { return 0; }  // Verilator wants one; nothing here has a clock

namespace {

constexpr int kMostSide = 2048;  // EDGE_BITS is for targets up to this
constexpr int kPixel = 16;

// A port of fewer bits than its C++ type wants the bits above cleared.
std::uint32_t LowBits(std::int64_t value, int bits) {
  return static_cast<std::uint32_t>(value) & ((1U << bits) - 1);
}

std::int32_t Draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  static_cast<void>(state);
  if (scene->width > kMostSide || scene->height > kMostSide) return 1;
  VerilatedContext context;
  Vtriangle unit(&context);
  for (std::size_t t = 0; t < scene->triangle_count; ++t) {
    const auto x = [&](std::size_t k) {
      return static_cast<std::uint16_t>(scene->fixed[2 * scene->triangles[3 * t + k]]);
    };
    const auto y = [&](std::size_t k) {
      return static_cast<std::uint16_t>(scene->fixed[2 * scene->triangles[3 * t + k] + 1]);
    };
    unit.ax = x(0), unit.ay = y(0), unit.bx = x(1), unit.by = y(1), unit.cx = x(2), unit.cy = y(2);
    for (std::int32_t row = 0; row < scene->height; ++row) {
      for (std::int32_t column = 0; column < scene->width; ++column) {
        unit.px = LowBits(column * kPixel + kPixel / 2, 17);
        unit.py = LowBits(row * kPixel + kPixel / 2, 17);
        unit.eval();
        std::uint32_t* const counts = unit.is_back ? target->back : target->front;
        counts[static_cast<std::size_t>(row) * target->stride + static_cast<std::size_t>(column)] +=
            unit.covers;
      }
    }
  }
  return 0;
}

}  // namespace

extern "C" const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = [] {
    rasterproof_plugin made{};
    made.version = RASTERPROOF_PLUGIN_VERSION;
    made.size = sizeof made;
    made.name = "verilog";
    made.summary = "triangle.sv: signed 12.4 coordinates, targets up to 2048 by 2048";
    made.profile = "{\"name\": \"verilog\", \"max_target\": [2048, 2048]}";
    made.input = RASTERPROOF_FIXED;
    made.coverage = RASTERPROOF_FACING_COUNTS;
    made.draw = Draw;
    made.fixed_integer_bits = 12;
    made.fixed_fraction_bits = 4;
    made.fixed_is_signed = 1;
    return made;
  }();
  return &plugin;
}
