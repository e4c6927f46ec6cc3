#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <span>
#include <string>
#include <string_view>

#include "core/error.h"
#include "library/arguments.h"
#include "library/rasterize.h"
#include "library/rasterproof_rasterize.h"

namespace rasterproof {
namespace {

thread_local std::array<char, 256> last_message{};

rasterproof_raster_status Fail(rasterproof_raster_status status, std::string_view message) {
  const std::size_t n = message.copy(last_message.data(), last_message.size() - 1);
  last_message[n] = '\0';
  return status;
}

// A callback's wish to end, thrown through the kernel.
struct Stop {};

template <class Act>
rasterproof_raster_status Guarded(const Act& act) noexcept {
  try {
    act();
    return RASTERPROOF_RASTER_OK;
  } catch (const Stop&) {
    return Fail(RASTERPROOF_RASTER_STOPPED, "the callback ended the drawing");
  } catch (const InputError& error) {
    return Fail(RASTERPROOF_RASTER_BAD_ARGUMENT, error.what());
  } catch (const std::bad_alloc&) {
    return Fail(RASTERPROOF_RASTER_NO_MEMORY,
                "not enough memory; counts, masks, ids and depths of one thread need none beyond a "
                "target of rasterproof_raster_room() bytes");
  } catch (const std::exception& error) {
    return Fail(RASTERPROOF_RASTER_FAULT, error.what());
  } catch (...) {
    return Fail(RASTERPROOF_RASTER_FAULT, "an exception of an unknown type");
  }
}

template <class T>
const T& Required(const T* argument, const char* name) {
  if (argument == nullptr) throw InputError(name, "null", "give one");
  return *argument;
}

std::size_t Times(std::size_t each, std::size_t n, const char* name) {
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (n <= std::min(kMost, std::numeric_limits<std::size_t>::max() / each)) return each * n;
  throw InputError(name, "too many", "draw parts of fewer than 2^29");
}

// Spans of lengths that cannot be are refused by name: a null pointer may only mean nothing.
template <class T>
std::span<T> SpanOf(T* values, std::size_t size, const char* name) {
  if (values == nullptr && size != 0) throw InputError(name, "null", "give the values, or none");
  return {values, size};
}

RasterMesh MeshOf(const rasterproof_raster_mesh* given) {
  const rasterproof_raster_mesh& mesh = Required(given, "mesh");
  if (mesh.space > RASTERPROOF_RASTER_CLIP_NEAR_MINUS_W) {
    throw InputError("mesh.space", "there is no such space",
                     "give one of rasterproof_raster_space");
  }
  const auto space = static_cast<RasterSpace>(mesh.space);
  const std::size_t coordinates = library::CoordinatesOf(space);
  return {.positions =
              SpanOf(mesh.positions, Times(coordinates, mesh.vertex_count, "mesh.vertex_count"),
                     "mesh.positions"),
          .indices = SpanOf(mesh.indices, Times(3, mesh.triangle_count, "mesh.triangle_count"),
                            "mesh.indices"),
          .space = space};
}

RasterTarget TargetOf(const rasterproof_raster_target* given) {
  const rasterproof_raster_target& target = Required(given, "target");
  if (target.output > RASTERPROOF_RASTER_INNER_DEPTHS) {
    throw InputError("target.output", "there is no such output",
                     "give one of rasterproof_raster_output");
  }
  return {
      .output = static_cast<RasterOutput>(target.output),
      .width = target.width,
      .height = target.height,
      .pitch = target.pitch,
      .memory = SpanOf(static_cast<std::byte*>(target.memory), target.memory_size, "target.memory"),
      .back = SpanOf(static_cast<std::byte*>(target.back), target.back_size, "target.back")};
}

RasterValues ValuesOf(const rasterproof_raster_values* given, const RasterMesh& mesh) {
  const rasterproof_raster_values& values = Required(given, "values");
  if (values.channels < 1 || values.channels > kMostRasterChannels) {
    throw InputError("values.channels", std::to_string(values.channels),
                     "give 1 to " + std::to_string(kMostRasterChannels));
  }
  if (values.interpolation > RASTERPROOF_RASTER_LINEAR) {
    throw InputError("values.interpolation", "there is no such one",
                     "give one of rasterproof_raster_interpolation");
  }
  if (values.rounding > RASTERPROOF_RASTER_NEAREST) {
    throw InputError("values.rounding", "there is no such one",
                     "give one of rasterproof_raster_rounding");
  }
  const auto plane = [&values](float* of, const char* name) {
    return SpanOf(of, values.size, name);
  };
  // NULL: not asked for.
  const auto derivative = [&plane](float* of, const char* name) {
    return of == nullptr ? std::span<float>() : plane(of, name);
  };
  return {.numbers =
              SpanOf(values.numbers, library::VerticesOf(mesh) * values.channels, "values.numbers"),
          .channels = static_cast<int>(values.channels),
          .interpolation = static_cast<RasterInterpolation>(values.interpolation),
          .rounding = static_cast<RasterRounding>(values.rounding),
          .width = values.width,
          .height = values.height,
          .pitch = values.pitch,
          .values = plane(values.values, "values.values"),
          .dx = derivative(values.dx, "values.dx"),
          .dy = derivative(values.dy, "values.dy")};
}

InstructionSet SetOf(std::uint32_t set) {
  if (set <= RASTERPROOF_RASTER_NEON) return static_cast<InstructionSet>(set);
  throw InputError("set", "there is no such set", "give one of rasterproof_raster_set");
}

}  // namespace
}  // namespace rasterproof

