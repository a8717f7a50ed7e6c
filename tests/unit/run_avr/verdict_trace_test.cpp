// Tests the links of the chain from a verdict to the lines of the sketch (sim/runner/verdict_trace.h).
#include "sim/runner/verdict_trace.h"

#include <gmock/gmock.h>

#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/exec/avr/avr_executor.h"
#include "sim/robot/robot.h"
#include "tests/support/one_robot.h"
#include "tests/support/require_target.h"
#include "tests/support/temporary_folder.h"

namespace robosim::runner::verdict_trace_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class VerdictTrace : public testing::Test {
 protected:
  void SetUp() override {
    ROBOSIM_NEEDS_TARGET("avr");
    test::use_shared_cache();
  }
  /// Returns the texts of the chain's links for a sketch that sets its motors' pins, then repeats `loop`.
  std::string links_of(const std::string& loop, const std::string& more = "") {
    const std::filesystem::path folder = folder_ / "Test";
    std::filesystem::create_directories(folder);
    write_file(folder / "Test.ino", more + R"(
void setup() {
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
}
void loop() { )" + loop + " }\n");
    const BoardSpec& board = *find_board("uno");
    exec::AvrExecutor executor(board, build::build({folder, board, "avr"}).image);
    test::OneRobot one(executor, "laps:1");
    one.setup.limit = 10 * kSecond;
    std::string texts;
    for (const result::Cause& cause : Inquiry(one.setup, board, robot::wiring_of(one.robot)).go().because)
      texts += cause.text + "\n";
    return texts;
  }

  const test::TemporaryFolder folder_;
};

constexpr const char* kDrives =
    "int seen = analogRead(A2); analogWrite(5, 160); analogWrite(6, 120 + seen / 64);";

TEST_F(VerdictTrace, NamesTheMotorsIfTheRobotDrove) {
  EXPECT_THAT(links_of(std::string(kDrives) + " delay(2);"),
              AllOf(HasSubstr("the robot left the line; motors: left 63 %, right "),
                    Not(HasSubstr("interrupt")), Not(HasSubstr("read no line sensor"))));
  EXPECT_THAT(links_of("noInterrupts(); for (;;) {}"),
              AllOf(HasSubstr("calls no functions any more"), Not(HasSubstr("motors: "))));
}

TEST_F(VerdictTrace, NamesATimeWithoutReads) {
  EXPECT_THAT(links_of(std::string(kDrives) + " delay(300);"),
              HasSubstr("ms it read no line sensor, and was here"));
}

TEST_F(VerdictTrace, NamesHandlersThatTakeMuchOfTheTime) {
  EXPECT_THAT(links_of("static bool on; if (!on) { TCCR2A = _BV(WGM21); OCR2A = 99; TCCR2B = _BV(CS21); "
                       "TIMSK2 = _BV(OCIE2A); } on = true; " +
                           std::string(kDrives) + " delay(2);",
                       "volatile int n; ISR(TIMER2_COMPA_vect) { delayMicroseconds(25); n++; }"),
              HasSubstr("interrupt handlers took "));
}

TEST_F(VerdictTrace, NamesWhereInterruptsWentOff) {
  EXPECT_THAT(links_of("noInterrupts(); for (;;) {}"),
              HasSubstr("interrupts were disabled here, and were off at all later checks"));
}

}  // namespace robosim::runner::verdict_trace_test
