// Tests sketches on the emulated STM32F103: exceptions, sleep, time, and every kind of crash.

#include <utility>

#include "tests/unit/exec_stm32/chip_fixture.h"

namespace robosim::exec::chip_test {

using testing::AllOf;
using testing::HasSubstr;

TEST_F(Stm32ChipTest, ASilentSketchHangsThoughAnInterruptIsEnabledIfTheyAreOffForGood) {
  const std::string begins =
      "volatile int n;\nvoid count() { ++n; }\nvoid setup() {\n"
      "  attachInterrupt(digitalPinToInterrupt(2), count, CHANGE);\n";
  const auto hangs = [&](const std::string& loop) {
    start(begins + "}\nvoid loop() { " + loop + " }\n");
    run(3 * kSecond);
    return chip_->hangs();
  };
  EXPECT_TRUE(hangs("noInterrupts(); for (;;);"));
  EXPECT_FALSE(hangs("for (;;);")) << "an edge may come";
  EXPECT_FALSE(hangs("for (;;) { noInterrupts(); for (volatile int i = n; i < 30000; i++); interrupts(); }"))
      << "interrupts are off most of the time, but not always";
}

TEST_F(Stm32ChipTest, PrintsNumbersOfItsOwnWidths) {
  EXPECT_EQ(output("void setup() { Serial.begin(115200); Serial.println(-1, HEX); Serial.println(1.5, 3);\n"
                   "Serial.println(sizeof(int)); char t[16]; dtostrf(-2.345, 8, 2, t); Serial.println(t);\n"
                   "Serial.println(100 / (int)(millis() - millis())); Serial.println(String(\"a\") + 7); }\n"
                   "void loop() {}\n"),
            "FFFFFFFF\r\n1.500\r\n4\r\n   -2.35\r\n0\r\na7\r\n");
}

TEST_F(Stm32ChipTest, DelaysLastTheirTimeAtBothClocks) {
  // The function calls make the period longer than the sum of the delays. A call takes nine times as long at
  // 8 MHz as at 72 MHz.
  for (const auto& [board, calls_ns] : {std::pair{"bluepill", 10e3}, std::pair{"bluepill8", 80e3}}) {
    board_name_ = board;
    start(
        "void setup() { pinMode(7, OUTPUT); }\n"
        "void loop() { digitalWrite(7, HIGH); delay(3); digitalWrite(7, LOW); delayMicroseconds(500); }\n");
    struct Edges : PinWatcher {
      void pin_changed(Pin, const PinDrive& drive, SimTime t) override {
        if (drive.level) rises.push_back(t);
      }
      std::vector<SimTime> rises;
    } edges;
    chip_->board().watch(7, edges);
    run(100 * kMillisecond);
    ASSERT_GT(edges.rises.size(), 20u);
    const double period = static_cast<double>(edges.rises[20] - edges.rises[10]) / 10;
    EXPECT_GT(period, 3.5e6) << board;
    EXPECT_LT(period, 3.5e6 + calls_ns) << board;
  }
}

TEST_F(Stm32ChipTest, AnInterruptPreemptsAndReturnsToTheVeryInstruction) {
  // Interrupts by SysTick and by a timer must not change the checksum of a long computation.
  const std::string sum =
      "uint32_t work() { uint32_t h = 1; double d = 1; for (uint32_t i = 0; i < 3000; ++i) { h = h * 31 + i "
      "/ "
      "(h % 7 + 1); if (h & 1) h ^= i; else h += i << 3; d = d * 1.0001 + h % 5; } return h + (uint32_t)d; "
      "}\n";
  const std::string quiet =
      output(sum +
             "void setup() { Serial.begin(115200); noInterrupts(); uint32_t h = work(); "
             "interrupts(); Serial.println(h); }\nvoid loop() {}\n");
  const std::string busy =
      output(sum +
             "void setup() { Serial.begin(115200); tone(11, 30000); uint32_t h = work(); noTone(11);\n"
             "Serial.println(h); }\nvoid loop() {}\n");
  EXPECT_EQ(busy, quiet);
  EXPECT_GT(quiet.size(), 3u);
}

// Defines three exception handlers, which log that they run. busy() takes so long that the handlers can run
// meanwhile.
const char* const kHandlers =
    "#include \"hal/stm32/registers.h\"\nusing namespace robosim::stm32;\nString log_;\n"
    "void busy() { for (volatile int i = 0; i < 50; ++i); }\n"
    "extern \"C\" void SVC_Handler() { log_ += 's'; }\n"
    "extern \"C\" void PendSV_Handler() { log_ += 'p'; store(kNvicIspr, 1u << kIrqTim3); busy(); log_ += "
    "'P'; "
    "}\n"
    "extern \"C\" void TIM3_IRQHandler() { log_ += 't'; }\n"
    "constexpr Address kShpr3 = kScbShpr1 + 8, kIprOfTim3 = kNvicIpr + kIrqTim3 / 4 * 4;\n";

TEST_F(Stm32ChipTest, FaultmaskHoldsAnInterruptBackThatStirAsksFor) {
  EXPECT_EQ(output(std::string(kHandlers) +
                   "void setup() { Serial.begin(115200); enable_irq(kIrqTim3);\n"
                   "  asm volatile(\"cpsid f\"); store(kNvicStir, kIrqTim3); busy(); log_ += '.';\n"
                   "  asm volatile(\"cpsie f\"); busy(); Serial.print(log_); }\nvoid loop() {}\n"),
            ".t");
}

TEST_F(Stm32ChipTest, AHandlerInterruptsWhatRunsOnTheProcessStackAndReturnsToIt) {
  EXPECT_EQ(
      output(
          "#include \"hal/stm32/registers.h\"\nusing namespace robosim::stm32;\n"
          "uint32_t stack_[128], psp_, return_, within_;\n"
          "extern \"C\" void PendSV_Handler() {\n"
          "  asm volatile(\"mrs %0, psp\" : \"=r\"(psp_)); return_ = (uint32_t)__builtin_return_address(0); "
          "}\n"
          "void setup() { Serial.begin(115200); noInterrupts(); uint32_t control;\n"
          "  asm volatile(\"msr psp, %2\\n movs r3, #2\\n msr control, r3\\n isb\\n str %3, [%4]\\n cpsie "
          "i\\n\"\n"
          "    \"isb\\n cpsid i\\n mov %0, sp\\n mrs %1, control\\n movs r3, #0\\n msr control, r3\\n isb\"\n"
          "    : \"=&r\"(within_), \"=&r\"(control)\n"
          "    : \"r\"(stack_ + 128), \"r\"(kPendSvSet), \"r\"(kScbIcsr) : \"r3\", \"memory\");\n"
          "  interrupts(); Serial.print((uint32_t)(stack_ + 128) - psp_); Serial.print(' ');\n"
          "  Serial.print(return_, HEX); Serial.print(' '); Serial.print(control); Serial.print(' ');\n"
          "  Serial.print((uint32_t)(stack_ + 128) - within_); }\nvoid loop() {}\n"),
      "32 FFFFFFFD 2 0");
}

TEST_F(Stm32ChipTest, AHigherPriorityInterruptsALowerOneAndNotTheOtherWayRound) {
  EXPECT_EQ(output(std::string(kHandlers) +
                   "void setup() { Serial.begin(115200); enable_irq(kIrqTim3);\n"
                   "  store(kShpr3, 0x00F00000);  // PendSV low, TIM3 high\n"
                   "  store(kScbIcsr, kPendSvSet); busy(); log_ += ' ';\n"
                   "  store(kShpr3, 0); store(kIprOfTim3, 0xF0F0F0F0);  // the other way round\n"
                   "  store(kScbIcsr, kPendSvSet); busy();\n"
                   "  asm volatile(\"svc 0\"); Serial.println(log_); }\nvoid loop() {}\n"),
            "ptP pPts\r\n");
}

TEST_F(Stm32ChipTest, WhatIsMaskedWaitsUntilItIsAllowed) {
  EXPECT_EQ(output(std::string(kHandlers) +
                   "void setup() { Serial.begin(115200); enable_irq(kIrqTim3); noInterrupts();\n"
                   "  store(kNvicIspr, 1u << kIrqTim3); busy(); log_ += 'a'; interrupts(); log_ += 'b';\n"
                   "  store(kIprOfTim3, 0x40404040); asm volatile(\"msr basepri, %0\" :: \"r\"(0x40));\n"
                   "  store(kNvicIspr, 1u << kIrqTim3); busy(); log_ += 'c';\n"
                   "  asm volatile(\"msr basepri, %0\" :: \"r\"(0)); log_ += 'd';\n"
                   "  Serial.println(log_); }\nvoid loop() {}\n"),
            "atbctd\r\n");
}

TEST_F(Stm32ChipTest, ASleepWithInterruptsOffEndsWithoutTheHandler) {
  EXPECT_EQ(output("void setup() { Serial.begin(115200); uint32_t t = millis(); noInterrupts();\n"
                   "  asm volatile(\"wfi\"); bool same = millis() == t; interrupts();\n"
                   "  asm volatile(\"nop\"); Serial.print(same); Serial.println(millis() - t); }\n"
                   "void loop() {}\n"),
            "11\r\n");
}

TEST_F(Stm32ChipTest, EveryFaultIsToldWithItsReasonAndPlace) {
  struct Case {
    const char* statement;
    const char* reason;
  };
  for (const Case& c :
       {Case{"n = *(volatile int*)0x20008000;", "read of address 0x20008000, where the chip has no memory"},
        Case{"n = *(volatile int*)0x0801FC00;", "read of address 0x0801FC00, after the 64 KB of flash"},
        Case{"*(volatile int*)0x60000000 = 1;", "write to address 0x60000000"},
        Case{"*(volatile int*)0 = 1;", "write to address 0x00000000 (null pointer)"},
        Case{"*(volatile int*)0x08000400 = 1;", "write to flash at 0x08000400"},
        Case{"asm volatile(\".short 0xDE00\");", "illegal instruction 0xDE00"},
        Case{"asm volatile(\"bkpt 1\");", "breakpoint instruction"},
        Case{"((void (*)())0x30000001)(); n = 1;",
             "call through a wrong function pointer to address 0x30000000"},
        Case{"asm volatile(\"ldr r0, =0x30000001\\n bx r0\\n .ltorg\" ::: \"r0\");",
             "jump to address 0x30000000, where there is no code"},
        Case{"asm volatile(\"ldr lr, =0x30000001\\n bx lr\\n .ltorg\" ::: \"lr\");",
             "return to address 0x30000000, where there is no code (the return address on the stack was "
             "overwritten)"},
        Case{"*(volatile int*)0xE000ED14 |= 16; n = 100 / n;",
             "division by zero, which is a fault because the sketch has set DIV_0_TRP in SCB_CCR"},
        Case{"*(volatile int*)0x40005C40 = 1;",
             "write of 0x1 to register 0x40005C40 (USB), which Robosim does not model"},
        Case{"n = *(volatile int*)0x40006408;", "read of register 0x40006408 (CAN1)"}}) {
    const auto& crash = crash_of(c.statement);
    ASSERT_TRUE(crash) << c.statement;
    EXPECT_THAT(crash->reason, HasSubstr(c.reason)) << c.statement;
    EXPECT_EQ(crash->where.function, "work") << c.statement;
    EXPECT_EQ(crash->where.file, "Test.ino") << c.statement;
    EXPECT_EQ(crash->where.line, 2) << c.statement;
    EXPECT_THAT(crash->registers, AllOf(HasSubstr("PC 0x080"), HasSubstr("r12"))) << c.statement;
  }
}

TEST_F(Stm32ChipTest, AReturnFromAnInterruptThatHasNotBegunIsACrash) {
  const auto& crash = crash_of("asm volatile(\"ldr r0, =0xFFFFFFF9\\n bx r0\\n .ltorg\" ::: \"r0\");");
  ASSERT_TRUE(crash);
  EXPECT_EQ(crash->reason,
            "return from an interrupt that never began, or whose return address was overwritten");
}

TEST_F(Stm32ChipTest, AnExceptionWithoutAHandlerIsACrash) {
  const auto& crash = crash_of(
      "static volatile int none[128] __attribute__((aligned(512))); *(volatile int*)0xE000ED08 = (int)none; "
      "*(volatile int*)0xE000ED04 = 1 << 28; asm volatile(\"isb\"); n = 1;");
  ASSERT_TRUE(crash);
  EXPECT_EQ(crash->reason, "exception 14 without a handler");
}

TEST_F(Stm32ChipTest, AStackThatFitsIsNoCrash) {
  EXPECT_FALSE(crash_of("volatile char room[4000]; room[n] = 1; n = room[n];"));
}

TEST_F(Stm32ChipTest, AStackThatReachesTheVariablesIsACrash) {
  start(
      "volatile int depth;\nint __attribute__((noinline)) deeper(int n) { volatile char use[64]; use[n % 64] "
      "= 1;\n"
      "  depth = n; return deeper(n + 1) + use[3]; }\nvoid setup() { depth = deeper(0); }\nvoid loop() {}\n");
  run(kSecond);
  ASSERT_TRUE(chip_->crash());
  EXPECT_THAT(chip_->crash()->reason, HasSubstr("stack overflow"));
  EXPECT_EQ(chip_->crash()->where.function, "deeper");
  EXPECT_GT(chip_->resources()->stack_bytes_max, 19000u);
}

TEST_F(Stm32ChipTest, SleepCostsNextToNothingAndLoadIsMeasured) {
  start("void setup() {}\nvoid loop() { delay(10); }\n");
  run(kSecond);
  const Resources r = *chip_->resources();
  EXPECT_LT(r.cpu_load, 0.02);
  EXPECT_NEAR(r.loop_us_mean, 10'000.0, 20.0);
  EXPECT_GE(r.loops, 97u);
}

TEST_F(Stm32ChipTest, ALoopThatBeginsWithALoopWithinIsNotCountedByThat) {
  start(R"(volatile unsigned n, rounds;
void setup() { Serial.begin(115200); }
void loop() {
  while (n < 50) n = n + 1;
  n = 0;
  if (++rounds == 500) Serial.println(micros());
})");
  run(50 * kMillisecond);
  const double took_us = std::stod(serial_);
  const Resources r = *chip_->resources();
  EXPECT_NEAR(r.loop_us_mean, took_us / 500.0, 0.02 * r.loop_us_mean);
}

const char* const kRegisters =
    "#include \"hal/stm32/registers.h\"\nusing namespace robosim::stm32;\nuint32_t n_;\n";

TEST_F(Stm32ChipTest, AResetBySoftwareBeginsAnewAndKeepsRam) {
  EXPECT_EQ(output(std::string(kRegisters) +
                   "uint32_t kept_ __attribute__((section(\".noinit\")));\n"
                   "void setup() { Serial.begin(115200);\n"
                   "  if (!(load(kRccCsr) & kSoftwareReset)) kept_ = 0;\n"
                   "  Serial.print(n_++); Serial.print(kept_++); Serial.print(' '); Serial.flush();\n"
                   "  if (kept_ < 3) store(kScbAircr, 0x05FA0004);\n"
                   "  Serial.print(millis() < 5 ? 'k' : '-'); }\nvoid loop() {}\n"),
            "00 01 02 k");
}

TEST_F(Stm32ChipTest, AWatchdogThatBitesAgainAndAgainIsACrashWhereItBit) {
  const std::string text =
      std::string(kRegisters) +
      "void setup() { Serial.begin(115200); Serial.print(load(kRccCsr) & kIwdgReset ? 'w' : 'p');\n"
      "  store(kIwdg, 0xCCCC); }\n"
      "void loop() {\n  delay(50);\n  store(kIwdg, 0xAAAA);\n  while (n_++ >= 2) load(kRccCsr);\n}\n";
  start(text);
  run(3 * kSecond);
  EXPECT_EQ(serial_, "pww");
  ASSERT_TRUE(chip_->crash());
  EXPECT_THAT(chip_->crash()->reason, HasSubstr("the watchdog has reset the chip 3 times"));
  EXPECT_EQ(chip_->watchdog_resets(), 3);
  EXPECT_EQ(chip_->crash()->where.function, "loop");
}

TEST_F(Stm32ChipTest, WfeSleepsUntilAnEventThatMayHaveBeenBefore) {
  EXPECT_EQ(
      output(std::string(kRegisters) +
             "void setup() { Serial.begin(115200); uint32_t t = millis();\n"
             "  noInterrupts(); asm volatile(\"sev\\n wfe\"); Serial.print(millis() - t); interrupts();\n"
             "  asm volatile(\"wfe\"); for (int i = 0; i < 3; ++i) asm volatile(\"wfe\");\n"
             "  uint32_t slept = millis() - t; Serial.print(slept >= 1 && slept <= 4 ? 'y' : 'n'); }\n"
             "void loop() {}\n"),
      "0y");
}

// The code after WFI does not run before a handler clears SLEEPONEXIT (PM0056, 2.5.1).
TEST_F(Stm32ChipTest, WithSleeponexitOnlyHandlersRun) {
  EXPECT_EQ(
      output("volatile uint32_t& scr = *(volatile uint32_t*)0xE000ED10;\n"
             "volatile int edges; void edge() { if (++edges == 3) scr = 0; }\n"
             "void setup() { Serial.begin(115200); pinMode(4, OUTPUT); attachInterrupt(4, edge, CHANGE);\n"
             "  tone(4, 500); scr = 2; asm volatile(\"wfi\"); int n = edges; scr = 0; noTone(4);\n"
             "  Serial.print(n); }\n"
             "void loop() {}\n"),
      "3");
}

TEST_F(Stm32ChipTest, KnowsHowMuchFlashItHas) {
  EXPECT_EQ(output(std::string(kRegisters) +
                   "void setup() { Serial.begin(115200); Serial.print(load_half(0x1FFFF7E0)); }\n"
                   "void loop() {}\n"),
            "64");
}

TEST_F(Stm32ChipTest, AProgramMayWriteCodeIntoFlashAndRunIt) {
  EXPECT_EQ(
      output("#include \"hal/stm32/registers.h\"\nusing namespace robosim::stm32;\n"
             "constexpr Address code = 0x0800F800;\n"
             "void setup() { Serial.begin(115200); auto copy = (int (*)())(code | 1);\n"
             "  at(kFlashKeyr) = kFlashKey1; at(kFlashKeyr) = kFlashKey2;\n"
             "  for (uint16_t value = 7; value < 60; value += 35) {\n"
             "    at(kFlashCr) = kFlashPer; at(kFlashAr) = code; at(kFlashCr) = kFlashPer | kFlashStart;\n"
             "    at(kFlashCr) = kFlashPg; store_half(code, 0x2000 | value); store_half(code + 2, "
             "0x4770); Serial.print(' '); Serial.print(copy()); } }\n"
             "void loop() {}\n"),
      " 7 42");
}

}  // namespace robosim::exec::chip_test