struct rasterproof_raster_workers {
  rasterproof::RasterWorkers workers;
};

extern "C" {

rasterproof_raster_status rasterproof_raster_workers_create(uint32_t count,
                                                            rasterproof_raster_workers** workers) {
  return rasterproof::Guarded([&] {
    if (workers == nullptr) {
      throw rasterproof::InputError("workers", "null", "give a place for the pointer");
    }
    *workers = nullptr;
    constexpr std::uint32_t kMost = std::numeric_limits<std::int32_t>::max();
    *workers = new rasterproof_raster_workers{
        rasterproof::RasterWorkers(static_cast<int>(std::min(count, kMost)))};
  });
}

void rasterproof_raster_workers_destroy(rasterproof_raster_workers* workers) { delete workers; }

rasterproof_raster_status rasterproof_raster_workers_rasterize(
    rasterproof_raster_workers* workers, const rasterproof_raster_mesh* mesh,
    const rasterproof_raster_target* target, uint32_t set) {
  return rasterproof::Guarded([&] {
    rasterproof::Required(workers, "workers");
    workers->workers.Rasterize(rasterproof::MeshOf(mesh), rasterproof::TargetOf(target),
                               rasterproof::SetOf(set));
  });
}

uint32_t rasterproof_raster_version(void) { return RASTERPROOF_RASTER_VERSION; }

const char* rasterproof_raster_message(void) { return rasterproof::last_message.data(); }

rasterproof_raster_status rasterproof_raster_clear(const rasterproof_raster_target* target) {
  return rasterproof::Guarded([&] { rasterproof::Clear(rasterproof::TargetOf(target)); });
}

rasterproof_raster_status rasterproof_rasterize(const rasterproof_raster_mesh* mesh,
                                                const rasterproof_raster_target* target,
                                                std::uint32_t set) {
  return rasterproof::Guarded([&] {
    rasterproof::Rasterize(rasterproof::MeshOf(mesh), rasterproof::TargetOf(target),
                           rasterproof::SetOf(set));
  });
}

rasterproof_raster_status rasterproof_rasterize_spans(const rasterproof_raster_mesh* mesh,
                                                      int32_t width, int32_t height,
                                                      rasterproof_raster_on_span on_span,
                                                      void* state, std::uint32_t set) {
  return rasterproof::Guarded([&] {
    if (on_span == nullptr) {
      throw rasterproof::InputError("on_span", "null", "give a function to call");
    }
    const auto call = [&](const rasterproof::RasterSpan& span) {
      const rasterproof_raster_span given{span.triangle, span.is_front ? 1 : 0, span.y, span.x0,
                                          span.x1};
      if (on_span(state, &given) != 0) throw rasterproof::Stop();
    };
    rasterproof::Rasterize(rasterproof::MeshOf(mesh), width, height, call, rasterproof::SetOf(set));
  });
}

rasterproof_raster_status rasterproof_rasterize_values(const rasterproof_raster_mesh* mesh,
                                                       const rasterproof_raster_values* values,
                                                       std::uint32_t set) {
  return rasterproof::Guarded([&] {
    const rasterproof::RasterMesh given = rasterproof::MeshOf(mesh);
    rasterproof::RasterizeValues(given, rasterproof::ValuesOf(values, given),
                                 rasterproof::SetOf(set));
  });
}

rasterproof_raster_status rasterproof_raster_mark_empty(const rasterproof_raster_mesh* mesh,
                                                        int32_t width, int32_t height,
                                                        uint8_t* is_empty, uint32_t set) {
  return rasterproof::Guarded([&] {
    const rasterproof::RasterMesh given = rasterproof::MeshOf(mesh);
    rasterproof::MarkEmptyTriangles(
        given, width, height, rasterproof::SpanOf(is_empty, given.indices.size() / 3, "is_empty"),
        rasterproof::SetOf(set));
  });
}

size_t rasterproof_raster_room(const rasterproof_raster_target* target) {
  if (target == nullptr) return 0;
  return rasterproof::RoomFor({.output = static_cast<rasterproof::RasterOutput>(target->output),
                               .width = target->width,
                               .height = target->height,
                               .pitch = target->pitch,
                               .memory = {},
                               .back = {}});
}

int32_t rasterproof_raster_is_supported(std::uint32_t set) {
  if (set > RASTERPROOF_RASTER_NEON) return 0;
  return rasterproof::IsSupported(static_cast<rasterproof::InstructionSet>(set)) ? 1 : 0;
}

}  // extern "C"
