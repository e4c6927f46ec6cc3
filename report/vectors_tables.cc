#include "report/vectors_tables.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/channel.h"
#include "core/hash_text.h"
#include "core/sample_pattern.h"
#include "core/sample_rows.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/profile_json.h"
#include "report/vectors_json.h"

namespace rasterproof::report {
namespace {

// Numbers in rows of one width; `names` says what each column is.
struct NumberTable {
  std::string_view name;
  std::vector<std::string> columns;
  std::vector<std::vector<std::int64_t>> rows = {};
};

// The vectors as tables: what has a variable number of rows is named by its first row and a count.
struct VectorTables {
  NumberTable cases{"cases",
                    {"width", "height", "samples", "first_location", "first_vertex",
                     "first_triangle", "triangles", "first_joint", "joints"}};
  NumberTable locations{"locations", {"x", "y"}};
  NumberTable vertices{"vertices", {"x", "y"}};
  NumberTable triangles{"triangles", {"a", "b", "c", "facing", "first_row"}};
  NumberTable joint{"joints", {"column", "row", "sample", "triangles", "counts"}};
  // Of floats their bits; only with values.
  NumberTable channels{"channels", {"interpolation", "at"}};
  NumberTable numbers{"numbers", {"w"}};  // and each channel's
  NumberTable values{
      "values",
      {"case", "triangle", "column", "row", "sample", "channel", "nearest", "low", "high",
       "dx_nearest", "dx_low", "dx_high", "dy_nearest", "dy_low", "dy_high"}};
  bool has_values = false;
  std::vector<std::string> names;  // of the cases
  std::vector<std::string> must;   // rows of samples, all of the target's
  std::vector<std::string> may;
  std::size_t widest = 1;  // samples in a row

