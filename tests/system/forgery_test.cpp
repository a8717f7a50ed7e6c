// Tests that a sketch which forges the verdict “reached” does not receive it. Sketches for the host are
// native code. sim/runner/sandbox_proxy.h describes how such a run reports to its runner. Firmware for a chip
// is only data for the emulator.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdlib.h>

#include <algorithm>
#include <iterator>

#include "hal/host/image.h"
#include "sim/exec/host/confinement.h"
#include "sim/wire/protocol.h"
#include "tests/system/command.h"
#include "tests/system/json_of.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace forgery_test {

/// Returns forged results of a runner, one line for each request number from 1 to 4.
std::string forged_lines() {
  std::string lines;
  for (std::int64_t id = 1; id <= 4; ++id) {
    result::RunResult result;
    result.verdict = "reached";
    result.why = "FORGED";
    result.goal = "laps:1";
    result.profile = "typical";
    result.for_s = 2.0;
    lines += wire::to_line(wire::Id(id), result);
  }
  return lines;
}

std::string literal(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '\n') quoted += "\\n";
    if (c == '"' || c == '\\') quoted += '\\';
    if (c != '\n') quoted += c;
  }
  return quoted + '"';
}

/// Returns definitions of LINES, and of the version that an image must have.
std::string beginning() {
  return "#define IMAGE_VERSION " + std::to_string(host::kImageVersion) + "\n#define LINES " +
         literal(forged_lines());
}

struct Attempt {
  const char* name;
  const char* text;
};
std::ostream& operator<<(std::ostream& out, const Attempt& attempt) { return out << attempt.name; }
std::string name_of_attempt(const testing::TestParamInfo<Attempt>& attempt) { return attempt.param.name; }

/// Declarations that the attempts use. say() outputs LINES.
constexpr const char* kOfTheSystem = R"(
extern "C" {
typedef void (*Handler)(int);
long write(int, const void*, unsigned long); long syscall(long, ...); long read(int, void*, unsigned long);
int close(int); int dup2(int, int); int puts(const char*); int fflush(void*); int atexit(void (*)());
int getpid(); int kill(int, int); int raise(int); int fork(); int open(const char*, int, ...);
void _exit(int) __attribute__((noreturn)); long ptrace(int, ...); Handler signal(int, Handler);
int _setjmp(void*); void longjmp(void*, int) __attribute__((noreturn)); void* dlsym(void*, const char*);
extern char** environ;
int sigprocmask(int, const void*, void*);
}
static void say(int fd) { write(fd, LINES, sizeof LINES - 1); }
)";

