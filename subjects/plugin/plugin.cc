#include "subjects/plugin/plugin.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "core/shown_outputs.h"
#include "core/stated_edges.h"
#include "core/target_size.h"
#include "kit/rasterproof_plugin.h"
#include "subjects/plugin/described.h"
#include "subjects/plugin/environment.h"
#include "subjects/plugin/guarded_target.h"

namespace rasterproof::subjects {
namespace {

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
  info.takes_batches = plugin.draw_many != nullptr;
  info.draws_elsewhere = Has(plugin, RASTERPROOF_DRAWS_ELSEWHERE);
  info.fragments = {static_cast<Visible>(plugin.visible),
                    static_cast<BarycentricsOf>(plugin.barycentrics_of),
                    plugin.barycentric_error,
                    plugin.depth_error,
                    Has(plugin, RASTERPROOF_SHOWS_CENTROIDS),
                    Has(plugin, RASTERPROOF_SHOWS_VALUES),
                    Has(plugin, RASTERPROOF_SHOWS_DERIVATIVES)};
  const auto property = [](double error) {
    return error < 0 ? std::nullopt : std::optional(error);
  };
  info.edges = {plugin.edge_value != nullptr, plugin.edge_steps != nullptr,
                property(plugin.edge_error), property(plugin.stepping_error)};
  return info;
}

// A scene's vertices as the library sees them. Fill() reuses the memory of the last scene unless it
// needs more: as in a program that draws from one buffer, where an address says nothing of the
// content.
struct PluginVertices {
  void Fill(std::shared_ptr<const Scene> of, const std::optional<FixedInput>& input) {
    scene = std::move(of);
    places.clear();
    fixed.clear();
    if (input) {
      for (const Vertex& v : scene->vertices) {
        fixed.insert(fixed.end(), {input->Raw(v.x), input->Raw(v.y)});
      }
    }
    for (const Vertex& v : scene->vertices) places.insert(places.end(), {v.x, v.y, v.z, v.w});
  }

  std::shared_ptr<const Scene> scene;
  std::vector<double> places;
  std::vector<std::int64_t> fixed;
};

// What is to be drawn as the library sees it; holds what the structure points to.
class PluginScene {
 public:
  /// `indices` is room for those of the triangles, which TakeIndices gives back.
  PluginScene(const DrawJob& job, std::shared_ptr<const PluginVertices> vertices,
              std::vector<std::int32_t> indices = {})
      : vertices_(std::move(vertices)), triangles_(std::move(indices)) {
    const Scene& scene = *job.scene;
    const DrawOptions& options = job.options;
    triangles_.clear();
    for (const Triangle& t : job.Triangles())
      triangles_.insert(triangles_.end(), t.begin(), t.end());
    const PixelRect cut = options.scissor.value_or(PixelRect{0, 0, scene.width, scene.height});
    if (job.wants.values) {
      for (const Channel& channel : scene.channels) {
        channels_.push_back({channel.name.c_str(), static_cast<std::int32_t>(channel.interpolation),
                             static_cast<std::int32_t>(channel.at), channel.values.data()});
      }
    }
    view_ = {.size = sizeof(rasterproof_scene),
             .width = scene.width,
             .height = scene.height,
             .clip_space = scene.clip_space ? 1 : 0,
             .vertices = vertices_->places.data(),
             .triangles = triangles_.data(),
             .vertex_count = scene.vertices.size(),
             .triangle_count = job.Triangles().size(),
             .cull = static_cast<std::int32_t>(options.cull),
             .scissor = {cut.x0, cut.y0, cut.x1, cut.y1},
             .tile = options.tile,
             .threads = options.threads,
             .fixed = vertices_->fixed.empty() ? nullptr : vertices_->fixed.data(),
             .channels = channels_.data(),
             .channel_count = channels_.size()};
  }
  const rasterproof_scene& view() const { return view_; }
  std::vector<std::int32_t> TakeIndices() { return std::move(triangles_); }

