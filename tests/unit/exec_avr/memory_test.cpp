// Tests the measurements of RAM, stack, loop() and interrupt handlers on an emulated AVR.
#include "sim/exec/avr/firmware.h"
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::memory_test {

class MemoryTest : public AvrTest {
 protected:
  Resources used(const std::string& text, SimTime duration = 100 * kMillisecond) {
    start(text);
    run(duration);
    EXPECT_FALSE(avr_->crash()) << avr_->crash()->reason;
    return avr_->resources().value_or(Resources{});
  }
};

TEST_F(MemoryTest, TheStacksMostIsMeasuredThoughNothingIsWrittenThere) {
  const auto with = [](const char* size) {
    return std::string(
               "void __attribute__((noinline)) use(volatile char* p) { p[0] = 1; }\n"
               "void setup() { volatile char room[") +
           size + "]; use(room); }\nvoid loop() {}";
  };
  const std::uint32_t little = used(with("100")).stack_bytes_max;
  const std::uint32_t much = used(with("500")).stack_bytes_max;
  EXPECT_NEAR(static_cast<double>(much) - little, 400.0, 10.0)
      << "an interrupt may use more stack in one of the runs";
}

TEST_F(MemoryTest, AShortDeepCallCounts) {
  const Resources r = used(R"(volatile int depth;
int __attribute__((noinline)) down(int n) { depth = n; return n == 0 ? 0 : down(n - 1) + depth; }
void setup() { down(100); }
void loop() {})");
  EXPECT_GT(r.stack_bytes_max, 200u);
  EXPECT_LT(r.stack_bytes_max, 300u);
}

TEST_F(MemoryTest, MemoryOfTheHeapIsNotFree) {
  const auto with = [&](const char* code) {
    return used(std::string("char* volatile p;\nvoid setup() { ") + code +
                " if (p) p[0] = 1; }\nvoid loop() {}")
        .free_bytes_min;
  };
  const auto without = with("p = (char*)malloc(10);"), with_heap = with("p = (char*)malloc(1010);");
  EXPECT_NEAR(static_cast<double>(without - with_heap), 1000.0, 10.0);
  EXPECT_GT(with_heap, 500);
}

TEST_F(MemoryTest, VariablesAndFlashAreThoseOfTheImage) {
  const Resources r = used("volatile byte table[300];\nvoid setup() { table[0] = 1; }\nvoid loop() {}");
  EXPECT_GE(r.ram_bytes, 300u);
  EXPECT_LT(r.ram_bytes, 330u);
  EXPECT_GT(r.flash_bytes, 400u);
}

// A program may read its flash. The detection of loop()'s rounds and of wait loops must not modify the flash.
TEST_F(MemoryTest, AProgramThatChecksItsOwnFlashFindsItAsItWasBuilt) {
  output(R"(extern const char __data_load_end;
void setup() { Serial.begin(115200); }
void loop() {
  unsigned long sum = 0;
  for (unsigned i = 0; i < (unsigned)&__data_load_end; ++i) sum = 31 * sum + pgm_read_byte(i);
  Serial.println(sum);
  delay(20);
})");
  const avr::Firmware built = avr::Firmware::read(built_.image, *find_board(board_name_));
  std::uint32_t sum = 0;
  for (const std::uint8_t byte : built.flash) sum = 31 * sum + byte;
  ASSERT_GT(numbers().size(), 3u);
  for (const long long found : numbers()) EXPECT_EQ(found, sum);
}

TEST_F(MemoryTest, LoopIsTimedThoughItIsInlined) {
  const Resources r = used(R"(void setup() { pinMode(13, OUTPUT); }
void loop() { static byte n; delayMicroseconds(++n % 10 == 0 ? 3000 : 1000); PINB = _BV(5); })",
                           kSecond);
  EXPECT_NEAR(r.loop_us_max, 3020.0, 30.0);
  EXPECT_NEAR(r.loop_us_mean, 1210.0, 20.0);
  EXPECT_NEAR(static_cast<double>(r.loops), 826.0, 15.0);
  EXPECT_DOUBLE_EQ(r.cpu_load, 1.0);
}

TEST_F(MemoryTest, LoopIsTimedThoughTheJumpBackIsTheLastInstructionOfMain) {
  const Resources r = used(R"(unsigned passes;
void blink() { digitalWrite(13, passes % 2); }
void setup() { pinMode(13, OUTPUT); Serial.begin(115200); }
void loop() { ++passes; blink(); Serial.println(millis() + analogRead(A0)); delay(5); })",
                           kSecond);
  EXPECT_NEAR(r.loop_us_mean, 5200.0, 200.0) << "the loop in delay() is not timed";
}

TEST_F(MemoryTest, APassOfLoopThatHasNotEndedCounts) {
  const Resources r =
      used("void setup() {}\nvoid loop() { static byte n; if (++n == 10) delay(10000); }", kSecond);
  EXPECT_EQ(r.loops, 9u);
  EXPECT_GT(r.loop_us_max, 990e3);
}

TEST_F(MemoryTest, TimeInHandlersIsCounted) {
  const Resources r = used(R"(ISR(TIMER1_COMPA_vect) { delayMicroseconds(250); }
void setup() { TCCR1A = 0; TCCR1B = _BV(WGM12) | _BV(CS11); OCR1A = 1999; TIMSK1 = _BV(OCIE1A); }
void loop() {})",
                           kSecond);
  EXPECT_NEAR(r.interrupt_share, 0.256, 0.01);
}

TEST_F(MemoryTest, ASketchWithoutAClockCannotHaveItSet) {
  start("int main() { for (;;) {} }");
  EXPECT_THROW(avr_->set_clock_start(kSecond), InputError);
}

}  // namespace robosim::exec::memory_test