constexpr Attempt kOnTheHost[] = {
    {"WritesToEveryDescriptorAndExits", R"(
void setup() { for (int fd = 0; fd < 256; ++fd) say(fd); _exit(0); }
void loop() {})"},
    {"WritesToEachDescriptorOfTheRunAndExits", R"(
void setup() { say(3); _exit(0); }
void loop() {})"},
    {"PrintsAndExits", R"(
void setup() { puts(LINES); fflush(0); exit(0); }
void loop() {})"},
    {"ExitsAsASuccess", R"(
void setup() {}
void loop() { _exit(0); })"},
    {"Aborts", R"(
void setup() { say(1); abort(); }
void loop() {})"},
    {"RaisesASignal", R"(
void setup() { say(1); raise(9); }
void loop() {})"},
    {"KillsItsRunner", R"(
void setup() { kill(getpid() - 1, 9); for (int fd = 0; fd < 64; ++fd) say(fd); _exit(0); }
void loop() {})"},
    {"JumpsOutOfItsFiber", R"(
long place[64];
void setup() { _setjmp(place); }
void loop() { static int times = 0; if (++times > 3) { say(3); _exit(0); } longjmp(place, 1); })"},
    {"ReturnsToWhereItCameFromAgain", R"(
void setup() { long* frame = (long*)__builtin_frame_address(0); for (int i = 0; i < 4096; ++i) frame[i] = (long)&_exit; }
void loop() {})"},
    {"SaysItInAConstructor", R"(
struct Early { Early() { for (int fd = 3; fd < 9; ++fd) say(fd); _exit(0); } } early;
void setup() {}
void loop() {})"},
    {"SaysItWhileItIsBeingLoaded", R"(
extern "C" __attribute__((no_sanitize_coverage)) void _init() { syscall(1, 3, LINES, sizeof LINES - 1); _exit(0); }
void setup() {}
void loop() {})"},
    {"SaysItInADestructorAndAtTheEnd", R"(
struct Late { ~Late() { say(3); _exit(0); } } late;
__attribute__((destructor)) void last() { say(3); _exit(0); }
void bye() { say(3); _exit(0); }
void setup() { atexit(bye); }
void loop() { delay(1); })"},
    {"HasItsOwnWriteAndExit", R"(
extern "C" long own_write(int, const void*, unsigned long n) __asm__("write");
extern "C" long own_write(int, const void*, unsigned long n) { return n; }
extern "C" void exit(int) { for (;;) {} }
extern "C" long keyed_write(int, const void*, unsigned long n) { return n; }
void setup() {}
void loop() { delay(1); })"},
    {"IsAnImageOfItsOwn", R"(
extern "C" __attribute__((visibility("default"))) const long robosim_image[16] = {IMAGE_VERSION, 0, (long)&_exit};
void setup() {}
void loop() { delay(1); })"},
    {"ClosesAllDescriptorsAndLoops", R"(
void setup() { for (int fd = 0; fd < 64; ++fd) close(fd); }
void loop() { for (volatile int i = 0;; ++i) {} })"},
    {"ClosesAllDescriptorsAndExits", R"(
void setup() { for (int fd = 0; fd < 64; ++fd) close(fd); _exit(0); }
void loop() {})"},
    {"PutsItsStandardOutputInThePlaceOfThePipe", R"(
void setup() { dup2(1, 3); say(3); _exit(0); }
void loop() {})"},
    {"PutsThePipeInThePlaceOfItsStandardOutput", R"(
void setup() { dup2(3, 1); say(1); _exit(0); }
void loop() {})"},
    {"TracesItsRunner", R"(
void setup() { ptrace(16, getpid() - 1, 0, 0); ptrace(0); }
void loop() { say(3); _exit(0); })"},
    {"OpensTheMemoryOfItsRunner", R"(
void setup() { int fd = open("/proc/self/mem", 2); write(fd, LINES, 10); _exit(0); }
void loop() {})"},
    {"WritesIntoTheMemoryOfItsRunner", R"(
long iov[2];
void setup() { syscall(311, getpid() - 1, iov, 1, iov, 1, 0); _exit(0); }
void loop() {})"},
    {"ForksAndLetsItsChildSayIt", R"(
void setup() { if (fork() == 0) for (;;) say(3); _exit(0); }
void loop() {})"},
    {"HasAHandlerForWhatIsRefused", R"(
void handle(int) { say(3); _exit(0); }
void setup() { signal(31, handle); signal(11, handle); *(volatile char*)1 = 1; }
void loop() {})"},
    {"GuessesTheToken", R"(
struct { unsigned long token; unsigned bytes; char what, unused[3]; char text[sizeof LINES]; } message;
void setup() {
  memcpy(message.text, LINES, sizeof LINES); message.bytes = sizeof LINES - 1; message.what = 'A';
  const long guesses[] = {0, 1, -1, getpid(), getpid() - 1};
  for (long guess : guesses) {
    message.token = guess; syscall(1, 3, &message, sizeof message, guess, guess);
  }
  _exit(0);
}
void loop() {})"},
    {"LooksForTheTokenInItsEnvironmentAndOnItsStack", R"(
struct { unsigned long token; unsigned bytes; char what, unused[3]; char text[sizeof LINES]; } message;
void setup() {
  memcpy(message.text, LINES, sizeof LINES); message.bytes = sizeof LINES - 1; message.what = 'A';
  for (char** one = environ; *one; ++one) { message.token = *(long*)*one; syscall(1, 3, &message, sizeof message, message.token, message.token >> 32); }
  for (long* at = (long*)__builtin_frame_address(0);; ++at) { message.token = *at; syscall(1, 3, &message, sizeof message, *at, *at >> 32); }
}
void loop() {})"},
};

/// Runs the sketch F with the command `robosim run`, and returns its JSON.
nlohmann::json verdict_of(const Folder& folder, const char* target, Ended& ended) {
  ended = robosim_command({"run", "./F", "--map", "oval", "--robot", "uno5", "--goal", "laps:1", "--for",
                           "2s", "--target", target, "--json"},
                          folder.path());
  return json_of(ended);
}

