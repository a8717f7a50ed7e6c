// Tests `robosim flash`, as a user runs it. avrdude is a script that records its arguments.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/support/require_target.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace cli_flash_test {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kFlashed =
    "void setup() { Serial.begin(9600); }\nvoid loop() { Serial.println(millis()); }\n";

std::string after(const std::string& text, const std::string& mark, const std::string& end) {
  const std::size_t at = text.find(mark);
  if (at == text.npos) return "";
  const std::size_t begin = at + mark.size();
  return text.substr(begin, text.find(end, begin) - begin);
}

class CliFlash : public ::testing::Test {
 protected:
  CliFlash() : path_(std::getenv("PATH")) { folder_.write("My/My.ino", kFlashed); }
  ~CliFlash() override { ::setenv("PATH", path_.c_str(), 1); }

  /// Puts a fake avrdude first on PATH. The script saves its arguments and a copy of the file to flash, and
  /// ends with `status`.
  void fake_avrdude(int status) {
    const auto script = folder_.write(
        "bin/avrdude", "#!/bin/sh\n: > '" + words().string() + "'\nfor word; do echo \"$word\" >> '" +
                           words().string() + "'; done\nfile=${word#flash:w:}\ncp \"${file%:i}\" '" +
                           written().string() + "'\necho to-out\necho to-err >&2\nexit " +
                           std::to_string(status) + "\n");
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    ::setenv("PATH", ((folder_ / "bin").string() + ":" + path_).c_str(), 1);
  }
  std::filesystem::path words() const { return folder_ / "words"; }
  std::filesystem::path written() const { return folder_ / "written.hex"; }
  Ended flash(std::vector<std::string> words) {
    words.insert(words.begin(), {"flash", "My/"});
    return robosim_command(words, folder_.path());
  }

  const Folder folder_;
  const std::string path_;
};

