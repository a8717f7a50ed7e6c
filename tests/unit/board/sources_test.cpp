// Compares the data of boards and chips with Arduino's boards.txt, and with Robosim's files that repeat parts
// of these data.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>

#include "hal/board/atmega328p.h"
#include "hal/board/board_spec.h"
#include "hal/board/stm32f103c8.h"
#include "hal/stm32/addresses.h"

namespace robosim {
namespace sources_test {

using testing::HasSubstr;

std::string text_of(const std::string& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}
std::string ours(const std::string& file) { return text_of(std::string(ROBOSIM_SOURCE_DIR "/") + file); }

/// Returns the `KEY=VALUE` lines of `text` as a map.
std::map<std::string, std::string> properties(const std::string& text) {
  std::map<std::string, std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t at = line.find('='); at != line.npos && line[0] != '#')
      found[line.substr(0, at)] = line.substr(at + 1);
  return found;
}

TEST(Boards, AreArduinosWhereArduinoHasThem) {
  const std::string text = text_of("/usr/share/arduino/hardware/arduino/avr/boards.txt");
  if (text.empty()) GTEST_SKIP() << "needs the Debian package arduino-core-avr";
  const auto known = properties(text);
  int boards = 0;
  for (int i = 0; const BoardSpec* board = board_at(i); ++i) {
    static const std::regex kName("arduino:avr:(\\w+)(:cpu=(\\w+))?");
    std::smatch name;
    const std::string fqbn = board->fqbn;
    if (!std::regex_match(fqbn, name, kName)) continue;
    SCOPED_TRACE(board->name);
    ++boards;
    std::smatch first;  // the CPU that Arduino selects by default
    std::string cpu = name[3];
    if (cpu.empty() &&
        std::regex_search(text, first, std::regex("\n" + name[1].str() + "\\.menu\\.cpu\\.(\\w+)=")))
      cpu = first[1];
    const auto value = [&](const std::string& key) {
      const auto chosen = known.find(name[1].str() + ".menu.cpu." + cpu + "." + key);
      const auto plain = known.find(name[1].str() + "." + key);
      return chosen != known.end() ? chosen->second : plain != known.end() ? plain->second : "";
    };
    EXPECT_EQ(board->macro, "ARDUINO_" + value("build.board"));
    EXPECT_EQ(std::to_string(board->clock_hz) + "L", value("build.f_cpu"));
    EXPECT_EQ(board->variant, value("build.variant"));
    EXPECT_EQ(board->chip->compiler_name, value("build.mcu"));
    EXPECT_EQ(std::to_string(board->flash_bytes), value("upload.maximum_size"));
    // boards.txt has no upload values for a Gemma, whose boot loader does not use a serial line.
    if (value("upload.protocol").empty()) {
      EXPECT_EQ(board->upload_protocol, nullptr);
      continue;
    }
    EXPECT_EQ(std::to_string(board->ram_bytes), value("upload.maximum_data_size"));
    EXPECT_EQ(board->upload_protocol, value("upload.protocol"));
    EXPECT_EQ(std::to_string(board->upload_baud), value("upload.speed"));
  }
  EXPECT_GE(boards, 2);
}

TEST(Chips, AreTheOnesThatTheFilesForTheLinkerAndForPlainCmakeSpeakOf) {
  const BoardSpec& blue = *find_board("bluepill");
  EXPECT_THAT(ours("hal/stm32/" + std::string(kStm32f103c8.compiler_name) + ".ld"),
              HasSubstr("ORIGIN = 0x08000000, LENGTH = " + std::to_string(blue.flash_bytes / 1024) +
                        "K - (DEFINED(robosim_eeprom_read) ? " +
                        std::to_string((stm32::kFlash + stm32::kFlashBytes - stm32::kEepromFlash) / 1024) +
                        "K : 0)\n  data (rwx) : ORIGIN = 0x20000000, LENGTH = " +
                        std::to_string(kStm32f103c8.ram_bytes / 1024) + "K\n"));
  const std::string stm32 = ours("toolchain/stm32_firmware.cmake");
  const std::string avr = ours("toolchain/avr_firmware.cmake");
  EXPECT_THAT(stm32, HasSubstr("set(ROBOSIM_STM32_FLASH " + std::to_string(blue.flash_bytes) + ")"));
  EXPECT_THAT(stm32, HasSubstr("set(ROBOSIM_STM32_RAM " + std::to_string(blue.ram_bytes) + ")"));
  EXPECT_THAT(avr, HasSubstr("set(ROBOSIM_AVR_RAM " + std::to_string(kAtmega328p.ram_bytes) + ")"));
  for (const char* name : {"bluepill", "bluepill8"})
    EXPECT_THAT(stm32, HasSubstr(std::string("set(ROBOSIM_STM32_") + name + " " +
                                 std::to_string(find_board(name)->clock_hz) + ")"));
  for (const char* name : {"uno", "nano"}) {
    const BoardSpec& board = *find_board(name);
    EXPECT_THAT(avr, HasSubstr(std::string("set(ROBOSIM_AVR_") + name + " " + board.macro + " " +
                               board.variant + " " + std::to_string(board.flash_bytes) + ")"));
    EXPECT_THAT(avr, HasSubstr("F_CPU=" + std::to_string(board.clock_hz) + "L"));
  }
}

TEST(Boards, AreInTheDocumentsAsTheyAre) {
  const std::string robots = ours("docs/reference/robots.md");
  for (int i = 0; const BoardSpec* board = board_at(i); ++i) {
    std::ostringstream row;
    row << "| `" << board->name << "` | " << board->chip->name << " | " << board->clock_hz / 1e6 << " MHz | "
        << board->supply_volts << " V | " << board->flash_bytes << ", " << board->ram_bytes << ", "
        << board->eeprom_bytes << " | `" << board->fqbn << "` | `"
        << std::regex_replace(board->platformio, std::regex(" "), "`, `") << "` |\n";
    EXPECT_THAT(robots, HasSubstr(row.str()));
  }
}

TEST(Chips, TheBluePillsCoreHasItsPins) {
  const BoardSpec& blue = *find_board("bluepill");
  const std::string core = ours("hal/stm32/pins.cpp"), names = ours("hal/arduino/bluepill.h");
  // The columns are port, bit, ADC channel, timer (0 = none), and the timer's output (from 1).
  static const std::regex kRow("\\{([ABC]), (\\d+), (-?\\d+), (\\d), (\\d)\\}");
  Pin pin = 0;
  for (std::sregex_iterator row(core.begin(), core.end(), kRow), end; row != end; ++row, ++pin) {
    ASSERT_LT(pin, blue.pin_count);
    const PinSpec& spec = blue.pins[pin];
    EXPECT_EQ(spec.chip_name, "P" + (*row)[1].str() + (*row)[2].str());
    EXPECT_EQ(spec.analog_channel, std::stoi((*row)[3]));
    const int timer = spec.pwm ? kStm32f103c8.timers[spec.chip_pin.timer].number : 0;
    EXPECT_EQ(timer, std::stoi((*row)[4])) << spec.chip_name;
    EXPECT_EQ(spec.pwm ? spec.chip_pin.output + 1 : 0, std::stoi((*row)[5])) << spec.chip_name;
    EXPECT_THAT(names,
                HasSubstr("#define " + std::string(spec.chip_name) + " " + std::to_string(pin) + "\n"));
  }
  EXPECT_EQ(pin, blue.pin_count);
}

}  // namespace sources_test
}  // namespace robosim
