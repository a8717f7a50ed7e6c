// Tests the thirty sketches of a school class on one machine. Five sketches are hostile. The other sketches
// must get the correct verdicts. strace confirms that the command reads no private file, and writes only
// into the folders for temporary files and the cache.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <regex>
#include <sstream>

#include "sim/base/file.h"
#include "sim/build/process.h"
#include "tests/hostile/watched.h"
#include "tests/support/temporary_folder.h"

namespace robosim::hostile {
namespace class_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string kCheck =
    "[[check]]\nname = \"lap\"\nmap = \"oval\"\nrobot = \"uno5\"\ngoal = \"laps:1\"\nfor = \"25s\"\n";

/// Returns a sketch that follows the line with Arduino's functions if `looks`, or else drives straight on.
std::string driver(int speed, bool looks) {
  const auto sees = [&](int one, int other) {
    return looks ? fmt::format("analogRead(A{}) > 400 || analogRead(A{}) > 400", one, other) : "false";
  };
  return fmt::format(
      "void drive(int left, int right) {{\n  digitalWrite(7, left > 0); digitalWrite(8, left < 0); "
      "analogWrite(5, abs(left));\n"
      "  digitalWrite(9, right > 0); digitalWrite(10, right < 0); analogWrite(6, abs(right));\n}}\n"
      "void setup() {{ for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT); }}\nvoid loop() {{\n"
      "  if ({1}) drive(30, {0});\n  else if ({2}) drive({0}, 30);\n  else drive({0}, {0});\n  "
      "delay(2);\n}}\n",
      speed, sees(0, 1), sees(3, 4));
}

TEST(Class, OfThirtyGetsTwentyFiveRightVerdictsAndReadsAndWritesNothingOutside) {
  const fs::path strace = build::find_program("strace");
  if (strace.empty()) GTEST_SKIP() << "there is no strace";
  const test::TemporaryFolder folder;
  const fs::path root = folder.path();
  std::vector<Entry> entries = {
      {"class.toml", kCheck}, {"outside/secret.h", kSecret}, {"home/.ssh/id", kSecret}};
  std::vector<std::string> due;
  const auto hand_in = [&](const std::string& name, const std::string& text, const char* verdict) {
    entries.push_back({"pupils/" + name + "/" + name + ".ino", text});
    due.emplace_back(verdict);
  };
  for (int i = 0; i < 15; ++i) hand_in(fmt::format("a{:02}", i), driver(104 + i, true), "passed");
  for (int i = 0; i < 6; ++i) hand_in(fmt::format("b{}", i), driver(90 + 10 * i, false), "lost");
  for (int i = 0; i < 2; ++i) hand_in(fmt::format("c{}", i), driver(0, true), "timeout");
  for (int i = 0; i < 2; ++i)
    hand_in(fmt::format("d{}", i), "void setup() { int x = ; }\nvoid loop() {}\n", "expected");
  const std::string body = "\nvoid setup() {}\nvoid loop() {}\n";
  hand_in("e0", "asm(\".incbin \\\"@SECRET@\\\"\");" + body, "is not a readable file of the sketch");
  hand_in("e1", "#include \"l.h\"" + body, "outside of the sketch's folder");
  entries.push_back({"pupils/e1/l.h", "../../outside/secret.h", Kind::link});
  hand_in("e2", "#include __FILE__\n#include __FILE__" + body, "ERROR");
  hand_in("e3", body, "begin with '@'");
  entries.push_back({"pupils/e3/@.o.cpp", ""});
  entries.push_back({"pupils/e3/.o.cpp", "-wrapper /bin/sh,x\n"});
  hand_in("e4", "void setup() { for (unsigned i = 0;; ++i) *(volatile char*)i = i; }\nvoid loop() {}\n",
          "FAILED");
  make(root, entries, {{kSecretHere, (root / "outside/secret.h").string()}});
  for (const char* name : {"tmp", "cache"}) fs::create_directories(root / name);
  const auto before = state_of(root, {"tmp", "cache"});

  std::vector<std::string> words = {
      strace.string(),
      "-f",
      "-qq",
      "-y",
      "-s",
      "4096",
      "-e",
      "signal=none",
      "-e",
      "trace=open,openat,openat2,creat,rename,renameat,renameat2,unlink,unlinkat,mkdir,mkdirat,"
      "link,linkat,symlink,symlinkat,truncate,chmod,fchmodat,chown,fchownat,socket,connect",
      "-o",
      (root / "tmp/trace").string(),
      "-E",
      "HOME=" + (root / "home").string(),
      "-E",
      "XDG_CACHE_HOME=" + (root / "cache").string(),
      "-E",
      "TMPDIR=" + (root / "tmp").string(),
      ROBOSIM_COMMAND,
      "test",
      "--untrusted",
      "--checks",
      "class.toml"};
  for (const auto& entry : entries)
    if (const fs::path path = entry.path; path.extension() == ".ino")
      words.push_back(path.parent_path().string() + "/");
  const Watched watched = watch(words, root, false, 900.0);
  EXPECT_EQ(watched.status, 2) << watched.err;
  std::vector<std::string> lines;
  std::istringstream all(watched.out);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 31u) << watched.out << watched.err;
  for (std::size_t i = 0; i < 30; ++i) EXPECT_THAT(lines[i], HasSubstr(due[i]));
  EXPECT_EQ(lines.back(), "15 of 30 sketches passed all checks");
  EXPECT_THAT(watched.out + watched.err, testing::Not(HasSubstr(kSecret)));
  EXPECT_EQ(state_of(root, {"tmp", "cache"}), before) << "folders of the class";

  const std::string trace = read_file(root / "tmp/trace");
  static const std::regex opened(R"(= \d+<([^>]*)>)"), named(R"re("([^"]*)")re");
  const fs::path programs = fs::path(ROBOSIM_COMMAND).parent_path();
  std::istringstream calls(trace);
  for (std::string call; std::getline(calls, call);) {
    EXPECT_THAT(call, testing::Not(testing::AnyOf(HasSubstr("socket("), HasSubstr("connect(")))) << call;
    if (call.find(" = -1 ") != call.npos || call.find("resumed>") != call.npos) continue;
    std::smatch match;
    if (!std::regex_search(call, match, call.find(" open") != call.npos ? opened : named)) continue;
    const std::string path = match[1];
    EXPECT_FALSE(path.starts_with((root / "outside").string()) || path.starts_with((root / "home").string()))
        << call;
    const bool writes = call.find(" open") == call.npos || call.find("O_WRONLY") != call.npos ||
                        call.find("O_RDWR") != call.npos;
    const bool scratch = path.starts_with((root / "tmp").string()) ||
                         path.starts_with((root / "cache").string()) || path.starts_with("/dev/null") ||
                         path.starts_with("/memfd:") || path.starts_with("/proc/") || path[0] != '/';
    const bool system = call.find("O_PATH") != call.npos || path.starts_with("/usr/") ||
                        path.starts_with("/lib") || path.starts_with("/etc/ld.so") ||
                        path.starts_with("/etc/alternatives") || path.starts_with("/sys/") ||
                        path.starts_with("/dev/urandom") || path.starts_with(root.string()) ||
                        path.starts_with(ROBOSIM_DATA);
    EXPECT_TRUE(writes ? scratch : scratch || system) << call;
  }
}

}  // namespace class_test
}  // namespace robosim::hostile