 private:
  std::shared_ptr<const PluginVertices> vertices_;
  std::vector<std::int32_t> triangles_;
  std::vector<rasterproof_channel> channels_;
  rasterproof_scene view_{};
};

// What one scene is drawn onto; a part that the library does not show is not there, nor one that
// is not wanted if it can do without.
class PluginTarget {
 public:
  PluginTarget(const DrawJob& job, const SubjectInfo& info, bool needs_all)
      : rows_(static_cast<std::size_t>(job.scene->height)) {
    RequireTargetSize("plugin", job.scene->width, job.scene->height, job.samples);
    drawing_.counts.width = job.scene->width;
    drawing_.counts.height = job.scene->height;
    drawing_.counts.samples = job.samples;
    size_ = CoverageCounts::Size(job.scene->width, job.scene->height, job.samples);
    const CoverageKind kind = info.coverage;
    const std::size_t columns = size_ / rows_;
    const GuardedCounts& shape =
        ShowsPrimitiveIds(info)
            ? primitive_ids_.emplace(columns, rows_, 1, static_cast<std::uint32_t>(kNoPrimitive))
            : front_.emplace(columns, rows_);
    if (kind == CoverageKind::kFacingCounts) back_.emplace(columns, rows_);
    const bool fragments = kind == CoverageKind::kFragments;
    if (fragments && (needs_all || job.wants.barycentrics)) {
      barycentrics_.emplace(columns, rows_, 3 * kWordsOfADouble);
    }
    if (fragments && (needs_all || job.wants.depths)) {
      depths_.emplace(columns, rows_, kWordsOfADouble);
    }
    wants_ = job.wants;
    const Outputs shown = ShownOutputs(job, info);
    const std::size_t channels = job.scene->channels.size();
    if (shown.centroids) centroids_.emplace(columns, rows_, 3 * kWordsOfADouble);
    if (shown.values) values_.emplace(columns, rows_, channels * kWordsOfADouble);
    if (shown.derivatives) derivatives_.emplace(columns, rows_, 2 * channels * kWordsOfADouble);
    view_ = {.size = sizeof(rasterproof_target),
             .samples = job.samples,
             .stride = shape.stride(),
             .front = DataOf<std::uint32_t>(front_),
             .back = DataOf<std::uint32_t>(back_),
             .primitive_ids = DataOf<std::int32_t>(primitive_ids_),
             .barycentrics = DataOf<double>(barycentrics_),
             .depths = DataOf<double>(depths_),
             .wants = (job.wants.barycentrics ? RASTERPROOF_WANTS_BARYCENTRICS : 0U) |
                      (job.wants.depths ? RASTERPROOF_WANTS_DEPTHS : 0U) |
                      (values_ ? RASTERPROOF_WANTS_VALUES : 0U) |
                      (derivatives_ ? RASTERPROOF_WANTS_DERIVATIVES : 0U),
             .centroids = DataOf<double>(centroids_),
             .values = DataOf<double>(values_),
             .derivatives = DataOf<double>(derivatives_)};
  }
  const rasterproof_target& view() const { return view_; }

  /// Returns what was drawn. Each part is freed once it is read: of a large target there is no room
  /// for all of them twice.
  ///
  /// Domain:     once.
  /// Error:      SubjectStop if anything was written outside the target.
  Drawing Drawn() {
    for (const auto* part : {&front_, &back_, &primitive_ids_, &barycentrics_, &depths_,
                             &centroids_, &values_, &derivatives_}) {
      const std::string damage = *part ? (*part)->Damage() : "";
      if (!damage.empty()) BreakDown("it wrote outside its target: " + damage);
    }
    TakeRows(front_, drawing_.counts.front);
    TakeRows(back_, drawing_.counts.back);
    TakeRows(primitive_ids_, drawing_.primitive_ids);
    if (wants_.barycentrics) TakeRows(barycentrics_, drawing_.barycentrics);
    if (wants_.depths) TakeRows(depths_, drawing_.depths);
    TakeRows(centroids_, drawing_.centroids);
    TakeRows(values_, drawing_.values);
    TakeRows(derivatives_, drawing_.derivatives);
    drawing_.counts.front.resize(size_);
    drawing_.counts.back.resize(size_);
    for (std::size_t k = 0; k < drawing_.primitive_ids.size(); ++k) {
      drawing_.counts.front[k] = drawing_.primitive_ids[k] == kNoPrimitive ? 0 : 1;
    }
    return std::move(drawing_);
  }

 private:
  using Part = std::optional<GuardedCounts>;
  static constexpr std::size_t kWordsOfADouble = sizeof(double) / sizeof(std::uint32_t);

  template <class T>
  static T* DataOf(Part& part) {
    return part ? reinterpret_cast<T*>(part->data()) : nullptr;
  }
  template <class T>
  void TakeRows(Part& part, std::vector<T>& to) {
    if (!part) return;
    to.resize(part->Row(0).size_bytes() / sizeof(T) * rows_);
    for (std::size_t row = 0; row < rows_; ++row) {
      const std::span<const std::uint32_t> from = part->Row(row);
      std::memcpy(to.data() + row * (to.size() / rows_), from.data(), from.size_bytes());
    }
    part.reset();
  }

