// Tests the sandbox. It confines sketches on the host, because they are native code by unknown authors.
// docs/explanation/security.md lists the confined actions.
#include <fmt/format.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/personality.h>
#include <sys/syscall.h>

#include "sim/base/error.h"
#include "sim/exec/host/confinement.h"
#include "tests/system/command.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace sandbox_test {

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
    request.map = map::find_map("oval");
    request.robot = "uno5";
    request.for_ns = 3'000'000'000;
    return request;
  }
  result::RunResult run_text(const std::string& text) { return runner_of("host").run(request_of_text(text)); }

  Folder folder_;
};

struct Refused {
  const char* declaration;
  const char* call;
  const char* subject;  ///< how the verdict names the call
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
    {"void* mmap(void*, unsigned long, int, int, int, long);", "mmap(0, 4096, 3, 0x21, -1, 0)",
     "mmap (memory)"},                                        // shared memory
    {"", "mmap(0, 4096, 3, 0x122, -1, 0)", "mmap (memory)"},  // grows downwards
    {"", "mmap(0, 4096, 7, 0x2, 6, 0)", "mmap (memory)"},     // memory that is both written and executed
    {"int memfd_create(const char*, unsigned);", "memfd_create(\"code\", 0)", "memfd_create (memory)"},
    {"int madvise(void*, unsigned long, int);",
     "madvise((void*)(((unsigned long)place + 4095) & ~4095ul), 4096, 12)", "madvise (memory)"},
    {"int dup3(int, int, int);", "dup3(3, 6, 0)", "dup3 (descriptors)"},
    {"long syscall(long, ...);", "syscall(EXIT, 98)", "exit_group (the end of its process)"},
    {"long wakes[2] = {1000};", "syscall(FUTEX, place, 0, 0, wakes, 0, 0)",
     "futex (time outside of the simulation)"},
};

/// Returns one sketch that can make each of these calls on command. Each call is on its own line; the first
/// call is on line 5.
std::string does_all() {
  std::string text =
      fmt::format("#define EXIT {}\n#define FUTEX {}\nextern \"C\" {{", SYS_exit_group, SYS_futex);
  std::string cases;
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
                             HasSubstr("Guest.ino:" + std::to_string(5 + i))));
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
  // The system's loader calls _init() before the runner counts the sketch's basic blocks as time.
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
    if (fd <= 2 || fd == exec::kImageFd) {  // these descriptors are empty or closed
      EXPECT_EQ(reads.serial, "r") << reads.why;
    } else {
      EXPECT_THAT(reads.why, AllOf(HasSubstr("read (descriptors)"), HasSubstr("Guest.ino:5")));
    }
    if (fd <= 2) {
      EXPECT_EQ(writes.serial, "w") << writes.why;
    } else {
      EXPECT_THAT(writes.why, AllOf(HasSubstr("write (descriptors)"), HasSubstr("Guest.ino:6")));
    }
  }
}

