#include "props/infer/locate.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/transform.h"
#include "model/drop.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"

namespace rasterproof::props {
namespace {

constexpr int kShort = 8;
constexpr int kFinest = 256;
constexpr int kCoarsest = 16;
constexpr int kProbedRow = 3;

// An edge that falls by one pixel in `per_pixel` columns from (2, 2): with ox > 0 it covers the
// columns of pixel row 3 up to per_pixel (1 + oy) + 1.
struct ProbeSize {
  int per_pixel = kFinest;
  bool is_power_of_two = false;  // the sides of its targets: a viewport then takes them exactly

  int Farthest() const { return 2 + 4 * per_pixel; }
  // A place that seems half a pixel off lies below 3/2.
  int Long() const {
    const int least = kShort + 5 * per_pixel / 2;
    return is_power_of_two ? static_cast<int>(std::bit_ceil(static_cast<unsigned>(least))) : least;
  }
  int LastColumnOfZero() const { return per_pixel + 1; }
  std::vector<Vertex> Corners(bool along_y) const {
    const double far = Farthest();
    if (along_y) return {{2, 2}, {far, 6}, {2, far}};
    return {{2, 2}, {6, far}, {far, 2}};
  }
};

Scene OneTriangle(int width, int height, std::vector<Vertex> vertices) {
  Scene scene;
  scene.width = width;
  scene.height = height;
  scene.vertices = std::move(vertices);
  scene.triangles = {{0, 1, 2}};
  return scene;
}

std::uint64_t Sum(const std::vector<std::uint32_t>& counts) {
  std::uint64_t sum = 0;
  for (const std::uint32_t count : counts) sum += count;
  return sum;
}

bool IsEmpty(const CoverageCounts& counts) {
  return Sum(counts.front) == 0 && Sum(counts.back) == 0;
}

// The counts of the upper half of the target minus those of the lower.
std::int64_t UpperExcess(CoverageCounts counts) {
  JoinFacings(counts);
  const auto half = static_cast<std::ptrdiff_t>(counts.size() / 2);
  const std::vector<std::uint32_t> upper(counts.front.begin(), counts.front.begin() + half);
  const std::vector<std::uint32_t> lower(counts.front.begin() + half, counts.front.end());
  return static_cast<std::int64_t>(Sum(upper)) - static_cast<std::int64_t>(Sum(lower));
}

FacingReport FacingOf(const Observer& observer, const CoverageCounts& front,
                      const CoverageCounts& back) {
  if (!observer.TellsFacings()) return FacingReport::kNotTold;
  if (Sum(front.back) == 0 && Sum(back.front) == 0) return FacingReport::kAsOnScreen;
  if (Sum(front.front) == 0 && Sum(back.back) == 0) return FacingReport::kReversed;
  return FacingReport::kNotTold;
}

// The place of sample s along one axis, `per_pixel` times, as a grid that holds the integers shows
// it while the place on the other axis is not 0; else it may be one less.
int Probe(Observer& observer, const ProbeSize& size, bool along_y, YAxis y_axis, int s) {
  const int width = along_y ? size.Long() : kShort;
  const int height = along_y ? kShort : size.Long();
  const CoverageCounts counts =
      observer.Draw(observer.Turned(OneTriangle(width, height, size.Corners(along_y))));
  const auto row_of = [&](int y) { return y_axis == YAxis::kUp ? height - 1 - y : y; };
  int last = 0;
  for (int k = 0; k < size.Long(); ++k) {
    const std::size_t index =
        along_y ? counts.Index(k, row_of(kProbedRow), s) : counts.Index(kProbedRow, row_of(k), s);
    if (counts.Count(index) != 0) last = k;
  }
  return last - size.LastColumnOfZero();
}

struct SampleReading {
  int x;
  int y;
};

int FloorInPixels(int place, int per_pixel) {
  return place >= 0 ? place / per_pixel : -1 - (-1 - place) / per_pixel;
}

// What (seen.x, seen.y) may stand for. The samples of a row lie at i + x: the last one that the
// edge covers comes floor(x) columns earlier, and if x is whole one column later or not as the tie
// rule has it. A grid that is half a pixel off seems to move places out of their pixel.
std::vector<SampleReading> PlacesSeenAs(SampleReading seen, int per_pixel) {
  std::vector<SampleReading> places;
  for (const int whole_x : {0, -1, 1}) {
    for (const int whole_y : {0, -1, 1}) {
      for (const int dx : {0, 1}) {
        for (const int dy : {0, 1}) {
          const SampleReading place{seen.x + whole_y - dx, seen.y + whole_x - dy};
          if (FloorInPixels(place.x, per_pixel) != whole_x) continue;
          if (FloorInPixels(place.y, per_pixel) != whole_y) continue;
          if (dx == 1 && place.y % per_pixel != 0) continue;
          if (dy == 1 && place.x % per_pixel != 0) continue;
          places.push_back(place);
        }
      }
    }
  }
  return places;
}

bool IsInPixel(SampleReading p, int per_pixel) {
  return p.x >= 0 && p.x < per_pixel && p.y >= 0 && p.y < per_pixel;
}

Point2 InPixels(SampleReading p, int per_pixel) {
  return {static_cast<double>(p.x) / per_pixel, static_cast<double>(p.y) / per_pixel};
}

void AddCandidate(std::vector<PatternCandidate>& candidates,
                  const std::vector<SampleReading>& places, int per_pixel, int shift) {
  PatternCandidate candidate{.pattern = {{}}, .half_off = shift != 0};
  for (const SampleReading& p : places) {
    const SampleReading moved{p.x + shift, p.y + shift};
    if (!IsInPixel(moved, per_pixel)) return;
    candidate.pattern.locations.push_back(InPixels(moved, per_pixel));
  }
  candidates.push_back(std::move(candidate));
}

void AddIfNew(std::vector<PatternCandidate>& candidates, const SamplePattern& pattern) {
  const auto is_it = [&](const PatternCandidate& candidate) {
    return !candidate.half_off && candidate.pattern == pattern;
  };
  if (std::ranges::none_of(candidates, is_it)) candidates.push_back({pattern, false});
}

// One sample's readings are all followed up; of several samples each is taken at its first.
std::vector<PatternCandidate> CandidatesFor(const std::vector<SampleReading>& seen, int per_pixel) {
  std::vector<std::vector<SampleReading>> readings;
  if (seen.size() == 1) {
    for (const SampleReading& place : PlacesSeenAs(seen.front(), per_pixel))
      readings.push_back({place});
  } else {
    readings.emplace_back();
    for (const SampleReading& p : seen) {
      const std::vector<SampleReading> places = PlacesSeenAs(p, per_pixel);
      readings.back().push_back(places.empty() ? p : places.front());
    }
  }
  std::vector<PatternCandidate> candidates;
  for (const int shift : {0, per_pixel / 2, -per_pixel / 2}) {
    for (const std::vector<SampleReading>& places : readings)
      AddCandidate(candidates, places, per_pixel, shift);
  }
  return candidates;
}

// Why the stated profile has no room for probes of this size; empty if it has.
std::string ComplaintAgainst(const ProbeSize& size, const Profile& stated) {
  TargetProfile small(stated, kShort, kShort);
  const int side = size.Long();
  for (const auto& [width, height] : {std::pair{side, kShort}, {kShort, side}, {32, 32}}) {
    if (TargetProfile(stated, width, height) != small) {
      return "the stated models of its targets part at less than " + std::to_string(side) +
             " pixels a side";
    }
  }
  if (!StatesGuardBand(small)) small.guard_band.reset();
  const int farthest = size.Farthest();
  for (const bool along_y : {false, true}) {
    const Scene probe = OneTriangle(side, side, size.Corners(along_y));
    const std::array<Vertex, 3> v = Corners(probe, probe.triangles[0]);
    if (!WithinLimits(probe, small) || !IsUnwrapped(probe, small)) {
      return "it needs coordinates up to " + std::to_string(farthest) +
             ", which the stated profile does not state";
    }
    if (!IsUnclipped(probe, small)) {
      return "the stated guard-band rectangle does not hold coordinates from 2 to " +
             std::to_string(farthest);
    }
    if (small.max_primitive_extent &&
        Exceeds({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])},
                *small.max_primitive_extent)) {
      return "it needs triangles of " + std::to_string(farthest - 2) +
             " pixels a side, larger than it promises to draw";
    }
  }
  return "";
}

