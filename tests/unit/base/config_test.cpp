#include "sim/base/config.h"

#include <gmock/gmock.h>

namespace robosim::config_test {

std::string error_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Config, KeepsTheOrderOfTheFileAndThePlaceOfEachValue) {
  const ConfigValue v = parse_toml("zebra = 1\napple = \"2 mm\"\n", "f.toml", 5);
  ASSERT_EQ(v.members.size(), 2u);
  EXPECT_EQ(v.members.front().first, "zebra");
  EXPECT_EQ(to_string(v.members.back().second.place), "f.toml:6:9");
}

TEST(Config, RefusesALetterBeyondAsciiBehindAQuoteInsideANumber) {
  EXPECT_THAT(error_of([] { parse_toml("size = 8\"8\u013f\"\n", "f.toml"); }),
              testing::StartsWith("f.toml:1:"));
}

TEST(Config, NamesUnknownKeysAndTheKnownOnes) {
  const ConfigValue v = parse_toml("with = 1\n", "f.toml");
  EXPECT_EQ(error_of([&] {
              TableReader r(v, "[map]");
              r.integer("width", 0, 0, 9);
              r.finish();
            }),
            "f.toml:1:8: unknown key with in [map]: expected width; did you mean width?");
}

TEST(Config, NamesEachKnownKeyOnceAndGuessesOnlyWhatIsNear) {
  const ConfigValue v = parse_toml("moon = 1\n", "f.toml");
  TableReader r(v, "[map]");
  r.find("width");
  r.integer("width", 0, 0, 9);
  r.refuse_misspelt();
  EXPECT_EQ(error_of([&] { r.finish(); }), "f.toml:1:8: unknown key moon in [map]: expected width");
}

TEST(Config, RefusesAMisspeltKeyBeforeOneIsMissed) {
  const ConfigValue v = parse_toml("capacity = 1\n", "f.toml");
  TableReader r(v, "[battery]");
  r.find("capacity_mAh");
  EXPECT_EQ(error_of([&] { r.refuse_misspelt(); }),
            "f.toml:1:12: unknown key capacity in [battery]; did you mean capacity_mAh?");
}

TEST(Config, ExplainsQuantitiesWithoutAUnitOutOfBoundsOrOfTheWrongKind) {
  const ConfigValue v =
      parse_toml("a = 5\nb = \"5 kg\"\nc = \"5 m\"\nd = []\ne = \"2e4mm\"\nf = \"2e0\"\n", "f.toml");
  TableReader r(v, "x");
  const auto length = [&](const char* key) {
    return error_of([&] { r.quantity(key, Dimension::length, 0, 0, 1); });
  };
  EXPECT_THAT(length("a"), testing::HasSubstr("a: expected a string with a unit (mm, cm, m or in), got 5"));
  EXPECT_THAT(length("b"),
              testing::HasSubstr("b: expected a number with a unit (mm, cm, m or in), got \"5 kg\""));
  EXPECT_THAT(length("c"), testing::HasSubstr("c: expected 0 to 1 m, got 5 m"));
  EXPECT_THAT(length("e"), testing::HasSubstr("e: expected 0 to 1000 mm, got 2e4mm"));
  EXPECT_THAT(error_of([&] { r.quantity("c", Dimension::length, 0, 6, 1e12); }),
              testing::HasSubstr("c: expected 6 m or more, got 5 m"));
  EXPECT_THAT(error_of([&] { r.quantity("e", Dimension::length, 0, 1e-3, 10); }),
              testing::HasSubstr("e: expected 1 mm to 10 m, got 2e4mm"));
  EXPECT_THAT(error_of([&] { r.quantity("f", Dimension::ratio, 0, 0, 1); }),
              testing::HasSubstr("f: expected 0 to 1, got 2e0"));
  EXPECT_THAT(length("d"), testing::HasSubstr("d: expected a quantity such as \"20 mm\", got an array"));
}

