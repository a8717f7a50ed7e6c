// Runs a sketch on a board without a robot or a world, and without code of sim/exec. The class BreadBoard is
// the shortest example of the interface between firmware and board (hal/board/firmware_port.h).
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <csetjmp>
#include <filesystem>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "hal/host/image.h"
#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "tests/support/temporary_folder.h"

namespace robosim {
namespace bread_board_test {

constexpr Pin kButton = 2, kLed = 13, kKnob = 14;

/// An Uno with an LED, a button to ground that is pressed from 150 ms on, and a potentiometer at 2 V.
class BreadBoard final : public FirmwarePort {
 public:
  const BoardSpec& spec() const override { return *find_board("uno"); }
  void set_drive(Pin pin, const PinDrive& drive, SimTime t) override {
    if (pin == kLed && drive.level != lit_) changes.push_back(t);
    if (pin == kLed) lit_ = drive.level;
  }
  bool read_level(Pin pin, SimTime t, ReadIntent) override {
    return pin == kButton && t < 150 * kMillisecond;
  }
  Source read_source(Pin pin, SimTime) override { return pin == kKnob ? 2.0 : 0.0; }
  const double& supply_volts() const override { return supply_; }
  void send_byte(uint8_t byte, SimTime) override { printed += static_cast<char>(byte); }
  bool two_wire_address(uint8_t, SimTime) override { return false; }
  bool two_wire_write(uint8_t, SimTime) override { return false; }
  uint8_t two_wire_read(SimTime) override { return 0xFF; }
  void two_wire_stop(SimTime) override {}
  uint8_t read_eeprom(uint16_t) const override { return 0xFF; }
  void write_eeprom(uint16_t, uint8_t, SimTime) override {}

  std::vector<SimTime> changes;  ///< times at which the LED is switched
  std::string printed;

 private:
  const double supply_ = 5.0;
  bool lit_ = false;
};

/// An executor that runs an image until the firmware reaches FirmwareState::limit. Nothing else happens.
class Runner final : public host::Host {
 public:
  void run(const host::Image& image, FirmwarePort& board) {
    if (setjmp(end_) == 0) image.run(board, *this, 0);
  }

 private:
  void yield() override { std::longjmp(end_, 1); }
  void crash(const char*, const char*, uint32_t, const void*) override { yield(); }
  void bite() override { yield(); }
  void undefined(const char*, const void*, uintptr_t, uintptr_t, const void*) override { yield(); }
  void bad_access(const host::BadAccess&, const void*) override { yield(); }
  void block_begins(const uint8_t*) override {}
  void take_state(const uint8_t*) override {}
  bool has_state(const uint8_t*) override { return false; }
  SimTime same_until(Pin, SimTime now) override { return now; }
  bool take_input(SimTime, host::Input&) override { return false; }
  bool want_edges(Pin, bool, SimTime) override { return false; }
  void listen(SimTime, SimTime) override {}
  void divides_by_zero(const void*, const void*) override {}
  void lacks(const char*, const void*) override {}
  void acted(const FirmwareAction&) override {}
  void globals(const host::GlobalRecord*, size_t) override {}

  std::jmp_buf end_;
};

constexpr const char* kSketch = R"(
void setup() {
  pinMode(13, OUTPUT);
  pinMode(2, INPUT_PULLUP);
  Serial.begin(9600);
}
void loop() {
  digitalWrite(13, digitalRead(2) == LOW);
  Serial.print(analogRead(A0));
  Serial.print(' ');
  delay(100);
}
)";

TEST(BreadBoard, RunsASketchWithoutARobot) {
  test::use_shared_cache();
  const test::TemporaryFolder temporary;
  const std::filesystem::path folder = temporary.path() / "Button";
  std::filesystem::create_directories(folder);
  write_file(folder / "Button.ino", kSketch);
  BreadBoard board;
  const std::string file = build::build({folder, board.spec()}).image.string();
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(library, nullptr) << dlerror();
  const auto& image = *static_cast<const host::Image*>(dlsym(library, "robosim_image"));
  ASSERT_EQ(image.version, host::kImageVersion);
  image.state->limit = 350 * kMillisecond;
  Runner().run(image, board);
  EXPECT_EQ(board.printed, "409 409 409 409 ") << "2 V of 5 V";
  ASSERT_EQ(board.changes.size(), 1u);
  EXPECT_NEAR(1e-6 * static_cast<double>(board.changes[0]), 200.0, 1.0) << "ms";
  dlclose(library);
}

}  // namespace bread_board_test
}  // namespace robosim
