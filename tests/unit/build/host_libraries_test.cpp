// Tests that libraries written for an AVR also work on the target host.
#include <gmock/gmock.h>

#include "sim/base/elf/elf_file.h"
#include "sim/build/libraries.h"
#include "tests/unit/build/run_fixture.h"

namespace robosim::build {
namespace host_libraries_test {

struct Edges final : PinWatcher {
  void pin_changed(Pin, const PinDrive& drive, SimTime t) override {
    if (drive.mode != PinMode::output || drive.level == level) return;
    level = drive.level;
    at.push_back(t);
  }
  bool level = false;
  std::vector<SimTime> at;
};

struct Level final : PinSource {
  bool level(SimTime) override { return value; }
  bool value = false;
};

class HostLibrariesTest : public RunTest {
 protected:
  std::string run_with_libraries(const std::string& code, SimTime duration = 50 * kMillisecond) {
    write("Run/Run.ino", code);
    image_ = build({folder_ / "Run", board_, "host", libraries_}).image;
    return run_image(image_, duration);
  }

  std::vector<std::filesystem::path> libraries_ = {folder_ / "libs"};
  std::filesystem::path image_;
};

const char* const kWithSerial = "void setup() { Serial.begin(115200); show(); }\nvoid loop() {}\n";

TEST_F(HostLibrariesTest, ALibraryMayKeepThePortsOfItsPins) {
  write("libs/Pulse/Pulse.h",
        "#include <Arduino.h>\n"
        "struct Pulse {\n"
        "  Pulse(uint8_t pin);\n"
        "  void twice();\n"
        "  bool high() { return *in & mask; }\n"
        "  volatile uint8_t *out, *in; uint8_t mask;\n"
        "};\n");
  write("libs/Pulse/Pulse.cpp",
        "#include \"Pulse.h\"\n"
        "Pulse::Pulse(uint8_t pin) : mask(digitalPinToBitMask(pin)) {\n"
        "  out = portOutputRegister(digitalPinToPort(pin));\n"
        "  in = portInputRegister(digitalPinToPort(pin));\n"
        "}\n"
        "void Pulse::twice() { *out |= mask; *out &= ~mask; *out |= mask; *out &= ~mask; }\n");
  const std::string code =
      "#include <Pulse.h>\n"
      "Pulse pulse(9);\n"
      "void show() {\n"
      "  pinMode(9, OUTPUT); pinMode(8, OUTPUT);\n"
      "  pulse.twice();\n"
      "  *pulse.out |= pulse.mask; digitalWrite(8, HIGH); Serial.println(pulse.high());\n"
      "  digitalWrite(9, LOW); Serial.println(pulse.high()); Serial.println(PORTB);\n"
      "}\n";
  EXPECT_EQ(run_with_libraries(code + kWithSerial), "1\n0\n1\n");

  Edges edges;
  executor_ = std::make_unique<exec::HostExecutor>(board_, image_);
  executor_->board().watch(9, edges);
  executor_->power_on(0);
  executor_->run_until(2 * kTick);
  ASSERT_EQ(edges.at.size(), 6u);
  // Each |= and &= reads and writes the register. Each access takes 2 cycles, so the edges are 250 ns apart.
  EXPECT_EQ(edges.at[1] - edges.at[0], 250);
  EXPECT_EQ(edges.at[3] - edges.at[2], 250);
}

TEST_F(HostLibrariesTest, RegistersHaveAddressesReferencesAndCFiles) {
  libraries_.clear();
  write("Run/timer.c",
        "#include <avr/io.h>\n"
        "void set_top(unsigned top) { TCCR1A = 0; TCCR1B = _BV(WGM13) | _BV(CS11); ICR1 = top; }\n");
  EXPECT_EQ(run_with_libraries("extern \"C\" void set_top(unsigned);\n"
                               "volatile int overflows;\n"
                               "ISR(TIMER1_OVF_vect) { overflows++; }\n"
                               "void show() {\n"
                               "  volatile uint8_t& mask = TIMSK1;\n"
                               "  volatile uint16_t* top = &ICR1;\n"
                               "  set_top(1000);\n"
                               "  TIFR1 = _BV(TOV1);\n"
                               "  mask |= _BV(TOIE1);\n"
                               "  delayMicroseconds(10500);\n"
                               "  Serial.println(overflows);\n"
                               "  Serial.println(*top);\n"
                               "  cli(); const uint8_t before = SREG; sei(); SREG = before; cli();\n"
                               "  Serial.println(SREG >> 7); sei();\n"
                               "}\n" +
                               std::string(kWithSerial)),
            "10\n1000\n0\n");
}

TEST_F(HostLibrariesTest, AProgramThatKeepsNoAddressIsNotWatched) {
  write("Run/Run.ino", "void setup() { PORTB |= 1; *portOutputRegister(2) &= ~1; }\nvoid loop() {}\n");
  const std::string image = build_here("Run").image;
  const ElfFile file(read_file(image), image);
  for (const ElfSymbol& symbol : file.symbols()) EXPECT_NE(symbol.name, "robosim_register_memory");
}

TEST_F(HostLibrariesTest, ALibraryForAvrsAloneIsCompiledAsForOne) {
  write("libs/Ticks/Ticks.h",
        "#ifndef __AVR__\n"
        "#error this library is for AVR boards\n"
        "#endif\n"
        "extern volatile unsigned ticks;\n"
        "inline void begin() { TCCR2A = 2; TCCR2B = 4; OCR2A = 249; TIMSK2 = 2; }\n");
  write("libs/Ticks/Ticks.cpp",
        "#include <Arduino.h>\n#include \"Ticks.h\"\n"
        "volatile unsigned ticks;\nISR(TIMER2_COMPA_vect) { ticks++; }\n");
  EXPECT_EQ(
      run_with_libraries("#include <Ticks.h>\nvoid show() { begin(); delay(20); Serial.println(ticks); }\n" +
                         std::string(kWithSerial)),
      "21\n");  // 20 in 20 ms, and 1 because the PWM of init() had set the flag, as on the chip
}

TEST_F(HostLibrariesTest, AnErrorOfTheSketchIsToldAsWithoutLibraries) {
  write("libs/Some/Some.h", "");
  write("Run/Run.ino", "#include <Some.h>\nvoid setup() { missing(); }\nvoid loop() {}\n");
  EXPECT_THAT(error_of("Run", {folder_ / "libs"}),
              testing::StartsWith("Run.ino:2:16: error: 'missing' was not declared"));
}

TEST_F(HostLibrariesTest, AStandInIsTakenForALibraryOfItsNameAlone) {
  const auto stand_in = write("ours/Encoder/Encoder.h", "").parent_path();
  write("ours/Encoder/library.properties", "name=Encoder\n");
  const auto found = [&](const char* folder) {
    const LibraryFinder finder({folder_ / folder}, folder_ / "ours");
    const Library* library = finder.find("Encoder.h");
    return library ? library->folder : std::filesystem::path();
  };
  EXPECT_EQ(found("none"), stand_in);
  const auto unnamed = write("unnamed/Encoder-master/Encoder.h", "").parent_path();
  EXPECT_EQ(found("unnamed"), stand_in);
  write("unnamed/Encoder-master/library.properties", "name=My Encoder\n");
  EXPECT_EQ(found("unnamed"), unnamed);
  const auto other = write("other/Wheels/Encoder.h", "").parent_path();
  EXPECT_EQ(found("other"), other);
}

TEST_F(HostLibrariesTest, AnEncoderCountsByInterruptsAndByLooking) {
  for (const auto& [pins, a, b] : {std::tuple{"2, 3", 2, 3}, std::tuple{"4, 7", 4, 7}}) {
    const std::string code = std::string("#include <Encoder.h>\nEncoder wheel(") + pins +
                             ");\nvoid setup() { Serial.begin(115200); }\n"
                             "void loop() { wheel.read(); if (millis() >= 60) { "
                             "Serial.println(wheel.read()); delay(1000); } }\n";
    write("Run/Run.ino", code);
    serial_.text.clear();
    executor_ = std::make_unique<exec::HostExecutor>(board_, build_here("Run").image);
    RobotPort& board = executor_->board();
    board.watch_serial(serial_);
    Level first, second;
    board.connect(static_cast<Pin>(a), first);
    board.connect(static_cast<Pin>(b), second);
    executor_->power_on(0);
    for (int tick = 0; tick < 100; ++tick) {
      const SimTime t = tick * kTick;
      // The encoder turns by ten quarters of a period forward, then by four backward.
      const int quarter = tick < 10 ? 0 : tick < 20 ? tick - 10 : std::max(6, 30 - tick);
      const bool levels[2] = {(quarter + 1) % 4 >= 2, quarter % 4 >= 2};
      if (first.value != levels[0]) board.schedule_edge(static_cast<Pin>(a), levels[0], t);
      if (second.value != levels[1]) board.schedule_edge(static_cast<Pin>(b), levels[1], t);
      first.value = levels[0];
      second.value = levels[1];
      executor_->run_until(t + kTick);
    }
    EXPECT_EQ(serial_.text, "-6\n") << pins;
  }
}

TEST_F(HostLibrariesTest, AStripOfLedsGetsItsPulses) {
  write("Run/Run.ino",
        "#include <Adafruit_NeoPixel.h>\nAdafruit_NeoPixel strip(1, 6);\n"
        "void setup() { strip.begin(); strip.setPixelColor(0, 0xA0, 0x80, 0); strip.show(); }\nvoid loop() "
        "{}\n");
  executor_ = std::make_unique<exec::HostExecutor>(board_, build_here("Run").image);
  Edges edges;
  executor_->board().watch(6, edges);
  executor_->power_on(0);
  executor_->run_until(2 * kTick);
  ASSERT_EQ(edges.at.size(), 48u);
  std::string bits;
  for (std::size_t i = 0; i < 48; i += 2) {
    const SimTime high = edges.at[i + 1] - edges.at[i];
    bits += high == 812 || high == 813 ? '1' : high == 312 || high == 313 ? '0' : '?';
  }
  EXPECT_EQ(bits, "100000001010000000000000");  // eight bits each of green, red and blue
}

TEST_F(HostLibrariesTest, LongDelaysOfMicrosecondsWrapAsOnTheChip) {
  EXPECT_EQ(run_code("void setup() { Serial.begin(115200); unsigned long t = micros(); "
                     "delayMicroseconds(16000); t = micros() - t; Serial.println(t / 100); "
                     "t = micros(); delayMicroseconds(50000); Serial.println((micros() - t) / 100); }\n"
                     "void loop() {}\n"),
            "160\n8\n");
}

}  // namespace host_libraries_test
}  // namespace robosim::build
