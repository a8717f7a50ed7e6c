// Tests compiling sketches for target avr. The tests are skipped if the AVR compiler is missing (see
// require_target.h).
#include <gmock/gmock.h>

#include <atomic>
#include <cstdlib>
#include <thread>

#include "sim/base/elf/elf_file.h"
#include "tests/support/require_target.h"
#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace avr_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;
namespace fs = std::filesystem;

class AvrTest : public SketchTest {
 protected:
  void SetUp() override { ROBOSIM_NEEDS_TARGET("avr"); }

  Image build_avr(const fs::path& sketch, const char* board = "uno",
                  Warnings warnings = Warnings::standard) const {
    return build({sketch, *find_board(board), "avr", {}, warnings});
  }
  Image build_avr_here(const std::string& name, const char* board = "uno") const {
    return build_avr(folder_ / name, board);
  }
  /// Counts the 4-byte CALL instructions in an image's flash.
  static int long_calls_of(const Image& image) {
    int calls = 0;
    const ElfFile elf(read_file(image.image), image.image.string());
    for (const ElfSegment& segment : elf.segments())
      for (std::size_t i = 0; segment.address < 0x800000 && i + 1 < segment.bytes.size(); i += 2)
        calls += segment.bytes[i] == '\x0E' && segment.bytes[i + 1] == '\x94';
    return calls;
  }
  std::string avr_error_of(const std::string& name) const {
    try {
      build_avr_here(name);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
};

class OneOfOurSketches : public AvrTest, public testing::WithParamInterface<std::string> {};

TEST_P(OneOfOurSketches, FitsTheChipAndCompilesWithoutWarnings) {
  const Image image = build_avr(find_sketch(GetParam()), "uno", Warnings::all);
  EXPECT_THAT(image.messages, Not(HasSubstr(GetParam() + ".ino:")));
  EXPECT_GT(image.text_bytes, 1000u);
  EXPECT_LT(image.text_bytes, 30720u);
  EXPECT_LT(image.data_bytes, 1800u);
  EXPECT_THAT(image.compiler, AllOf(StartsWith("gcc "), EndsWith(" avr")));
  ASSERT_THAT(image.products, SizeIs(1));
  EXPECT_THAT(read_file(image.products[0]), AllOf(StartsWith(":10000000"), HasSubstr("\n:00000001FF")));
}

INSTANTIATE_TEST_SUITE_P(Sketches, OneOfOurSketches, testing::ValuesIn(stock_sketches()),
                         [](const auto& test) { return test.param; });

class AnOrdinarySketchOnTheChip : public AvrTest, public testing::WithParamInterface<const char*> {};

TEST_P(AnOrdinarySketchOnTheChip, CompilesUnmodified) {
  const fs::path sketches = SKETCHES;
  Request request{sketches / GetParam(), *find_board("uno"), "avr", {}, Warnings::standard};
  if (fs::exists(sketches / (std::string(GetParam()) + "_libraries")))
    request.libraries = {sketches / (std::string(GetParam()) + "_libraries")};
  EXPECT_GT(build(request).text_bytes, 400u);
}

INSTANTIATE_TEST_SUITE_P(Sketches, AnOrdinarySketchOnTheChip,
                         testing::Values("CommonNames", "EepromGains", "FlashTables", "Formatting",
                                         "Hobbyist", "Order", "Parking", "PinInterrupts", "Registers",
                                         "Strings", "Tabs", "TimerInterrupt"),
                         [](const auto& test) { return std::string(test.param); });

TEST_F(AvrTest, ACoreIsToldWhenItIsCompiledForTheFirstTime) {
  ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
  write("One/One.ino", kEmptySketch);
  write("Two/Two.ino", kEmptySketch);
  int told = 0;
  for (const char* sketch : {"One", "Two"}) {
    Request request{folder_ / sketch, *find_board("uno"), "avr"};
    request.core_begins = [&] { ++told; };
    build(request);
    EXPECT_EQ(told, 1) << sketch;
  }
}

TEST_F(AvrTest, IntHas16BitsAndTheMacrosAreTheChips) {
  write("Chip/Chip.ino",
        "static_assert(sizeof(int) == 2 && sizeof(double) == 4 && F_CPU == 16000000L, \"\");\n"
        "#if !defined(__AVR_ATmega328P__) || !defined(ARDUINO_ARCH_AVR) || defined(ROBOSIM)\n#error\n#endif\n"
        "#ifdef ARDUINO_AVR_NANO\nint nano[NUM_ANALOG_INPUTS == 8 ? 1 : -1];\n#else\nint "
        "uno[NUM_ANALOG_INPUTS == 6 ? 1 : -1];\n#endif\n" +
            kEmptySketch);
  EXPECT_GT(build_avr_here("Chip", "uno").text_bytes, 400u);
  EXPECT_GT(build_avr_here("Chip", "nano").text_bytes, 400u);
}

TEST_F(AvrTest, FunctionsMayBeUsedBeforeTheyAreDefined) {
  write("Later/Later.ino", "void setup() { later(3); }\nvoid loop() {}\nvoid later(int x) { delay(x); }\n");
  EXPECT_EQ(avr_error_of("Later"), "no error");
}

TEST_F(AvrTest, TheSameSketchInAnotherFolderGivesTheSameBytesWithoutNamesOfThisMachine) {
  const std::string code = "#include \"x.h\"\n#include <LineKit.h>\nDriveMotor m(1, 2, 3);\n" + kEmptySketch;
  write("a/Same/Same.ino", code);
  write("a/Same/x.h", "inline const char* where() { return __FILE__ __DATE__; }\n");
  write("a/Same/x.cpp", "#include <Arduino.h>\n#include \"x.h\"\nvoid f() { Serial.print(where()); }\n");
  fs::create_directories(folder_ / "b");
  fs::copy(folder_ / "a", folder_ / "b", fs::copy_options::recursive);
  const Image a = build_avr_here("a/Same");
  ::setenv("XDG_CACHE_HOME", (folder_ / "another cache").c_str(), 1);
  const Image b = build_avr_here("b/Same/Same.ino");
  EXPECT_FALSE(b.from_cache);
  EXPECT_EQ(a.image_sha256, b.image_sha256);
  EXPECT_EQ(read_file(a.products.at(0)), read_file(b.products.at(0)));
  const std::string bytes = read_file(b.image);
  for (const std::string& name : {folder_.string(), cache_folder().string(), data_folder().string()})
    EXPECT_THAT(bytes, Not(HasSubstr(name))) << name;
}

TEST_F(AvrTest, ASecondBuildComesFromTheCacheAndALostHexIsMadeAnew) {
  write("Cached/Cached.ino", "int cached = 7;\n" + kEmptySketch);
  const Image first = build_avr_here("Cached");
  const std::string hex = read_file(first.products.at(0));
  fs::remove(first.products.at(0));
  const Image second = build_avr_here("Cached");
  EXPECT_TRUE(second.from_cache);
  EXPECT_EQ(second.image, first.image);
  EXPECT_EQ(read_file(second.products.at(0)), hex);
  EXPECT_FALSE(build_here("Cached").from_cache) << "the host has a separate image";
}

TEST_F(AvrTest, FlashHoldsTheVariablesInitialValuesAndNeitherCountsTheEeprom) {
  write("Empty/Empty.ino", kEmptySketch);
  write("Sizes/Sizes.ino",
        "#include <EEPROM.h>\nbyte zero[100], one[50] = {1};\nbyte kept[20] EEMEM = {3};\n"
        "void setup() { randomSeed(zero[random(9)] + one[random(9)] + EEPROM[1] + "
        "eeprom_read_byte(kept)); }\nvoid loop() { zero[random(9)]++; one[random(9)]++; }\n");
  const Image empty = build_avr_here("Empty");
  const Image image = build_avr_here("Sizes");
  EXPECT_EQ(empty.data_bytes, 9u) << "Arduino prints this value for an empty sketch";
  EXPECT_GE(image.data_bytes, empty.data_bytes + 150);
  EXPECT_LT(image.data_bytes, empty.data_bytes + 170);
  EXPECT_THAT(image.libraries, ElementsAre("EEPROM"));
}

TEST_F(AvrTest, TheCoresOwnLibrariesAreFoundAndAMissingOneIsToldWithWhereItWasLookedFor) {
  write("Wired/Wired.ino",
        "#include <Wire.h>\n#include <SoftwareSerial.h>\nSoftwareSerial s(2, 3);\n" + kEmptySketch);
  EXPECT_THAT(build_avr_here("Wired").libraries, ElementsAre("Wire", "SoftwareSerial"));
  write("Needy/Needy.ino", "#include <NoSuchServo.h>\n" + kEmptySketch);
  EXPECT_THAT(avr_error_of("Needy"),
              AllOf(HasSubstr("Needy.ino:1:"), HasSubstr("no such header NoSuchServo.h"),
                    HasSubstr("home/Arduino/libraries"), HasSubstr("arduino/avr/libraries")));
}

TEST_F(AvrTest, OfALibraryThatWantsToBeAnArchiveOnlyWhatIsNeededIsLinked) {
  write("Part/Part.ino", "#include <Two.h>\nvoid setup() { one(); }\nvoid loop() {}\n");
  write("Part/libraries/Two/src/Two.h", "void one();\nvoid two();\n");
  write("Part/libraries/Two/src/one.cpp", "#include <Arduino.h>\nvoid one() { pinMode(1, OUTPUT); }\n");
  write("Part/libraries/Two/src/two.cpp",
        "#include <Arduino.h>\nvoid two() {}\n"
        "ISR(INT0_vect) { Serial.print(1); }\n");
  write("Part/libraries/Two/library.properties", "name=Two\n");
  const Image whole = build_avr_here("Part");
  write("Part/libraries/Two/library.properties", "name=Two\ndot_a_linkage=true\n");
  const Image part = build_avr_here("Part");
  EXPECT_FALSE(part.from_cache);
  EXPECT_LT(part.text_bytes + 500, whole.text_bytes);
}

TEST_F(AvrTest, AssemblerSourcesBelongToTheSketch) {
  write("Asm/Asm.ino",
        "extern \"C\" byte seven();\nvoid setup() { Serial.print(seven()); }\nvoid loop() {}\n");
  write("Asm/seven.S", "#include <avr/io.h>\n.global seven\nseven:\n  ldi r24, 7\n  ret\n");
  EXPECT_EQ(avr_error_of("Asm"), "no error");
  write("Asm/seven.S", ".global seven\nseven:\n  ldi r24, 8\n  ret\n");
  EXPECT_FALSE(build_avr_here("Asm").from_cache);
}

TEST_F(AvrTest, ASketchMayDefineAFunctionOfTheCoreAnew) {
  write("Own/Own.ino",
        "long map(long x, long, long, long, long) { return x; }\nvoid yield() {}\n" + kEmptySketch);
  EXPECT_EQ(avr_error_of("Own"), "no error");
}

TEST_F(AvrTest, ACompileErrorNamesTheFileOfTheSketchAndItsLine) {
  write("Wrong/Wrong.ino", "int before() { return 1; }\nvoid setup() {\n  int x = \n}\nvoid loop() {}\n");
  EXPECT_THAT(avr_error_of("Wrong"),
              AllOf(StartsWith("Wrong.ino:4:1: error: "), Not(HasSubstr(folder_.string())),
                    Not(HasSubstr(cache_folder().string())), Not(HasSubstr("stdin"))));
  write("Core/Core.ino", "struct P : Print {};\nP p;\n" + kEmptySketch);
  EXPECT_THAT(avr_error_of("Core"), AllOf(StartsWith("Core.ino:2:3: error: "), HasSubstr("\nPrint.h:")));
}

TEST_F(AvrTest, ALinkErrorNamesTheSketchsFileAsFarAsTheLinkerKnows) {
  write("Half/Half.ino", "void setup() {}\n");
  EXPECT_EQ(avr_error_of("Half"),
            "Half.ino: the sketch has no function loop(); every sketch needs setup() and loop()");
  write("Link/Link.ino", "void later(int);\nvoid setup() { later(3); }\nvoid loop() {}\n");
  EXPECT_EQ(avr_error_of("Link"), "Link.ino:2: undefined reference to `later(int)'");
  write("Twice/Twice.ino", "int twice() { return 1; }\n" + kEmptySketch);
  write("Twice/other.cpp", "int twice() { return 2; }\n");
  EXPECT_EQ(avr_error_of("Twice"),
            "other.cpp: multiple definition of `twice()'\nTwice.ino: first defined here");
  write("Asm/Asm.ino", "void setup() { asm volatile(\"bogus r1\"); }\nvoid loop() {}\n");
  EXPECT_EQ(avr_error_of("Asm"),
            "asm() contains text that the chip's assembler rejects: unknown opcode `bogus'");
}

TEST_F(AvrTest, VariablesThatDoNotFitTheChipAreToldSo) {
  write("Big/Big.ino",
        "byte b[3000];\nvoid setup() { b[random(3000)] = 1; Serial.print(b[random(3000)]); }\n"
        "void loop() {}\n");
  EXPECT_THAT(avr_error_of("Big"),
              testing::MatchesRegex(
                  "Big does not fit: its variables take 3[0-9]+ bytes, but the uno has 2048 of RAM"));
}

TEST_F(AvrTest, CodeThatDoesNotFitTheChipIsToldSo) {
  write("Long/Long.ino",
        "const byte t[32000] PROGMEM = {1}, u[9000] PROGMEM = {1};\nvoid setup() {\n"
        "  Serial.print(pgm_read_byte(t + random(9)) + pgm_read_byte(u + random(9)));\n}\n"
        "void loop() {}\n");
  EXPECT_THAT(avr_error_of("Long"), AllOf(StartsWith("Long does not fit: it is "), HasSubstr("flash")));
}

TEST_F(AvrTest, LimitsAreReadFromTheImageOfEveryTarget) {
  write("Limits/Limits.ino",
        "__asm__(\".set linekit_limit_junctions, 64\");\n__asm__(\".set linekit_limit_nodes_of_a_tree, "
        "200\");\n" +
            kEmptySketch);
  write("Limits/again.cpp", "__asm__(\".set linekit_limit_junctions, 64\");\n");
  for (const Image& image : {build_avr_here("Limits"), build_here("Limits")}) {
    std::vector<std::string> found;
    for (const Limit& limit : stated_limits(image))
      found.push_back(std::to_string(limit.value) + " " + limit.what);
    EXPECT_THAT(found, ElementsAre("64 junctions", "200 nodes of a tree"));
  }
}

TEST_F(AvrTest, AMegasProgramHasShortCallsAsTheOneThatArduinoFlashes) {
  write("Calls/Calls.ino",
        "int next(int) __attribute__((noinline));\nint next(int n) { return analogRead(n); }\n"
        "void setup() {}\nvoid loop() { digitalWrite(next(3), next(4)); }\n");
  EXPECT_LE(long_calls_of(build_avr_here("Calls", "mega")), 1);
  EXPECT_GE(long_calls_of(build_avr_here("Calls", "uno")), 4);
}

TEST_F(AvrTest, ABoardWithoutAnAvrChipIsRefused) {
  const BoardSpec& other = *find_board("bluepill");
  write("Any/Any.ino", kEmptySketch);
  EXPECT_THAT(
      [&] {
        build({folder_ / "Any", other, "avr"});
      },
      testing::ThrowsMessage<InputError>(HasSubstr("the board bluepill cannot run the target avr")));
}

TEST_F(AvrTest, AnotherProcessMayPutTheSameImageInItsPlaceMeanwhile) {
  write("Any/Any.ino", kEmptySketch);
  ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
  const Image first = build_avr_here("Any");
  std::atomic<bool> done{false};
  std::thread other([&] {
    while (!done) {
      const fs::path copy = folder_ / "cache/robosim/copy";
      fs::copy_file(first.image, copy, fs::copy_options::overwrite_existing);
      fs::rename(copy, first.image);
    }
  });
  for (int i = 0; i < 5; ++i) {
    fs::remove(first.products.at(0));
    EXPECT_NO_THROW(EXPECT_EQ(build_avr_here("Any").products, first.products));
  }
  done = true;
  other.join();
}

TEST_F(SketchTest, AMissingCrossCompilerIsNamedWithItsPackage) {
  write("Any/Any.ino", kEmptySketch);
  ::setenv("PATH", folder_.c_str(), 1);
  const char* sentence = "avr-g++ is missing: sudo apt install gcc-avr";
  EXPECT_THAT(
      [this] {
        build({folder_ / "Any", *find_board("uno"), "avr"});
      },
      testing::ThrowsMessage<ToolMissing>(sentence));
  EXPECT_EQ(missing_tool("avr"), sentence);
  EXPECT_THROW(missing_tool("pdp11"), InputError);
}

TEST_F(SketchTest, ARequiredTargetIsOneThatTheEnvironmentNames) {
  const char* before = std::getenv("ROBOSIM_REQUIRE");
  const std::string kept = before ? before : "";
  ::setenv("ROBOSIM_REQUIRE", "host,avr", 1);
  EXPECT_TRUE(test::is_required("avr"));
  EXPECT_TRUE(test::is_required("host"));
  EXPECT_FALSE(test::is_required("stm32"));
  ::unsetenv("ROBOSIM_REQUIRE");
  EXPECT_FALSE(test::is_required("avr"));
  if (before) ::setenv("ROBOSIM_REQUIRE", kept.c_str(), 1);
}

}  // namespace avr_test
}  // namespace robosim::build
