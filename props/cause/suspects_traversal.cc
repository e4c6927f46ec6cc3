// Suspects that visit the wrong samples: box, target, scissor, tiles.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "props/cause/suspect.h"

namespace rasterproof::props {
namespace {

// The sides of a rectangle, and how the reader calls them.
struct Side {
  int PixelRect::* end;
  int inward;
  std::string_view word;
};
constexpr Side kRectangleSides[] = {{&PixelRect::x0, 1, "left"},
                                    {&PixelRect::y0, 1, "top"},
                                    {&PixelRect::x1, -1, "right"},
                                    {&PixelRect::y1, -1, "bottom"}};

constexpr double kEverywhere = std::numeric_limits<double>::infinity();

void AddBoxes(std::vector<Suspect>& list) {
  for (const Side& side : kRectangleSides) {
    for (const int by : {1, 2}) {
      list.push_back({"bounding-box",
                      "ends a triangle's box " + std::to_string(by) + " pixel" +
                          (by == 1 ? "" : "s") + " early on the " + std::string(side.word),
                      {.box = [side, by](PixelRect& box, const SuspectTriangle&, const Scene&) {
                        box.*side.end += by * side.inward;
                      }}});
    }
    // On the other sides it is one of the loops below.
    if (side.inward < 0) continue;
    list.push_back({"bounding-box",
                    "begins a triangle's box 1 pixel late on the " + std::string(side.word) +
                        ", before it is cut to the target",
                    {.box = [side](PixelRect& box, const SuspectTriangle& t, const Scene&) {
                      const auto axis = side.end == &PixelRect::x0 ? &Point2::x : &Point2::y;
                      const Point2& least = std::ranges::min(t.v, {}, axis);
                      box.*side.end = std::max(box.*side.end, ToPixel(std::floor(least.*axis)) + 1);
                    }}});
  }
  list.push_back({"bounding-box",
                  "takes a box of one column for empty",
                  {.box = [](PixelRect& box, const SuspectTriangle&, const Scene&) {
                    if (box.x1 - box.x0 == 1) box.x1 = box.x0;
                  }}});
  list.push_back({"bounding-box",
                  "takes a box of one row for empty",
                  {.box = [](PixelRect& box, const SuspectTriangle&, const Scene&) {
                    if (box.y1 - box.y0 == 1) box.y1 = box.y0;
                  }}});
}

// Where a loop over the pixels of a triangle's box begins, by the least coordinate.
struct LoopBegin {
  std::string_view words;  ///< "{}" is the axis; "": where it should
  double (*of)(double least);
};
constexpr LoopBegin kLoopBegins[] = {
    {"", [](double) { return -kEverywhere; }},
    {"at ceil of the least {}", [](double least) { return std::ceil(least); }},
};
// Where it ends, by the largest coordinate and the target's size: that pixel is left out.
struct LoopEnd {
  std::string_view words;
  double (*of)(double most, double size);
};
constexpr LoopEnd kLoopEnds[] = {
    {"", [](double, double) { return kEverywhere; }},
    {"before floor of the largest {}", [](double most, double) { return std::floor(most); }},
    {"before ceil of the largest {} less 1",
     [](double most, double) { return std::ceil(most) - 1; }},
    {"before floor of the largest {}, cut to the target's last pixel",
     [](double most, double size) { return std::min(std::floor(most), size - 1); }},
    {"before ceil of the largest {} less 1, cut to the target's last pixel",
     [](double most, double size) { return std::min(std::ceil(most), size) - 1; }},
};

struct BoxLoop {
  bool along_x, along_y;
  bool y_up;  ///< its rows are counted from the bottom
  double (*begin)(double least);
  double (*end)(double most, double size);