TEST(Forgery, WouldBeAnAnswerIfItCameFromARunner) {
  const std::string lines = forged_lines();
  const wire::Line line = wire::parse_line(lines.substr(0, lines.find('\n')));
  ASSERT_TRUE(std::holds_alternative<result::RunResult>(line.content));
  EXPECT_EQ(std::get<result::RunResult>(line.content).verdict, "reached");
}

class OnTheHost : public testing::TestWithParam<Attempt> {};

TEST_P(OnTheHost, IsNeverSaidToHaveReachedItsGoal) {
  if (!exec::why_not_confined().empty()) GTEST_SKIP() << exec::why_not_confined();
  const Folder folder;
  folder.write("F/F.ino", beginning() + kOfTheSystem + GetParam().text + "\n");
  Ended ended;
  const auto json = verdict_of(folder, "host", ended);
  ASSERT_TRUE(json.is_object()) << ended.out << ended.err;
  RecordProperty("why", json["why"].get<std::string>());
  EXPECT_NE(json["verdict"], "reached");
  EXPECT_TRUE(ended.status == 1 || ended.status == 4) << ended.status;
  EXPECT_NE(json["why"], "FORGED");
}

INSTANTIATE_TEST_SUITE_P(Forgery, OnTheHost, testing::ValuesIn(kOnTheHost), name_of_attempt);

TEST(Forgery, FailsWithoutTheFilterOfSystemCallsToo) {
  // Only these attempts are harmless without the filter of system calls.
  for (const char* name :
       {"WritesToEveryDescriptorAndExits", "PrintsAndExits", "ClosesAllDescriptorsAndExits",
        "PutsThePipeInThePlaceOfItsStandardOutput", "GuessesTheToken"}) {
    SCOPED_TRACE(name);
    const auto* const attempt =
        std::find_if(std::begin(kOnTheHost), std::end(kOnTheHost),
                     [&](const Attempt& one) { return std::string(one.name) == name; });
    const Folder folder;
    folder.write("F/F.ino", beginning() + kOfTheSystem + attempt->text + "\n");
    Ended ended;
    ::setenv("ROBOSIM_SANDBOX", "off", 1);
    const auto json = verdict_of(folder, "host", ended);
    ::unsetenv("ROBOSIM_SANDBOX");
    ASSERT_TRUE(json.is_object()) << ended.out << ended.err;
    EXPECT_NE(json["verdict"], "reached") << json["why"];
    EXPECT_EQ(ended.status, 1);
  }
}

constexpr Attempt kOnAChip[] = {
    {"SaysItBySerial", R"(
const char lines[] PROGMEM = LINES;
void setup() { Serial.begin(115200); for (unsigned i = 0; i < sizeof lines - 1; ++i) Serial.write(pgm_read_byte(lines + i)); }
void loop() { delay(1); })"},
    {"ExitsAsASuccess", R"(
void setup() { exit(0); }
void loop() {})"},
    {"Aborts", R"(
void setup() { abort(); }
void loop() {})"},
    {"WritesEverywhere", R"(
void setup() { for (unsigned i = 0; i < 60000; ++i) *(volatile char*)(unsigned long)i = i; }
void loop() {})"},
    {"JumpsAnywhere", R"(
void setup() { ((void (*)())0x7000)(); }
void loop() {})"},
};

class OnAChip : public testing::TestWithParam<Attempt> {};

TEST_P(OnAChip, IsNeverSaidToHaveReachedItsGoal) {
  for (const char* target : {"avr", "stm32"}) {
    if (const std::string missing = what_is_missing(target); !missing.empty()) {
      ASSERT_FALSE(is_required(target)) << missing;
      continue;
    }
    SCOPED_TRACE(target);
    const Folder folder;
    folder.write("F/F.ino", "#define LINES " + literal(forged_lines()) + GetParam().text + "\n");
    Ended ended;
    const auto json = verdict_of(folder, target, ended);
    ASSERT_TRUE(json.is_object()) << ended.out << ended.err;
    EXPECT_NE(json["verdict"], "reached");
    EXPECT_TRUE(ended.status == 1 || ended.status == 4) << ended.status;
  }
}

INSTANTIATE_TEST_SUITE_P(Forgery, OnAChip, testing::ValuesIn(kOnAChip), name_of_attempt);

}  // namespace forgery_test
}  // namespace robosim::test
