// Allegro 5: al_draw_prim into a memory bitmap, which its software rasterizer draws.
#include <allegro5/allegro.h>
#include <allegro5/allegro_primitives.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include "kit/bitmap_plugin.h"

namespace {

using rasterproof::kit::Corners;

constexpr double kLimit = 0x1p30;
constexpr int kMaxSide = 16384;

class AllegroBitmap {
 public:
  AllegroBitmap() {
    // No atexit: the library may be unloaded before the process ends.
    if (!al_install_system(ALLEGRO_VERSION_INT, nullptr) || !al_init_primitives_addon()) {
      throw std::runtime_error("Allegro does not start");
    }
    al_set_new_bitmap_flags(ALLEGRO_MEMORY_BITMAP);
    al_set_new_bitmap_format(ALLEGRO_PIXEL_FORMAT_ARGB_8888);
  }
  ~AllegroBitmap() { Unlock(); }
  AllegroBitmap(const AllegroBitmap&) = delete;
  AllegroBitmap& operator=(const AllegroBitmap&) = delete;

  bool Resize(int width, int height) {
    if (width > kMaxSide || height > kMaxSide) return false;
    if (bitmap_ != nullptr && width == width_ && height == height_) return true;
    Unlock();
    width_ = width;
    height_ = height;
    bitmap_.reset(al_create_bitmap(width, height));
    if (bitmap_ == nullptr) return false;
    al_set_target_bitmap(bitmap_.get());
    return true;
  }
  void Clear() {
    Unlock();
    al_clear_to_color(al_map_rgba(0, 0, 0, 0));
  }
  bool Fill(const Corners& corners) {
    if (!rasterproof::kit::AllWithin(corners, -kLimit, kLimit)) return false;
    std::array<ALLEGRO_VERTEX, 3> vertices{};
    for (std::size_t k = 0; k < 3; ++k) {
      vertices[k].x = static_cast<float>(corners[k].x);
      vertices[k].y = static_cast<float>(corners[k].y);
      vertices[k].color = al_map_rgba(255, 255, 255, 255);
    }
    al_draw_prim(vertices.data(), nullptr, nullptr, 0, 3, ALLEGRO_PRIM_TRIANGLE_LIST);
    lock_ = al_lock_bitmap(bitmap_.get(), ALLEGRO_PIXEL_FORMAT_ARGB_8888, ALLEGRO_LOCK_READONLY);
    return lock_ != nullptr;
  }
  bool Covered(int x, int y) const {
    const auto* const row = static_cast<const std::uint8_t*>(lock_->data) + y * lock_->pitch;
    return reinterpret_cast<const std::uint32_t*>(row)[x] != 0;
  }

 private:
  void Unlock() {
    if (lock_ != nullptr) al_unlock_bitmap(bitmap_.get());
    lock_ = nullptr;
  }
  struct Destroy {
    void operator()(ALLEGRO_BITMAP* bitmap) const { al_destroy_bitmap(bitmap); }
  };
  int width_ = 0;
  int height_ = 0;
  std::unique_ptr<ALLEGRO_BITMAP, Destroy> bitmap_;
  ALLEGRO_LOCKED_REGION* lock_ = nullptr;
};

// al_draw_prim's documentation does not say which pixels a triangle covers; that neighbours share
// none and leave none out is what drawing a mesh from triangles relies on.
constexpr const char* kProfile = R"({"name": "allegro5", "subpixel_bits": null,
  "contract": "watertight", "coordinate_limit": 16384})";

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = rasterproof::kit::DescribeBitmap<AllegroBitmap>(
      "allegro5", "al_draw_prim into a memory bitmap", kProfile, RASTERPROOF_FLOAT32);
  return &plugin;
}
