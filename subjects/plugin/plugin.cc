#include "subjects/plugin/plugin.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "core/error.h"
#include "kit/rasterproof_plugin.h"
#include "subjects/plugin/guarded_target.h"

namespace rasterproof::subjects {
namespace {

constexpr const char* kSymbol = "rasterproof_plugin_describe";

bool Has(const rasterproof_plugin& plugin, std::uint32_t bit) { return (plugin.takes & bit) != 0; }

// Of a description that ends before a field the field is zero.
constexpr std::size_t kFirstSize = offsetof(rasterproof_plugin, fixed_integer_bits);

rasterproof_plugin Whole(const rasterproof_plugin& described) {
  rasterproof_plugin plugin{};
  std::memcpy(&plugin, &described, std::min<std::size_t>(described.size, sizeof(plugin)));
  return plugin;
}

std::optional<FixedInput> FixedInputOf(const rasterproof_plugin& plugin) {
  if (plugin.input != RASTERPROOF_FIXED) return std::nullopt;
  return FixedInput{static_cast<int>(plugin.fixed_integer_bits),
                    static_cast<int>(plugin.fixed_fraction_bits), plugin.fixed_is_signed != 0,
                    plugin.fixed_wraps != 0};
}

SubjectInfo InfoOf(const rasterproof_plugin& plugin, const std::string& path) {
  SubjectInfo info;
  info.name = plugin.name == nullptr ? path : plugin.name;
  info.summary = plugin.summary == nullptr ? "" : plugin.summary;
  info.input = plugin.input == RASTERPROOF_FLOAT64 ? Precision::kFloat64 : Precision::kFloat32;
  info.profile.fixed = FixedInputOf(plugin);
  info.coverage = static_cast<CoverageKind>(plugin.coverage);
  info.takes_clip = Has(plugin, RASTERPROOF_TAKES_CLIP_SPACE);
  info.takes_window = !Has(plugin, RASTERPROOF_TAKES_NO_WINDOW_SPACE);
  info.takes_culling = Has(plugin, RASTERPROOF_TAKES_CULLING);
  info.takes_scissor = Has(plugin, RASTERPROOF_TAKES_SCISSOR);
  info.takes_tiles = Has(plugin, RASTERPROOF_TAKES_TILES);
  info.takes_threads = Has(plugin, RASTERPROOF_TAKES_THREADS);
  return info;
}

// The scene as the library sees it; the vectors hold what it points to.
class PluginScene {
 public:
  PluginScene(const Scene& scene, const DrawOptions& options,
              const std::optional<FixedInput>& fixed) {
    if (fixed) {
      for (const Vertex& v : scene.vertices) {
        fixed_.insert(fixed_.end(), {fixed->Raw(v.x), fixed->Raw(v.y)});
      }
    }
    for (const Vertex& v : scene.vertices) vertices_.insert(vertices_.end(), {v.x, v.y, v.z, v.w});
    for (const Triangle& t : scene.triangles) {
      triangles_.insert(triangles_.end(), {t[0], t[1], t[2]});
    }
    const PixelRect cut = options.scissor.value_or(PixelRect{0, 0, scene.width, scene.height});
    view_ = {.size = sizeof(rasterproof_scene),
             .width = scene.width,
             .height = scene.height,
             .clip_space = scene.clip_space ? 1 : 0,
             .vertices = vertices_.data(),
             .triangles = triangles_.data(),
             .vertex_count = scene.vertices.size(),
             .triangle_count = scene.triangles.size(),
             .cull = static_cast<std::int32_t>(options.cull),
             .scissor = {cut.x0, cut.y0, cut.x1, cut.y1},
             .tile = options.tile,
             .threads = options.threads,
             .fixed = fixed ? fixed_.data() : nullptr};
  }
  const rasterproof_scene& view() const { return view_; }

 private:
  std::vector<double> vertices_;
  std::vector<std::int32_t> triangles_;
  std::vector<std::int64_t> fixed_;
  rasterproof_scene view_{};
};

void AddRows(const GuardedCounts& drawn, std::vector<std::uint32_t>& to, std::size_t rows,
             std::size_t row_length) {
  for (std::size_t row = 0; row < rows; ++row) {
    const std::span<const std::uint32_t> from = drawn.Row(row);
    for (std::size_t k = 0; k < row_length; ++k) to[row * row_length + k] += from[k];
  }
}

class PluginSubject final : public Subject {
 public:
  PluginSubject(const rasterproof_plugin& plugin, const std::string& path)
      : plugin_(plugin), info_(InfoOf(plugin, path)) {
    if (plugin_.open != nullptr) state_ = plugin_.open();
  }
  ~PluginSubject() override {
    if (plugin_.close != nullptr) plugin_.close(state_);
  }
  PluginSubject(const PluginSubject&) = delete;
  PluginSubject& operator=(const PluginSubject&) = delete;

