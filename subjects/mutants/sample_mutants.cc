// Several samples a pixel: what the legal sets leave open of their places, and what they don't.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "core/sample_pattern.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

constexpr std::int64_t kSamplePixel = 256;

FixedStages StagesOf(std::string_view preset) { return StagesOfPreset(preset); }

// Positions that are the same in every pixel, and not stated.
FixedStages Unstated(SamplePositions positions) {
  FixedStages stages = StagesOf("gl-4x");
  stages.profile.name = "gl, 4 samples";
  stages.profile.sample_positions = positions;
  stages.profile.translation_invariant = positions == SamplePositions::kFixed;
  return stages;
}

GridPoint CornerOf(const Sample& sample) {
  return {sample.x * kSamplePixel, sample.row * kSamplePixel};
}

// Sample s of the pixel at a place of the standard pattern, whatever the profile's own.
GridPoint AtStandard(const Sample& sample, std::size_t s) {
  static const SamplePattern pattern = *StandardPattern(4);
  const GridPoint corner = CornerOf(sample);
  return {corner.x + static_cast<std::int64_t>(pattern.locations[s].x * kSamplePixel),
          corner.y + static_cast<std::int64_t>(pattern.locations[s].y * kSamplePixel)};
}

GridPoint Mirrored(const Sample& sample) {
  const GridPoint corner = CornerOf(sample);
  return {2 * corner.x + kSamplePixel - sample.at.x, sample.at.y};
}

FixedStages Sampling(FixedStages stages, GridPoint (*sample)(const Sample&)) {
  stages.sample = sample;
  return stages;
}

GridPoint MirroredInOddColumns(const Sample& sample) {
  return sample.x % 2 == 0 ? sample.at : Mirrored(sample);
}

GridPoint InTheCorners(const Sample& sample) {
  const GridPoint corner = CornerOf(sample);
  constexpr std::array<std::int64_t, 2> kFar{0, kSamplePixel - 1};
  const auto s = static_cast<std::size_t>(sample.s);
  return {corner.x + kFar[s % 2], corner.y + kFar[s / 2]};
}

GridPoint OnTheFarBorders(const Sample& sample) {
  const GridPoint corner = CornerOf(sample);
  const auto s = static_cast<std::size_t>(sample.s);
  return {corner.x + (s % 2 == 0 ? 0 : kSamplePixel), corner.y + (s / 2 == 0 ? 0 : kSamplePixel)};
}

GridPoint APixelRight(const Sample& sample) { return {sample.at.x + kSamplePixel, sample.at.y}; }

// Covers nothing if it is smaller than a quarter of a pixel.
std::uint32_t UnlessSmall(const Sample& /*sample*/, const GridTriangle& triangle) {
  const auto& [a, b, c] = triangle.v;
  const std::int64_t twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return std::abs(twice) < kSamplePixel * kSamplePixel / 2 ? 0 : 1;
}

FixedStages LosingSmallTriangles(FixedStages stages) {
  stages.times = UnlessSmall;
  return stages;
}

// Every other triangle is tested a quarter of a pixel beside the sample.
FixedStages SamplingByTriangle(FixedStages stages) {
  stages.facing = [](GridTriangle& triangle) {
    if (triangle.number % 2 == 0) return;
    for (GridPoint& p : triangle.v) p.x += kSamplePixel / 4;
  };
  return stages;
}

// What the last sample of a pixel counts as front, it shows as back.
void TurnTheLastSample(CoverageCounts& counts, const CoverageCounts& before) {
  const auto samples = static_cast<std::size_t>(counts.samples);
  for (std::size_t k = samples - 1; k < counts.size(); k += samples) {
    const std::uint32_t front = counts.front[k] - before.front[k];
    const std::uint32_t back = counts.back[k] - before.back[k];
    counts.front[k] = before.front[k] + back;
    counts.back[k] = before.back[k] + front;
  }
}

FixedStages TurningTheLastSample(FixedStages stages) {
  stages.after = TurnTheLastSample;
  return stages;
}

// 64 places on multiples of 2^-8.
FixedStages SixtyFour() {
  FixedStages stages;
  stages.profile.name = "64 samples";
  stages.profile.pattern.locations.clear();
  for (int k = 0; k < kMaxSamplesPerPixel; ++k)
    stages.profile.pattern.locations.push_back({k * 4 / 256.0, k * 37 % 256 / 256.0});
  return stages;
}

