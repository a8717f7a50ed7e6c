// Tests that crashes of a sketch on the host are reported with their reason and line.
#include <fmt/format.h>

#include "sim/base/error.h"
#include "sim/base/program_sandbox.h"
#include "sim/exec/host/asan_build.h"
#include "sim/exec/host/image_file.h"
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::crash_test {

using testing::HasSubstr;

class CrashTest : public HostTest {
 protected:
  /// Returns the crash of a sketch whose setup() executes `call`. `line_2` is the sketch's second line.
  Crash crash(const std::string& line_2, const std::string& call = "faulty();") {
    start("volatile int zero, n;\n" + line_2 + "\nvoid setup() {\n  delay(5);\n  " + call +
          "\n}\nvoid loop() {}\n");
    run(kSecond);
    if (!host_->crash()) return {"none", {}};
    return *host_->crash();
  }

  void expect(const Crash& crash, const char* reason, const char* function, int line) {
    EXPECT_THAT(crash.reason, HasSubstr(reason));
    EXPECT_EQ(crash.where.function, function);
    EXPECT_EQ(crash.where.file, "Test.ino");
    EXPECT_EQ(crash.where.line, line);
  }
};

TEST_F(CrashTest, NullPointer) {
  expect(crash("void faulty() { volatile int* p = nullptr; *p = 1; }"), "of address 0x0 (null pointer)",
         "faulty", 2);
}

TEST_F(CrashTest, NullPointerToAFunction) {
  expect(crash("void (*volatile hook)(); void faulty() { hook(); ++n; }"),
         "jump to address 0x0 (null pointer)", "faulty", 2);
}

TEST_F(CrashTest, DeepRecursion) {
  expect(crash("int deep(int k) { volatile char b[64]; b[0] = k; return deep(k + 1) + b[0]; }", "deep(1);"),
         "stack overflow (deep recursion?)", "deep", 2);
  EXPECT_EQ(crash("int deep(int k) { volatile char b[64]; b[0] = k; return k < 9 ? deep(k + 1) + b[0] : 0; }",
                  "deep(1);")
                .reason,
            "none");
}

TEST_F(CrashTest, AWildPointer) {
#if defined(__x86_64__)
  const char* const reason = "invalid pointer";
#else  // unlike x86-64, other processors report even an address that is not canonical
  const char* const reason = "of address 0x";
#endif
  expect(crash("void faulty() { *(volatile char*)0x123456789ABCDEFull = 1; }"), reason, "faulty", 2);
}

TEST_F(CrashTest, Abort) {
  expect(crash("void faulty() { if (zero == 0) abort(); }"), "abort() called", "faulty", 2);
}

TEST_F(CrashTest, AFailedAssertion) {
  const std::string text = "#include <assert.h>\nvoid faulty() { assert(n == zero); }";
  EXPECT_EQ(crash(text).reason, "none");
  expect(crash("#include <assert.h>\nvoid faulty() { assert(n > zero); }"), "assert() failed", "faulty", 3);
}

#if defined(__x86_64__)  // ud2 is an instruction of this processor
TEST_F(CrashTest, AnInstructionThatDoesNotExist) {
  expect(crash("void faulty() { asm volatile(\"ud2\"); }"), "an instruction that does not exist", "faulty",
         2);
  EXPECT_EQ(crash("void faulty() { asm volatile(\"nop\"); }").reason, "none");
}
#endif

TEST_F(CrashTest, InsideALibraryFunctionTheSketchsLineIsNamed) {
  expect(crash("char* volatile target; void faulty() { strcpy(target, \"hello\"); ++n; }"), "null pointer",
         "faulty", 2);
}

// The sketch overwrites a pointer of the executor. A write past the end of an array can have the same effect.
TEST_F(CrashTest, InTheExecutorWhereTheSketchHasSpoiltWhatItIsCalledWith) {
#ifdef ROBOSIM_ASAN
  GTEST_SKIP() << "the sanitizers of Robosim itself end the process first";
#endif
  const Crash found = crash(
      "namespace robosim { class FirmwarePort; namespace host { extern FirmwarePort* board; } } void* "
      "fake[64]; void "
      "faulty() "
      "{ fake[0] = *(void**)robosim::host::board; robosim::host::board = (robosim::FirmwarePort*)fake; "
      "digitalWrite(13, HIGH); ++n; }");
  // The reported reason depends on the processor.
  EXPECT_NE(found.reason, "none");
  expect(found, "", "faulty", 2);
}

TEST_F(CrashTest, InAnInterruptHandler) {
  expect(
      crash("ISR(TIMER1_OVF_vect) { if (!zero) abort(); }", "TCCR1B = 1; TIMSK1 = _BV(TOIE1); while (true);"),
      "abort() called", "__vector_13", 2);
}

TEST_F(CrashTest, AnInterruptWithoutHandler) {
  const Crash found = crash("", "TCCR1B = 1; TIMSK1 = _BV(OCIE1B); while (true);");
  EXPECT_THAT(found.reason, HasSubstr("TIMER1_COMPB_vect"));
  EXPECT_EQ(found.where.line, 5);
}

TEST_F(CrashTest, InAConstructorOfAStaticObject) {
  expect(crash("struct Early { Early() { if (!zero) abort(); } } early;", ""), "abort() called",
         "Early::Early", 2);
}

TEST_F(CrashTest, ACrashedFirmwareStaysAsItIsUntilItIsSwitchedOnAgain) {
  start(R"(#include <EEPROM.h>
volatile int zero;
void setup() { Serial.begin(115200); int runs = EEPROM.read(0) + 1; EEPROM.write(0, runs); Serial.println((uint8_t)runs); pinMode(13, OUTPUT); digitalWrite(13, HIGH); abort(); }
void loop() {})");
  run(50 * kMillisecond);
  ASSERT_TRUE(host_->crash());
  EXPECT_TRUE(board().drive(13).level);
  host_->power_on(now_);
  EXPECT_FALSE(host_->crash());
  EXPECT_EQ(board().drive(13).mode, PinMode::input);
  run(50 * kMillisecond);
  EXPECT_TRUE(host_->crash());
  EXPECT_EQ(numbers(), (std::vector<long long>{0, 1}));
}

TEST_F(CrashTest, ExitIsNoCrash) {
  start(
      "void setup() { pinMode(13, OUTPUT); digitalWrite(13, HIGH); exit(0); } void loop() { digitalWrite(13, "
      "LOW); }");
  run(100 * kMillisecond);
  EXPECT_FALSE(host_->crash());
  EXPECT_EQ(host_->activity().stopped_by, "exit(0)");
  EXPECT_TRUE(board().drive(13).level);
}

TEST_F(CrashTest, TheEndOfMainIsNoCrash) {
  start("int main() { return 0; }");
  run(100 * kMillisecond);
  EXPECT_FALSE(host_->crash());
  EXPECT_EQ(host_->activity().stopped_by, "the end of main()");
  start("int main() { for (;;) delay(1); }");
  run(100 * kMillisecond);
  EXPECT_EQ(host_->activity().stopped_by, "");
}

TEST_F(CrashTest, AFileThatIsNoImageIsAnErrorOfTheUser) {
  write_file(folder_ / "firmware.so", "hello");
  HostExecutor host(*find_board("uno"), folder_ / "firmware.so");
  EXPECT_THROW(host.power_on(0), InputError);
  HostExecutor none(*find_board("uno"), folder_ / "nothing.so");
  EXPECT_THROW(none.power_on(0), InputError);
}

TEST_F(CrashTest, ManyCrashesLeaveNothingBehind) {
  start("void setup() { abort(); } void loop() {}");
  for (int cycle = 0; cycle < 300; ++cycle) {
    host_->power_on(now_);
    run(kMillisecond);
    ASSERT_TRUE(host_->crash());
    if (cycle % 50) continue;
    std::size_t mapped = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
      mapped += entry.exists() ? 1 : 0;
    EXPECT_LT(mapped, 40u);
  }
}

// An untrusted sketch controls the content of the image file, so addr2line runs in a sandbox.
TEST_F(CrashTest, TheProgramThatLooksUpLinesSeesNothingButTheImage) {
  if (!ProgramSandbox::missing().empty()) GTEST_SKIP() << ProgramSandbox::missing();
  const std::string image = build("void setup() {}\nvoid loop() {}\n").string();
  write_file(folder_ / "secret", "hunter2\n");
  std::filesystem::create_directory(folder_ / "bin");
  write_file(
      folder_ / "bin/addr2line",
      fmt::format(
          "#!/bin/sh\ncat {0}/secret\necho $ROBOSIM_TEST_SECRET >{0}/written\ntest -r {1} && echo seen "
          "$ROBOSIM_TEST_SECRET\n",
          folder_.string(), image));
  std::filesystem::permissions(folder_ / "bin/addr2line", std::filesystem::perms::owner_all);
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", fmt::format("{}:{}", (folder_ / "bin").string(), path).c_str(), 1);
  ::setenv("ROBOSIM_TEST_SECRET", "hunter2", 1);
  const std::string lines = ask_addr2line(image, {1});
  ::unsetenv("ROBOSIM_TEST_SECRET");
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(lines, "seen\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "written"));
}

}  // namespace robosim::exec::crash_test
