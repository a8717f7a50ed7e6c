// Tests that a chip that is restored from a snapshot continues like the original chip. The test saves
// snapshots during every operation that takes time.
#include <algorithm>
#include <random>

#include "tests/support/effort.h"
#include "tests/support/stm32_sum.h"
#include "tests/unit/exec_stm32/chip_fixture.h"

namespace robosim::exec {
namespace snapshots_test {

// The first lines of each sketch. They let the sketch access registers, and install handlers for 60
// interrupts in a vector table in RAM.
const std::string kBegins = R"(#define R(address) (*(volatile unsigned*)(address))
static unsigned vectors[76] __attribute__((aligned(512)));
volatile unsigned counts[8];
static void take_vectors() {
  for (int i = 0; i < 76; ++i) vectors[i] = ((unsigned*)0x08000000)[i];
  R(0xE000ED08) = (unsigned)vectors;
}
static void enable(int irq, void (*handler)(), int priority) {
  vectors[16 + irq] = (unsigned)handler;
  ((volatile unsigned char*)0xE000E400)[irq] = priority << 4;
  R(0xE000E100 + irq / 32 * 4) = 1u << irq % 32;
}
static void dawdle(unsigned n) { for (volatile unsigned i = 0; i < n; i++); }
)";

struct Case {
  const char* name;
  const char* text;
  bool is_cut = false;  ///< whether the test cuts the power once
  int us = 350;         ///< longest time between two snapshots, in us
};

const Case kCases[] = {
    {"Core", R"(
volatile int edges;
void came() { ++edges; counts[edges % 8] += micros(); }
void setup() {
  Serial.begin(115200);
  attachInterrupt(digitalPinToInterrupt(2), came, CHANGE);
  pinMode(6, OUTPUT);
  analogWrite(5, 77);
  tone(9, 700, 20);
}
void loop() {
  Serial.println(analogRead(A1) + edges + Serial.read());
  digitalWrite(6, !digitalRead(6));
  delay(3);
  delayMicroseconds(700);
  analogWrite(5, millis());
})"},
    {"Handlers", R"(
static void slow() { ++counts[0]; dawdle(400); R(0x40000010) = 0; ++counts[1]; }
static void quick() { counts[2] += counts[1]; dawdle(20); R(0x40000410) = 0; }
void setup() {
  take_vectors();
  R(0x4002101C) |= 3;  // TIM2 interrupts, TIM3 preempts it
  enable(28, slow, 9);
  enable(29, quick, 3);
  R(0x4000002C) = 10000, R(0x4000000C) = 1, R(0x40000000) = 1;
  R(0x4000042C) = 3331, R(0x4000040C) = 1, R(0x40000400) = 1;
}
void loop() {
  counts[3] += counts[0] & 1 ? counts[2] : 1;
  asm volatile("wfi");
  if (counts[0] == 30) R(0xE000ED10) = 2;  // SLEEPONEXIT
})"},
    {"DmaAndBuses", R"(
static unsigned short samples[24];
static char text[] = "what a byte takes: 8.7 us\r\n";
static void converted() { counts[7] += R(0x4001284C) + 1; }
static void moved() { counts[0] += R(0x40020000); R(0x40020004) = 0xFFFFFFFF; }
void setup() {
  Serial.begin(115200);
  take_vectors();
  R(0x40021014) |= 1;       // DMA1
  R(0x40021018) |= 0x1E01;  // ADC1 and 2, TIM1, SPI1, AFIO
  R(0x4002101C) |= 0x18A04001;  // TIM2, SPI2, I2C1, PWR, BKP, WWDG
  enable(11, moved, 5);
  R(0x40012408) = 1;  // ADC1 by DMA, endlessly, 3 channels
  R(0x4001242C) = 2 << 20, R(0x40012434) = 1 | 2 << 5 | 4 << 10;
  R(0x40012404) = 0x100;
  R(0x40020010) = (unsigned)samples, R(0x40020014) = 0;
  R(0x40020010) = 0x4001244C, R(0x40020014) = (unsigned)samples, R(0x4002000C) = 24;
  R(0x40020008) = 0x5A7;
  R(0x40012408) = 0x1E0103, R(0x40012408) = 0x5E0103;
  R(0x40005404) = 36, R(0x4000541C) = 180, R(0x40005400) = 1;  // I2C1
  R(0x40013000) = 0x37C;  // SPI1
  R(0x40012808) = 1, R(0x40012810) = 0x38;  // ADC2 occasionally interrupts at the end of a conversion
  R(0x40012804) = 0x20;
  enable(18, converted, 6);
}
static void by_dma(unsigned n) {
  R(0x40013814) |= 0x80;
  R(0x40020044) = 0;
  R(0x40020048) = 0x40013804, R(0x4002004C) = (unsigned)text, R(0x40020048 - 4) = n;
}
static unsigned word_by_word[64];
void loop() {
  R(0x40005400) |= 0x100;  // a start, and an address that no device answers
  while (!(R(0x40005414) & 1)) ++counts[1];
  R(0x40005410) = 0x46;
  while (!(R(0x40005414) & 0x402)) ++counts[2];
  R(0x40005414) = 0, R(0x40005400) |= 0x200;
  R(0x4001300C) = counts[1];
  while (!(R(0x40013008) & 1)) ++counts[3];
  counts[4] += R(0x4001300C) + samples[7];
  R(0x40020030) = 0;  // memory to memory: channel 3
  R(0x40020038) = (unsigned)counts, R(0x4002003C) = (unsigned)word_by_word, R(0x40020034) = 8;
  R(0x40020030) = 0x4AC1;
  Serial.write(text[counts[5]++ % 20]);
  counts[6] ^= R(0xE0001004);  // DWT_CYCCNT
  if (counts[5] % 4 == 0) R(0x40012808) = 1;
  if (counts[5] % 30 == 9) by_dma(20);
})"},
    {"Watchdogs", R"(
void setup() {
  Serial.begin(115200);
  Serial.println(R(0x40021024), HEX);  // why it was reset
  R(0xE000EDFC) |= 1u << 24, R(0xE0001000) |= 1;
  R(0x40021014) |= 0x40;  // CRC
  R(0x40021018) |= 1, R(0x4002101C) |= 0x18000800;
  if (R(0x40006C04) == 0) {
    R(0x40021024) |= 1;
    while (!(R(0x40021024) & 2)) {}
    R(0x40007000) |= 0x100;
    R(0x40021020) = 0x8200;  // the RTC on LSI
    R(0x40002804) = 0x10;
    R(0x4000280C) = 13;
    R(0x40002804) = 0;
  }
  R(0x40007000) |= 0x100;
  R(0x40006C04) = R(0x40006C04) + 1;  // a backup register
  if (R(0x40006C04) == 3) R(0x40002C04) = 0x1FF, R(0x40002C00) = 0xFF;  // the window watchdog: 58 ms
  if (R(0x40006C04) == 2)
    R(0x40003000) = 0x5555, R(0x40003004) = 2, R(0x40003008) = 50, R(0x40003000) = 0xCCCC;
}
void loop() {
  if (millis() < 12) R(0x40003000) = 0xAAAA, R(0x40007000) &= ~0x100u;
  if (R(0x40006C04) == 1 && millis() > 20) R(0xE000ED0C) = 0x05FA0004;  // SYSRESETREQ
  counts[0] += R(0x4000281C) + R(0xE0001004);
  R(0x40006C08) = counts[0];
  R(0x40023000) = counts[0] + R(0x40002C00) + R(0x40006C08);
  counts[1] = R(0x40023000);
  delay(2);
  Serial.print(R(0x4000281C));
})"},
    {"Flash", R"(#include <EEPROM.h>
static volatile unsigned short* const half = (volatile unsigned short*)0x0800E000;
void setup() { Serial.begin(115200); }
void loop() {
  static int i;
  EEPROM.write(i++ % 7, micros());
  R(0x40022004) = 0x45670123, R(0x40022004) = 0xCDEF89AB;
  if (i == 20) R(0x40022010) = 2, R(0x40022014) = 0x0800E000, R(0x40022010) = 0x42;
  R(0x40022010) = 1;
  half[i * 2] = micros();
  R(0x40022010) = 0x80;
  Serial.println(EEPROM.read(3) + half[4] + half[i * 2]);
})",
     true, 1400},
    {"OwnCode", R"(
// Runs code that the sketch writes to flash and partly overwrites with zeros. Also runs code in RAM.
static unsigned short* const code = (unsigned short*)0x0800F000;
static unsigned short in_ram[4] = {0x3001, 0xEA80, 0x0040, 0x4770};  // adds; eor r0, r0, r0, lsl #1; bx lr
typedef unsigned (*Function)(unsigned);
static void program(int at, unsigned value) {
  R(0x40022004) = 0x45670123, R(0x40022004) = 0xCDEF89AB;
  R(0x40022010) = 1;
  ((volatile unsigned short*)code)[at] = value;
  R(0x40022010) = 0x80;
}
void setup() { Serial.begin(115200); }
void loop() {
  static unsigned n = 1, k = micros() / 1000;
  const Function here = (Function)((unsigned)(code + 4 * k) + 1);
  program(4 * k, 0x3001 + k % 100);  // adds r0, #1
  program(4 * k + 1, 0xFA90), program(4 * k + 2, 0xF0A0);  // rbit r0, r0
  program(4 * k + 3, 0x4770);
  for (int i = 0; i < 20; ++i) n = here(n), dawdle(50);
  program(4 * k, 0);
  for (int i = 0; i < 20; ++i) n = here(n) + 1, dawdle(50);
  ++k;
  in_ram[0] = 0x3000 | (n & 0x7F);
  for (int i = 0; i < 50; ++i) n = ((Function)((unsigned)in_ram + 1))(n), dawdle(9);
  Serial.println(n);
})",
     true},
    {"Exclusive", R"(
// Often waits between LDREX and STREX.
void setup() { Serial.begin(115200); }
void loop() {
  static unsigned word = 1, other = 2;
  unsigned old, failed;
  asm volatile("ldrex %0, [%1]" : "=r"(old) : "r"(&word));
  dawdle(old % 97 * 20);
  if (old % 7 == 0) asm volatile("clrex");
  asm volatile("strex %0, %1, [%2]" : "=&r"(failed) : "r"(old * 5 + 1), "r"(old % 4 ? &word : &other) : "memory");
  if (failed) word += 3;
  counts[failed] += word;
  Serial.println(word);
})"},
    {"Sleep", R"(
static void ticked() { ++counts[0]; R(0x40000010) = 0; }
void setup() {
  take_vectors();
  R(0x4002101C) |= 1;
  R(0x4000002C) = 60000, R(0x4000000C) = 1, R(0x40000000) = 1;
  R(0xE000ED10) = 0x10;  // SEVONPEND
}
void loop() {
  asm volatile("wfe");
  counts[1] += micros();
  if (R(0xE000E200) >> 28 & 1) R(0x40000010) = 0, R(0xE000E280) = 1u << 28, ++counts[2];
  if (counts[2] % 8 == 5) asm volatile("sev");
  if (counts[2] % 8 == 7) asm volatile("cpsid i\n wfi\n cpsie i");
  if (counts[2] == 40) enable(28, ticked, 2);
})"},
};

