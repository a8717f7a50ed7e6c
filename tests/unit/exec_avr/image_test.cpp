// Tests loading images for an AVR: ELF and Intel HEX files, valid and invalid.
#include <algorithm>
#include <cstdio>

#include "sim/base/error.h"
#include "sim/exec/avr/firmware.h"
#include "tests/support/refusal.h"
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::image_test {

using testing::HasSubstr;

class ImageTest : public AvrTest {
 protected:
  std::string refusal(const std::string& content, const char* name = "x.elf") {
    const auto file = folder_ / name;
    write_file(file, content);
    return test::refusal([&] { AvrExecutor executor(*find_board(board_name_), file); });
  }
};

TEST_F(ImageTest, AFileThatIsNotAnAvrProgramIsRefusedByFileName) {
  EXPECT_THAT(refusal("hello"),
              testing::AllOf(HasSubstr("x.elf"), HasSubstr("expected a program for a chip")));
  const std::string good = read_file(build("void setup() {}\nvoid loop() {}"));
  EXPECT_EQ(refusal(good), "accepted");
  std::string arm = good;
  arm[18] = 40;
  EXPECT_THAT(refusal(arm), HasSubstr("expected an image for the target avr, got one for the target stm32"));
}

TEST_F(ImageTest, AnImageForAnotherChipIsRefusedWithBothNames) {
  const std::string empty = "void setup() {}\nvoid loop() {}";
  const std::string of_uno = read_file(build(empty));
  board_name_ = "mega";
  const std::string of_mega = read_file(build(empty));
  EXPECT_THAT(refusal(of_uno), HasSubstr("expected an image for the mega's ATmega2560, got one for the "
                                         "atmega328p: choose a robot with that chip, as with --robot "
                                         "ROBOT@uno"));
  board_name_ = "uno";
  EXPECT_THAT(refusal(of_mega), HasSubstr("expected an image for the uno's ATmega328P, got one for the "
                                          "atmega2560: choose a robot with that chip, as with --robot "
                                          "ROBOT@mega"));
  const auto for_device = [&](std::string_view device) {
    constexpr std::string_view kOwn = "atmega328p";
    std::string name(device), image = of_uno;
    name.resize(kOwn.size());
    for (std::size_t at = 0; (at = image.find(kOwn, at)) != image.npos;) image.replace(at, kOwn.size(), name);
    return image;
  };
  for (const char* const other : {"atmega16", "atmega128", "attiny4313", "atmega88p"}) {
    const std::string got = refusal(for_device(other));
    EXPECT_THAT(got, HasSubstr(std::string("got one for the ") + other + ": compile it with"));
    EXPECT_THAT(got, HasSubstr("-mmcu=atmega328p"));
  }
  EXPECT_EQ(refusal(for_device("atmega328")), "accepted") << "the same chip, with a higher power consumption";
  EXPECT_EQ(refusal(for_device("")), "accepted")
      << "images built with an older avr-libc contain no device name";
}

TEST_F(ImageTest, ATruncatedFileIsRefusedAndADamagedOneDoesNotCrash) {
  const std::string good = read_file(build("void setup() { Serial.begin(9600); }\nvoid loop() {}"));
  for (std::size_t size = 52; size < good.size(); size += 97)
    EXPECT_THAT(refusal(good.substr(0, size)), testing::Not(HasSubstr("accepted"))) << size;
  for (std::size_t at = 16; at < 300; at += 3) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x5A);
    refusal(bad);
  }
}

TEST_F(ImageTest, AProgramLargerThanTheBoardsFlashIsRefused) {
  board_name_ = "nano";
  const std::string text =
      "const PROGMEM byte big[30700] = {1};\nvolatile int i;\n"
      "void setup() { i = pgm_read_byte(big + i); }\nvoid loop() {}";
  board_name_ = "uno";
  const std::string good = read_file(build(text));
  EXPECT_EQ(refusal(good), "accepted");
  board_name_ = "nano";
  EXPECT_THAT(refusal(good), HasSubstr("the nano has 30720 for a sketch"));
}

TEST_F(ImageTest, TheFlashInUseIsTheSameForTheBuildAndForTheChip) {
  const std::string text =
      "int numbers[] = {1, 2, 3, 4, 5, 6, 7};\nvoid setup() { Serial.begin(9600); }\n"
      "void loop() { Serial.println(++numbers[millis() % 7]); }";
  start(text);
  const auto flash = built_.text_bytes;
  EXPECT_EQ(avr_->resources()->flash_bytes, flash);
  EXPECT_EQ(avr_->resources()->ram_bytes, built_.data_bytes);
  BoardSpec small = *find_board("uno");
  small.flash_bytes = static_cast<std::uint32_t>(flash - 1);
  EXPECT_THAT(test::refusal([&] { AvrExecutor executor(small, built_.image); }),
              HasSubstr("requires " + std::to_string(flash) + " bytes of flash"));
  small.flash_bytes = static_cast<std::uint32_t>(flash);
  EXPECT_NO_THROW(AvrExecutor(small, built_.image));
}

