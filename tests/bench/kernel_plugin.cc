// The exact kernel behind the C interface, to compare bench's times of a plugin with those of the
// kernel that draws into the same sink.
//
//     cmake --build build --target kernel_plugin
//     build/rasterproof bench --plugin build/test_plugins/kernel.so --subject kernel-exact
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "kit/rasterproof_plugin.h"
#include "library/rasterproof_rasterize.h"

namespace {

// Owns its memory, with the room after the rows that saves a second pass over the mesh.
class Counts {
 public:
  explicit Counts(const rasterproof_scene& scene)
      : width_(static_cast<std::size_t>(scene.width)),
        height_(static_cast<std::size_t>(scene.height)) {
    view_ = {.output = RASTERPROOF_RASTER_FACING_COUNTS,
             .width = scene.width,
             .height = scene.height,
             .pitch = 4 * ((width_ + 15) / 16 * 16),
             .memory = nullptr,
             .memory_size = 0,
             .back = nullptr,
             .back_size = 0};
    const std::size_t room = rasterproof_raster_room(&view_);
    for (std::vector<std::uint32_t>* plane : {&front_, &back_}) plane->resize(room / 4 + 16);
    view_.memory = front_.data();
    view_.back = back_.data();
    view_.memory_size = view_.back_size = room;
  }
  const rasterproof_raster_target& view() const { return view_; }
  bool Fits(const rasterproof_scene& scene) const {
    return scene.width == view_.width && scene.height == view_.height;
  }
  // Adds the counts to the target, and empties them.
  void MoveTo(const rasterproof_target& target) {
    const std::size_t pitch = view_.pitch / 4;
    for (std::size_t y = 0; y < height_; ++y) {
      Move(front_.data() + y * pitch, target.front + y * target.stride);
      Move(back_.data() + y * pitch, target.back + y * target.stride);
    }
  }

 private:
  void Move(std::uint32_t* from, std::uint32_t* to) const {
    for (std::size_t x = 0; x < width_; ++x) to[x] += from[x];
    std::memset(from, 0, 4 * width_);
  }

  std::size_t width_;
  std::size_t height_;
  std::vector<std::uint32_t> front_;
  std::vector<std::uint32_t> back_;
  rasterproof_raster_target view_{};
};

std::int32_t Draw(void* /*state*/, const rasterproof_scene* scene,
                  const rasterproof_target* target) {
  static std::vector<float> positions;
  static std::optional<Counts> counts;
  positions.clear();
  for (std::size_t i = 0; i < scene->vertex_count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      positions.push_back(static_cast<float>(scene->vertices[4 * i + axis]));
    }
  }
  if (!counts || !counts->Fits(*scene)) counts.emplace(*scene);
  // The unsigned type of the same width may be read in the signed one's place.
  const auto* const indices = reinterpret_cast<const std::uint32_t*>(scene->triangles);
  const rasterproof_raster_mesh mesh{positions.data(), scene->vertex_count, indices,
                                     scene->triangle_count, RASTERPROOF_RASTER_WINDOW};
  const auto status = rasterproof_rasterize(&mesh, &counts->view(), RASTERPROOF_RASTER_BEST);
  counts->MoveTo(*target);
  return status == RASTERPROOF_RASTER_OK ? 0 : 1;
}

rasterproof_plugin Describe() {
  rasterproof_plugin plugin{};
  plugin.version = RASTERPROOF_PLUGIN_VERSION;
  plugin.size = sizeof(rasterproof_plugin);
  plugin.name = "kernel";
  plugin.summary = "the exact kernel behind the C interface";
  plugin.profile = "real";
  plugin.input = RASTERPROOF_FLOAT32;
  plugin.coverage = RASTERPROOF_FACING_COUNTS;
  plugin.draw = &Draw;
  plugin.edge_error = -1;
  plugin.stepping_error = -1;
  return plugin;
}

}  // namespace

extern "C" const rasterproof_plugin* rasterproof_plugin_describe() {
  static const rasterproof_plugin plugin = Describe();
  return &plugin;
}