  std::vector<const NumberTable*> All() const {
    std::vector<const NumberTable*> all{&cases, &locations, &vertices, &triangles, &joint};
    if (has_values) all.insert(all.end(), {&channels, &numbers, &values});
    return all;
  }
};

std::int64_t Signed(std::size_t n) { return static_cast<std::int64_t>(n); }

// Bit k: triangle k, or a count of k.
template <class Numbers>
std::int64_t BitsOfNumbers(const Numbers& numbers) {
  std::int64_t bits = 0;
  for (const auto n : numbers) bits |= std::int64_t{1} << n;
  return bits;
}

// The number of a pattern's first location; equal patterns are there once.
std::int64_t PlaceOfPattern(const SamplePattern& pattern, NumberTable& locations) {
  std::vector<std::vector<std::int64_t>> rows;
  for (const Point2& at : pattern.locations) {
    rows.push_back({static_cast<std::int64_t>(at.x * 256), static_cast<std::int64_t>(at.y * 256)});
  }
  const auto found = std::ranges::search(locations.rows, rows);
  const auto place = found.begin() - locations.rows.begin();
  if (found.empty()) locations.rows.insert(locations.rows.end(), rows.begin(), rows.end());
  return place;
}

std::int64_t BitsOfFloat(double x) { return std::bit_cast<std::int32_t>(static_cast<float>(x)); }

// All vectors of a file have the same channels.
void NameChannels(const std::vector<Channel>& channels, VectorTables& tables) {
  if (!tables.channels.rows.empty()) return;
  for (const Channel& channel : channels) {
    tables.channels.rows.push_back(
        {static_cast<int>(channel.interpolation), static_cast<int>(channel.at)});
    std::string name = channel.name;
    std::ranges::replace(name, '-', '_');
    tables.numbers.columns.push_back(std::move(name));
  }
}

void AddNumber(const NumberVector& number, std::vector<std::int64_t>& row) {
  for (const float x : {number.nearest, number.low, number.high})
    row.push_back(BitsOfFloat(static_cast<double>(x)));
}

// What is stated of no derivative lies between the infinities.
void AddValues(const TestVector& vector, VectorTables& tables) {
  if (vector.w.empty()) return;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const NumberVector anything{"", 0, -kInfinity, kInfinity};
  tables.has_values = true;
  NameChannels(vector.scene.channels, tables);
  for (std::size_t v = 0; v < vector.w.size(); ++v) {
    std::vector<std::int64_t>& row = tables.numbers.rows.emplace_back();
    row.push_back(BitsOfFloat(vector.w[v]));
    for (const Channel& channel : vector.scene.channels)
      row.push_back(BitsOfFloat(channel.values.empty() ? 1 : channel.values[v]));
  }
  const auto samples = static_cast<std::size_t>(vector.pattern.samples());
  const auto width = static_cast<std::size_t>(vector.scene.width);
  const std::size_t first_triangle = tables.triangles.rows.size() - vector.triangles.size();
  for (const ValueVector& value : vector.values) {
    const std::size_t pixel = value.sample / samples;
    std::vector<std::int64_t>& row = tables.values.rows.emplace_back();
    row = {Signed(tables.cases.rows.size() - 1),
           Signed(first_triangle + value.triangle),
           Signed(pixel % width),
           Signed(pixel / width),
           Signed(value.sample % samples),
           Signed(value.channel)};
    AddNumber(value.value, row);
    AddNumber(value.derivatives ? (*value.derivatives)[0] : anything, row);
    AddNumber(value.derivatives ? (*value.derivatives)[1] : anything, row);
  }
}

void AddVector(const TestVector& vector, VectorTables& tables) {
  const auto samples = static_cast<std::size_t>(vector.pattern.samples());
  const std::size_t row_length = static_cast<std::size_t>(vector.scene.width) * samples;
  tables.widest = std::max(tables.widest, row_length);
  tables.names.push_back(vector.name);
  tables.cases.rows.push_back(
      {vector.scene.width, vector.scene.height, Signed(samples),
       PlaceOfPattern(vector.pattern, tables.locations), Signed(tables.vertices.rows.size()),
       Signed(tables.triangles.rows.size()), Signed(vector.triangles.size()),
       Signed(tables.joint.rows.size()), Signed(vector.joint.size())});
  const std::int64_t first_vertex = Signed(tables.vertices.rows.size());
  for (const auto& [x, y] : *vector.on_lattice) tables.vertices.rows.push_back({x, y});
  for (std::size_t t = 0; t < vector.triangles.size(); ++t) {
    const Triangle& v = vector.scene.triangles[t];
    const TriangleVector& triangle = vector.triangles[t];
    tables.triangles.rows.push_back({first_vertex + v[0], first_vertex + v[1], first_vertex + v[2],
                                     triangle.facing, Signed(tables.must.size())});
    for (std::size_t row = 0; row < static_cast<std::size_t>(vector.scene.height); ++row) {
      tables.must.push_back(RowOf(triangle.must, row, row_length));
      tables.may.push_back(RowOf(triangle.may, row, row_length));
    }
  }
  for (const JointVector& joint : vector.joint) {
    const std::size_t pixel = joint.sample % row_length / samples;
    tables.joint.rows.push_back({Signed(pixel), Signed(joint.sample / row_length),
                                 Signed(joint.sample % samples), BitsOfNumbers(joint.triangles),
                                 BitsOfNumbers(joint.counts)});
  }
  AddValues(vector, tables);
}

VectorTables TablesOf(const std::vector<TestVector>& vectors) {
  VectorTables tables;
  for (const TestVector& vector : vectors) AddVector(vector, tables);
  return tables;
}

// What the first lines of each file say.
std::string HeadOfTables(const VectorsHeader& header, const VectorTables& tables,
                         const std::string& hash) {
  const auto clauses = [](const std::vector<std::string>& ids) {
    return ids.empty() ? std::string("the profile's own words")
                       : fmt::format("{}", fmt::join(ids, ", "));
  };
  const std::string drawn = header.world.empty()
                                ? fmt::format("seed {}, level {}", header.seed, header.level)
                                : fmt::format("world {}", header.world);
  return fmt::format(
      "// rasterproof vectors, format {}, by {}\n"
      "// profile {}: {}\n"
      "// {}, {} cases, {} triangles, {} joint constraints{}, widest row {} samples\n"
      "// required of a triangle by {}\n"
      "// required jointly by {}\n"
      "// body fnv1a64 {}\n",
      kVectorsVersion, header.program, header.profile.name, io::WholeProfileLine(header.profile),
      drawn, header.cases, header.triangles, header.joint,
      tables.has_values ? fmt::format(", {} values", *header.values) : "", tables.widest,
      clauses(header.sample_clauses), clauses(header.joint_clauses), hash);
}

// The parameters of the tables: name and value.
std::vector<std::pair<std::string_view, std::int64_t>> ParametersOf(const VectorsHeader& header,
                                                                    const VectorTables& tables) {
  std::vector<std::pair<std::string_view, std::int64_t>> parameters{
      {"VERSION", kVectorsVersion},
      {"LATTICE_BITS", header.lattice_bits},
      {"Y_UP", header.profile.y_axis == YAxis::kUp ? 1 : 0},
      {"CASES", Signed(tables.cases.rows.size())},
      {"LOCATIONS", Signed(tables.locations.rows.size())},
      {"VERTICES", Signed(tables.vertices.rows.size())},
      {"TRIANGLES", Signed(tables.triangles.rows.size())},
      {"JOINTS", Signed(tables.joint.rows.size())},
      {"ROWS", Signed(tables.must.size())}};
  if (tables.has_values) {
    parameters.emplace_back("CHANNELS", Signed(tables.channels.rows.size()));
    parameters.emplace_back("VALUES", Signed(tables.values.rows.size()));
  }
  return parameters;
}

// The words of 64 bits of a row, the one of the first samples first.
std::string WordsInC(const std::string& row, std::size_t words) {
  const std::string digits = std::string(16 * words - row.size(), '0') + row;
  std::string text = "{";
  for (std::size_t k = 0; k < words; ++k) {
    text += fmt::format("{}0x{}u", k == 0 ? "" : ", ", digits.substr(16 * (words - 1 - k), 16));
  }
  return text + "}";
}

std::string RowsInC(std::string_view name, const std::vector<std::string>& rows,
                    std::size_t words) {
  std::string text = fmt::format(
      "\nstatic const uint64_t vectors_{}[VECTORS_ROWS][VECTORS_ROW_WORDS] = {{\n", name);
  for (const std::string& row : rows) text += "    " + WordsInC(row, words) + ",\n";
  return text + "};\n";
}

std::string TableInC(const NumberTable& table) {
  std::string text = fmt::format("\n/* {} */\nstatic const int32_t vectors_{}[][{}] = {{\n",
                                 fmt::join(table.columns, ", "), table.name, table.columns.size());
  for (const std::vector<std::int64_t>& row : table.rows)
    text += fmt::format("    {{{}}},\n", fmt::join(row, ", "));
  if (table.rows.empty()) text += "    {0},\n";  // C has no empty arrays
  return text + "};\n";
}

// Two's complement of 32 bits.
std::string WordsInHex(const NumberTable& table) {
  std::string text = fmt::format("// a row: {}\n", fmt::join(table.columns, ", "));
  for (const std::vector<std::int64_t>& row : table.rows) {
    for (std::size_t k = 0; k < row.size(); ++k)
      text += fmt::format("{}{:08x}", k == 0 ? "" : " ", static_cast<std::uint32_t>(row[k]));
    text += "\n";
  }
  if (table.rows.empty()) text += "00000000\n";  // an empty file is an error to some simulators
  return text;
}

std::string RowsInHex(std::string_view what, const std::vector<std::string>& rows) {
  std::string text = fmt::format("// a row of a target in a word: bit k is sample k; {}\n", what);
  for (const std::string& row : rows) text += row + "\n";
  return text;
}

}  // namespace

std::string VectorsAsC(const VectorsHeader& header, const std::vector<TestVector>& vectors) {
  const VectorTables tables = TablesOf(vectors);
  const std::size_t words = (tables.widest + 63) / 64;
  std::string body =
      "#ifndef RASTERPROOF_VECTORS_H_\n#define RASTERPROOF_VECTORS_H_\n\n"
      "#include <stdint.h>\n\n";
  for (const auto& [name, value] : ParametersOf(header, tables))
    body += fmt::format("#define VECTORS_{} {}\n", name, value);
  body += fmt::format("#define VECTORS_ROW_WORDS {}\n", words);
  body += "\nstatic const char *const vectors_names[VECTORS_CASES] = {\n";
  for (const std::string& name : tables.names) body += fmt::format("    \"{}\",\n", name);
  body += "};\n";
  for (const NumberTable* table : tables.All()) body += TableInC(*table);
  body += RowsInC("must", tables.must, words) + RowsInC("may", tables.may, words);
  body += "\n#endif\n";
  return HeadOfTables(header, tables, HashText(body)) + body;
}

std::vector<NamedText> VectorsAsReadmemh(const VectorsHeader& header,
                                         const std::vector<TestVector>& vectors) {
  const VectorTables tables = TablesOf(vectors);
  std::vector<NamedText> files;
  for (const NumberTable* table : tables.All())
    files.emplace_back(fmt::format("{}.hex", table->name), WordsInHex(*table));
  files.emplace_back("must.hex", RowsInHex("every legal drawing covers it", tables.must));
  files.emplace_back("may.hex", RowsInHex("some legal drawings cover it", tables.may));
  std::string names;
  for (const std::string& name : tables.names) names += name + "\n";
  files.emplace_back("names.txt", names);
  std::string sizes = "`ifndef RASTERPROOF_VECTORS_SVH\n`define RASTERPROOF_VECTORS_SVH\n";
  for (const auto& [name, value] : ParametersOf(header, tables))
    sizes += fmt::format("localparam int VECTORS_{} = {};\n", name, value);
  for (const NumberTable* table : tables.All()) {
    for (std::size_t k = 0; k < table->columns.size(); ++k)
      sizes += fmt::format("localparam int {}_{} = {};\n", table->name, table->columns[k], k);
    sizes += fmt::format("localparam int {}_COLUMNS = {};\n", table->name, table->columns.size());
  }
  sizes += fmt::format("localparam int VECTORS_ROW_BITS = {};\n`endif\n", tables.widest);
  files.emplace_back("vectors.svh", sizes);
  std::string all;
  for (const auto& [name, text] : files) all += text;
  files.back().second = HeadOfTables(header, tables, HashText(all)) + sizes;
  return files;
}

}  // namespace rasterproof::report
