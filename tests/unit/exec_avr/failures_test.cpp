// Tests that Robosim reports every kind of crash on an AVR with its reason and place. Uses the sketches of
// the system tests.

#include <fmt/format.h>

#include <array>

#include "sim/exec/avr/firmware.h"
#include "sim/exec/elf/demangle.h"
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::failures_test {

using testing::AnyOf;
using testing::HasSubstr;

class FailuresTest : public AvrTest {
 protected:
  const std::optional<Crash>& crash_of(const std::string& name, SimTime duration = kSecond) {
    build::Request request{std::filesystem::path(ROBOSIM_TEST_SKETCHES) / name, *find_board(board_name_)};
    request.target = "avr";
    built_ = build::build(request);
    start_image(built_.image);
    run(duration);
    return avr_->crash();
  }
  /// Returns the address `offset` bytes after the start of a variable of the last sketch, as in "0x9D56".
  std::string address(const char* variable, int offset) const {
    const auto found = avr::Firmware::read(built_.image, *find_board(board_name_)).find_variable(variable);
    return found ? fmt::format("0x{:04X}", *found + offset) : "no variable";
  }
};

TEST(Demangle, KeepsNamesThatAreNotMangled) {
  EXPECT_EQ(demangle("n"), "n") << "n is not decoded as the type __int128";
  EXPECT_EQ(demangle("i"), "i");
  EXPECT_EQ(demangle("_ZN3Foo3barE"), "Foo::bar");
}

TEST_F(FailuresTest, EachNamesReasonFunctionAndLine) {
  struct Case {
    const char* sketch;
    const char* reason;
    const char* function;
    int line;
    int index = 0;  ///< index into `table`; the compiler chooses the address of `table`
  };
  for (const Case& c :
       {Case{"ChipWildRead", "read of address {}, where the chip has no memory", "look", 4, 40000},
        Case{"ChipWildWrite", "write to address {}, where the chip has no memory", "put", 4, 30000},
        Case{"ChipWildCall",
             "call through a wrong function pointer to address 0x7400, where there is no code", "call", 4},
        Case{"ChipRestart", "to address 0, where a reset begins", "call", 5},
        Case{"ChipSmash", "the return address on the stack was overwritten", "copy", 10},
        Case{"ChipOpcode", "illegal instruction 0x0001", "setup", 6},
        Case{"ChipDeep", "stack overflow", "deeper", 4},
        Case{"ChipWatchdog", "the watchdog has reset the chip 3 times", "work", 6},
        Case{"ChipFlash", "write to the sketch's own flash at 0x7000", "burn", 4}}) {
    const auto& crash = crash_of(c.sketch);
    ASSERT_TRUE(crash) << c.sketch;
    std::string reason = c.reason;
    if (c.index > 0) reason = fmt::format(fmt::runtime(reason), address("table", c.index));
    EXPECT_THAT(crash->reason, HasSubstr(reason)) << c.sketch;
    EXPECT_EQ(crash->where.file, std::string(c.sketch) + ".ino");
    const auto place = std::pair(crash->where.function, crash->where.line);
    const auto expected = std::pair(std::string(c.function), c.line);
    // The assembler of avr-gcc 5.4 assigns no line to data, such as the .word of an asm(). Robosim then
    // reports the caller's line.
    if (c.sketch == std::string("ChipOpcode"))
      EXPECT_THAT(place, AnyOf(expected, std::pair(std::string("broken"), 2)));
    else
      EXPECT_EQ(place, expected) << c.sketch;
    EXPECT_THAT(crash->registers, HasSubstr("SP 0x")) << c.sketch;
    EXPECT_FALSE(crash->calls.empty()) << c.sketch;
  }
}

TEST_F(FailuresTest, TheyAreToldWhereReturnAddressesHaveThreeBytes) {
  board_name_ = "mega";
  for (const auto& [sketch, reason, function] :
       {std::array{"ChipWildRead", "where the chip has no memory", "look"},
        std::array{"ChipWildCall", "call through a wrong function pointer to address 0x7400", "call"},
        std::array{"ChipSmash", "the return address on the stack was overwritten", "copy"},
        std::array{"ChipDeep", "stack overflow", "deeper"},
        std::array{"ChipWatchdog", "the watchdog has reset the chip 3 times", "work"}}) {
    const auto& crash = crash_of(sketch);
    ASSERT_TRUE(crash) << sketch;
    EXPECT_THAT(crash->reason, HasSubstr(reason)) << sketch;
    EXPECT_EQ(crash->where.function, function) << sketch;
    EXPECT_FALSE(crash->calls.empty()) << sketch;
  }
}

TEST_F(FailuresTest, AnInterruptWithoutAHandlerIsNoStackThatWasOverwritten) {
  for (const char* board : {"uno", "attiny85"}) {
    board_name_ = board;
    start(R"(
void setup() {}
void loop() {
  delay(5);
#ifdef TIMSK1
  TCCR1B = 1;
  TIMSK1 = _BV(OCIE1B);
#else
  TCCR1 = 1;
  TIMSK |= _BV(OCIE1B);
#endif
  for (;;) {}
}
)");
    run(20 * kMillisecond);
    ASSERT_TRUE(avr_->crash()) << board;
    EXPECT_THAT(avr_->crash()->reason, HasSubstr(board[0] == 'u' ? "interrupt 12 was" : "interrupt 9 was"));
    EXPECT_EQ(avr_->crash()->where.function, "loop") << board;
  }
}

TEST_F(FailuresTest, AJumpThroughAPointerIsNoReturn) {
  start(R"(
typedef void (*Step)();
volatile Step step;
void __attribute__((noinline)) go() { step(); }
void setup() {}
void loop() { delay(1); go(); }
)");
  run(20 * kMillisecond);
  ASSERT_TRUE(avr_->crash());
  EXPECT_THAT(avr_->crash()->reason, testing::StartsWith("jump to address 0"));
}

TEST_F(FailuresTest, AnAddressAfterTheEndOfTheFlashIsNamedSo) {
  start(R"(
volatile uint16_t target = 0x4100;  // a word address; the flash has 0x4000 words
void __attribute__((noinline)) go() { ((void (*)())target)(); delay(1); }
void setup() {}
void loop() { go(); }
)");
  run(20 * kMillisecond);
  ASSERT_TRUE(avr_->crash());
  EXPECT_THAT(avr_->crash()->reason, HasSubstr("after the end of the flash"));
}

TEST_F(FailuresTest, ACallIsTheOneThatTheSketchMakesNotOneOfTheCore) {
  start("void rest() { delay(10000); }\nvoid setup() {}\nvoid loop() { rest(); Serial.flush(); }\n");
  run(kSecond);
  EXPECT_EQ(avr_->activity().call, "delay()");
}

// Returns a sketch with two coroutines, whose stacks are variables. The second coroutine executes `body`
// whenever it is resumed.
std::string coroutines(const std::string& body) {
  return R"(uint8_t stack_a[120], stack_b[120];
uint8_t *sp_main, *sp_a, *sp_b;
uint8_t* volatile* from __attribute__((used));
uint8_t* volatile* to __attribute__((used));
void __attribute__((naked, noinline)) swap() {
  __asm__ volatile(
      ".irp r,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,28,29\n push r\\r\n .endr\n"
      "lds r30, from\n lds r31, from+1\n in r24, 0x3d\n st Z, r24\n in r24, 0x3e\n std Z+1, r24\n"
      "lds r30, to\n lds r31, to+1\n ld r24, Z\n ldd r25, Z+1\n"
      "in r0, 0x3f\n cli\n out 0x3d, r24\n out 0x3e, r25\n out 0x3f, r0\n"
      ".irp r,29,28,17,16,15,14,13,12,11,10,9,8,7,6,5,4,3,2\n pop r\\r\n .endr\n ret");
}
void switch_to(uint8_t** a, uint8_t** b) { from = a; to = b; swap(); }
int deep(int n) { volatile char room[20]; room[n] = n; return n == 0 ? 0 : deep(n - 1) + room[n]; }
void task_a() { for (;;) switch_to(&sp_a, &sp_b); }
void task_b() { for (int n = 1;; ++n) { )" +
         body + R"( Serial.println(n); switch_to(&sp_b, &sp_main); } }
uint8_t* prepare(uint8_t* stack, void (*task)()) {
  uint8_t* sp = stack + 119;
  *sp-- = (uint16_t)task & 0xff;
  *sp-- = (uint16_t)task >> 8;
  return sp - 18;
}
void setup() { Serial.begin(115200); sp_a = prepare(stack_a, task_a); sp_b = prepare(stack_b, task_b); }
void loop() { switch_to(&sp_main, &sp_a); delay(10); })";
}

// The sketch acts as an RTOS, in which the timer's handler switches from the interrupted task to another
// task.
TEST_F(FailuresTest, ATaskThatAHandlerHasLetGoOnIsInNoHandler) {
  start(R"(uint8_t stack_b[100];
uint8_t *sp_main, *sp_b;
uint8_t* volatile* now __attribute__((used));
uint8_t* volatile* next __attribute__((used));
void __attribute__((naked, noinline)) change() {
  __asm__ volatile(
      "push r0\n in r0, 0x3f\n cli\n push r0\n"
      ".irp r,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31\n"
      " push r\\r\n .endr\n clr r1\n"
      "lds r30, now\n lds r31, now+1\n in r24, 0x3d\n st Z, r24\n in r24, 0x3e\n std Z+1, r24\n"
      "lds r26, next\n lds r27, next+1\n sts now, r26\n sts now+1, r27\n sts next, r30\n sts next+1, r31\n"
      "ld r28, X+\n out 0x3d, r28\n ld r29, X+\n out 0x3e, r29\n"
      ".irp r,31,30,29,28,27,26,25,24,23,22,21,20,19,18,17,16,15,14,13,12,11,10,9,8,7,6,5,4,3,2,1\n"
      " pop r\\r\n .endr\n pop r0\n out 0x3f, r0\n pop r0\n ret");
}
ISR(TIMER2_COMPA_vect, ISR_NAKED) { __asm__ volatile("call %x0\n reti" ::"i"(change)); }
void busy() { for (;;) { PINB = _BV(5); } }
uint8_t* prepare(uint8_t* stack, void (*task)()) {
  uint8_t* sp = stack + 99;
  *sp-- = (uint16_t)task & 0xff;
  *sp-- = (uint16_t)task >> 8;
  *sp-- = 0;
  *sp-- = 0x80;
  return sp - 31;
}
int main() {
  DDRB = _BV(5);
  sp_b = prepare(stack_b, busy);
  TCCR2A = _BV(WGM21); OCR2A = 249; TCCR2B = _BV(CS22); TIMSK2 = _BV(OCIE2A);
  now = &sp_main;
  next = &sp_b;
  for (;;) { change(); }
})");
  run(100 * kMillisecond);
  EXPECT_FALSE(avr_->crash()) << avr_->crash()->reason;
  EXPECT_GT(changes(13).size(), 1000u);
  EXPECT_GT(avr_->activity().last_call, 99 * kMillisecond);
  EXPECT_LT(avr_->resources()->interrupt_share, 0.2);
}

TEST_F(FailuresTest, ASketchMayHaveStacksOfItsOwn) {
  start(coroutines(""));
  run(95 * kMillisecond);
  EXPECT_FALSE(avr_->crash()) << avr_->crash()->reason;
  EXPECT_GT(numbers().size(), 7u);
}

// As in ChibiOS, the sketch saves the old stack pointer and loads the new one through the same register.
TEST_F(FailuresTest, StacksOfItsOwnMayBeSwitchedThroughOneRegister) {
  std::string sketch = coroutines("");
  const auto from = sketch.find("\"lds r30, from"), to = sketch.find("\".irp r,29,28");
  sketch.replace(from, to - from, R"("lds r30, from\n lds r31, from+1\n lds r26, to\n lds r27, to+1\n cli\n"
      "in r24, 0x3d\n st Z, r24\n in r24, 0x3e\n std Z+1, r24\n movw r30, r26\n"
      "ld r24, Z\n out 0x3d, r24\n ldd r24, Z+1\n out 0x3e, r24\n sei\n"
      )");
  start(sketch);
  run(95 * kMillisecond);
  EXPECT_FALSE(avr_->crash()) << avr_->crash()->reason;
  EXPECT_GT(numbers().size(), 7u);
}

/// Returns a sketch that moves the stack pointer with the statements `move`, calls work(), and restores the
/// stack pointer. The last variable in RAM is `tail`, with 160 bytes.
std::string on_tail(const std::string& move, const std::string& work = "") {
  return "uint8_t tail[160] __attribute__((section(\".noinit\"), used));\nvolatile uint16_t top, old;\n"
         "int deep(int n) { volatile char room[20]; room[n % 20] = n; return n == 0 ? 0 : deep(n - 1) + "
         "room[n % 20]; "
         "}\n"
         "void __attribute__((noinline)) work() { volatile char room[16]; room[3] = 7; old = room[3]; " +
         work +
         " }\nvoid setup() { Serial.begin(115200); top = (uint16_t)tail + 150; }\n"
         "void loop() { uint16_t was = SP; cli(); " +
         move + " work(); SP = was; sei(); Serial.println(old); }";
}

TEST_F(FailuresTest, AStackInTheLastVariableIsLegalHoweverItsPointerIsSet) {
  for (const char* const move : {
           "SP = (uint16_t)(tail + 159);",
           "SP = (uint16_t)(tail + sizeof tail);",
           "SPH = (uint16_t)(tail + 159) >> 8; SPL = (uint16_t)(tail + 159);",
           "SPL = (uint16_t)(tail + 159); SPH = (uint16_t)(tail + 159) >> 8;",
           "old = SP; SP = (uint16_t)(tail + 100);",
           "SP = top;",
           "SP = top + 10;",
           "uint16_t to = top; SPL = to; asm volatile(\"nop\\n nop\\n nop\\n nop\\n nop\\n nop\\n nop\\n\"); "
           "SPH = to >> 8;",
       }) {
    start(on_tail(move));
    run(50 * kMillisecond);
    EXPECT_FALSE(avr_->crash()) << move << ": " << avr_->crash()->reason;
    EXPECT_GT(numbers().size(), 3u) << move;
  }
}

TEST_F(FailuresTest, AStackInTheLastVariableOutgrowsIt) {
  for (const char* const move :
       {"SP = (uint16_t)(tail + 159);", "SP = (uint16_t)(tail + sizeof tail);", "old = SP; SP = top;"}) {
    start(on_tail(move, "old = deep(9);"));
    run(50 * kMillisecond);
    ASSERT_TRUE(avr_->crash()) << move;
    EXPECT_EQ(avr_->crash()->reason,
              "stack overflow: the stack that the sketch has placed in tail has outgrown its 160 bytes");
  }
  start(on_tail("", "old = deep(99);"));
  run(50 * kMillisecond);
  ASSERT_TRUE(avr_->crash());
  EXPECT_THAT(avr_->crash()->reason, HasSubstr("bytes of RAM that variables and heap leave free"));
}

TEST_F(FailuresTest, AStackInTheHeapOutgrowsItsBlock) {
  // The heap's end is read once per tick, so the sketch waits after malloc().
  const auto with = [](int depth) {
    return fmt::format(
        "uint8_t* block;\nvolatile int sum;\n"
        "int deep(int n) {{ volatile char room[20]; room[n % 20] = n; return n == 0 ? 0 : deep(n - 1) + "
        "room[n % 20]; }}\n"
        "void __attribute__((noinline)) work() {{ sum = deep({}); }}\n"
        "void setup() {{ malloc(20); block = (uint8_t*)malloc(200); delay(5); }}\n"
        "void loop() {{ uint16_t was = SP; cli(); SP = (uint16_t)(block + 199); work(); SP = was; sei(); }}",
        depth);
  };
  start(with(1));
  run(20 * kMillisecond);
  EXPECT_FALSE(avr_->crash()) << avr_->crash()->reason;
  start(with(19));
  run(20 * kMillisecond);
  ASSERT_TRUE(avr_->crash());
  EXPECT_EQ(avr_->crash()->reason,
            "stack overflow: a stack that the sketch has allocated in the heap has outgrown its block");
}

// If a stack begins at `stack + sizeof stack`, its first byte is after the variable. All other bytes of the
// stack are inside the variable.
TEST_F(FailuresTest, AStackOfItsOwnMayBeginRightBehindItsVariable) {
  const auto with = [](const char* body) {
    // no_reorder prevents the compiler from reordering the variables. The byte after stack_b is therefore
    // after[0], which the sketch does not use.
    return std::string(
               "__attribute__((no_reorder)) volatile uint8_t before[4], stack_b[200], after[4];\n"
               "int deep(int n) { volatile char room[20]; room[n] = n;"
               " return n == 0 ? 0 : deep(n - 1) + room[n]; }\n"
               "void __attribute__((noinline)) work() { for (int n = 1;; ++n) { ") +
           body + R"( Serial.println(n); delay(10); } }
void setup() {
  Serial.begin(115200);
  before[1] = after[1] = stack_b[1] = 1;
  __asm__ volatile("ldi r24, lo8(stack_b+200)\n ldi r25, hi8(stack_b+200)\n in r0, 0x3f\n cli\n"
                   "out 0x3e, r25\n out 0x3f, r0\n out 0x3d, r24\n call %x0" ::"i"(work) : "r24", "r25");
}
void loop() {})";
  };
  start(with(""));
  run(95 * kMillisecond);
  EXPECT_FALSE(avr_->crash()) << avr_->crash()->reason;
  EXPECT_GT(numbers().size(), 7u);
  start(with("deep(12);"));
  run(95 * kMillisecond);
  ASSERT_TRUE(avr_->crash());
  EXPECT_EQ(avr_->crash()->reason,
            "stack overflow: the stack that the sketch has placed in stack_b has outgrown its 200 bytes");
}

TEST_F(FailuresTest, AStackOfTheSketchsOwnMustStayInItsVariable) {
  start(coroutines("deep(9);"));
  run(95 * kMillisecond);
  ASSERT_TRUE(avr_->crash());
  EXPECT_EQ(avr_->crash()->reason,
            "stack overflow: the stack that the sketch has placed in stack_b has outgrown its 120 bytes");
  EXPECT_EQ(avr_->crash()->where.function, "deep");
}

TEST_F(FailuresTest, APowerCycleBeginsAfreshAfterACrash) {
  ASSERT_TRUE(crash_of("ChipWildWrite"));
  avr_->power_on(now_);
  EXPECT_FALSE(avr_->crash());
  run(100 * kMillisecond);
  EXPECT_TRUE(avr_->crash()) << "the restarted sketch crashes again";
}

}  // namespace robosim::exec::failures_test
