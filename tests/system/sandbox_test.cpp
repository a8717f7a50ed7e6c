// What a sketch for the host may not do: it is code of this machine, and whoever runs it need not know who
// wrote it. docs/security.md says what is held off.
#include <stdlib.h>

#include "sim/exec/host/confinement.h"
#include "tests/system/command.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Sandbox : public testing::Test {
 protected:
  void SetUp() override {
    const std::string missing = exec::why_not_confined();
    if (!missing.empty()) GTEST_SKIP() << "nothing is confined here: " << missing;
  }

  wire::RunRequest request_of_text(const std::string& text) {
    folder_.write("Guest/Guest.ino", text);
    build::Request sketch{folder_ / "Guest", *find_board("uno")};
    sketch.warnings = build::Warnings::none;
    wire::RunRequest request;
    request.image = build::build(sketch).image;
    request.map = grid::find_map("oval");
    request.robot = "uno5";
    request.for_ns = 3'000'000'000;
    return request;
  }
  wire::RunResult run_text(const std::string& text) { return runner_of("host").run(request_of_text(text)); }

  Folder folder_;
};

struct Refused {
  const char* declaration;
  const char* call;
  const char* subject;  ///< as the verdict has it
};

constexpr Refused kRefused[] = {
    {"int open(const char*, int, ...);", "open(\"/etc/passwd\", 0)", "openat (files)"},
    {"int creat(const char*, unsigned);", "creat(\"/tmp/robosim-was-here\", 0644)", "(files)"},
    {"int unlink(const char*);", "unlink(\"/tmp/robosim-was-here\")", "(files)"},
    {"void* opendir(const char*);", "opendir(\"/\")", "openat (files)"},
    {"int access(const char*, int);", "access(\"/etc/passwd\", 4)", "(files)"},
    {"int socket(int, int, int);", "socket(2, 1, 0)", "socket (the network)"},
    {"int fork();", "fork()", "(processes and threads)"},
    {"int system(const char*);", "system(\"touch /tmp/robosim-was-here\")", ""},
    {"int execl(const char*, const char*, ...);", "execl(\"/bin/sh\", \"sh\", (char*)0)",
     "execve (programs)"},
    {"int getppid(); int kill(int, int);", "kill(-1, 9)", "kill (signals to others)"},
    {"long ptrace(int, ...);", "ptrace(16, 1, 0, 0)", "ptrace (processes and threads)"},
    {"int setitimer(int, const void*, void*); long zeros[8];", "setitimer(1, zeros, 0)",
     "setitimer (time outside of the simulation)"},
    {"unsigned sleep(unsigned);", "sleep(1000)", "(time outside of the simulation)"},
    {"int prctl(int, ...);", "prctl(1, 0)", "prctl (the operating system)"},
    {"int setsid();", "setsid()", "setsid (the operating system)"},
    {"void (*signal(int, void (*)(int)))(int);", "signal(31, (void (*)(int))1)", "rt_sigaction (signals)"},
    {"int mprotect(void*, unsigned long, int); long place[2048];",
     "mprotect((void*)(((unsigned long)place + 4095) & ~4095ul), 4096, 7)", "mprotect (memory)"},
};

/// One sketch that does each of them when it is told to: a line each, from the third on.
std::string does_all() {
  std::string text = "extern \"C\" {", cases;
  for (std::size_t i = 0; i < std::size(kRefused); ++i) {
    text += std::string(" ") + kRefused[i].declaration;
    cases += std::string("    case '") + static_cast<char>('a' + i) + "': " + kRefused[i].call + "; break;\n";
  }
  return text + " }\nvoid setup() { Serial.begin(9600); } void loop() { switch (Serial.read()) {\n" + cases +
         "  }\n  delay(1);\n}\n";
}

TEST_F(Sandbox, RefusesASketchWhatIsNoneOfItsBusinessAndNamesTheCallAndTheLine) {
  auto request = request_of_text(does_all());
  for (std::size_t i = 0; i < std::size(kRefused); ++i) {
    const Refused& what = kRefused[i];
    SCOPED_TRACE(what.call);
    request.script = std::string("at 100ms send ") + static_cast<char>('a' + i);
    const auto r = runner_of("host").run(request);
    EXPECT_EQ(r.verdict, "crashed");
    EXPECT_EQ(r.status, 1);
    EXPECT_EQ(r.crash ? r.crash->check : "", "sandbox");
    EXPECT_THAT(r.why, AllOf(HasSubstr("the sandbox refuses its system call"), HasSubstr(what.subject),
                             HasSubstr("Guest.ino:" + std::to_string(3 + i))));
  }
  EXPECT_FALSE(std::filesystem::exists("/tmp/robosim-was-here"));
}