  const SubjectInfo& Info() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    if (plugin_.reset != nullptr) plugin_.reset(state_);
    const auto rows = static_cast<std::size_t>(counts.height);
    const auto row_length =
        static_cast<std::size_t>(counts.width) * static_cast<std::size_t>(counts.samples);
    const bool facings = info_.coverage == CoverageKind::kFacingCounts;
    GuardedCounts front(row_length, rows);
    GuardedCounts back(row_length, facings ? rows : 0);
    const rasterproof_target target{.size = sizeof(rasterproof_target),
                                    .samples = counts.samples,
                                    .stride = front.stride(),
                                    .front = front.data(),
                                    .back = facings ? back.data() : nullptr};
    const std::optional<FixedInput> fixed = FixedInputOf(plugin_);
    if (fixed && !CanBeGiven(scene, info_.profile)) {
      throw InputError("subject " + info_.name, "its integers do not hold a coordinate",
                       "give it multiples of its step within its range");
    }
    const PluginScene given(scene, options, fixed);
    const std::int32_t refused = plugin_.draw(state_, &given.view(), &target);
    for (const GuardedCounts* side : {&front, &back}) {
      const std::string damage = side->Damage();
      if (!damage.empty()) throw SubjectFault("it wrote outside its target: " + damage);
    }
    if (refused != 0) {
      throw InputError("subject " + info_.name, "draw returned " + std::to_string(refused),
                       "give it another scene");
    }
    AddRows(front, counts.front, rows, row_length);
    if (facings) AddRows(back, counts.back, rows, row_length);
  }

 private:
  rasterproof_plugin plugin_;
  SubjectInfo info_;
  void* state_ = nullptr;
};

void RequireSound(const rasterproof_plugin* plugin, const std::string& path) {
  const auto require = [&](bool holds, const std::string& reason, const char* remedy) {
    if (!holds) throw InputError(path, reason, remedy);
  };
  require(plugin != nullptr, std::string(kSymbol) + " returned NULL", "return a description");
  require(plugin->version == RASTERPROOF_PLUGIN_VERSION,
          "it is written for version " + std::to_string(plugin->version) + " of the interface",
          "build it with the header of version 1");
  require(plugin->size >= kFirstSize,
          "its description has " + std::to_string(plugin->size) + " bytes, not " +
              std::to_string(sizeof(rasterproof_plugin)),
          "set size to sizeof(rasterproof_plugin)");
  require(plugin->draw != nullptr, "it has no draw function", "set draw");
  require(plugin->input <= RASTERPROOF_FIXED, "its input is " + std::to_string(plugin->input),
          "use enum rasterproof_input");
  require(plugin->coverage <= RASTERPROOF_MASK,
          "its coverage is " + std::to_string(plugin->coverage), "use enum rasterproof_coverage");
}

void RequireSoundFixedInput(const rasterproof_plugin& plugin, const std::string& path) {
  if (plugin.input != RASTERPROOF_FIXED) return;
  if (plugin.fixed_integer_bits < 1 || plugin.fixed_integer_bits > kMaxIntegerBits ||
      plugin.fixed_fraction_bits > kMaxSubpixelBits) {
    throw InputError(path,
                     "its fixed-point input has " + std::to_string(plugin.fixed_integer_bits) +
                         " bits before the point and " +
                         std::to_string(plugin.fixed_fraction_bits) + " after it",
                     "set fixed_integer_bits from 1 to 31 and fixed_fraction_bits from 0 to 16");
  }
  if (Has(plugin, RASTERPROOF_TAKES_CLIP_SPACE) || Has(plugin, RASTERPROOF_TAKES_NO_WINDOW_SPACE)) {
    throw InputError(path, "its input is fixed point, and it takes clip space",
                     "leave the bits for clip space out of takes");
  }
}

}  // namespace

LoadedPlugin LoadPlugin(const std::string& path) {
  // A name without a slash would be searched in the system's folders.
  const std::string file = path.find('/') == std::string::npos ? "./" + path : path;
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    throw InputError(path, std::string("it can't be loaded: ") + dlerror(),
                     "give a shared library (.so) and what it needs");
  }
  void* const symbol = dlsym(library, kSymbol);
  if (symbol == nullptr) {
    throw InputError(path, std::string("it exports no ") + kSymbol,
                     "see kit/rasterproof_plugin.h; C++ needs its extern \"C\"");
  }
  const auto describe = reinterpret_cast<const rasterproof_plugin* (*)()>(symbol);
  const rasterproof_plugin* const plugin = describe();
  RequireSound(plugin, path);
  const rasterproof_plugin whole = Whole(*plugin);
  RequireSoundFixedInput(whole, path);
  return {std::make_unique<PluginSubject>(whole, path),
          plugin->profile == nullptr ? "real" : plugin->profile};
}

}  // namespace rasterproof::subjects