// The finest probes that what is stated has room for; else the coarsest.
ProbeSize SizeFor(const Profile& stated) {
  ProbeSize size;
  size.is_power_of_two = stated.transform.has_value();
  while (size.per_pixel > kCoarsest && !ComplaintAgainst(size, stated).empty()) size.per_pixel /= 2;
  return size;
}

}  // namespace

std::string TooLittleRoom(const SubjectInfo& info) {
  const Profile& stated = info.profile;
  const auto& transform = stated.transform;
  if (transform && transform->map) {
    return "it draws maps, and infer needs window space; give a variant that takes it";
  }
  if (!stated.scanline_rounding.IsNone()) {
    return "it rounds where edges cross rows, as stated: on a grid that holds the samples this "
           "can't be told from samples elsewhere";
  }
  return ComplaintAgainst(SizeFor(stated), stated);
}

Location Locate(Observer& observer) {
  Location location;
  // In the upper half with y down, in the lower with y up.
  const Scene back_scene = OneTriangle(32, 32, {{2, 2}, {30, 2}, {2, 14}});
  Scene front_scene = back_scene;
  front_scene.triangles = {{0, 2, 1}};
  CoverageCounts clockwise = observer.Raw(back_scene);
  CoverageCounts counter = observer.Raw(front_scene);
  // Both windings are asked: a subject may draw one of them only.
  const std::int64_t excess = UpperExcess(clockwise) + UpperExcess(counter);
  if (excess == 0) {
    location.complaint = "a triangle in one half of the target covers nothing, or both halves";
    location.complaint_scene = back_scene;
  }
  location.y_axis = excess < 0 ? YAxis::kUp : YAxis::kDown;
  // With y up the same vertices turn the other way on screen.
  if (location.y_axis == YAxis::kUp) std::swap(clockwise, counter);
  observer.SetFacing(FacingOf(observer, counter, clockwise));
  JoinFacings(counter);
  JoinFacings(clockwise);
  if (IsEmpty(counter) != IsEmpty(clockwise)) {
    location.culls = IsEmpty(counter) ? Cull::kFront : Cull::kBack;
    observer.SetCulls(location.culls, location.y_axis);
  } else if (location.complaint.empty() && counter != clockwise) {
    location.complaint = "a triangle covers other samples when its vertices turn the other way";
    location.complaint_scene = front_scene;
  }
  const ProbeSize size = SizeFor(observer.info().profile);
  location.per_pixel = size.per_pixel;
  std::vector<SampleReading> seen;
  for (int s = 0; s < observer.info().profile.pattern.samples(); ++s) {
    const int x = Probe(observer, size, false, location.y_axis, s);
    seen.push_back({x, Probe(observer, size, true, location.y_axis, s)});
  }
  location.patterns = CandidatesFor(seen, size.per_pixel);
  if (std::ranges::all_of(location.patterns, &PatternCandidate::half_off)) {
    // Nothing that a plain grid explains: the race is run all the same, to name the nearest.
    SamplePattern centres;
    centres.locations.assign(seen.size(), {0.5, 0.5});
    location.patterns.insert(location.patterns.begin(), {centres, false});
  }
  // What is stated is in the race, also if it lies between the places that could be seen.
  if (size.per_pixel < kFinest) AddIfNew(location.patterns, observer.stated().pattern);
  return location;
}

}  // namespace rasterproof::props