  void operator()(PixelRect& box, const SuspectTriangle& t, const Scene& scene) const {
    if (along_x) {
      const auto [left, right] = std::ranges::minmax(t.v, {}, &Point2::x);
      box.x0 = std::max(box.x0, ToPixel(begin(left.x)));
      box.x1 = std::min(box.x1, ToPixel(end(right.x, scene.width)));
    }
    if (along_y) {
      const auto [top, bottom] = std::ranges::minmax(t.v, {}, &Point2::y);
      int first = ToPixel(begin(y_up ? -bottom.y : top.y));
      int last = ToPixel(end(y_up ? -top.y : bottom.y, scene.height));
      if (y_up) std::tie(first, last) = std::pair(scene.height - last, scene.height - first);
      box.y0 = std::max(box.y0, first);
      box.y1 = std::min(box.y1, last);
    }
  }
};

std::string BoxWords(const LoopBegin& begin, const LoopEnd& end, std::string_view axis) {
  const auto named = [axis](std::string_view words) {
    std::string text(words);
    return text.replace(text.find("{}"), 2, axis);
  };
  if (end.words.empty()) return "begins a triangle's box " + named(begin.words);
  if (begin.words.empty()) return "ends a triangle's box " + named(end.words);
  return "begins a triangle's box " + named(begin.words) + " and ends it " + named(end.words);
}

// Loops as usual code has them, for (x = floor(least); x < floor(largest); ++x), in x alone, in y
// alone and in both.
void AddBoxLoops(const Profile& profile, std::vector<Suspect>& list) {
  const bool y_up = profile.y_axis == YAxis::kUp;
  for (const auto& [x, y, axis] : {std::tuple(true, true, "x and y"), std::tuple(true, false, "x"),
                                   std::tuple(false, true, "y")}) {
    const auto add = [&, along_x = x, along_y = y](const std::string& what, auto begin, auto end) {
      list.push_back({"bounding-box", what, {.box = BoxLoop{along_x, along_y, y_up, begin, end}}});
    };
    for (const LoopBegin& begin : kLoopBegins) {
      for (const LoopEnd& end : kLoopEnds) {
        if (!begin.words.empty() || !end.words.empty())
          add(BoxWords(begin, end, axis), begin.of, end.of);
      }
    }
    // Right where the samples are centres and none lies on the triangle's far side.
    add(std::string("ends a triangle's box before ceil of the largest ") + axis, kLoopBegins[0].of,
        [](double most, double) { return std::ceil(most); });
    add(
        std::string("takes only pixels whose centre lies strictly within the box in ") + axis,
        [](double least) { return std::floor(least + 0.5); },
        [](double most, double) { return std::ceil(most - 0.5); });
  }
}

using InPicture = bool (*)(const SuspectSample&);

void AddTargets(std::vector<Suspect>& list) {
  const auto add = [&](const std::string& what, auto is_lost) {
    list.push_back({"target-border",
                    what,
                    {.times = [is_lost](const SuspectSample& s, const SuspectTriangle&) {
                      return is_lost(s) ? 0U : 1U;
                    }}});
  };
  add("never draws the first row", [](const SuspectSample& s) { return s.row == 0; });
  add("never draws the first column", [](const SuspectSample& s) { return s.x == 0; });
  add("never draws the last row", [](const SuspectSample& s) { return s.row == s.height - 1; });
  add("never draws the last column", [](const SuspectSample& s) { return s.x == s.width - 1; });
  for (const int odd : {0, 1}) {
    const std::string of = odd == 1 ? "odd" : "even";
    add("never draws the last column of targets of " + of + " width",
        [odd](const SuspectSample& s) { return s.width % 2 == odd && s.x == s.width - 1; });
    add("never draws the last row of targets of " + of + " height",
        [odd](const SuspectSample& s) { return s.height % 2 == odd && s.row == s.height - 1; });
  }
  add("draws nothing on targets of one column",
      [](const SuspectSample& s) { return s.width == 1; });
  add("draws nothing on targets of one row", [](const SuspectSample& s) { return s.height == 1; });
  for (const auto& [line, at] :
       {std::pair("column", &SuspectSample::x), std::pair("row", &SuspectSample::row)}) {
    const auto within = [at = at](std::int64_t budget) -> SuspectStages {
      return {.times = [=](const SuspectSample& s, const SuspectTriangle&) {
        return s.*at < budget ? 1U : 0U;
      }};
    };
    list.push_back(
        {"target-border", std::string("never draws pixels from ") + line + " {} on", {}, within});
  }
}

void AddTiles(std::vector<Suspect>& list) {
  for (const int side : {2, 4, 8, 16, 32, 64}) {
    for (const bool last : {false, true}) {
      for (const bool y : {false, true}) {
        for (const bool twice : {false, true}) {
          const std::string what =
              std::string(twice ? "counts samples twice in " : "leaves out samples in ") +
              (last ? "the last " : "the first ") + (y ? "row" : "column") + " of tiles of " +
              std::to_string(side) + " pixels";
          list.push_back(
              {"tile-borders", what, {.times = [=](const SuspectSample& s, const SuspectTriangle&) {
                 const int at = y ? s.row : s.x;
                 const bool hits = last ? at % side == side - 1 : at % side == 0 && at > 0;
                 return !hits ? 1U : twice ? 2U : 0U;
               }}});
        }
      }
    }
  }
}

using CornerNumbers = SuspectStages::TileCorners;

bool IsInside(const std::array<CornerNumbers, 3>& values, std::size_t corner) {
  return std::ranges::all_of(values, [&](const CornerNumbers& e) { return e[corner] > 0; });
}
bool IsOutside(const std::array<CornerNumbers, 3>& values, std::size_t corner) {
  return std::ranges::any_of(values, [&](const CornerNumbers& e) { return e[corner] < 0; });
}

void AddTileTests(std::vector<Suspect>& list) {
  using variants::TileTest;
  const auto add = [&](const std::string& what, TileTest instead, auto holds) {
    for (const int side : {4, 8, 16, 32, 64}) {
      SuspectStages stages;
      stages.tile = side;
      stages.tile_test = [instead, holds](const std::array<CornerNumbers, 3>& values,
                                          TileTest sound) {
        return holds(values) ? instead : sound;
      };
      list.push_back({"tile-borders", what + " (tiles of " + std::to_string(side) + " pixels)",
                      std::move(stages)});
    }
  };
  constexpr std::string_view kCorners[] = {"top left", "top right", "bottom left", "bottom right"};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string corner = "its " + std::string(kCorners[k]) + " sample ";
    add("fills a tile if " + corner + "is inside", TileTest::kInside,
        [k](const auto& values) { return IsInside(values, k); });
    add("leaves out a tile if " + corner + "is outside", TileTest::kOutside,
        [k](const auto& values) { return IsOutside(values, k); });
  }
  add("fills a tile if two opposite samples are inside", TileTest::kInside,
      [](const auto& values) { return IsInside(values, 0) && IsInside(values, 3); });
  add("leaves out a tile if no corner is inside", TileTest::kOutside, [](const auto& values) {
    return IsOutside(values, 0) && IsOutside(values, 1) && IsOutside(values, 2) &&
           IsOutside(values, 3);
  });
}

void AddScissors(std::vector<Suspect>& list) {
  const auto add = [&](const std::string& what, auto change) {
    list.push_back({"scissor", what, {.options = [change](DrawOptions& o, const Scene& scene) {
                      if (o.scissor) change(o, scene);
                    }}});
  };
  add("ignores the scissor", [](DrawOptions& o, const Scene&) { o.scissor.reset(); });
  for (const Side& side : kRectangleSides) {
    for (const int by : {-1, 1}) {
      add("ends the scissor one pixel " + std::string(by < 0 ? "late" : "early") + " on the " +
              std::string(side.word),
          [side, by](DrawOptions& o, const Scene&) { (*o.scissor).*side.end += by * side.inward; });
    }
  }
  add("exchanges the scissor's axes", [](DrawOptions& o, const Scene&) {
    const PixelRect s = *o.scissor;
    o.scissor = PixelRect{s.y0, s.x0, s.y1, s.x1};
  });
  add("counts the scissor's rows from the bottom", [](DrawOptions& o, const Scene& scene) {
    const PixelRect s = *o.scissor;
    o.scissor = PixelRect{s.x0, scene.height - s.y1, s.x1, scene.height - s.y0};
  });
}

void AddCounting(std::vector<Suspect>& list) {
  list.push_back({"counting",
                  "counts a sample once, however many triangles cover it",
                  {.after = [](CoverageCounts& counts, const CoverageCounts&) {
                    for (std::uint32_t& n : counts.front) n = std::min(n, 1U);
                    for (std::uint32_t& n : counts.back) n = std::min(n, 1U);
                  }}});
  list.push_back({"y-axis",
                  "draws the picture upside down",
                  {.after = [](CoverageCounts& counts, const CoverageCounts&) {
                    const CoverageCounts drawn = counts;
                    for (int row = 0; row < counts.height; ++row) {
                      for (int x = 0; x < counts.width; ++x) {
                        for (int s = 0; s < counts.samples; ++s) {
                          const auto to = counts.Index(x, row, s);
                          const auto from = counts.Index(x, counts.height - 1 - row, s);
                          counts.front[to] = drawn.front[from];
                          counts.back[to] = drawn.back[from];
                        }
                      }
                    }
                  }}});
  list.push_back({"counting",
                  "counts samples level with the middle vertex twice",
                  {.times = [](const SuspectSample& s, const SuspectTriangle& t) {
                    std::array<double, 3> y{t.v[0].y, t.v[1].y, t.v[2].y};
                    std::ranges::sort(y);
                    return s.at.y == y[1] && y[0] < y[1] && y[1] < y[2] ? 2U : 1U;
                  }}});
  list.push_back({"vertices",
                  "does not draw a sample exactly on a vertex",
                  {.times = [](const SuspectSample& s, const SuspectTriangle& t) {
                    return std::ranges::find(t.v, s.at) == t.v.end() ? 1U : 0U;
                  }}});
}

}  // namespace

void AddTraversal(const Profile& profile, std::vector<Suspect>& list) {
  AddBoxes(list);
  AddBoxLoops(profile, list);
  AddTargets(list);
  AddTiles(list);
  AddTileTests(list);
  AddScissors(list);
  AddCounting(list);
}

}  // namespace rasterproof::props