TEST_F(CliFlash, GivesAvrdudeTheHexOfTheImage) {
  ROBOSIM_NEEDS_TARGET("avr");
  fake_avrdude(0);
  const Ended ended = flash({"--port", "/dev/ttyACM0"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const std::string hex = after(ended.out, "hex: ", "\n");
  EXPECT_EQ(read_file(words()),
            "-p\natmega328p\n-c\narduino\n-b\n115200\n-P\n/dev/ttyACM0\n-D\n-U\nflash:w:" + hex + ":i\n");
  ASSERT_EQ(robosim_command({"build", "My/", "--target", "avr", "--out", "made"}, folder_.path()).status, 0);
  EXPECT_EQ(read_file(written()), read_file(folder_ / "made/My.hex"));
  EXPECT_THAT(ended.out, EndsWith("to-out\n"));
  EXPECT_THAT(ended.err, EndsWith("to-err\n"));
}

TEST_F(CliFlash, TakesTheBoardOfTheRobotAndTheSpeedOfAnOldBootLoader) {
  ROBOSIM_NEEDS_TARGET("avr");
  fake_avrdude(0);
  folder_.write("nano.toml", "base = \"uno5\"\nboard = \"nano\"\n");
  const Ended ended = flash({"--port", "/dev/ttyUSB0", "--baud", "57600", "--robot", "./nano.toml"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("My for the nano ("));
  EXPECT_THAT(read_file(words()), HasSubstr("-b\n57600\n-P\n/dev/ttyUSB0\n"));
}

TEST_F(CliFlash, TakesTheSpeedOfTheBoardsBootLoader) {
  ROBOSIM_NEEDS_TARGET("avr");
  fake_avrdude(0);
  const Ended ended = flash({"--port", "/dev/ttyUSB0", "--robot", "uno5@promini8"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("My for the promini8 ("));
  EXPECT_THAT(ended.out, HasSubstr("Maximum is 30720 bytes."));
  EXPECT_THAT(read_file(words()), HasSubstr("-p\natmega328p\n-c\narduino\n-b\n57600\n"));
  ASSERT_EQ(robosim_command({"build", "My/", "--target", "avr", "--out", "made"}, folder_.path()).status, 0);
  const Ended image = robosim_command(
      {"flash", "made/My.elf", "--port", "p", "--robot", "uno5@promini16", "--dry-run"}, folder_.path());
  EXPECT_THAT(image.out, HasSubstr(" -b 57600 ")) << image.err;
  EXPECT_THAT(flash({"--port", "p", "--robot", "uno5@leonardo", "--dry-run"}).out,
              HasSubstr("\np is opened with 1200 baud and closed first, which starts the boot loader\n"
                        "avrdude -p atmega32u4 -c avr109 -b 57600 -P p -D -U flash:w:"));
  EXPECT_THAT(flash({"--port", "p", "--robot", "uno5@mega", "--dry-run"}).out,
              HasSubstr("\navrdude -p atmega2560 -c wiring -b 115200 -P p -D -U flash:w:"));
  EXPECT_THAT(flash({"--port", "p", "--robot", "uno5@nano168", "--dry-run"}).out,
              HasSubstr("\navrdude -p atmega168 -c arduino -b 19200 -P p -D -U flash:w:"));
}

TEST_F(CliFlash, PutsNoOtherBoardInThePlaceOfTheRobots) {
  ROBOSIM_NEEDS_TARGET("avr");
  fake_avrdude(0);
  const Ended ended = flash({"--port", "/dev/ttyUSB0", "--robot", "bluepill3"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, HasSubstr("the board bluepill cannot run the target avr"));
  EXPECT_FALSE(std::filesystem::exists(words())) << "avrdude was started";
}

TEST_F(CliFlash, SaysThatABoardWithoutABootLoaderOfArduinosHasAProgrammerOfItsOwn) {
  ROBOSIM_NEEDS_TARGET("avr");
  folder_.write("My/My.ino", "void setup() { analogWrite(4, 9); }\nvoid loop() {}\n");
  const Ended ended = flash({"--port", "/dev/ttyACM0", "--robot", "digispark2", "--dry-run"});
  EXPECT_EQ(ended.status, 2) << ended.out;
  EXPECT_THAT(ended.err, HasSubstr(".hex: robosim flash cannot write to a digispark"));
}

TEST_F(CliFlash, ADryRunPrintsTheCommandAndTheHashOfTheTestedImage) {
  ROBOSIM_NEEDS_TARGET("avr");
  fake_avrdude(0);
  const Ended ended = flash({"--port", "/dev/tty '1", "--dry-run"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_FALSE(std::filesystem::exists(words())) << "avrdude was started";
  EXPECT_THAT(ended.out,
              EndsWith("\navrdude -p atmega328p -c arduino -b 115200 -P '/dev/tty '\\''1' -D -U flash:w:" +
                       after(ended.out, "hex: ", "\n") + ":i\n"));
  const Ended run =
      robosim_command({"run", "My/", "--target", "avr", "--for", "10ms", "--json"}, folder_.path());
  if (run.status == 5 && !is_required("avr")) GTEST_SKIP() << run.err;  // the emulator is missing
  const auto result = nlohmann::json::parse(run.out, nullptr, false);
  ASSERT_TRUE(result.is_object()) << run.out << run.err;
  const auto image = result["inputs"]["image_sha256"].get<std::string>();
  EXPECT_EQ(after(ended.out, "\nimage_sha256: ", ","), image);
  EXPECT_EQ(sha256(read_file(after(ended.out, "\nimage: ", "\n"))), image);
}

TEST_F(CliFlash, FailsWhereAvrdudeDoes) {
  ROBOSIM_NEEDS_TARGET("avr");
  fake_avrdude(3);
  const Ended ended = flash({"--port", "/dev/ttyACM7"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err,
              HasSubstr("to-err\nrobosim: avrdude failed (exit status 3). Is the board at /dev/ttyACM7?"));
}

TEST_F(CliFlash, DoesNotFlashWhatIsOverTheRobotsBudget) {
  ROBOSIM_NEEDS_TARGET("avr");
  fake_avrdude(0);
  folder_.write("My/robot.toml", "base = \"uno5\"\n[budget]\nflash = 1500\n");
  const Ended ended = flash({"--port", "/dev/ttyACM0"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err, HasSubstr("My is over the budget"));
  EXPECT_FALSE(std::filesystem::exists(words())) << "avrdude was started";
}

TEST_F(CliFlash, DoesNotFlashWhatDoesNotFitTheChip) {
  ROBOSIM_NEEDS_TARGET("avr");
  fake_avrdude(0);
  folder_.write("My/My.ino",
                "volatile char much[2100];\nvoid setup() { much[millis()] = 1; }\nvoid loop() {}\n");
  const Ended ended = flash({"--port", "/dev/ttyACM0"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_FALSE(std::filesystem::exists(words())) << "avrdude was started";
}

TEST_F(CliFlash, AMissingAvrdudeIsStatus5AndItsPackageIsNamed) {
  ::setenv("PATH", folder_.path().c_str(), 1);
  const Ended ended = flash({"--port", "/dev/ttyACM0"});
  EXPECT_EQ(ended.status, 5);
  EXPECT_EQ(ended.err, "robosim: avrdude is missing: sudo apt install avrdude\n");
}

TEST_F(CliFlash, AFinishedImageIsWrittenAsItIs) {
  ROBOSIM_NEEDS_TARGET("avr");
  fake_avrdude(0);
  ASSERT_EQ(robosim_command({"build", "My/", "--target", "avr", "--out", "made"}, folder_.path()).status, 0);
  const Ended ended = robosim_command({"flash", "made/My.elf", "--port", "/dev/ttyACM0"}, folder_.path());
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(read_file(words()), EndsWith("-U\nflash:w:made/My.elf:e\n"));
  EXPECT_EQ(after(ended.out, "image_sha256: ", ","), sha256(read_file(folder_ / "made/My.elf")));
}

TEST_F(CliFlash, AnImageForThisComputerIsRefused) {
  ASSERT_EQ(robosim_command({"build", "My/", "--out", "made"}, folder_.path()).status, 0);
  const Ended ended =
      robosim_command({"flash", "made/My.so", "--port", "/dev/ttyACM0", "--dry-run"}, folder_.path());
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, HasSubstr("made/My.so"));
}

TEST_F(CliFlash, AMissingPortIsStatus2AndTheSentenceSaysHowToFindIt) {
  const Ended ended = flash({});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_THAT(ended.err, AllOf(HasSubstr("/dev/ttyACM0"), HasSubstr("/dev/ttyUSB0"), HasSubstr("ls /dev/")));
}

}  // namespace cli_flash_test
}  // namespace robosim::test
