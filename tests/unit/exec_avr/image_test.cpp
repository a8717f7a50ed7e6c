#include "sim/base/error.h"
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace {

using testing::HasSubstr;

class ImageTest : public AvrTest {
 protected:
  std::string refusal(const std::string& content) {
    const auto file = folder_ / "x.elf";
    write_file(file, content);
    try {
      AvrExecutor executor(*find_board(board_name_), file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
};

TEST_F(ImageTest, WhatIsNoAvrProgramIsRefusedWithItsName) {
  EXPECT_THAT(refusal("hello"), testing::AllOf(HasSubstr("x.elf"), HasSubstr("no ELF file")));
  const std::string good = read_file(build("void setup() {}\nvoid loop() {}"));
  EXPECT_EQ(refusal(good), "accepted");
  std::string arm = good;
  arm[18] = 40;
  EXPECT_THAT(refusal(arm), HasSubstr("no program for an AVR chip"));
}

TEST_F(ImageTest, ADamagedFileNeverReachesTheChip) {
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
  try {
    AvrExecutor executor(small, built_.image);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("needs " + std::to_string(flash) + " bytes of flash"));
  }
  small.flash_bytes = static_cast<std::uint32_t>(flash);
  EXPECT_NO_THROW(AvrExecutor(small, built_.image));
}

}  // namespace
}  // namespace robosim::exec