  std::size_t rows_;
  std::size_t size_ = 0;
  Outputs wants_;
  Drawing drawing_;
  Part front_;
  Part back_;
  Part primitive_ids_;
  Part barycentrics_;
  Part depths_;
  Part centroids_;
  Part values_;
  Part derivatives_;
  rasterproof_target view_{};
};

// The library's edge values, by its two calls.
class PluginEdges final : public StatedEdges {
 public:
  PluginEdges(const rasterproof_plugin& plugin, const SubjectInfo& info, void* state,
              LibraryEnvironment& environment)
      : StatedEdges(info.edges, info.input),
        plugin_(plugin),
        state_(state),
        environment_(environment) {}

  double Value(Point2 a, Point2 b, Point2 p) const override {
    double value = 0;
    RequireDone([&] {
      return plugin_.edge_value(state_, Pair(a).data(), Pair(b).data(), Pair(p).data(), &value);
    });
    return value;
  }
  std::vector<double> Steps(Point2 a, Point2 b, Point2 p, Step step, int steps) const override {
    // The last number is none of the steps': it shows whether more was written.
    constexpr double kGuard = 0x1.badp+77;
    std::vector<double> values(static_cast<std::size_t>(steps) + 2, kGuard);
    const rasterproof_stepping stepping{step.along_y ? 1 : 0, step.sign, step.length, steps};
    RequireDone([&] {
      return plugin_.edge_steps(state_, Pair(a).data(), Pair(b).data(), Pair(p).data(), &stepping,
                                values.data());
    });
    if (values.back() != kGuard) BreakDown("it wrote past the values of its steps");
    values.pop_back();
    return values;
  }

 private:
  static std::array<double, 2> Pair(Point2 p) { return {p.x, p.y}; }
  template <class Call>
  void RequireDone(const Call& call) const {
    std::int32_t refused = 0;
    {
      const LibraryEnvironment::Within library(environment_);
      refused = call();
    }
    if (refused == 0) return;
    throw InputError("subject", "it refused an edge value: " + std::to_string(refused),
                     "give it another scene");
  }

  const rasterproof_plugin& plugin_;
  void* state_;
  LibraryEnvironment& environment_;
};

class PluginSubject final : public Subject {
 public:
  PluginSubject(const rasterproof_plugin& plugin, const std::string& path,
                const LibraryEnvironment& environment)
      : plugin_(plugin),
        info_(InfoOf(plugin, path)),
        fixed_(FixedInputOf(plugin)),
        environment_(environment),
        needs_all_(!Has(plugin, RASTERPROOF_TAKES_WANTS)) {
    const LibraryEnvironment::Within library(environment_);
    if (plugin_.open != nullptr) state_ = plugin_.open();
    if (info_.edges.shows_values) edges_.emplace(plugin_, info_, state_, environment_);
  }
  ~PluginSubject() override {
    const LibraryEnvironment::Within library(environment_);
    if (plugin_.close != nullptr) plugin_.close(state_);
  }
  PluginSubject(const PluginSubject&) = delete;
  PluginSubject& operator=(const PluginSubject&) = delete;

  const SubjectInfo& OwnInfo() const override { return info_; }
  const EdgeEvaluator* Edges() const override { return edges_ ? &*edges_ : nullptr; }

  Drawing Show(const DrawJob& job) override {
    Reset();
    if (!CanBeGiven(*job.scene, info_.profile)) {
      throw InputError("subject " + info_.name, "a coordinate is out of range of its integers",
                       "give it multiples of its step within its range");
    }
    PluginScene given(job, VerticesOf(job), std::move(indices_));
    PluginTarget target(job, info_, needs_all_);
    const std::int32_t refused = InLibrary(job.options.float_mode, [&] {
      return plugin_.draw(state_, &given.view(), &target.view());
    });
    indices_ = given.TakeIndices();
    Drawing drawing = target.Drawn();
    RequireDrawn(refused);
    return drawing;
  }

