#include "sim/build/vector_hints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/build/toolchain.h"
#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace vector_hints_test {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::filesystem::path& avr_libc() {
  static const std::filesystem::path folder = find_core().avr_libc;
  return folder;
}

/// Returns the hint on the linker's message that both `first` and `second` define `vector`.
std::string hint(const char* vector, const std::string& second, const std::string& first,
                 const char* name = "uno") {
  const BoardSpec& board = *find_board(name);
  return vector_hint(
      second + ": multiple definition of `" + vector + "'\n" + first + ": first defined here\n", "", board,
      {*board.chip, avr_libc()});
}

TEST(VectorHints, AVectorHasTheNameThatAvrLibcGivesItOnEachChip) {
  const auto name = [](const char* board, int number) {
    return vector_name({*find_board(board)->chip, avr_libc()}, number);
  };
  EXPECT_EQ(name("uno", 5), "PCINT2_vect");
  EXPECT_EQ(name("nano168", 7), "TIMER2_COMPA_vect");
  EXPECT_EQ(name("mega", 5), "INT4_vect");
  EXPECT_EQ(name("leonardo", 17), "TIMER1_COMPA_vect");
  EXPECT_EQ(name("attiny85", 5), "TIMER0_OVF_vect");
  EXPECT_EQ(name("uno", 99), "");
}

TEST(VectorHints, TwoOwnersOfAVectorAreNamedWithWhatToDo) {
  const std::string serial = "libraries/SoftwareSerial/src/SoftwareSerial.cpp:229";
  EXPECT_EQ(hint("__vector_5", serial, "My.ino:5"),
            "the interrupt PCINT2_vect (__vector_5) can have only one handler, but My.ino:5 and the "
            "library SoftwareSerial both define one: SoftwareSerial handles the pin changes of all pins; "
            "read the other pins by attachInterrupt(), which works for D2, D3, or use another serial "
            "library");
  EXPECT_THAT(hint("__vector_3", "libraries/A/A.cpp:1", "libraries/B/src/B.cpp:2"),
              AllOf(HasSubstr("PCINT0_vect"), HasSubstr("the library B and the library A both define one"),
                    HasSubstr("attachInterrupt(), which works for D2, D3")));
  EXPECT_THAT(hint("__vector_11", "libraries/Servo/src/avr/Servo.cpp:81", "My.ino:4"),
              AllOf(HasSubstr("TIMER1_COMPA_vect"), HasSubstr("both use timer 1; use another timer")));
  EXPECT_THAT(
      hint("__vector_7", "core/Tone.cpp", "My.ino"),
      HasSubstr(
          "My.ino and tone() both define one: both use timer 2; use another timer for one of them, or do"));
  EXPECT_THAT(
      hint("__vector_1", "core/WInterrupts.c", "My.ino:2"),
      HasSubstr("My.ino:2 and attachInterrupt() both define one: attachInterrupt() handles all external"));
  EXPECT_THAT(hint("__vector_21", "other.cpp:3", "My.ino:2"),
              AllOf(HasSubstr("ADC_vect"), HasSubstr("remove one of the two handlers")));
  EXPECT_THAT(hint("__vector_10", "libraries/A/A.cpp:1", "My.ino:2", "mega"), HasSubstr("PCINT1_vect"));
}

TEST(VectorHints, OtherErrorsOfTheLinkerHaveNone) {
  EXPECT_EQ(hint("twice()", "other.cpp:1", "My.ino:2"), "");
  EXPECT_EQ(hint("__vector_table", "other.cpp:1", "My.ino:2"), "");
  const BoardSpec& uno = *find_board("uno");
  EXPECT_EQ(vector_hint("My.ino:1: undefined reference to `__vector_5'", "", uno, {*uno.chip, avr_libc()}),
            "");
}

