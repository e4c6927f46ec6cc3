#include "props/infer/sample_places.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "core/coverage.h"
#include "core/scene.h"

namespace rasterproof::props {
namespace {

constexpr double kFarSide = 32;  // beyond the target from every place
constexpr int kNever = -1;       // in place of a number of steps: no edge leaves the place covered

// Covers what lies beyond the edge, right of it or with greater y.
Scene HalfPlaneScene(int steps, bool along_y) {
  const double begin = static_cast<double>(steps) / kPlaceSteps;
  const double x = along_y ? 0 : begin;
  const double y = along_y ? begin : 0;
  Scene scene;
  scene.width = kSmallTarget;
  scene.height = kSmallTarget;
  scene.vertices = {{x, y}, {x + kFarSide, y}, {x, y + kFarSide}};
  scene.triangles = {{0, 2, 1}};
  return scene;
}

// The last step, from the target's side, at which each sample is covered.
std::vector<int> LastSteps(Observer& observer, bool along_y) {
  std::vector<Scene> scenes;
  std::vector<int> steps;
  for (int k = 0; k <= kSmallTarget * kPlaceSteps; ++k) {
    const std::optional<Scene> given = observer.Given(observer.Turned(HalfPlaneScene(k, along_y)));
    if (!given) continue;
    scenes.push_back(*given);
    steps.push_back(k);
  }
  std::vector<int> last;
  const std::vector<CoverageCounts> seen = observer.Draw(scenes);
  for (std::size_t n = 0; n < seen.size(); ++n) {
    last.resize(std::max(last.size(), seen[n].size()), kNever);
    for (std::size_t k = 0; k < seen[n].size(); ++k) {
      if (seen[n].Count(k) != 0) last[k] = steps[n];
    }
  }
  return last;
}

int Difference(const SeenPlace& a, const SeenPlace& b) {
  return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}

class Reader {
 public:
  Reader(std::vector<int> along_x, std::vector<int> along_y, YAxis y_axis, int samples)
      : x_(std::move(along_x)),
        y_(std::move(along_y)),
        y_up_(y_axis == YAxis::kUp),
        shape_(kSmallTarget, kSmallTarget, samples) {}

  bool IsWhole() const { return x_.size() == shape_.size() && y_.size() == shape_.size(); }

  // Of the pixels that show the sample.
  std::vector<SeenPlace> PlacesOf(int sample) const {
    std::vector<SeenPlace> places;
    for (int row = 0; row < kSmallTarget; ++row) {
      for (int column = 0; column < kSmallTarget; ++column) {
        const std::size_t k = shape_.Index(column, row, sample);
        if (x_[k] == kNever || y_[k] == kNever) continue;
        const int rows = y_up_ ? kSmallTarget - 1 - row : row;
        places.push_back({column, row, x_[k] - kPlaceSteps * column, y_[k] - kPlaceSteps * rows});
      }
    }
    return places;
  }

 private:
  std::vector<int> x_;
  std::vector<int> y_;
  bool y_up_;
  CoverageCounts shape_;
};

std::optional<std::array<int, 2>> Sharing(const std::vector<SeenPlace>& samples) {
  for (std::size_t b = 0; b < samples.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (Difference(samples[a], samples[b]) == 0)
        return std::array<int, 2>{static_cast<int>(a), static_cast<int>(b)};
    }
  }
  return std::nullopt;
}

std::string StepsText(int steps) {
  const std::string of = "/" + std::to_string(kPlaceSteps);
  return std::to_string(steps) + of + " to " + std::to_string(steps + 1) + of;
}

std::string PlaceText(const SeenPlace& place) {
  return "x " + StepsText(place.x) + ", y " + StepsText(place.y);
}

std::string InPixelText(const SeenPlace& place) {
  return "in pixel (" + std::to_string(place.column) + ", " + std::to_string(place.row) + ") at " +
         PlaceText(place);
}

}  // namespace

std::optional<SamplePlaces> FindSamplePlaces(Observer& observer, YAxis y_axis) {
  const int samples = observer.info().profile.pattern.samples();
  std::vector<int> along_x = LastSteps(observer, false);
  const Reader reader(std::move(along_x), LastSteps(observer, true), y_axis, samples);
  if (!reader.IsWhole()) return std::nullopt;
  SamplePlaces places;
  for (int s = 0; s < samples; ++s) {
    const std::vector<SeenPlace> seen = reader.PlacesOf(s);
    if (seen.empty()) return std::nullopt;
    places.samples.push_back(seen.front());
    // A sample on an edge may go to another side in another pixel: one step tells nothing.
    const auto other = std::ranges::find_if(
        seen, [&](const SeenPlace& place) { return Difference(seen.front(), place) >= 2; });
    if (other != seen.end() && !places.varying) places.varying = {s, {seen.front(), *other}};
  }
  places.sharing = Sharing(places.samples);
  return places;
}

std::vector<std::string> PlacesText(const SamplePlaces& places) {
  std::vector<std::string> lines;
  for (std::size_t s = 0; s < places.samples.size(); ++s)
    lines.push_back("sample " + std::to_string(s) + " " + PlaceText(places.samples[s]));
  if (const auto& sharing = places.sharing) {
    lines.push_back("samples " + std::to_string((*sharing)[0]) + " and " +
                    std::to_string((*sharing)[1]) + " seem to share one place");
  }
  if (const auto& varying = places.varying) {
    lines.push_back("positions vary: sample " + std::to_string(varying->sample) + " lies " +
                    InPixelText(varying->seen[0]) + ", " + InPixelText(varying->seen[1]));
  } else {
    lines.emplace_back("positions are the same in every pixel");
  }
  return lines;
}

}  // namespace rasterproof::props
