// Tests compiling sketches for the Blue Pill. The tests are skipped if the ARM compiler is missing (see
// require_target.h).
#include <gmock/gmock.h>

#include "tests/support/require_target.h"
#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace stm32_test {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;
namespace fs = std::filesystem;

class Stm32Test : public SketchTest {
 protected:
  void SetUp() override { ROBOSIM_NEEDS_TARGET("stm32"); }

  Image build_stm32(const fs::path& sketch, const char* board = "bluepill",
                    Warnings warnings = Warnings::standard) const {
    return build({sketch, *find_board(board), "stm32", {}, warnings});
  }
  std::string stm32_error_of(const std::string& name, const char* board = "bluepill") const {
    try {
      build_stm32(folder_ / name, board);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
};

class OneOfOurSketchesOnTheBluePill : public Stm32Test, public testing::WithParamInterface<std::string> {};

TEST_P(OneOfOurSketchesOnTheBluePill, FitsAndCompilesWithoutWarnings) {
  const Image image = build_stm32(find_sketch(GetParam()), "bluepill", Warnings::all);
  EXPECT_THAT(image.messages, Not(HasSubstr(GetParam() + ".ino:")));
  EXPECT_GT(image.text_bytes, 3000u);
  EXPECT_LT(image.text_bytes, 30000u);
  EXPECT_LT(image.data_bytes, 2500u);
  EXPECT_THAT(image.compiler, AllOf(StartsWith("gcc "), EndsWith(" arm-none-eabi")));
  ASSERT_THAT(image.products, SizeIs(1));
  EXPECT_EQ(image.products[0].extension(), ".bin");
  EXPECT_THAT(read_file(image.products[0]), StartsWith(std::string("\0\x50\0\x20", 4)))
      << "the first word is the stack's beginning, 0x20005000";
  EXPECT_LE(read_file(image.products[0]).size(), image.text_bytes + 16);
}

INSTANTIATE_TEST_SUITE_P(Sketches, OneOfOurSketchesOnTheBluePill, testing::ValuesIn(stock_sketches()),
                         [](const auto& test) { return test.param; });

class AnOrdinarySketchOnTheBluePill : public Stm32Test, public testing::WithParamInterface<const char*> {};

TEST_P(AnOrdinarySketchOnTheBluePill, CompilesUnmodified) {
  EXPECT_GT(build_stm32(fs::path(SKETCHES) / GetParam()).text_bytes, 2000u);
}

INSTANTIATE_TEST_SUITE_P(Sketches, AnOrdinarySketchOnTheBluePill,
                         testing::Values("EepromGains", "FlashTables", "Order", "Strings", "Tabs"),
                         [](const auto& test) { return std::string(test.param); });

TEST_F(Stm32Test, PinNamesAreArduinosNumbersAndWidthsAreAnArms) {
  write("Chip/Chip.ino",
        "static_assert(sizeof(int) == 4 && sizeof(long) == 4 && sizeof(double) == 8 && char(-1) > 0, \"\");\n"
        "static_assert(PC13 == LED_BUILTIN && PA0 == 14 && PB6 == 5 && A5 == PA5, \"\");\n"
        "#if !defined(ARDUINO_ARCH_STM32) || F_CPU != 72000000L || defined(__AVR__)\n#error\n#endif\n" +
            kEmptySketch);
  EXPECT_EQ(stm32_error_of("Chip"), "no error");
  EXPECT_THAT(
      stm32_error_of("Chip", "uno"),
      HasSubstr("the board uno cannot run the target stm32: expected a robot with bluepill or bluepill8"));
}

TEST_F(Stm32Test, TheHeadersOfCHaveTheirNamesForCxx) {
  const std::string code =
      "#include <cctype>\n#include <climits>\n#include <cmath>\n#include <cstddef>\n#include <cstdint>\n"
      "#include <cstdio>\n#include <cstdlib>\n#include <cstring>\n"
      "std::uint8_t a; std::size_t b = std::strlen(\"ab\");\n"
      "float c = std::sqrt(2.0) + std::fmod(5.0, 3.0); int d = std::atoi(\"3\") + std::toupper('a') + "
      "INT_MAX;\n"
      "void setup() { char text[9]; std::snprintf(text, sizeof text, \"%d\", d); }\nvoid loop() {}\n";
  write("C/C.ino", code);
  EXPECT_EQ(stm32_error_of("C"), "no error");
  EXPECT_NO_THROW(build({folder_ / "C", *find_board("bluepill")})) << "the host has the same headers";
  write("V/V.ino", "#include <vector>\n" + kEmptySketch);
  EXPECT_THAT(stm32_error_of("V"), HasSubstr("no such header vector: for the STM32, Robosim has only"));
  EXPECT_THROW(build({folder_ / "C", *find_board("uno")}), CompileError)
      << "Arduino's core lacks these headers";
}

TEST_F(Stm32Test, TheSameSketchInAnotherFolderGivesTheSameBytesWithoutNamesOfThisMachine) {
  const std::string code = "#include <LineKit.h>\nDriveMotor m(1, 2, 3);\n" + kEmptySketch;
  write("a/Same/Same.ino", code);
  write("b/Same/Same.ino", code);
  const Image a = build_stm32(folder_ / "a/Same");
  ::setenv("XDG_CACHE_HOME", (folder_ / "another cache").c_str(), 1);
  const Image b = build_stm32(folder_ / "b/Same");
  EXPECT_FALSE(b.from_cache);
  EXPECT_EQ(a.image_sha256, b.image_sha256);
  const std::string bytes = read_file(b.image);
  for (const std::string& name : {folder_.string(), cache_folder().string(), data_folder().string()})
    EXPECT_THAT(bytes, Not(HasSubstr(name))) << name;
}

TEST_F(Stm32Test, ASketchMayFillAllOfFlashUnlessItUsesTheEeprom) {
  const std::string table = "const byte t[61000] = {1};\nvoid loop() { Serial.print(t[random(9)]); }\n";
  write("Whole/Whole.ino", table + "void setup() {}\n");
  EXPECT_EQ(stm32_error_of("Whole"), "no error");
  write("Keeps/Keeps.ino", "#include <EEPROM.h>\n" + table + "void setup() { EEPROM.write(1, 2); }\n");
  EXPECT_THAT(stm32_error_of("Keeps"), HasSubstr("only if the sketch does not use the EEPROM"));
}

TEST_F(Stm32Test, WhatDoesNotFitTheChipIsToldSo) {
  write("Big/Big.ino",
        "byte b[30000];\nvoid setup() { b[random(30000)] = 1; Serial.print(b[random(30000)]); }\n"
        "void loop() {}\n");
  EXPECT_THAT(
      stm32_error_of("Big"),
      MatchesRegex("Big does not fit: its variables take 30[0-9]+ bytes, but the bluepill has 20480 of "
                   "RAM"));
  write("Long/Long.ino",
        "const byte t[66000] = {1};\nvoid setup() { Serial.print(t[random(9)]); }\nvoid loop() {}\n");
  EXPECT_THAT(stm32_error_of("Long"), AllOf(StartsWith("Long does not fit: it is "), HasSubstr("flash")));
}

}  // namespace stm32_test
}  // namespace robosim::build