TEST_F(Sandbox, HoldsBeforeTheFirstConstructor) {
  const auto r = run_text(
      "extern \"C\" int open(const char*, int, ...);\n"
      "struct Early { Early() {\n"
      "  open(\"/etc/passwd\", 0);\n"
      "} } early;\nvoid setup() {}\nvoid loop() {}\n");
  EXPECT_THAT(r.why, AllOf(HasSubstr("openat (files)"), HasSubstr("Guest.ino:3")));
}

TEST_F(Sandbox, HoldsWhileTheImageIsBeingLoaded) {
  // The loader calls a function of this name, before the firmware has a clock to count its blocks with.
  const auto r = run_text(
      "extern \"C\" int open(const char*, int, ...);\n"
      "extern \"C\" __attribute__((no_sanitize_coverage)) void _init() { open(\"/etc/passwd\", 0); }\nvoid "
      "setup() {}\nvoid loop() {}\n");
  EXPECT_EQ(r.verdict, "crashed");
  EXPECT_THAT(r.why, HasSubstr("the sandbox refuses a system call"));
}

TEST_F(Sandbox, HoldsAfterAPowerCycleWhichLoadsTheImageAgain) {
  auto request = request_of_text(
      "#include <EEPROM.h>\nextern \"C\" int open(const char*, int, ...);\nvoid setup() {\n"
      "  if (EEPROM.read(0) == 1) open(\"/etc/passwd\", 0);\n  EEPROM.write(0, 1);\n}\nvoid loop() {}\n");
  request.script = "at 1s power off\nat 1500ms power on\n";
  const auto r = runner_of("host").run(request);
  EXPECT_THAT(r.why, AllOf(HasSubstr("openat (files)"), HasSubstr("Guest.ino:4")));
  EXPECT_GT(r.time_s, 1.4);
}

TEST_F(Sandbox, LeavesNoDescriptorToReadOrWrite) {
  auto request = request_of_text(
      "extern \"C\" { long read(int, void*, unsigned long); long write(int, const void*, unsigned long); }\n"
      "char text[64];\n"
      "void setup() { Serial.begin(9600); } void loop() {\n"
      "  const int what = Serial.read();\n"
      "  if (what >= 'a' && what < 'n') { if (read(what - 'a', text, 63) > 0) Serial.print(text); "
      "Serial.print('r'); }\n"
      "  if (what >= 'n') { write(what - 'n', \"{}\\n\", 3); Serial.print('w'); }\n  delay(1);\n}\n");
  const auto ask = [&](int letter) {
    request.script = std::string("at 100ms send ") + static_cast<char>(letter);
    return runner_of("host").run(request);
  };
  for (int fd = 0; fd < 12; ++fd) {
    SCOPED_TRACE(fd);
    const auto reads = ask('a' + fd), writes = ask('n' + fd);
    if (fd <= 2 || fd == exec::kImageFd) {  // nothing at all, or closed
      EXPECT_EQ(reads.serial, "r") << reads.why;
      EXPECT_EQ(writes.serial, "w") << writes.why;
    } else {
      EXPECT_THAT(reads.why, AllOf(HasSubstr("read (descriptors)"), HasSubstr("Guest.ino:5")));
      EXPECT_THAT(writes.why, AllOf(HasSubstr("write (descriptors)"), HasSubstr("Guest.ino:6")));
    }
  }
}