TEST(VectorHints, OnTheHostAHandlerThatTheCoreHasOnTheChipIsWarnedOf) {
  const auto on = [](const char* board, const std::string& code) {
    return core_handler_warnings("#line 1 \"My.ino\"\n" + code, *find_board(board), avr_libc());
  };
  EXPECT_EQ(on("uno", "void __vector_1(void) { ++n; }\nvoid setup() { attachInterrupt(1, tick, 3); }"),
            "My.ino:1: warning: the interrupt INT0_vect can have only one handler, but attachInterrupt() "
            "also defines one: the sketch does not link for the chip; attachInterrupt() handles all "
            "external interrupts; call it for this interrupt, too, instead of ISR()");
  EXPECT_THAT(on("nano", "void __vector_2(void) { ++n; }\nvoid setup() { attachInterrupt(0, tick, 3); }"),
              HasSubstr("the interrupt INT1_vect"));
  EXPECT_THAT(on("uno", "void __vector_7(void) { ++n; }\nvoid setup() { tone(8, 440); }"),
              HasSubstr("TIMER2_COMPA_vect can have only one handler, but tone() also defines one"));
  EXPECT_EQ(on("uno", "void __vector_1(void) { ++n; }\nvoid setup() { pcint.attachInterrupt(1, tick, 3); }"),
            "");
  EXPECT_EQ(on("uno", "void __vector_11(void) { ++n; }\nvoid setup() { tone(8, 440); }"), "");
  EXPECT_EQ(on("uno", "void __vector_7(void) { ++n; }\nvoid tone(int pin, int hz) {}"), "");
  EXPECT_EQ(on("leonardo", "void __vector_7(void) { ++n; }\nvoid setup() { tone(8, 440); }"), "");
}

class VectorHintsOf : public SketchTest {
 protected:
  VectorHintsOf() { std::filesystem::create_directories(folder_ / "libraries"); }

  /// Returns the error if the sketch does not link, otherwise the warnings.
  std::string messages_on(const char* target, const std::string& code) const {
    write("My/My.ino", code);
    try {
      return build({folder_ / "My", *find_board("uno"), target, {folder_ / "libraries"}}).messages;
    } catch (const InputError& error) {
      return error.what();
    }
  }
};

const char* const kSerialSketch =
    "#include <SoftwareSerial.h>\nSoftwareSerial phone(12, 13);\nvolatile int left;\nvoid count() { left++; "
    "}\n";

TEST_F(VectorHintsOf, ASketchNameItsLineAndTheLibraryOnHostAndAvr) {
  for (const char* target : {"host", "avr"})
    EXPECT_THAT(
        messages_on(target, std::string(kSerialSketch) +
                                "ISR(PCINT2_vect) { left++; }\n"
                                "void setup() { phone.begin(9600); }\nvoid loop() {}\n"),
        AllOf(
            HasSubstr("multiple definition of `__vector_5'"),
            HasSubstr("hint: the interrupt PCINT2_vect (__vector_5) can have only one handler, but My.ino:5 "
                      "and the library SoftwareSerial both define one")))
        << target;
}

TEST_F(VectorHintsOf, ASketchNameTwoLibraries) {
  write("libraries/Encoders/Encoders.h", "void count();\n");
  write("libraries/Encoders/Encoders.cpp", "#include <Arduino.h>\nISR(PCINT2_vect) {}\nvoid count() {}\n");
  for (const char* target : {"host", "avr"})
    EXPECT_THAT(
        messages_on(target,
                    "#include <SoftwareSerial.h>\n#include <Encoders.h>\nSoftwareSerial phone(12, 13);\n"
                    "void setup() { phone.begin(9600); count(); }\nvoid loop() {}\n"),
        HasSubstr("the library SoftwareSerial and the library Encoders both define one"))
        << target;
}

TEST_F(VectorHintsOf, ASketchForTheChipNameTheFunctionOfTheCore) {
  EXPECT_THAT(
      messages_on("avr", "ISR(TIMER2_COMPA_vect) {}\nvoid setup() { tone(8, 440); }\nvoid loop() {}\n"),
      AllOf(HasSubstr("core/Tone.cpp: multiple definition of `__vector_7'"),
            HasSubstr("but My.ino:1 and tone() both define one")));
  EXPECT_THAT(
      messages_on("avr",
                  "void tick() {}\nISR(INT0_vect) {}\nvoid setup() { attachInterrupt(1, tick, RISING); }\n"
                  "void loop() {}\n"),
      HasSubstr("but My.ino:2 and attachInterrupt() both define one"));
}

TEST_F(VectorHintsOf, ASketchWithOneOwnerOfEachVectorAreNotGiven) {
  for (const char* target : {"host", "avr"}) {
    EXPECT_EQ(
        messages_on(target, std::string(kSerialSketch) +
                                "void setup() { phone.begin(9600); attachInterrupt(0, count, RISING); }\n"
                                "void loop() {}\n"),
        "");
    EXPECT_EQ(
        messages_on(target, "ISR(PCINT2_vect) {}\nISR(INT0_vect) {}\nvoid setup() {}\nvoid loop() {}\n"), "");
    EXPECT_EQ(
        messages_on(target, "ISR(TIMER1_COMPA_vect) {}\nvoid setup() { tone(8, 440); }\nvoid loop() {}\n"),
        "");
  }
}

}  // namespace vector_hints_test
}  // namespace robosim::build