class Stm32Snapshots : public Stm32ChipTest, public testing::WithParamInterface<Case>, PinWatcher {
 protected:
  void before_power_on() override {
    for (Pin pin = 0; pin < find_board(board_name_)->pin_count; ++pin) chip_->board().watch(pin, *this);
  }
  void pin_changed(Pin, const PinDrive& drive, SimTime t) override {
    told_.add(static_cast<std::uint64_t>(t) + drive.level);
    told_.add(static_cast<std::uint64_t>(1e6 * drive.duty));
  }
  void byte_sent(std::uint8_t byte, SimTime t) override {
    serial_ += static_cast<char>(byte);
    told_.add(static_cast<std::uint64_t>(t) + byte);
  }

  /// Runs to `t`, the time of snapshot number `moment`. If the case has a power cut, switches the power off
  /// at snapshot 250, and on at snapshot 254.
  void go_to(std::size_t moment, SimTime t) {
    chip_->run_until(t);
    if (!GetParam().is_cut) return;
    if (moment == 250) chip_->power_off(t);
    if (moment == 254) chip_->power_on(t);
  }
  std::uint64_t sum() const {
    run::Sum sum = told_;
    if (chip_->machine()) sum.add(run::sum_of(*chip_->machine()));
    return sum.value();
  }