/// Returns `flash` as Intel HEX, 16 bytes per line.
std::string hex_of(const std::vector<std::uint8_t>& flash) {
  std::string text;
  const auto line = [&](std::size_t at, unsigned kind, std::size_t count) {
    std::string bytes{static_cast<char>(count), static_cast<char>(at >> 8), static_cast<char>(at),
                      static_cast<char>(kind)};
    for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(flash[at + i]);
    unsigned sum = 0;
    for (const char byte : bytes) sum += static_cast<std::uint8_t>(byte);
    bytes += static_cast<char>(-sum);
    text += ':';
    for (const char byte : bytes) {
      char digits[3];
      std::snprintf(digits, sizeof digits, "%02X", static_cast<std::uint8_t>(byte));
      text += digits;
    }
    text += "\r\n";
  };
  for (std::size_t at = 0; at < flash.size(); at += 16)
    line(at, 0, std::min<std::size_t>(16, flash.size() - at));
  line(0, 1, 0);
  return text;
}

TEST_F(ImageTest, AHexFileRunsLikeItsElfWithTheSameMemoryUse) {
  const std::string text =
      "int counted[50];\nint begins = 40;\n"
      "int __attribute__((noinline)) down(int n) { volatile char room[100]; room[n] = n; return n ? down(n - "
      "1) + "
      "room[n] : 0; }\n"
      "void setup() { Serial.begin(115200); Serial.println(begins + sizeof counted); }\n"
      "void loop() { counted[millis() % 50]++; if (millis() > 50) down(90); }";
  start(text);
  run(40 * kMillisecond);
  const Resources of_elf = *avr_->resources();
  const std::string hex = hex_of(avr::Firmware::read(built_.image, *find_board("uno")).flash);
  write_file(folder_ / "x.hex", hex);
  start_image(folder_ / "x.hex");
  run(40 * kMillisecond);
  EXPECT_EQ(serial_, "140\r\n");
  const Resources of_hex = *avr_->resources();
  EXPECT_EQ(of_hex.flash_bytes, of_elf.flash_bytes);
  EXPECT_EQ(of_hex.ram_bytes, of_elf.ram_bytes);
  EXPECT_EQ(of_hex.stack_bytes_max, of_elf.stack_bytes_max);
  EXPECT_EQ(of_hex.loops, 0u) << "a HEX file does not locate loop()";
  run(100 * kMillisecond);
  ASSERT_TRUE(avr_->crash());
  EXPECT_THAT(avr_->crash()->reason, HasSubstr("stack overflow"));
  EXPECT_THROW(avr_->set_clock_start(kSecond), InputError);

  EXPECT_THAT(refusal(hex.substr(0, 100), "x.hex"),
              HasSubstr("x.hex:3: expected a line of an Intel HEX file"));
  EXPECT_THAT(refusal(hex.substr(0, hex.find('\n') + 1), "x.hex"),
              HasSubstr("expected the line :00000001FF at its end"));
  std::string wrong = hex;
  wrong[10] = wrong[10] == '0' ? '1' : '0';
  EXPECT_THAT(refusal(wrong, "x.hex"), HasSubstr("x.hex:1: expected a line of an Intel HEX file"));
  EXPECT_THAT(refusal(":020000040001F9\n:0100000000FF\n:00000001FF\n", "x.hex"),
              HasSubstr("beyond the end of the chip's flash: expected at most 32768 bytes"));
  for (const char* const other : {"", "hello", "\177ELF"})
    EXPECT_THAT(refusal(other, "x.hex"), HasSubstr("Intel HEX file")) << other;
}

TEST_F(ImageTest, AHexFileWithABootLoaderStartsTheSketch) {
  start("void setup() { Serial.begin(115200); Serial.println(\"hello\"); }\nvoid loop() {}");
  const std::string hex = hex_of(avr::Firmware::read(built_.image, *find_board("uno")).flash);
  const std::size_t end = hex.find(":00000001FF");
  write_file(folder_ / "x.hex",
             hex.substr(0, end) + ":107E0000112484B714BE81FFF0D085E080938100F7\n" + hex.substr(end));
  start_image(folder_ / "x.hex");
  run(40 * kMillisecond);
  EXPECT_EQ(serial_, "hello\r\n");
}

TEST_F(ImageTest, TheImageInitialisesTheEepromAndFusesAreIgnored) {
  EXPECT_EQ(output("#include <avr/eeprom.h>\n#include <avr/fuse.h>\n#include <avr/lock.h>\n"
                   "byte level EEMEM = 42;\nint trim EEMEM = -300;\n"
                   "FUSES = {0xFF, 0xDE, 0xFD};\nLOCKBITS = 0xCF;\n"
                   "void setup() {\n  Serial.begin(115200);\n"
                   "  Serial.println(eeprom_read_byte(&level));\n"
                   "  Serial.println((int)eeprom_read_word((uint16_t*)&trim));\n"
                   "  Serial.println(eeprom_read_byte((uint8_t*)100));\n}\nvoid loop() {}"),
            "42\r\n-300\r\n255\r\n");
}

TEST_F(ImageTest, WhatIsNotInitialisedIsKeptWhenTheWatchdogResets) {
  EXPECT_EQ(output("#include <avr/wdt.h>\n"
                   "unsigned magic __attribute__((section(\".noinit\")));\n"
                   "unsigned starts __attribute__((section(\".noinit\")));\nunsigned zero;\n"
                   "void setup() {\n  wdt_disable();\n  Serial.begin(115200);\n"
                   "  if (magic != 0xBEEF) { magic = 0xBEEF; starts = 0; }\n"
                   "  Serial.println(++starts * 10 + ++zero);\n  Serial.flush();\n"
                   "  if (starts < 2) { wdt_enable(WDTO_15MS); for (;;) {} }\n}\nvoid loop() {}"),
            "11\r\n21\r\n");
}

}  // namespace robosim::exec::image_test