std::vector<Mutant> SampleMutants() {
  return {
      {"samples-one-reused", "the third of four samples lies where the second does", "",
       Sampling(StagesOf("d3d11-4x"),
                [](const Sample& at) { return at.s == 2 ? AtStandard(at, 1) : at.at; }),
       "sample-order", "OneLegalModelExplainsTheMesh"},
      {"samples-centre-for-all", "coverage is decided in the pixel's centre for all four samples",
       "",
       Sampling(StagesOf("d3d11-4x"),
                [](const Sample& at) {
                  const GridPoint corner = CornerOf(at);
                  return GridPoint{corner.x + kSamplePixel / 2, corner.y + kSamplePixel / 2};
                }),
       "sample-order", "OneLegalModelExplainsTheMesh"},
      {"samples-exchanged-under-vulkan", "the first and the last standard location are exchanged",
       "",
       Sampling(
           StagesOf("vulkan-standard-4x"),
           [](const Sample& at) {
             return AtStandard(at, static_cast<std::size_t>(at.s == 0 ? 3 : at.s == 3 ? 0 : at.s));
           }),
       "sample-order", "OneLegalModelExplainsTheMesh"},
      {"samples-vary", "stated locations are mirrored in every other column", "",
       Sampling(StagesOf("d3d11-4x"), MirroredInOddColumns), "", "OneLegalModelExplainsTheMesh"},
      {"samples-vary-where-fixed",
       "locations that are said to be fixed are mirrored in every other column", "",
       Sampling(Unstated(SamplePositions::kFixed), MirroredInOddColumns), "",
       "IntegerTranslationMovesCoverage|SamplesLieInTheirPixel"},
      {"samples-by-triangle", "a sample lies elsewhere for every other triangle", "",
       SamplingByTriangle(StagesOf("vulkan-4x")), "list", "SharedEdgeSamplesAreCoveredOnce"},
      {"facing-by-sample", "the last of four samples sees the other facing", "",
       TurningTheLastSample(StagesOf("d3d11-4x")), "", "FacingIsOneAtAllSamples"},
      {"facing-by-sample-where-open",
       "the last of four samples, wherever it lies, sees the other "
       "facing",
       "", TurningTheLastSample(StagesOf("vulkan-4x")), "", "FacingIsOneAtAllSamples"},
      {"samples-outside-where-open", "all four samples lie 1.5 pixels beside their pixel's places",
       "",
       Sampling(
           StagesOf("vulkan-4x"),
           [](const Sample& at) { return GridPoint{at.at.x + 3 * kSamplePixel / 2, at.at.y}; }),
       "sample-order", "SamplesLieInTheirPixel"},
      {"samples-one-outside-where-open", "one of four samples lies a pixel further", "",
       Sampling(StagesOf("vulkan-4x"),
                [](const Sample& at) { return at.s == 2 ? APixelRight(at) : at.at; }),
       "sample-order", "SamplesLieInTheirPixel"},
      {"small-triangles-lost-where-open",
       "triangles smaller than a quarter of a pixel vanish, wherever samples lie", "",
       LosingSmallTriangles(StagesOf("vulkan-4x")), "lost-triangles", "SamplesLieInTheirPixel"},
  };
}

std::vector<Mutant> SampleVariants() {
  return {
      {"samples-standard-8", "eight samples lie as Direct3D says", "", StagesOf("d3d11-8x")},
      {"samples-standard-16", "16 samples lie as Vulkan's table says", "",
       StagesOf("vulkan-standard-16x")},
      {"samples-64", "64 samples lie on multiples of 1/256", "", SixtyFour()},
      {"samples-mirrored-under-gl", "samples lie elsewhere, in every pixel alike", "OpenGL",
       Sampling(Unstated(SamplePositions::kFixed), Mirrored)},
      {"samples-in-corners", "samples lie in the corners of the pixel", "Vulkan",
       Sampling(StagesOf("vulkan-4x"), InTheCorners)},
      {"samples-vary-under-gl", "samples lie elsewhere in every other column", "OpenGL",
       Sampling(StagesOf("gl-4x"), MirroredInOddColumns)},
      {"samples-centre-under-vulkan", "all four samples lie in one place of their pixel", "Vulkan",
       Sampling(StagesOf("vulkan-4x"), [](const Sample& at) { return AtStandard(at, 0); })},
      {"samples-on-far-borders", "samples lie on the pixel's corners, the far ones too", "Vulkan",
       Sampling(StagesOf("vulkan-4x"), OnTheFarBorders)},
      {"samples-vary-under-vulkan", "samples lie elsewhere in every other column", "Vulkan",
       Sampling(StagesOf("vulkan-4x"), MirroredInOddColumns)},
      {"samples-16-under-vulkan", "16 samples whose places are not stated", "Vulkan",
       StagesOf("vulkan-16x")},
      {"samples-outside-under-gl", "samples lie a pixel beside their pixel's places", "OpenGL",
       Sampling(StagesOf("gl-4x"), APixelRight)},
  };
}

}  // namespace

extern constinit const MutantTable kSampleMutants{MutantKind::kPlanted, 21, SampleMutants};
extern constinit const MutantTable kSampleVariants{MutantKind::kLegal, 13, SampleVariants};

}  // namespace rasterproof::subjects::mutants
