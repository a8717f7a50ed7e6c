// Tests that a chip that is restored from a snapshot continues like the original chip. The test saves
// snapshots during every operation that takes time.
#include <algorithm>
#include <random>

#include "tests/support/effort.h"
#include "tests/support/stm32_sum.h"
#include "tests/unit/exec_stm32/chip_fixture.h"

namespace robosim::exec::snapshots_test {

// The first lines of each sketch. They give access to registers, and define functions that install
// interrupt handlers in a vector table in RAM.
const std::string kBegins = R"(#include "hal/stm32/registers.h"
using namespace robosim::stm32;
#define R(address) (*(volatile unsigned*)(address))
static unsigned vectors[76] __attribute__((aligned(512)));
volatile unsigned counts[8];
static void take_vectors() {
  for (int i = 0; i < 76; ++i) vectors[i] = ((unsigned*)kFlash)[i];
  R(kScbVtor) = (unsigned)vectors;
}
static void enable(int irq, void (*handler)(), int priority) {
  vectors[16 + irq] = (unsigned)handler;
  ((volatile unsigned char*)kNvicIpr)[irq] = priority << 4;
  R(kNvicIser + irq / 32 * 4) = 1u << irq % 32;
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
static void slow() { ++counts[0]; dawdle(400); R(kTim2 + kTimSr) = 0; ++counts[1]; }
static void quick() { counts[2] += counts[1]; dawdle(20); R(kTim3 + kTimSr) = 0; }
void setup() {
  take_vectors();
  R(kRccApb1Enr) |= kTim2En | kTim3En;  // TIM2 interrupts, TIM3 preempts it
  enable(kIrqTim2, slow, 9);
  enable(kIrqTim3, quick, 3);
  R(kTim2 + kTimArr) = 10000, R(kTim2 + kTimDier) = kUie, R(kTim2 + kTimCr1) = kCen;
  R(kTim3 + kTimArr) = 3331, R(kTim3 + kTimDier) = kUie, R(kTim3 + kTimCr1) = kCen;
}
void loop() {
  counts[3] += counts[0] & 1 ? counts[2] : 1;
  asm volatile("wfi");
  if (counts[0] == 30) R(kScbScr) = kSleepOnExit;
})"},
    {"DmaAndBuses", R"(
static unsigned short samples[24];
static char text[] = "what a byte takes: 8.7 us\r\n";
static void converted() { counts[7] += R(kAdc2 + 0x4C) + 1; }
static void moved() { counts[0] += R(kDma1); R(kDma1 + 4) = 0xFFFFFFFF; }
void setup() {
  Serial.begin(115200);
  take_vectors();
  R(kRccAhbEnr) |= kDma1En;
  R(kRccApb2Enr) |= 0x1E01;  // ADC1 and 2, TIM1, SPI1, AFIO
  R(kRccApb1Enr) |= 0x18A04001;  // TIM2, SPI2, I2C1, PWR, BKP, WWDG
  enable(kIrqDma1Channel1, moved, 5);
  R(kAdcCr2) = 1;  // ADC1 by DMA, endlessly, 3 channels
  R(kAdcSqr1) = 2 << 20, R(kAdcSqr3) = 1 | 2 << 5 | 4 << 10;
  R(kAdcCr1) = 0x100;
  R(kDma1 + 0x10) = (unsigned)samples, R(kDma1 + 0x14) = 0;
  R(kDma1 + 0x10) = kAdcDr, R(kDma1 + 0x14) = (unsigned)samples, R(kDma1 + 0xC) = 24;
  R(kDma1 + 8) = 0x5A7;
  R(kAdcCr2) = 0x1E0103, R(kAdcCr2) = 0x5E0103;
  R(kI2c1 + 4) = 36, R(kI2c1 + 0x1C) = 180, R(kI2c1) = 1;
  R(kSpi1) = 0x37C;
  R(kAdc2 + 8) = 1, R(kAdc2 + 0x10) = 0x38;  // ADC2 occasionally interrupts at the end of a conversion
  R(kAdc2 + 4) = 0x20;
  enable(kIrqAdc, converted, 6);
}
static void by_dma(unsigned n) {
  R(kUsartCr3) |= kDmaT;
  R(kDma1 + 0x44) = 0;
  R(kDma1 + 0x48) = kUsartDr, R(kDma1 + 0x4C) = (unsigned)text, R(kDma1 + 0x44) = n;
}
static unsigned word_by_word[64];
void loop() {
  R(kI2c1) |= 0x100;  // a start, and an address that no device answers
  while (!(R(kI2c1 + 0x14) & 1)) ++counts[1];
  R(kI2c1 + 0x10) = 0x46;
  while (!(R(kI2c1 + 0x14) & 0x402)) ++counts[2];
  R(kI2c1 + 0x14) = 0, R(kI2c1) |= 0x200;
  R(kSpi1 + 0xC) = counts[1];
  while (!(R(kSpi1 + 8) & 1)) ++counts[3];
  counts[4] += R(kSpi1 + 0xC) + samples[7];
  R(kDma1 + 0x30) = 0;  // memory to memory: channel 3
  R(kDma1 + 0x38) = (unsigned)counts, R(kDma1 + 0x3C) = (unsigned)word_by_word, R(kDma1 + 0x34) = 8;
  R(kDma1 + 0x30) = 0x4AC1;
  Serial.write(text[counts[5]++ % 20]);
  counts[6] ^= R(0xE0001004);  // DWT_CYCCNT
  if (counts[5] % 4 == 0) R(kAdc2 + 8) = 1;
  if (counts[5] % 30 == 9) by_dma(20);
})"},
    {"Watchdogs", R"(
void setup() {
  Serial.begin(115200);
  Serial.println(R(kRccCsr), HEX);  // why it was reset
  R(0xE000EDFC) |= 1u << 24, R(0xE0001000) |= 1;
  R(kRccAhbEnr) |= kCrcUnitEn;
  R(kRccApb2Enr) |= 1, R(kRccApb1Enr) |= 0x18000800;
  if (R(kBkp + 4) == 0) {
    R(kRccCsr) |= kLsiOn;
    while (!(R(kRccCsr) & kLsiReady)) {}
    R(kPwr) |= 0x100;
    R(kRccBdcr) = 0x8200;  // the RTC on LSI
    R(kRtc + 4) = 0x10;
    R(kRtc + 0xC) = 13;
    R(kRtc + 4) = 0;
  }
  R(kPwr) |= 0x100;
  R(kBkp + 4) = R(kBkp + 4) + 1;  // a backup register
  if (R(kBkp + 4) == 3) R(kWwdg + 4) = 0x1FF, R(kWwdg) = 0xFF;  // the window watchdog: 58 ms
  if (R(kBkp + 4) == 2)
    R(kIwdg) = 0x5555, R(kIwdg + 4) = 2, R(kIwdg + 8) = 50, R(kIwdg) = 0xCCCC;
}
void loop() {
  if (millis() < 12) R(kIwdg) = 0xAAAA, R(kPwr) &= ~0x100u;
  if (R(kBkp + 4) == 1 && millis() > 20) R(kScbAircr) = 0x05FA0004;  // SYSRESETREQ
  counts[0] += R(kRtc + 0x1C) + R(0xE0001004);
  R(kBkp + 8) = counts[0];
  R(kCrc) = counts[0] + R(kWwdg) + R(kBkp + 8);
  counts[1] = R(kCrc);
  delay(2);
  Serial.print(R(kRtc + 0x1C));
})"},
    {"Flash", R"(#include <EEPROM.h>
static volatile unsigned short* const half = (volatile unsigned short*)0x0800E000;
void setup() { Serial.begin(115200); }
void loop() {
  static int i;
  EEPROM.write(i++ % 7, micros());
  R(kFlashKeyr) = kFlashKey1, R(kFlashKeyr) = kFlashKey2;
  if (i == 20) R(kFlashCr) = kFlashPer, R(kFlashAr) = 0x0800E000, R(kFlashCr) = kFlashPer | kFlashStart;
  R(kFlashCr) = kFlashPg;
  half[i * 2] = micros();
  R(kFlashCr) = kFlashLock;
  Serial.println(EEPROM.read(3) + half[4] + half[i * 2]);
})",
     true, 1400},
    {"OwnCode", R"(
// Runs code that the sketch writes to flash and partly overwrites with zeros. Also runs code in RAM.
static unsigned short* const code = (unsigned short*)0x0800F000;
static unsigned short in_ram[4] = {0x3001, 0xEA80, 0x0040, 0x4770};  // adds; eor r0, r0, r0, lsl #1; bx lr
typedef unsigned (*Function)(unsigned);
static void program(int at, unsigned value) {
  R(kFlashKeyr) = kFlashKey1, R(kFlashKeyr) = kFlashKey2;
  R(kFlashCr) = kFlashPg;
  ((volatile unsigned short*)code)[at] = value;
  R(kFlashCr) = kFlashLock;
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
static void ticked() { ++counts[0]; R(kTim2 + kTimSr) = 0; }
void setup() {
  take_vectors();
  R(kRccApb1Enr) |= kTim2En;
  R(kTim2 + kTimArr) = 60000, R(kTim2 + kTimDier) = kUie, R(kTim2 + kTimCr1) = kCen;
  R(kScbScr) = kSevOnPend;
}
void loop() {
  asm volatile("wfe");
  counts[1] += micros();
  if (R(kNvicIspr) >> kIrqTim2 & 1) R(kTim2 + kTimSr) = 0, R(kNvicIcpr) = 1u << kIrqTim2, ++counts[2];
  if (counts[2] % 8 == 5) asm volatile("sev");
  if (counts[2] % 8 == 7) asm volatile("cpsid i\n wfi\n cpsie i");
  if (counts[2] == 40) enable(kIrqTim2, ticked, 2);
})"},
};

class Stm32Snapshots : public Stm32ChipTest, public testing::WithParamInterface<Case> {
 protected:
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

}  // namespace robosim::exec::snapshots_test
