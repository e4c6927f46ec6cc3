#include "subjects/process/npy.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <optional>
#include <system_error>

#include "core/call_end.h"
#include "core/quoted.h"

namespace rasterproof::subjects {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are sent as they lie in memory");

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kAlignment = 64;  // of the first number, from the first byte
constexpr std::size_t kMostOfAnNpyHead = 4096;
constexpr std::size_t kMostShown = 100;

template <class T>
std::string NpyText(std::string_view type, std::span<const T> numbers, std::size_t columns) {
  std::string head = "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': (" +
                     std::to_string(numbers.size() / columns) + ", " + std::to_string(columns) +
                     "), }";
  const std::size_t before = kMagic.size() + 4;
  head.append(kAlignment - 1 - (before + head.size()) % kAlignment, ' ');
  head += '\n';
  std::string text(kMagic);
  text += {1, 0, static_cast<char>(head.size() & 0xff), static_cast<char>(head.size() >> 8)};
  text += head;
  const std::size_t begin = text.size();
  text.resize(begin + numbers.size_bytes());
  if (!numbers.empty()) std::memcpy(text.data() + begin, numbers.data(), numbers.size_bytes());
  return text;
}

struct NpyHead {
  std::string type;  // "<u4"
  std::vector<std::size_t> shape;
};

[[noreturn]] void NoArray(const std::string& what) {
  BreakDown("`npy` in its answer is not followed by an array in the format NPY: " + what);
}

// What follows `'key':` in the dictionary of the head.
std::string_view ValueOf(std::string_view head, std::string_view key) {
  const std::size_t at = head.find("'" + std::string(key) + "':");
  if (at == std::string_view::npos) {
    NoArray("its head, " + Quoted(head, kMostShown) + ", has no '" + std::string(key) + "'");
  }
  std::string_view value = head.substr(at + key.size() + 3);
  value.remove_prefix(std::min(value.find_first_not_of(' '), value.size()));
  return value;
}

std::vector<std::size_t> ShapeOf(std::string_view text, std::string_view head) {
  std::vector<std::size_t> shape;
  const auto wrong = [&] { NoArray("its head, " + Quoted(head, kMostShown) + ", has no shape"); };
  const std::size_t close = text.find(')');
  if (!text.starts_with('(') || close == std::string_view::npos) wrong();
  text = text.substr(1, close - 1);
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(", "), text.size()));
    if (text.empty()) return shape;
    std::size_t side = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    if (error != std::errc{}) wrong();
    shape.push_back(side);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

NpyHead ReadNpyHead(const NextBytes& next_bytes) {
  const std::string magic(next_bytes(kMagic.size() + 2));
  if (!magic.starts_with(kMagic)) NoArray("it begins with " + Quoted(magic, kMostShown));
  const auto version = static_cast<unsigned char>(magic[kMagic.size()]);
  if (version < 1 || version > 3) NoArray("it is of version " + std::to_string(version));
  std::size_t size = 0;
  const std::string bytes(next_bytes(version == 1 ? 2 : 4));
  for (std::size_t k = bytes.size(); k-- > 0;)
    size = size << 8 | static_cast<unsigned char>(bytes[k]);
  if (size > kMostOfAnNpyHead) NoArray("its head has " + std::to_string(size) + " bytes");
  const std::string head(next_bytes(size));
  const std::string_view type = ValueOf(head, "descr");
  const std::string_view order = ValueOf(head, "fortran_order");
  if (!order.starts_with("False")) {
    NoArray("its numbers are in column-major order; give numpy.ascontiguousarray(...)");
  }
  NpyHead read{{}, ShapeOf(ValueOf(head, "shape"), head)};
  const std::size_t end = type.find('\'', 1);
  if (type.starts_with('\'') && end != std::string_view::npos) read.type = type.substr(1, end - 1);
  return read;
}

std::string ShapeText(const std::vector<std::size_t>& shape) {
  std::string text = "(";
  for (std::size_t k = 0; k < shape.size(); ++k)
    text += (k == 0 ? "" : ", ") + std::to_string(shape[k]);
  return text + ")";
}

template <class T>
std::int64_t IntegerAt(const char* at) {
  T value{};
  std::memcpy(&value, at, sizeof(T));
  return static_cast<std::int64_t>(value);
}

using ReadInteger = std::int64_t (*)(const char*);
struct IntegerType {
  std::string_view name;
  std::size_t bytes;
  ReadInteger read;
};
constexpr IntegerType kIntegerTypes[] = {
    {"|b1", 1, IntegerAt<std::uint8_t>},  {"|u1", 1, IntegerAt<std::uint8_t>},
    {"|i1", 1, IntegerAt<std::int8_t>},   {"<u2", 2, IntegerAt<std::uint16_t>},
    {"<i2", 2, IntegerAt<std::int16_t>},  {"<u4", 4, IntegerAt<std::uint32_t>},
    {"<i4", 4, IntegerAt<std::int32_t>},  {"<i8", 8, IntegerAt<std::int64_t>},
    {"<u8", 8, IntegerAt<std::uint64_t>},
};

std::size_t NumbersIn(const std::vector<std::size_t>& shape) {
  std::size_t count = 1;
  for (const std::size_t side : shape) count *= side;
  return count;
}

}  // namespace

std::string NpyOf(std::span<const double> numbers, std::size_t columns) {
  return NpyText("<f8", numbers, columns);
}

std::string NpyOf(std::span<const std::int32_t> numbers, std::size_t columns) {
  return NpyText("<i4", numbers, columns);
}

std::vector<std::int64_t> ReadNpyIntegers(std::span<const std::vector<std::size_t>> shapes,
                                          const NextBytes& next_bytes) {
  const NpyHead head = ReadNpyHead(next_bytes);
  const auto* const type = std::ranges::find(kIntegerTypes, head.type, &IntegerType::name);
  if (type == std::end(kIntegerTypes)) {
    BreakDown("its answer's array has numbers of type " + Quoted(head.type, kMostShown) +
              "; give integers, little-endian");
  }
  if (std::ranges::find(shapes, head.shape) == shapes.end()) {
    BreakDown("its answer's array has shape " + ShapeText(head.shape) + ", not " +
              ShapeText(shapes.front()));
  }
  const std::size_t count = NumbersIn(head.shape);
  const std::string_view bytes = next_bytes(count * type->bytes);
  std::vector<std::int64_t> numbers(count);
  for (std::size_t k = 0; k < count; ++k) numbers[k] = type->read(&bytes[k * type->bytes]);
  return numbers;
}

std::vector<double> ReadNpyDoubles(std::size_t rows, std::size_t columns,
                                   const NextBytes& next_bytes) {
  const NpyHead head = ReadNpyHead(next_bytes);
  const std::vector<std::size_t> wanted{rows, columns};
  if (head.type != "<f8" || head.shape != wanted) {
    BreakDown("an array has shape " + ShapeText(head.shape) + " and numbers of type " +
              Quoted(head.type, kMostShown) + ", not " + ShapeText(wanted) + " and '<f8'");
  }
  const std::string_view bytes = next_bytes(rows * columns * sizeof(double));
  std::vector<double> numbers(rows * columns);
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

}  // namespace rasterproof::subjects