// All runs of a runner load it from the same memory.
TEST_F(Sandbox, LetsNoSketchChangeItsImageOrMissIt) {
  auto request = request_of_text(
      "#include <EEPROM.h>\nextern \"C\" { long write(int, const void*, unsigned long); int close(int);\n"
      "int dup3(int, int, int); int ftruncate(int, long); void* mmap(void*, unsigned long, int, int, int, "
      "long); }\n"
      "void setup() {\n  Serial.begin(9600);\n  int at = 100;\n  while (dup3(at, 6, 0) < 0 && at < 110) "
      "++at;\n"
      "  Serial.print(at < 110);\n  Serial.print(write(6, \"x\", 1));\n  Serial.print(ftruncate(at, 1));\n"
      "  Serial.print(mmap(0, 4096, 3, 1, 6, 0) == (void*)-1);\n"
      "  if (EEPROM.read(0) == 1) close(at);\n  EEPROM.write(0, 1);\n}\nvoid loop() {}\n");
  request.script = "at 1s power off\nat 1500ms power on\nat 2s power off\nat 2500ms power on\n";
  for (int run = 0; run < 2; ++run) {
    const auto r = runner_of("host").run(request);
    EXPECT_EQ(r.verdict, "timeout") << r.why;
    EXPECT_EQ(r.serial, "1-1-111-1-110-1-11") << "closed, its process has a copy of its own, not at 100";
  }
}

TEST_F(Sandbox, LetsASketchPrintToNobody) {
  const auto r = run_text(
      "extern \"C\" int puts(const char*);\nvoid setup() { puts(\"{}\"); pinMode(13, OUTPUT); }\n"
      "void loop() { delay(10); }\n");
  EXPECT_EQ(r.verdict, "timeout") << r.why;
}

TEST_F(Sandbox, EndsASketchThatTakesAllMemory) {
  const auto r = run_text(
      "extern \"C\" void* mmap(void*, unsigned long, int, int, int, long);\n"
      "volatile long mapped = 0;\n"
      "void setup() {\n  Serial.begin(9600);\n"
      "  while (mmap(0, 1 << 20, 3, 0x22, -1, 0) != (void*)-1 && mapped < 4096) ++mapped;\n"
      "  Serial.print(mapped);\n}\nvoid loop() { delay(10); }\n");
  if (r.verdict == "crashed") {
    EXPECT_THAT(r.why, HasSubstr("memory"));
  } else {
    EXPECT_LE(std::stoi(r.serial), 512) << r.why;
  }
}

TEST_F(Sandbox, BlamesASketchForTheMemoryThatItsRunLacks) {
  auto request = request_of_text(
      "extern \"C\" void* mmap(void*, unsigned long, int, int, int, long);\nvoid setup() {\n"
      "  while (mmap(0, 1 << 20, 3, 0x22, -1, 0) != (void*)-1) {}\n"
      "  while (mmap(0, 4096, 3, 0x22, -1, 0) != (void*)-1) {}\n  Serial.begin(1000000);\n}\n"
      "void loop() { Serial.println(F(\"text that is to be kept, and is to be kept somewhere\")); }\n");
  request.for_ns = 60'000'000'000;
  const auto r = runner_of("host").run(request);
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(r.why, "The sketch crashed: it took more than the 512 MB of memory that it may have.");
}

TEST_F(Sandbox, EndsASketchThatGoesOnBehindClosedDescriptors) {
  const auto r = run_text(
      "extern \"C\" int close(int);\n__attribute__((no_sanitize_coverage)) void setup() {\n"
      "  for (int fd = 0; fd < 64; ++fd) close(fd);\n  for (;;) asm volatile(\"nop\");\n}\nvoid loop() {}\n");
  EXPECT_EQ(r.why, "The sketch crashed: it closed what its verdict goes through.");
}

TEST_F(Sandbox, EndsASketchThatHasSwitchedItsSignalsOff) {
  const auto r = run_text(
      "extern \"C\" { int sigfillset(void*); int sigprocmask(int, const void*, void*); }\nlong set[16];\n"
      "__attribute__((no_sanitize_coverage)) void setup() {\n"
      "  sigfillset(set);\n  sigprocmask(0, set, 0);\n  for (;;) asm volatile(\"nop\");\n}\nvoid loop() "
      "{}\n");
  EXPECT_EQ(r.why, "The sketch crashed: it loops without end inside a library function.");
}

TEST_F(Sandbox, ChangesNoRun) {
  auto request = request_of({.sketch = "PidFollower", .goal = "laps:1"});
  const auto confined = runner_of("host").run(request);
  ::setenv("ROBOSIM_SANDBOX", "off", 1);
  const auto open = client::Runner("host").run(request);
  ::unsetenv("ROBOSIM_SANDBOX");
  EXPECT_EQ(confined.trace_hash, open.trace_hash);
  EXPECT_EQ(confined.verdict, "reached");
}

}  // namespace
}  // namespace robosim::test