// All runs of a runner load the image from the same memory.
TEST_F(Sandbox, LetsNoSketchChangeItsImageOrMissIt) {
  auto request = request_of_text(
      "#include <EEPROM.h>\nextern \"C\" { int close(int); void* mmap(void*, unsigned long, int, int, int, "
      "long); }\n"
      "void setup() {\n  Serial.begin(9600);\n"
      "  for (int fd = 6; fd < 4096; ++fd) if (close(fd) == 0) Serial.print(fd);\n"
      "  Serial.print(mmap(0, 4096, 3, 2, 6, 0) == (void*)-1);\n  EEPROM.write(0, 1);\n}\nvoid loop() {}\n");
  request.script = "at 1s power off\nat 1500ms power on\nat 2s power off\nat 2500ms power on\n";
  for (int run = 0; run < 2; ++run) {
    const auto r = runner_of("host").run(request);
    EXPECT_EQ(r.verdict, "timeout") << r.why;
    EXPECT_EQ(r.serial, "111") << "the sketch cannot close the image, and is loaded each time";
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

TEST_F(Sandbox, LoadsNoImageWhoseCodeCanBeWrittenTo) {
  const auto r = run_text(
      "asm(\".pushsection .written, \\\"awx\\\", @progbits\\nwritten: .skip 64\\n.popsection\");\n"
      "extern \"C\" __attribute__((visibility(\"hidden\"))) volatile char written[64];\n"
      "void setup() { written[0] = 1; }\nvoid loop() {}\n");
  EXPECT_EQ(r.verdict, "crashed");
  EXPECT_THAT(r.why, HasSubstr("the sandbox refuses a system call"));
}

// The kernel's limit RLIMIT_DATA does not count pages that are only read. Some kernels allocate memory for
// them.
TEST_F(Sandbox, LimitsThePagesThatASketchOnlyReads) {
  const auto r = run_text(
      "extern \"C\" void* mmap(void*, unsigned long, int, int, int, long);\n"
      "void setup() {\n  Serial.begin(9600);\n  int mapped = 0;\n"
      "  while (mmap(0, 64ul << 20, 1, 0x4022, -1, 0) != (void*)-1 && mapped < 1000) ++mapped;\n"
      "  Serial.print(mapped);\n}\nvoid loop() { delay(10); }\n");
  EXPECT_LE(std::stoi(r.serial), 4) << r.why;
}

TEST_F(Sandbox, LimitsThePagesThatASketchWritesAndThenProtects) {
  const auto r = run_text(
      "extern \"C\" { void* mmap(void*, unsigned long, int, int, int, long); int mprotect(void*, unsigned "
      "long, int); }\n"
      "void setup() {\n  Serial.begin(9600);\n  int mapped = 0;\n"
      "  for (void* p; mapped < 200 && (p = mmap(0, 4 << 20, 3, 0x22, -1, 0)) != (void*)-1; ++mapped) {\n"
      "    memset(p, 1, 4 << 20);\n    mprotect(p, 4 << 20, 1);\n  }\n"
      "  Serial.print(mapped);\n}\nvoid loop() { delay(10); }\n");
  EXPECT_LE(std::stoi(r.serial), 256 / 4) << r.why;
}

TEST_F(Sandbox, RefusesVariablesThatAreLargerThanARunsMemory) {
  EXPECT_THAT(
      [&] {
        run_text("char big[400 << 20];\nvoid setup() { memset(big, 1, sizeof big); }\nvoid loop() {}\n");
      },
      testing::ThrowsMessage<InputError>(
          HasSubstr("the sketch's variables take 401 MB: expected at most 192 MB")));
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
  EXPECT_EQ(r.why, "The sketch crashed: it took more than 192 MB of memory, which is its limit.");
}

TEST_F(Sandbox, EndsASketchThatGoesOnBehindClosedDescriptors) {
  const auto r = run_text(
      "extern \"C\" int close(int);\n__attribute__((no_sanitize_coverage)) void setup() {\n"
      "  for (int fd = 0; fd < 64; ++fd) close(fd);\n  for (;;) asm volatile(\"nop\");\n}\nvoid loop() {}\n");
  EXPECT_EQ(r.why, "The sketch crashed: it closed the pipe of its result.");
}

TEST_F(Sandbox, EndsASketchThatHasSwitchedItsSignalsOff) {
  const auto r = run_text(
      "extern \"C\" { int sigfillset(void*); int sigprocmask(int, const void*, void*); }\nlong set[16];\n"
      "__attribute__((no_sanitize_coverage)) void setup() {\n"
      "  sigfillset(set);\n  sigprocmask(0, set, 0);\n  for (;;) asm volatile(\"nop\");\n}\nvoid loop() "
      "{}\n");
  EXPECT_EQ(r.why, "The sketch crashed: it loops without end, and simulated time does not advance.");
}

TEST_F(Sandbox, NamesTheSignalThatASketchSendsItselfAndTheLine) {
  auto request = request_of_text(fmt::format(
      "#define TGKILL {}\nextern \"C\" {{ int raise(int); int getpid(); int kill(int, int); long "
      "syscall(long, ...); }}\n"
      "void setup() {{ Serial.begin(9600); }} void loop() {{\n  const int what = Serial.read();\n"
      "  if (what > 'A' && what < 'a') raise(what - 'A');\n"
      "  if (what == 'a') kill(getpid(), 19);\n  if (what == 'b') syscall(TGKILL, getpid(), getpid(), 19);\n"
      "  delay(1);\n}}\n",
      SYS_tgkill));
  const auto expect = [&](char what, int signal, int line) {
    request.script = std::string("at 100ms send ") + what;
    const auto r = runner_of("host").run(request);
    EXPECT_EQ(r.verdict, "crashed") << signal;
    EXPECT_EQ(r.status, 1) << signal;
    EXPECT_THAT(r.why, AllOf(HasSubstr(fmt::format("it sends itself signal {} (", signal)),
                             HasSubstr(fmt::format("Guest.ino:{}", line))));
    EXPECT_NEAR(r.time_s, 0.1, 0.01) << signal;
  };
  for (const int signal :
       {SIGHUP, SIGINT, SIGABRT, SIGKILL, SIGSEGV, SIGCHLD, SIGSTOP, SIGTSTP, SIGTTIN, SIGTTOU, SIGSYS})
    expect(static_cast<char>('A' + signal), signal, 5);
  expect('a', SIGSTOP, 6);
  expect('b', SIGSTOP, 7);
}

TEST_F(Sandbox, NamesASignalThatASketchSendsItselfWhileItIsLoaded) {
  for (const int signal : {SIGINT, SIGSTOP}) {
    const auto r = run_text(
        fmt::format("extern \"C\" {{ int getpid(); int kill(int, int);\n"
                    "__attribute__((no_sanitize_coverage)) void _init() {{ kill(getpid(), {}); }} }}\n"
                    "void setup() {{}}\nvoid loop() {{}}\n",
                    signal));
    EXPECT_EQ(r.verdict, "crashed");
    EXPECT_EQ(r.why, fmt::format("The sketch crashed: it sends itself signal {} ({}).", signal,
                                 ::strsignal(signal)));
  }
}

TEST_F(Sandbox, EndsASketchThatIsNeverLoaded) {
  for (const char* text : {"extern \"C\" __attribute__((no_sanitize_coverage)) void _init() { for (;;) asm "
                           "volatile(\"nop\"); }\n"
                           "void setup() {}\n",
                           "extern \"C\" { __attribute__((no_sanitize_coverage)) void* which() { for (;;) "
                           "asm volatile(\"nop\"); }\n"
                           "void one() __attribute__((ifunc(\"which\"))); }\nvoid setup() { one(); }\n"}) {
    const auto r = run_text(std::string(text) + "void loop() {}\n");
    EXPECT_EQ(r.why, "The sketch crashed: loading it takes too much processor time.");
  }
}

TEST_F(Sandbox, ShowsASketchNothingOfTheEnvironment) {
  const auto request = request_of_text(
      "extern \"C\" { char* getenv(const char*); extern char** environ; extern void* __libc_stack_end; }\n"
      "void setup() {\n  Serial.begin(9600);\n  Serial.print(getenv(\"ROBOSIM_SECRET\") ? "
      "getenv(\"ROBOSIM_SECRET\") : "
      "\"none\");\n  long* words = (long*)__libc_stack_end;\n"
      "  for (char** one = (char**)(words + *words + 2); *one; ++one) if (**one) Serial.print('!');\n}\n"
      "void loop() { delay(10); }\n");
  ::setenv("ROBOSIM_SECRET", "token", 1);
  client::Runner runner("host");
  ::unsetenv("ROBOSIM_SECRET");
  for (int run = 0; run < 2; ++run) EXPECT_EQ(runner.run(request).serial, "none");
}

/// Sketch code that calls a function for each mapped page near the heap, the C library and the stack. A
/// system call fails for pages that are not mapped.
constexpr const char* kLooksAtAllMemory = R"(
extern "C" { void* sbrk(long); int getpid(); long syscall(long, ...); int* __errno_location(); extern void* __libc_stack_end; }
#define QUIET __attribute__((no_sanitize_coverage))
QUIET bool is_there(const char* page) { syscall(SIGPROCMASK, 99, page, 0, 8); return *__errno_location() != 14; }
template <class Look> QUIET void look_around(const void* place, long before, long after, Look look) {
  char* const middle = (char*)((unsigned long)place & ~4095ul);
  for (char* page = middle - before; page < middle + after; page += 4096) if (is_there(page)) look(page);
}
template <class Look> QUIET void look_everywhere(Look look) {
  look_around(sbrk(0), 64l << 20, 0, look);
  look_around((void*)&getpid, 256l << 20, 256l << 20, look);
  look_around(__libc_stack_end, 1l << 20, 65536, look);
}
)";

TEST_F(Sandbox, ShowsASketchNothingOfTheProgramThatRanBefore) {
  const std::string mark = "robosim-marker-1";
  std::string shifted = mark;  // the searching sketch must not find its own text
  for (char& c : shifted) c = static_cast<char>(c + 1);
  const auto before = request_of_text(
      "#define FOUR(x) x x x x\nextern const char text[] = FOUR(FOUR(FOUR(FOUR(FOUR(\"" + mark +
      "\")))));\nvoid setup() { Serial.begin(115200); Serial.println(text[millis()]); }\nvoid loop() { "
      "delay(10); }\n");
  const auto looks = request_of_text(
      fmt::format("#define SIGPROCMASK {}\n", SYS_rt_sigprocmask) + kLooksAtAllMemory + "char wanted[] = \"" +
      shifted +
      "\";\nint found = 0, pages = 0;\nQUIET void look_at(const char* page) {\n  ++pages;\n"
      "  for (int i = 0; i < 4080; ++i) {\n    int j = 0;\n"
      "    while (j < 16 && page[i + j] == wanted[j] - 1) ++j;\n    found += j == 16;\n  }\n}\n"
      "void setup() {\n  Serial.begin(115200);\n  look_everywhere(look_at);\n"
      "  Serial.print(pages > 500 ? \"found \" : \"saw nothing \");\n  Serial.print(found);\n}\n"
      "void loop() { delay(10); }\n");
  client::Runner runner("host");
  for (int run = 0; run < 2; ++run) {
    EXPECT_EQ(runner.run(before).serial, "r\r\n");
    EXPECT_EQ(runner.run(looks).serial, "found 0");
  }
}

// A sketch shares its progress and pending events with its runner, in memory.
TEST_F(Sandbox, BelievesNothingOfWhatASketchWritesIntoSharedMemory) {
  for (const char* fill : {"255", "0", "page[i] + 1"}) {
    SCOPED_TRACE(fill);
    auto request = request_of_text(
        fmt::format("#define SIGPROCMASK {}\n#define FILL {}\n", SYS_rt_sigprocmask, fill) +
        kLooksAtAllMemory +
        "extern \"C\" void* mremap(void*, unsigned long, unsigned long, int, ...);\n"
        "QUIET void look_at(char* page) {\n"  // only shared memory can be mapped twice
        "  if (mremap(page, 0, 4096, 1) == (void*)-1) return;\n"
        "  for (int i = 0; i < 4096; ++i) page[i] = FILL;\n}\n"
        "void setup() { pinMode(13, OUTPUT); }\nvoid loop() {\n  digitalWrite(13, millis() & 1);\n  "
        "delay(1);\n"
        "  if (millis() == 500) {\n    look_everywhere(look_at);\n    *(volatile int*)8 = 1;\n  }\n}\n");
    for (const bool batches : {false, true}) {
      request.batches = request.pins = request.notes = batches;
      request.samples_every_ns = batches ? 1'000'000 : 0;
      const auto r = runner_of("host").run(request, [](const wire::Event&) {});
      EXPECT_EQ(r.verdict, "crashed");
      EXPECT_EQ(r.status, 1) << r.why;
      EXPECT_GE(r.time_s, 0.0);
      EXPECT_LE(r.time_s, 3.0);
    }
  }
}

TEST_F(Sandbox, EndsASketchThatSaysAgainAndAgainThatItHasNotBegun) {
  const auto r = run_text(
      fmt::format("#define SIGPROCMASK {}\n", SYS_rt_sigprocmask) + kLooksAtAllMemory +
      "extern \"C\" void* mremap(void*, unsigned long, unsigned long, int, ...);\n"
      "long long* shared[4096]; int count = 0;\n"
      "QUIET void look_at(char* page) {\n"
      "  if (count < 4096 && mremap(page, 0, 4096, 1) != (void*)-1) shared[count++] = (long long*)page;\n}\n"
      "QUIET void forge() {\n  look_everywhere(look_at);\n"
      "  for (;;)\n    for (int i = 0; i < count; ++i) *(volatile long long*)shared[i] = -2;\n}\n"
      "void setup() {}\nvoid loop() {\n  delay(1);\n  if (millis() == 500) forge();\n}\n");
  EXPECT_EQ(r.verdict, "crashed") << r.why;
  EXPECT_THAT(r.why, HasSubstr("it loops"));
}

TEST_F(Sandbox, LooksUpNoLineForLongerThanItMay) {
  // This mangled name of nested pairs expands to gigabytes of text.
  std::string name = "_Z1f1PI1AS0_E";
  for (int i = 1; i < 33; ++i) {
    const std::string digit(1, static_cast<char>(i < 10 ? '0' + i : 'A' + i - 10));
    name += "S_IS" + digit + "_S" + digit + "_E";
  }
  const auto r = run_text("void crash() asm(\"" + name +
                          "\");\n__attribute__((noinline)) void crash() { *(volatile int*)8 = 1; }\n"
                          "void setup() { crash(); delay(1); }\nvoid loop() {}\n");
  EXPECT_EQ(r.verdict, "crashed");
  EXPECT_THAT(r.why, HasSubstr("write of address 0x8"));
  EXPECT_FALSE(r.crash && r.crash->where.line > 0) << "the line was looked up";
}

bool kernel_allows_fixed_addresses() {
  const int before = ::personality(0xffffffff);
  if (::personality(static_cast<unsigned long>(before) | ADDR_NO_RANDOMIZE) < 0) return false;
  ::personality(static_cast<unsigned long>(before));
  return true;
}

TEST_F(Sandbox, ShowsASketchTheSameAddressesInEachRun) {
  if (!kernel_allows_fixed_addresses()) GTEST_SKIP() << "the kernel refuses fixed addresses here";
  const auto request = request_of_text(
      "extern \"C\" int getpid();\nint global;\n"
      "void show(const void* place) { unsigned long n = (unsigned long)place;\n"
      "  Serial.print((unsigned)(n >> 31 >> 1)); Serial.print(' '); Serial.println((unsigned)n); }\n"
      "void setup() {\n  Serial.begin(115200);\n  int local;\n"
      "  show(&global); show(&local); show(new int); show((void*)&setup); show((void*)&getpid);\n"
      "}\nvoid loop() { delay(10); }\n");
  const result::RunResult first = client::Runner("host").run(request);
  client::Runner runner("host");
  for (int run = 0; run < 3; ++run) {
    const result::RunResult again = runner.run(request);
    EXPECT_EQ(again.serial, first.serial);
    EXPECT_EQ(again.trace_hash, first.trace_hash);
  }
}

// Only on x86-64: elsewhere, the unwritten stack contains the C library's random canary.
#ifdef __x86_64__
TEST_F(Sandbox, ShowsASketchTheSameUnwrittenStackInEachCommand) {
  if (!kernel_allows_fixed_addresses()) GTEST_SKIP() << "the kernel refuses fixed addresses here";
  const auto request = request_of_text(
      "__attribute__((noinline)) void show_rest() {\n"
      "  volatile unsigned char rest[512]; unsigned sum = 0;\n"
      "  for (unsigned char byte : rest) sum = sum * 31 + byte;\n"
      "  Serial.println(sum); }\n"
      "void setup() { Serial.begin(115200); Serial.println(1.5); show_rest(); delay(10); show_rest(); }\n"
      "void loop() { delay(10); }\n");
  const std::string first = client::Runner("host").run(request).serial;
  for (int run = 0; run < 3; ++run) EXPECT_EQ(client::Runner("host").run(request).serial, first);
}
#endif

TEST_F(Sandbox, ChangesNoRun) {
  auto request = request_of({.sketch = "PidFollower", .goal = "laps:1"});
  const auto confined = runner_of("host").run(request);
  ::setenv("ROBOSIM_SANDBOX", "off", 1);
  const auto open = client::Runner("host").run(request);
  ::unsetenv("ROBOSIM_SANDBOX");
  EXPECT_EQ(confined.trace_hash, open.trace_hash);
  EXPECT_EQ(confined.verdict, "reached");
}

}  // namespace sandbox_test
}  // namespace robosim::test
