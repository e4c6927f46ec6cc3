// Answers as bytes: counts and ids in runs of equal ones, because most samples are like the one
// before; numbers of covered samples alone, as floats if they are.
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/channel.h"
#include "core/drawing.h"
#include "core/scene.h"
#include "props/engine/known_answers.h"

namespace rasterproof::props {
namespace {

// Of longer lists all numbers are written: damaged bytes can't ask for more memory than that.
constexpr std::size_t kMostLeftOut = std::size_t{4} * kMaxTargetSamples;

// Calls `each` with the places of the numbers, equally many a sample, of samples that show a
// triangle; of all samples if nothing says which do.
template <class Each>
void ForEachShown(std::size_t count, const std::vector<std::int32_t>& ids, const Each& each) {
  const std::size_t of_each = ids.empty() ? 0 : count / ids.size();
  if (of_each == 0 || count % ids.size() != 0 || count > kMostLeftOut) {
    for (std::size_t k = 0; k < count; ++k) each(k);
    return;
  }
  for (std::size_t s = 0; s < ids.size(); ++s) {
    if (ids[s] == kNoPrimitive) continue;
    for (std::size_t k = s * of_each; k < (s + 1) * of_each; ++k) each(k);
  }
}

// The same numbers, bit for bit; none if they are not floats.
std::vector<float> FloatsOf(const std::vector<double>& numbers) {
  std::vector<float> floats;
  for (const double number : numbers) {
    const auto as_float = static_cast<float>(number);
    if (std::bit_cast<std::uint64_t>(double{as_float}) != std::bit_cast<std::uint64_t>(number))
      return {};
    floats.push_back(as_float);
  }
  return floats;
}

// Arrays as their numbers, and back.
template <std::size_t N>
std::vector<double> Flat(const std::vector<std::array<double, N>>& arrays) {
  std::vector<double> numbers;
  for (const std::array<double, N>& array : arrays)
    numbers.insert(numbers.end(), array.begin(), array.end());
  return numbers;
}
template <std::size_t N>
std::vector<std::array<double, N>> InArrays(const std::vector<double>& numbers) {
  std::vector<std::array<double, N>> arrays(numbers.size() / N);
  for (std::size_t k = 0; k < N * arrays.size(); ++k) arrays[k / N][k % N] = numbers[k];
  return arrays;
}

class OutcomeWriter {
 public:
  void Number(std::uint64_t n) {
    for (; n >= 0x80; n >>= 7U) bytes_.push_back(static_cast<char>(0x80U | (n & 0x7fU)));
    bytes_.push_back(static_cast<char>(n));
  }
  void Text(std::string_view text) {
    Number(text.size());
    bytes_ += text;
  }
  template <class T>
  void Runs(const std::vector<T>& values) {
    Number(values.size());
    for (std::size_t k = 0; k < values.size();) {
      std::size_t end = k + 1;
      while (end < values.size() && values[end] == values[k]) ++end;
      Number(static_cast<std::uint32_t>(values[k]));
      Number(end - k);
      k = end;
    }
  }
  void Numbers(const std::vector<double>& numbers, const std::vector<std::int32_t>& ids) {
    Number(numbers.size());
    if (numbers.empty()) return;
    std::vector<double> shown;
    ForEachShown(numbers.size(), ids, [&](std::size_t k) { shown.push_back(numbers[k]); });
    const std::vector<float> floats = FloatsOf(shown);
    Number(floats.size());
    floats.empty() ? Add(shown) : Add(floats);
  }
  std::string Take() { return std::move(bytes_); }

 private:
  template <class T>
  void Add(const std::vector<T>& values) {
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }

  std::string bytes_;
};

class OutcomeReader {
 public:
  explicit OutcomeReader(std::string_view bytes) : bytes_(bytes) {}
  bool IsGood() const { return is_good_; }
  bool IsAtEnd() const { return is_good_ && bytes_.empty(); }

  // What has `most` is a size, or 32 bits.
  std::size_t Number(std::size_t most) {
    std::uint64_t n = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      if (bytes_.empty()) break;
      const auto byte = static_cast<unsigned char>(bytes_.front());
      bytes_.remove_prefix(1);
      n |= std::uint64_t{byte & 0x7fU} << shift;
      if (byte < 0x80) {
        if (n > most) break;
        return static_cast<std::size_t>(n);
      }
    }
    is_good_ = false;
    return 0;
  }
  std::string_view Text() {
    const std::size_t size = Number(bytes_.size());
    return Bytes(size, 1);
  }
  template <class T>
  void Runs(std::vector<T>& values, std::size_t most) {
    const std::size_t size = Number(most);
    while (is_good_ && values.size() < size) {
      const auto value = static_cast<T>(Number(UINT32_MAX));
      const std::size_t run = Number(size - values.size());
      if (run == 0) is_good_ = false;
      if (is_good_) values.insert(values.end(), run, value);
    }
  }
  std::vector<double> Numbers(const std::vector<std::int32_t>& ids) {
    const std::size_t size = Number(SIZE_MAX);
    if (size > std::max(kMostLeftOut, bytes_.size())) is_good_ = false;
    if (!is_good_ || size == 0) return {};
    std::size_t count = 0;
    ForEachShown(size, ids, [&](std::size_t /*k*/) { ++count; });
    const std::size_t floats = Number(count);
    if (floats != 0 && floats != count) is_good_ = false;
    std::vector<double> numbers(is_good_ ? size : 0);
    floats != 0 ? Into<float>(numbers, count, ids) : Into<double>(numbers, count, ids);
    return numbers;
  }

