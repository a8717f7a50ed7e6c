// Runs compiled sketches with the host executor: those of the folder `sketches`, and code in the tests.
#include <gmock/gmock.h>

#include "tests/unit/build/run_fixture.h"

namespace robosim::build {
namespace run_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(RunTest, FunctionsAreFoundWhereverTheyStandAndDefaultArgumentsHold) {
  EXPECT_EQ(run_sketch("Order"), "-60\n1none, (yet)\n3none, (yet)\n3two (2), a=b\n10\n4\n5\n2\n6\n");
}

TEST_F(RunTest, NumbersAreFormattedAsOnTheChip) {
  EXPECT_EQ(run_sketch("Formatting"),
            "1    -2|3    |-0004 +5\n"
            "ff FF 0xff 10 7 c%\n"
            "-70000 70000 abc|   abc|abc   |ab\n"
            "?      ?\n"
            "7\n1234\n"
            "-42\n11111111\nee6b2800\n"
            "    3.14\n-3.142  \n 1.235e+04\n"
            "0123a\nA3210\n"
            "194\n1\n");
}

TEST_F(RunTest, ABluePillsSketchFindsTheChipsPins) {
  board_ = *find_board("bluepill");
  volts_.value = 1.65;
  ConstantVolts beside{3.3 / 4};
  const std::string code =
      "#include <avr/io.h>\n"
      "void setup() {\n"
      "  Serial.begin(9600);\n"
      "  const int pins[] = {PA0, PB0, PA6, PA8, PB9, PB12, PC13, A7};\n"
      "  for (int pin : pins) { Serial.print(pin); Serial.print(' '); }\n"
      "  Serial.println(digitalPinToInterrupt(PB12));\n"
      "  Serial.println(analogRead(PA1));\n"
      "  analogReadResolution(12);\n"
      "  Serial.println(analogRead(PA1));\n"
      "  Serial.println(analogRead(PA7));\n"
      "  analogWriteResolution(12);\n"
      "  pinMode(PB6, OUTPUT);\n"
      "  analogWrite(PB6, 51 << 4);\n"
      "}\n"
      "void loop() {}\n";
  write("Run/Run.ino", code);
  executor_ = std::make_unique<exec::HostExecutor>(board_, build({folder_ / "Run", board_}).image);
  executor_->board().watch_serial(serial_);
  executor_->board().connect(15, volts_);
  executor_->board().connect(11, beside);
  executor_->power_on(0);
  executor_->run_until(100 * kMillisecond);
  EXPECT_EQ(serial_.text, "14 20 12 3 10 2 13 21 0\n512\n2048\n1024\n");
  EXPECT_DOUBLE_EQ(executor_->board().drive(5).duty, 52.0 / 256.0) << "one timer step more than the value";
}

TEST_F(RunTest, ABluePillsFurtherPinsReadWriteAndInterrupt) {
  board_ = *find_board("bluepill");
  write("Run/Run.ino",
        "volatile int rising, any;\n"
        "void setup() {\n"
        "  Serial.begin(115200);\n"
        "  pinMode(PB10, OUTPUT);\n"
        "  digitalWrite(PB10, HIGH);\n"
        "  pinMode(PC15, INPUT_PULLUP);\n"
        "  attachInterrupt(digitalPinToInterrupt(PB4), [] { rising++; }, RISING);\n"
        "  attachInterrupt(digitalPinToInterrupt(PB13), [] { any++; }, CHANGE);\n"
        "  Serial.println(digitalRead(PC15) * 10 + digitalRead(PB11));\n"
        "  delay(10);\n"
        "  detachInterrupt(digitalPinToInterrupt(PB13));\n"
        "  delay(10);\n"
        "  Serial.println(rising * 10 + any);\n"
        "}\n"
        "void loop() {}\n");
  executor_ = std::make_unique<exec::HostExecutor>(board_, build({folder_ / "Run", board_}).image);
  auto& pins = executor_->board();
  pins.watch_serial(serial_);
  ConstantVolts high{3.3};
  pins.connect(24, high);  // PB11
  executor_->power_on(0);
  executor_->run_until(5 * kMillisecond);
  for (const int ms : {6, 7, 15, 16})
    for (const Pin pin : {Pin{27}, Pin{4}}) pins.schedule_edge(pin, ms % 2 == 0, ms * kMillisecond);
  executor_->run_until(100 * kMillisecond);
  EXPECT_EQ(serial_.text, "11\n22\n");
  EXPECT_EQ(pins.drive(23).mode, PinMode::output);
  EXPECT_TRUE(pins.drive(23).level);
  EXPECT_EQ(pins.drive(31).mode, PinMode::input_pullup);
}

TEST_F(RunTest, AMegasPinsHaveTheTimersOfItsOwnChip) {
  board_ = *find_board("mega");
  write("Run/Run.ino",
        "void setup() {\n"
        "  analogWrite(9, 150); analogWrite(10, 150); analogWrite(11, 150); analogWrite(46, 150);\n"
        "  TCCR1A = 0; TCCR1B = _BV(CS11);\n"
        "}\n"
        "void loop() {}\n");
  executor_ = std::make_unique<exec::HostExecutor>(board_, build({folder_ / "Run", board_}).image);
  executor_->power_on(0);
  executor_->run_until(10 * kMillisecond);
  for (const Pin pin : {9, 10, 46}) EXPECT_TRUE(executor_->board().drive(pin).pwm) << int{pin};
  EXPECT_FALSE(executor_->board().drive(11).pwm) << "OC1A, whose timer the sketch has taken";
}

TEST_F(RunTest, ATimerOfALeonardoDrivesThePinThatHasTwoNumbers) {
  board_ = *find_board("leonardo");
  write("Run/Run.ino",
        "void setup() { pinMode(9, OUTPUT); TCCR1A = _BV(COM1A1) | _BV(WGM10); TCCR1B = _BV(CS10); }\n"
        "void loop() { OCR1A = 100; delay(5); OCR1A = 0; delay(5); }\n");
  executor_ = std::make_unique<exec::HostExecutor>(board_, build({folder_ / "Run", board_}).image);
  executor_->power_on(0);
  executor_->run_until(12 * kMillisecond);
  EXPECT_TRUE(executor_->board().drive(9).pwm);
  EXPECT_NEAR(executor_->board().drive(9).duty, 100 / 255.0, 0.01);
}

TEST_F(RunTest, TablesInFlashAreRead) {
  EXPECT_EQ(run_sketch("FlashTables"), "in flash\n160\n-100\n60000\n1.50\nright\nleft\n-100\n5\n");
}

TEST_F(RunTest, StringsWorkAsInTheGenuineCore) {
  EXPECT_EQ(run_sketch("Strings"), "3.142 FF -7\n6.28\n6\n13\n");
}

TEST_F(RunTest, ATimerInterruptCallsItsHandler) {
  EXPECT_EQ(
      run_code(
          "volatile int n;\nISR(TIMER1_COMPA_vect) { n++; }\n"
          "void setup() { Serial.begin(115200); OCR1A = 15999; TCCR1A = 0; TCCR1B = _BV(WGM12) | _BV(CS10);"
          " TCNT1 = 0; TIMSK1 = _BV(OCIE1A); while (n < 50) ; Serial.println(millis()); }\nvoid loop() {}\n"),
      "48\n");  // init()'s PWM had already set the flag; millis() counts overflows of 1.024 ms
}

TEST_F(RunTest, GainsInEepromSurviveAPowerCycle) {
  const std::string first = run_sketch("EepromGains", 500 * kMillisecond);
  EXPECT_THAT(first, StartsWith("0.50\n"));
  EXPECT_EQ(executor_->probe().memory()[100], 42);
  executor_->power_off(500 * kMillisecond);
  serial_.text.clear();
  executor_->power_on(600 * kMillisecond);
  executor_->run_until(kSecond);
  EXPECT_THAT(serial_.text, StartsWith("0.50\n"));
  EXPECT_EQ(executor_->probe().memory()[500], 2) << "the sketch counts its starts";
}

TEST_F(RunTest, ASleepingSketchWakesForTheClockAndParksForGood) {
  EXPECT_EQ(run_sketch("Parking"), "4B37\n1\nparked\n");
  EXPECT_LT(executor_->last_call(), 150 * kMillisecond);
}

TEST_F(RunTest, ASerialThatIsNeverBegunSendsNothing) {
  EXPECT_EQ(run_code("void setup() {}\nvoid loop() { Serial.println(1); delay(10); }\n"), "");
}

TEST_F(RunTest, ADelayOfLessThanNothingLastsForWeeksAsOnTheChip) {
  EXPECT_EQ(run_code("long wait = -1;\nvoid setup() { Serial.begin(115200); Serial.print('a'); }\n"
                     "void loop() { delay(wait); Serial.print('b'); }\n"),
            "a");
}

TEST_F(RunTest, RegistersDriveThePins) {
  EXPECT_THAT(run_sketch("Registers", 50 * kMillisecond), testing::Not(testing::IsEmpty()));
  EXPECT_EQ(executor_->board().drive(5).mode, PinMode::output);
  EXPECT_TRUE(executor_->board().drive(5).level);
  EXPECT_EQ(executor_->board().drive(9).mode, PinMode::output);
  EXPECT_TRUE(executor_->board().drive(9).pwm);
}

TEST_F(RunTest, AHobbyistsSketchWithCommonNamesAndALibraryRuns) {
  const Image image =
      build({fs::path(SKETCHES) / "Hobbyist", board_, "host", {fs::path(SKETCHES) / "Hobbyist_libraries"}});
  EXPECT_THAT(run_image(image.image, 2 * kSecond), StartsWith("starting with 5 sensors\nposition 2000\n"));
  EXPECT_EQ(executor_->board().drive(13).mode, PinMode::output);
  EXPECT_TRUE(executor_->board().drive(13).level);
  EXPECT_NEAR(executor_->board().drive(5).duty, 150 / 255.0, 0.01);
}

TEST_F(RunTest, GlobalsNamedAsTheCLibrarysFunctionsAreTheSketchsOwn) {
  const fs::path image = build({fs::path(SKETCHES) / "CommonNames", board_}).image;
  run_image(image, 100 * kMillisecond);
}

// As on the chip, a function that lacks its return statement returns to its caller. The returned value is
// meaningless.
TEST_F(RunTest, AFunctionThatShouldGiveAValueAndHasNoReturnReturns) {
  EXPECT_EQ(run_code("int a;\nvoid never() { Serial.println(\"never called\"); }\n"
                     "bool __attribute__((noinline)) set_up(int& b) { b = 1; }\n"
                     "void setup() { Serial.begin(115200); set_up(a); Serial.println(a); }\n"
                     "void loop() { if (millis() > 10000) never(); }\n"),
            "1\n");
}

TEST_F(RunTest, TheClockOfAvrLibcStandsStillUnlessItIsTicked) {
  EXPECT_EQ(run_code("#include <time.h>\nvoid setup() { Serial.begin(115200); Serial.print(time(0)); "
                     "Serial.print(' ');\n"
                     "set_system_time(40); system_tick(); time_t now; time(&now); Serial.println(now); }\n"
                     "void loop() {}\n"),
            "0 41\n");
}

TEST_F(RunTest, ConstructorsRunInTheOrderOfTheirPriority) {
  EXPECT_EQ(
      run_code(
          "char order[9];\nint n;\nstruct A { A(char c) { order[n++] = c; } };\nA a('a');\nA b('b');\n"
          "A c __attribute__((init_priority(200)))('c');\nA d __attribute__((init_priority(150)))('d');\n"
          "void setup() { Serial.begin(9600); Serial.println(order); }\nvoid loop() {}\n"),
      "dcab\n");
}

TEST_F(RunTest, TimePassesInAnEmptyEndlessLoopAndInterruptsAreServed) {
  EXPECT_EQ(
      run_code(
          "volatile int n;\nISR(TIMER1_COMPA_vect) { n++; if (n == 20) Serial.print(n); }\n"
          "void setup() { Serial.begin(115200); OCR1A = 15999; TCCR1A = 0; TCCR1B = _BV(WGM12) | _BV(CS10);"
          " TIMSK1 = _BV(OCIE1A); for (;;); }\nvoid loop() {}\n"),
      "20");
  EXPECT_EQ(run_code("int x;\nvoid setup() {\n  while (1)\n    ;\n}\nvoid loop() {}\n"), "");
  EXPECT_EQ(executor_->activity().where.file, "Run.ino");
  EXPECT_EQ(executor_->activity().where.line, 3);
}

TEST_F(RunTest, ACrashNamesTheLineOfTheIno) {
  write("Run/Run.ino", "int zero;\nvoid setup() {\n  if (zero == 0) abort();\n}\nvoid loop() {}\n");
  exec::HostExecutor executor(board_, build_here("Run").image);
  executor.power_on(0);
  executor.run_until(kTick);
  ASSERT_TRUE(executor.crash());
  EXPECT_THAT(executor.crash()->reason, HasSubstr("abort() called"));
  EXPECT_EQ(executor.crash()->where.file, "Run.ino");
  EXPECT_EQ(executor.crash()->where.line, 3);
}

}  // namespace run_test
}  // namespace robosim::build
