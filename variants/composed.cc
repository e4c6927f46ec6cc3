#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "variants/stages.h"

namespace rasterproof::variants {
namespace {

// Fills `into` from `from` where only one of the two is there.
template <class Stage>
bool Merge(Stage& into, const Stage& from) {
  if (into && from) return false;
  if (from) into = from;
  return true;
}

// Both changes, one after the other.
template <class... Arguments>
void Add(std::function<void(Arguments...)>& into, const std::function<void(Arguments...)>& more) {
  if (Merge(into, more)) return;
  into = [first = std::move(into), more](Arguments... arguments) {
    first(arguments...);
    more(arguments...);
  };
}

}  // namespace

std::optional<Stages<Point2>> Composed(const Stages<Point2>& a, const Stages<Point2>& b) {
  using Both = Stages<Point2>;
  Both both = a;
  both.draws_flat = a.draws_flat || b.draws_flat;
  Add(both.model, b.model);
  Add(both.options, b.options);
  Add(both.scene, b.scene);
  Add(both.vertices, b.vertices);
  Add(both.place, b.place);
  Add(both.facing, b.facing);
  Add(both.edges, b.edges);
  Add(both.box, b.box);
  Add(both.share, b.share);
  Add(both.weights, b.weights);
  Add(both.depth, b.depth);
  Add(both.after, b.after);
  Add(both.batch, b.batch);
  if (!Merge(both.leaves_out, b.leaves_out)) {
    both.leaves_out = [one = a.leaves_out, two = b.leaves_out](const Both::Placed& t,
                                                               const Scene& scene) {
      return one(t, scene) || two(t, scene);
    };
  }
  if (!Merge(both.times, b.times)) {
    both.times = [one = a.times, two = b.times](const Both::Sample& s, const Both::Placed& t) {
      return one(s, t) * two(s, t);
    };
  }
  const bool is_one =
      Merge(both.tile, b.tile) && Merge(both.clip, b.clip) &&
      Merge(both.turns_over, b.turns_over) && Merge(both.drops, b.drops) &&
      Merge(both.wrap, b.wrap) && Merge(both.snap, b.snap) && Merge(both.too_large, b.too_large) &&
      Merge(both.area, b.area) && Merge(both.tile_test, b.tile_test) &&
      Merge(both.sample, b.sample) && Merge(both.value, b.value) && Merge(both.owns, b.owns) &&
      Merge(both.index, b.index) && Merge(both.id, b.id) && Merge(both.kept_by, b.kept_by);
  return is_one ? std::optional(both) : std::nullopt;
}

}  // namespace rasterproof::variants
