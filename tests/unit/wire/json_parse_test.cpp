// Tests that parsed_json() accepts and rejects the same texts as nlohmann, with equal results.
#include "sim/wire/json_parse.h"
#include "sim/base/json_limits.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "sim/base/json_limits.h"

namespace robosim::wire {
namespace json_parse_test {

using Json = nlohmann::json;

void expect_same(const std::string& text) {
  const Json known = Json::parse(text, nullptr, false);
  const Json ours = parsed_json(text);
  ASSERT_EQ(ours.is_discarded(), known.is_discarded()) << text;
  if (known.is_discarded()) return;
  EXPECT_EQ(ours, known) << text;
  EXPECT_EQ(ours.type(), known.type()) << text;
  EXPECT_EQ(ours.dump(), known.dump()) << text;
}

TEST(ParsedJson, IsWhatNlohmannMakesOfIt) {
  for (const char* text : {"0",
                           "-0",
                           "7",
                           "-7",
                           "007",
                           "-01",
                           "1.",
                           ".5",
                           "-.5",
                           "1.5",
                           "-0.5",
                           "-0.0",
                           "1e5",
                           "1E+5",
                           "1e-5",
                           "1e",
                           "1e+",
                           "1.5e3",
                           "1.e3",
                           "--1",
                           "+1",
                           "1e999",
                           "-1e999",
                           "1e-999",
                           "18446744073709551615",
                           "18446744073709551616",
                           "-9223372036854775808",
                           "-9223372036854775809",
                           "9223372036854775808",
                           "0.1",
                           "123456789012345680.0",
                           "5e-324",
                           "0x10",
                           "1 2",
                           "nan",
                           "inf",
                           "true",
                           "false",
                           "null",
                           "tru",
                           "truex",
                           "nulll",
                           "\"\"",
                           "\"a\"",
                           "\"a",
                           "\"\\n\"",
                           "\"\\u00e9\"",
                           "\"é\"",
                           "\"\xff\"",
                           "\"\t\"",
                           "\"\x7f\"",
                           "[]",
                           "[1]",
                           "[1,]",
                           "[,1]",
                           "[1,2",
                           "[1 ,2]",
                           " [1]",
                           "[1]\n",
                           "[1]\n\n",
                           "[1] x",
                           "{}",
                           R"({"a":1})",
                           R"({"a":1,})",
                           R"({"a":1)",
                           R"({"a" :1})",
                           R"({"a":1,"a":2})",
                           R"({"a":{"b":1},"a":{"c":2}})",
                           R"({a:1})",
                           R"({"a"})",
                           R"({"a":})",
                           R"({1:2})",
                           "",
                           "\n",
                           "{",
                           "[",
                           "\"",
                           "-",
                           "]",
                           "}",
                           ",",
                           ":"})
    expect_same(text);
  for (const int depth : {1, 15, 16, 17, 18, kDeepestJson}) {
    const auto levels = static_cast<std::size_t>(depth);
    expect_same(std::string(levels, '[') + std::string(levels, ']'));
    expect_same(std::string(levels, '['));
  }
  EXPECT_TRUE(
      parsed_json(std::string(kDeepestJson + 1, '[') + std::string(kDeepestJson + 1, ']')).is_discarded());
}

// Tests a runner's line in which one byte is changed or added, or up to three bytes are removed.
TEST(ParsedJson, NorDoesDamageMakeADifference) {
  const std::string line =
      R"({"id":7,"result":{"verdict":"reached","why":"It is done.","status":0,"time_s":0.001,"metrics":)"
      R"({"distance_m":-1.5e-05,"laps_s":[1.25,3.0],"collisions":12,"stations":["a","b"]},"usage":null,"ok":true}})";
  std::mt19937_64 random(1);
  const std::string bytes = "{}[]\",:.-+eE0123456789 tfn\\\n\x01\x7f\xc3";
  for (int i = 0; i < 20'000; ++i) {
    std::string damaged = line;
    const std::size_t at = random() % line.size();
    const char byte = bytes[random() % bytes.size()];
    switch (random() % 3) {
      case 0:
        damaged[at] = byte;
        break;
      case 1:
        damaged.insert(at, 1, byte);
        break;
      default:
        damaged.erase(at, 1 + random() % 3);
    }
    expect_same(damaged);
  }
}

}  // namespace json_parse_test
}  // namespace robosim::wire