 private:
  template <class T>
  void Into(std::vector<double>& numbers, std::size_t count, const std::vector<std::int32_t>& ids) {
    const std::string_view raw = Bytes(count, sizeof(T));
    const char* next = raw.data();
    if (raw.empty()) return;
    ForEachShown(numbers.size(), ids, [&](std::size_t k) {
      T number{};
      std::memcpy(&number, next, sizeof(T));
      numbers[k] = double{number};
      next += sizeof(T);
    });
  }
  std::string_view Bytes(std::size_t count, std::size_t of_each) {
    if (!is_good_ || count > bytes_.size() / of_each) {
      is_good_ = false;
      return {};
    }
    const std::string_view taken = bytes_.substr(0, count * of_each);
    bytes_.remove_prefix(taken.size());
    return taken;
  }

  std::string_view bytes_;
  bool is_good_ = true;
};

bool HasValuesOf(const Drawing& drawing, std::uint64_t samples) {
  const std::size_t values = drawing.values.size();
  return (values == 0 ||
          (samples != 0 && values % samples == 0 && values / samples <= kMostChannels)) &&
         (drawing.derivatives.empty() || drawing.derivatives.size() == values);
}

// Whether each output that is there has a value for every sample, of each channel one; a draw that
// ended has none.
bool HasItsShape(const Drawing& drawing) {
  const CoverageCounts& counts = drawing.counts;
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(counts.width) * static_cast<std::uint64_t>(counts.height);
  if (pixels > std::uint64_t{kMaxTargetSamples}) return false;
  const std::uint64_t samples = pixels * static_cast<std::uint64_t>(counts.samples);
  const auto fits = [samples](const auto& values) {
    return values.empty() || values.size() == samples;
  };
  return counts.front.size() == samples && counts.back.size() == samples &&
         fits(drawing.primitive_ids) && fits(drawing.barycentrics) && fits(drawing.depths) &&
         fits(drawing.centroids) && HasValuesOf(drawing, samples);
}

}  // namespace

std::string OutcomeBytes(const DrawOutcome& outcome) {
  OutcomeWriter out;
  out.Number(static_cast<std::uint64_t>(outcome.end.stop));
  out.Text(outcome.end.why);
  const Drawing& drawing = outcome.drawing;
  for (const int n : {drawing.counts.width, drawing.counts.height, drawing.counts.samples}) {
    out.Number(static_cast<std::uint64_t>(n));
  }
  out.Runs(drawing.counts.front);
  out.Runs(drawing.counts.back);
  out.Runs(drawing.primitive_ids);
  const std::vector<std::int32_t>& ids = drawing.primitive_ids;
  out.Numbers(Flat(drawing.barycentrics), ids);
  out.Numbers(drawing.depths, ids);
  out.Numbers(Flat(drawing.centroids), ids);
  out.Numbers(drawing.values, ids);
  out.Numbers(Flat(drawing.derivatives), ids);
  return out.Take();
}

std::optional<DrawOutcome> ReadOutcome(std::string_view bytes) {
  OutcomeReader in(bytes);
  DrawOutcome outcome;
  outcome.end.stop = static_cast<Stop>(in.Number(static_cast<std::size_t>(Stop::kDeadline)));
  outcome.end.why = in.Text();
  Drawing& drawing = outcome.drawing;
  for (int* n : {&drawing.counts.width, &drawing.counts.height, &drawing.counts.samples}) {
    *n = static_cast<int>(in.Number(INT32_MAX));
  }
  in.Runs(drawing.counts.front, std::size_t{kMaxTargetSamples});
  in.Runs(drawing.counts.back, std::size_t{kMaxTargetSamples});
  in.Runs(drawing.primitive_ids, std::size_t{kMaxTargetSamples});
  const std::vector<std::int32_t>& ids = drawing.primitive_ids;
  drawing.barycentrics = InArrays<3>(in.Numbers(ids));
  drawing.depths = in.Numbers(ids);
  drawing.centroids = InArrays<3>(in.Numbers(ids));
  drawing.values = in.Numbers(ids);
  drawing.derivatives = InArrays<2>(in.Numbers(ids));
  const bool is_one = in.IsAtEnd() && HasItsShape(drawing);
  return is_one ? std::optional(std::move(outcome)) : std::nullopt;
}

}  // namespace rasterproof::props