  run::Sum told_;
};

TEST_P(Stm32Snapshots, GoOnAsTheChipThatWasNotInterrupted) {
  start(kBegins + GetParam().text);
  std::mt19937 random(11);
  for (int i = 0; i < 60; ++i) {
    chip_->board().schedule_edge(2, i % 2 == 0, (i * 1700 + random() % 900) * kMicrosecond);
    chip_->board().receive_byte(static_cast<std::uint8_t>(i), (i * 1500 + random() % 900) * kMicrosecond);
  }
  struct Moment {
    SimTime t = 0;
    std::uint64_t sum = 0;
    run::Sum told;
    std::any saved;
  };
  std::vector<Moment> moments(test::rounds(400));
  SimTime t = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    go_to(i, t += 1000 + random() % (GetParam().us * kMicrosecond));
    moments[i] = {t, sum(), told_, chip_->save()};
  }
  ASSERT_FALSE(chip_->crash()) << chip_->crash()->reason;
  for (int i = 0; i < test::rounds(80); ++i) {
    const std::size_t from = random() % moments.size();
    chip_->restore(moments[from].saved);
    told_ = moments[from].told;
    const std::size_t to = i % 20 == 0 ? moments.size() : std::min(from + 25, moments.size());
    ASSERT_EQ(sum(), moments[from].sum);
    for (std::size_t at = from + 1; at < to; ++at) {
      go_to(at, moments[at].t);
      ASSERT_EQ(sum(), moments[at].sum) << "from " << moments[from].t << " to " << moments[at].t << " ns";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Stm32Snapshots, testing::ValuesIn(kCases),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace snapshots_test
}  // namespace robosim::exec