TEST(Config, RefusesCharactersBeyondAsciiOutsideQuotesAndComments) {
  const auto error = [](const char* text) { return error_of([&] { parse_toml(text, "f.toml"); }); };
  EXPECT_THAT(
      error("a = 1\nline\xEF\xBB\xAF = 2\n"),
      testing::StartsWith("f.toml:2:5: not valid TOML: expected only ASCII characters outside quotes"));
  EXPECT_THAT(
      error("a = \"\\\"\"\xC3\xA9\n"),
      testing::StartsWith("f.toml:1:9: not valid TOML: expected only ASCII characters outside quotes"));
  EXPECT_THAT(
      error("a = \"\"\"x\"\"\"\"\xC3\xA9\n"),
      testing::StartsWith("f.toml:1:13: not valid TOML: expected only ASCII characters outside quotes"));
  EXPECT_EQ(error("\xEF\xBB\xBF"
                  "# \xE2\x9A\xA0\xEF\xB8\x8F\na = \"\\\"\xC3\xA9\"\nb = '\xC3\xA9'\n"
                  "c = \"\"\"\n\xC3\xA9\"\"\"\nd = '''\xC3\xA9\n'''\n"),
            "no error");
}

TEST(Config, RefusesWhatWouldTakeTooLongOrTooMuchStack) {
  const auto error = [](const std::string& text) { return error_of([&] { parse_toml(text, "f.toml"); }); };
  std::string deep = "\na", many, brackets = "a = ";
  for (int i = 0; i < 30'000; ++i) deep += ".a";
  for (int i = 0; i < 1001; ++i) many += "k" + std::to_string(i) + " = 1.5\n";
  for (int i = 0; i < 100'000; ++i) brackets += '[';
  EXPECT_EQ(error(deep + " = 1\n"), "f.toml:2:16: the key has too many parts: expected at most 8");
  EXPECT_EQ(error("[" + deep.substr(1) + "]\n"),
            "f.toml:1:17: the key has too many parts: expected at most 8");
  EXPECT_EQ(error("a.b.\"c.d\".e.f.g.h = [1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5]\n"), "no error");
  EXPECT_EQ(error(brackets), "f.toml:1:21: the brackets are nested too deeply: expected at most 16 levels");
  EXPECT_EQ(error("[many]\n" + many),
            "f.toml:1:1: the table has too many keys: expected at most 1000, got 1001");
  EXPECT_EQ(error("a = \"" + std::string(1 << 18, 'x') + "\"\n"),
            "f.toml: the file is too large: expected at most 256 KiB of TOML");
}

TEST(Config, AsksForTheQuotesThatAreMissing) {
  const auto error = [](const char* text) { return error_of([&] { parse_toml(text, "f.toml"); }); };
  EXPECT_EQ(error("a = 1\nbase = uno5\n"), "f.toml:2:8: text requires quotes: expected \"uno5\", got uno5");
  EXPECT_THAT(error("radius = 20 mm # wide\n"), testing::HasSubstr("expected \"20 mm\", got 20 mm"));
  EXPECT_THAT(error("pins = [\"A0\", A1]\n"), testing::HasSubstr("expected \"A1\", got A1"));
  EXPECT_THAT(error("mass = { value = 1 kg }\n"), testing::HasSubstr("expected \"1 kg\", got 1 kg"));
  EXPECT_THAT(error("send = go, now\n"), testing::HasSubstr("expected \"go\", got go"));
  EXPECT_THAT(error("a = 1 2\n"), testing::HasSubstr("not valid TOML: ")) << "no text";
  EXPECT_THAT(error("a = 0x\n"), testing::HasSubstr("not valid TOML: "));
  EXPECT_THAT(error("a = \"x\n"), testing::HasSubstr("not valid TOML: "));
  EXPECT_THAT(error("base = “uno5”\n"), testing::HasSubstr("replace typographic quotes by \""));
}

TEST(Config, PointsAtASyntaxError) {
  EXPECT_THAT(error_of([] { parse_toml("a = \nb = 1\n", "f.toml"); }), testing::HasSubstr("f.toml:1"));
  for (const char* header : {"[}", "[[=x]]", "[ , ]", "[\x0E]"})
    EXPECT_THAT(error_of([&] { parse_toml(header, "f.toml"); }), testing::HasSubstr("f.toml:1")) << header;
}

}  // namespace robosim::config_test