  // The library's draws alone, onto one target, which is cleared in between: a draw adds.
  std::optional<DrawTime> TimeDraws(const DrawJob& job, int repeats) override {
    Reset();
    const PluginScene given(job, VerticesOf(job));
    DrawTime sum;
    for (int k = 0; k < repeats; ++k) {
      const PluginTarget target(job, info_, needs_all_);
      std::int32_t refused = 0;
      const DrawTime one = Timed([&] {
        refused = InLibrary(FloatMode::kUsual,
                            [&] { return plugin_.draw(state_, &given.view(), &target.view()); });
      });
      RequireDrawn(refused);
      sum.seconds += one.seconds;
      sum.wall_seconds += one.wall_seconds;
    }
    return sum;
  }

  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    const auto can_be_given = [&](const DrawJob& job) {
      return CanBeGiven(*job.scene, info_.profile);
    };
    if (plugin_.draw_many == nullptr || jobs.size() < 2 || !AreInTheUsualMode(jobs) ||
        !std::ranges::all_of(jobs, can_be_given)) {
      return Subject::DrawMany(jobs);
    }
    Reset();
    std::deque<PluginScene> given;
    std::deque<PluginTarget> targets;
    std::vector<const rasterproof_scene*> scene_views;
    std::vector<const rasterproof_target*> target_views;
    for (const DrawJob& job : jobs) {
      scene_views.push_back(&given.emplace_back(job, VerticesOf(job)).view());
      target_views.push_back(&targets.emplace_back(job, info_, needs_all_).view());
    }
    const std::int32_t refused = InLibrary(FloatMode::kUsual, [&] {
      return plugin_.draw_many(state_, scene_views.data(), target_views.data(), jobs.size());
    });
    if (refused != 0) return Subject::DrawMany(jobs);
    std::vector<DrawOutcome> outcomes;
    for (PluginTarget& target : targets) {
      DrawOutcome& outcome = outcomes.emplace_back();
      outcome.end = EndOf([&] { outcome.drawing = target.Drawn(); });
      if (outcome.end.stop != Stop::kNone) break;
    }
    return outcomes;
  }

 private:
  // Converts once for consecutive jobs that share a scene; into the buffers of the previous scene
  // if no other job of the call needs them.
  std::shared_ptr<const PluginVertices> VerticesOf(const DrawJob& job) {
    if (vertices_ != nullptr && vertices_->scene == job.scene) return vertices_;
    if (vertices_ == nullptr || vertices_.use_count() != 1) {
      vertices_ = std::make_shared<PluginVertices>();
    }
    vertices_->Fill(job.scene, fixed_);
    return vertices_;
  }
  template <class Call>
  std::int32_t InLibrary(FloatMode float_mode, const Call& call) {
    const LibraryEnvironment::Within library(environment_);
    const WithinFloatMode mode(float_mode);
    const std::int32_t refused = call();
    if (const std::string complaint = mode.Complaint(); !complaint.empty()) BreakDown(complaint);
    return refused;
  }
  void RequireDrawn(std::int32_t refused) const {
    if (refused == 0) return;
    throw InputError("subject " + info_.name, "draw returned " + std::to_string(refused),
                     "give it another scene");
  }
  void Reset() {
    const LibraryEnvironment::Within library(environment_);
    if (plugin_.reset != nullptr) plugin_.reset(state_);
  }

  rasterproof_plugin plugin_;
  SubjectInfo info_;
  std::optional<FixedInput> fixed_;
  LibraryEnvironment environment_;
  bool needs_all_;  ///< it was not built to be given less than it shows
  void* state_ = nullptr;
  std::optional<PluginEdges> edges_;
  std::shared_ptr<PluginVertices> vertices_;
  std::vector<std::int32_t> indices_;  ///< room for the next scene's
};

}  // namespace

LoadedPlugin LoadPlugin(const std::string& path) {
  // A name without a slash would be searched in the system's folders.
  const std::string file = path.find('/') == std::string::npos ? "./" + path : path;
  LibraryEnvironment environment;
  void* library = nullptr;
  {
    const LibraryEnvironment::Within loading(environment);  // it may set a mode as it is loaded
    library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  if (library == nullptr) {
    throw InputError(path, std::string("it can't be loaded: ") + dlerror(),
                     "give a shared library (.so) whose dependencies are installed");
  }
  void* const symbol = dlsym(library, kPluginSymbol);
  if (symbol == nullptr) {
    throw InputError(path, std::string("it exports no ") + kPluginSymbol,
                     "see kit/rasterproof_plugin.h; C++ needs its extern \"C\"");
  }
  const auto describe = reinterpret_cast<const rasterproof_plugin* (*)()>(symbol);
  const rasterproof_plugin* description = nullptr;
  {
    const LibraryEnvironment::Within describing(environment);
    description = describe();
  }
  const rasterproof_plugin plugin = Described(description, path);
  return {std::make_unique<PluginSubject>(plugin, path, environment),
          plugin.profile == nullptr ? "real" : plugin.profile};
}

}  // namespace rasterproof::subjects
