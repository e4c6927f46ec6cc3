// Rasterizers of subjects/mutants/ that show values, against the exact oracle and apart from the
// properties: the legal ones keep their error, and most of what is planted shows.
#include "subjects/mutants/values.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "core/channel.h"
#include "core/drawing.h"
#include "core/scene.h"
#include "core/subject.h"
#include "exact/values.h"
#include "subjects/mutants/mutants.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

constexpr int kValueSide = 8;

class DrawScenes {
 public:
  Scene Next(bool clip_space) {
    Scene scene;
    scene.width = scene.height = kValueSide;
    scene.clip_space = clip_space;
    for (int i = 0; i < 3; ++i) {
      const double w = clip_space ? Number(8) : 1;
      const double x = std::floor(Unit() * 48 - 16) / 4, y = std::floor(Unit() * 48 - 16) / 4;
      scene.vertices.push_back({Float(x * w), Float(y * w), Number(2), w});
    }
    scene.triangles = {{0, 1, 2}};
    for (const Interpolation i : {Interpolation::kPerspective, Interpolation::kLinear,
                                  Interpolation::kInverseW, Interpolation::kPerspective}) {
      Channel channel{"c" + std::to_string(scene.channels.size()), i};
      if (i != Interpolation::kInverseW) {
        for (int k = 0; k < 3; ++k) channel.values.push_back(Number(20));
      }
      scene.channels.push_back(channel);
    }
    return scene;
  }

 private:
  double Unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  static double Float(double x) { return static_cast<float>(x); }
  double Number(int exponents) {
    const double size = std::ldexp(1 + Unit(), static_cast<int>(Unit() * exponents) - 4);
    return Float(Unit() < 0.2 ? -size : size);
  }

  std::mt19937_64 random_{1};
};

exact::HomogeneousTriangle CornersOf(const Scene& scene) {
  const std::vector<Vertex>& v = scene.vertices;
  if (scene.clip_space) return exact::ClipTriangle({v[0], v[1], v[2]});
  return exact::WindowTriangle({{{v[0].x, v[0].y}, {v[1].x, v[1].y}, {v[2].x, v[2].y}}});
}

exact::Attribute NumbersOf(const Channel& channel) {
  if (channel.interpolation == Interpolation::kInverseW) return exact::Ones();
  return exact::ToAttribute({channel.values[0], channel.values[1], channel.values[2]});
}

// How many values of the scene are beyond the subject's error.
int Wrong(Subject& subject, const Scene& scene) {
  const ValueError stated = subject.Info().profile.values.error;
  const ValueError bound = stated.IsStated() ? stated : ValueError{.conditions = kUsualConditions};
  DrawJob job(scene, {}, 1);
  job.wants.values = job.wants.derivatives = true;
  const Drawing drawing = DrawOne(subject, job);
  const std::size_t channels = scene.channels.size();
  int wrong = 0;
  for (std::size_t k = 0; k < drawing.primitive_ids.size(); ++k) {
    if (drawing.primitive_ids[k] == kNoPrimitive) continue;
    const exact::Interpolant at(CornersOf(scene), {static_cast<double>(k % kValueSide) + 0.5,
                                                   static_cast<double>(k / kValueSide) + 0.5});
    for (std::size_t c = 0; c < channels; ++c) {
      const Channel& channel = scene.channels[c];
      const auto value = at.Value(channel.interpolation, NumbersOf(channel));
      const auto condition = at.Conditions(channel.interpolation, NumbersOf(channel));
      if (!value || !condition) continue;
      const double x = drawing.values[k * channels + c];
      wrong += exact::IsWithin(x, *value, condition->value, bound, subject.Info().input) ? 0 : 1;
    }
  }
  return wrong;
}

int WrongOfMany(std::string_view name, int scenes) {
  const std::unique_ptr<Subject> subject = subjects::MakeMutant(name);
  DrawScenes draw;
  int wrong = 0;
  for (int n = 0; n < scenes; ++n) {
    const Scene scene = draw.Next(n % 2 == 1 && subject->Info().takes_clip);
    wrong += Wrong(*subject, scene);
  }
  return wrong;
}

bool IsOfUsualPixels(const SubjectInfo& info) {
  return info.fragments.shows_values && info.profile.pattern.samples() == 1 &&
         info.profile.y_axis == YAxis::kDown &&
         info.fragments.barycentrics_of == BarycentricsOf::kGiven;
}

TEST(Values, OfLegalVariantsKeepTheirError) {
  int variants = 0;
  for (const subjects::MutantInfo& variant : subjects::Mutants()) {
    if (!variant.legal || !IsOfUsualPixels(subjects::MakeMutant(variant.name)->Info())) continue;
    ++variants;
    EXPECT_EQ(WrongOfMany(variant.name, Cases(200)), 0) << variant.name;
  }
  EXPECT_GT(variants, 20);
}

TEST(Values, OfPlantedBugsDoNot) {
  for (const char* name :
       {"mutant:values-affine", "mutant:values-exchanged", "mutant:values-divided-twice",
        "mutant:values-times-w", "mutant:values-not-divided", "mutant:values-behind-the-eye",
        "mutant:values-12-bits-of-inverse-w", "mutant:values-half", "mutant:values-at-corners"})
    EXPECT_GT(WrongOfMany(name, 50), 0) << name;
}

}  // namespace
}  // namespace rasterproof
