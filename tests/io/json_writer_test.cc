#include "io/json_writer.h"

#include <cmath>
#include <limits>
#include <string>

#include "gtest/gtest.h"
#include "nlohmann/json.hpp"

namespace rasterproof::io {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(JsonWriter, BreaksLinesAsTheLayoutSays) {
  JsonWriter json;
  json.BeginObject().Key("a").Integer(1).Key("b").BeginArray(kOneLine).Integer(2).Integer(3);
  json.EndArray().Key("c").BeginArrayLine().Bool(true).Null().EndArray().EndObject();
  EXPECT_EQ(json.Finish(), "{\n  \"a\": 1,\n  \"b\": [2, 3],\n  \"c\": [true,null]\n}\n");
}

TEST(JsonWriter, WritesContainersThatHoldNothing) {
  JsonWriter json;
  json.BeginObject().Key("a").BeginArray().EndArray().Key("o").BeginObject().EndObject();
  const auto read = nlohmann::json::parse(json.EndObject().json());
  EXPECT_TRUE(read["a"].is_array() && read["a"].empty());
  EXPECT_TRUE(read["o"].is_object() && read["o"].empty());
}

TEST(JsonWriter, WritesNumbersThatJsonHasNot) {
  JsonWriter json;
  json.BeginArray(kOneLine).Exact(kInfinity).Exact(std::nan("")).Exact(1.5).Shortest(-kInfinity);
  json.Rounded(std::nan("")).EndArray();
  const auto read = nlohmann::json::parse(json.json());
  EXPECT_EQ(read[0], "inf");
  EXPECT_EQ(read[1], "nan");
  EXPECT_EQ(read[2], "0x1.8p+0");
  EXPECT_TRUE(read[3].is_string());
  EXPECT_TRUE(read[4].is_string());
}

TEST(JsonWriter, KeepsADoubleWhereItIsShortestAndSixDigitsWhereItIsRounded) {
  JsonWriter json;
  json.BeginArray().Shortest(0.1).Shortest(1e300).Rounded(1.0 / 3).EndArray();
  const auto read = nlohmann::json::parse(json.json());
  EXPECT_EQ(read[0].get<double>(), 0.1);
  EXPECT_EQ(read[1].get<double>(), 1e300);
  EXPECT_EQ(read[2].get<double>(), 0.333333);
}

// A name that lies: what ends a string, what ends a line, and bytes that are no text.
TEST(JsonWriter, LetsNoTextOutOfItsQuotes) {
  const std::string text = std::string("a\", \"b\": 1\n\\ \x01 ") + '\0' + "\xff\xc3\xa9";
  JsonWriter json;
  json.BeginObject().Key(text).Text(text).EndObject();
  const auto read = nlohmann::json::parse(json.json());
  ASSERT_EQ(read.size(), 1U);
  for (const char c : json.json()) EXPECT_TRUE(c == '\n' || (c & 0xE0) != 0);
}

}  // namespace
}  // namespace rasterproof::io
