// A case for a conformance test: the scene, and what all legal drawings agree on.
#ifndef RASTERPROOF_CORE_TEST_VECTOR_H_
#define RASTERPROOF_CORE_TEST_VECTOR_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/counters.h"
#include "core/profile.h"
#include "core/sample_pattern.h"
#include "core/scene.h"

namespace rasterproof {

/// The version of the format of vectors: a reader refuses any other.
inline constexpr int kVectorsVersion = 1;
/// The last key of a file's first line: the hash of what comes before it.
inline constexpr std::string_view kHeaderHashKey = "header_fnv1a64";

/// One triangle of a vector, drawn alone.
struct TriangleVector {
  /// +1 counter-clockwise on screen, -1 clockwise, in every legal drawing; 0: they differ, or it
  /// has no area.
  int facing = 0;
  std::vector<std::size_t> must;  ///< samples that every legal drawing covers, in rising order
  std::vector<std::size_t> may;   ///< samples that some cover and others do not, in rising order

  friend bool operator==(const TriangleVector&, const TriangleVector&) = default;
};

/// Triangles that may each cover a sample, and how many of them do in legal drawings.
struct JointVector {
  std::size_t sample = 0;
  std::vector<std::size_t> triangles;  ///< in rising order, at least two
  std::vector<int> counts;             ///< legal numbers of covering triangles, in rising order

  friend bool operator==(const JointVector&, const JointVector&) = default;
};

/// A number that is asked for, and the floats that the profile's error allows in its place.
struct NumberVector {
  std::string exact;  ///< "3", "-7/2"
  float nearest = 0;
  float low = 0;
  float high = 0;
};

/// What a channel of the scene holds at a covered sample of a triangle.
struct ValueVector {
  std::size_t triangle = 0;
  std::size_t sample = 0;
  std::size_t channel = 0;
  NumberVector value;
  /// Along x and y, of the plane; nothing where the profile does not state these.
  std::optional<std::array<NumberVector, 2>> derivatives = {};
};

/// A scene with its required coverage.
///
/// Shape:      samples are indices in counts of the scene's target: [row][column][sample].
struct TestVector {
  std::string name;  ///< of the drawn case: "near-edge:17@1"
  Scene scene;       ///< window space
  SamplePattern pattern;
  YAxis y_axis = YAxis::kDown;
  /// Vertices in units of the file's lattice: where the model places them, or, if several models
  /// are legal, where they lie. Nothing: one of them lies on no point of it.
  std::optional<std::vector<std::array<std::int32_t, 2>>> on_lattice;
  std::vector<TriangleVector> triangles;
  std::vector<JointVector> joint;
  std::string domain;  ///< why it is hard, in words
  NearEdgeCounts near_edges;
  /// One a vertex, if values are stated of the scene's channels.
  std::vector<double> w = {};
  std::vector<ValueVector> values = {};
};

/// What all vectors of a file share: its first line.
struct VectorsHeader {
  std::string program;  ///< "rasterproof 1.0.0"
  Profile profile;
  std::uint64_t seed = 1;
  int level = 1;
  std::string world;                        ///< "u2.1": all of it; empty: drawn cases
  int lattice_bits = 8;                     ///< `on_lattice` is in units of 2^-lattice_bits pixels
  std::vector<std::string> sample_clauses;  ///< what is required of single triangles
  std::vector<std::string> joint_clauses;   ///< what is required of several at one sample
  std::uint64_t cases = 0;
  std::uint64_t triangles = 0;
  std::uint64_t joint = 0;
  std::optional<std::uint64_t> values = {};  ///< nothing: none are asked for
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_TEST_VECTOR_H_
