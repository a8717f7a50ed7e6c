// Tests the timers (RM0008, chapters 14 and 15), and the pins that AFIO_MAPR assigns to them (9.3).
#include <vector>

#include "tests/unit/exec_stm32/bus_fixture.h"

namespace robosim::exec::stm32::timers_test {

using namespace robosim::stm32;

constexpr Pin kPa0 = 14, kPa1 = 15, kPa6 = 12, kPa15 = 25, kPb3 = 26, kPb13 = 4, kPa8 = 3, kPb4 = 27;

class TimersTest : public BusFixture, protected PinWatcher {
 protected:
  void SetUp() override {
    BusFixture::SetUp();
    store(kAfioMapr, kSwjNoJtag);
    for (Address port = 0; port < 3; ++port)
      for (const Address half : {kCrl, kCrh}) store(kGpioA + port * kPortBytes + half, 0x44444444);
  }
  void pin_changed(Pin, const PinDrive& drive, SimTime t) override { edges_.push_back({t, drive.level}); }
  /// Makes the pin an output of its timer.
  void alternate(int port, int bit) {
    const Address at = kGpioA + static_cast<Address>(port) * kPortBytes + (bit < 8 ? kCrl : kCrh);
    const int shift = 4 * (bit % 8);
    store(at, (load(at) & ~(15u << shift)) | kAlternate << shift);
  }
  /// Schedules an edge after `in` cycles of the 8 MHz clock, and runs until one cycle after the edge.
  void edge(Pin pin, bool level, Cycle in) {
    levels_[pin] = level;
    board_.schedule_edge(pin, level, bus_.link().clock.time_of(now() + in));
    board_.connect(pin, *sources_.emplace_back(std::make_unique<Level>(level)));
    pass(in + 1);
  }
  struct Level final : PinSource {
    explicit Level(bool is_high) : high(is_high) {}
    bool level(SimTime) override { return high; }
    bool high;
  };

  std::vector<std::pair<SimTime, bool>> edges_;
  std::vector<std::unique_ptr<Level>> sources_;
  bool levels_[32] = {};
};

TEST_F(TimersTest, CountsUpDownAndBothWays) {
  store(kTim2 + kTimPsc, 9);
  store(kTim2 + kTimArr, 99);
  for (const auto& [control, first, later] :
       {std::tuple{0u, 25u, 50u}, {1u << 4, 74u, 49u}, {1u << 5, 25u, 50u}}) {
    store(kTim2 + kTimCr1, control);
    store(kTim2 + kTimEgr, kUg);
    store(kTim2 + kTimSr, 0);
    store(kTim2 + kTimCr1, control | kCen);
    pass(250);
    EXPECT_EQ(load(kTim2 + kTimCnt), first) << control;
    pass(1250);
    EXPECT_EQ(load(kTim2 + kTimCnt), control == 1u << 5 ? 48u : later) << control;
    EXPECT_EQ(load(kTim2 + kTimSr) & kUif, kUif);
    EXPECT_EQ(bool(load(kTim2 + kTimCr1) & 1u << 4), control != 0) << "the timer counts down";
  }
}

TEST_F(TimersTest, RunAtTwiceTheirBusWhereThatIsDivided) {
  store(kRccCfgr, 8u << 4 | 5u << 11 | 4u << 8);  // AHB / 2, APB2 / 4, APB1 / 2
  EXPECT_EQ(bus_.link().clock.hz(), 4'000'000u);
  store(kTim1 + kTimCr1, kCen);
  store(kTim2 + kTimCr1, kCen);
  pass(100);
  EXPECT_EQ(load(kTim1 + kTimCnt), 50u);
  EXPECT_EQ(load(kTim2 + kTimCnt), 100u);
}

TEST_F(TimersTest, ComparesInterruptAtTheirCounts) {
  enable(kIrqTim3);
  store(kTim3 + kTimArr, 999);
  store(kTim3 + kTimCcr1, 100);
  store(kTim3 + kTimCcr1 + 4, 400);
  store(kTim3 + kTimDier, 1u << 2);  // CC2IE
  store(kTim3 + kTimCr1, kCen);
  pass(399);
  EXPECT_EQ(load(kTim3 + kTimSr) & 7, 0b010u);
  EXPECT_FALSE(takes(kIrqTim3));
  pass(1);
  EXPECT_EQ(load(kTim3 + kTimSr) & 7, 0b110u);
  store(kTim3 + kTimSr, 0);
  EXPECT_TRUE(takes(kIrqTim3));
  pass(999);
  EXPECT_FALSE(takes(kIrqTim3));
  pass(1);
  EXPECT_TRUE(takes(kIrqTim3));
}

TEST_F(TimersTest, WhatIsPreloadedCountsFromTheNextUpdateOn) {
  alternate(0, 6);
  store(kTim3 + kTimArr, 999);
  store(kTim3 + kTimCcmr1, kPwmMode1 | kPreload);
  store(kTim3 + kTimCcer, 1);
  store(kTim3 + kTimCcr1, 250);
  store(kTim3 + kTimCr1, kCen | kArpe);
  EXPECT_DOUBLE_EQ(board_.drive(kPa6).duty, 0.25);
  pass(100);
  store(kTim3 + kTimCcr1, 400);
  store(kTim3 + kTimArr, 799);
  EXPECT_EQ(load(kTim3 + kTimCcr1), 400u);
  pass(899);
  EXPECT_DOUBLE_EQ(board_.drive(kPa6).duty, 0.25);
  pass(1);
  EXPECT_DOUBLE_EQ(board_.drive(kPa6).duty, 0.5);
  pass(799);
  EXPECT_EQ(load(kTim3 + kTimCnt), 799u);
}

TEST_F(TimersTest, AChannelTogglesItsPin) {
  alternate(0, 6);
  store(kTim3 + kTimArr, 999);
  store(kTim3 + kTimCcr1, 200);
  store(kTim3 + kTimCcmr1, 3u << 4);
  store(kTim3 + kTimCcer, 1);
  board_.watch(kPa6, *this);
  store(kTim3 + kTimCr1, kCen);
  pass(2500);
  ASSERT_EQ(edges_.size(), 3u);
  EXPECT_EQ(edges_[1].first - edges_[0].first, 125'000);
  EXPECT_TRUE(edges_[0].second);
  EXPECT_FALSE(edges_[1].second);
}

TEST_F(TimersTest, TheProgramReadsTheLevelOfItsOwnPwm) {
  alternate(0, 6);
  store(kTim3 + kTimArr, 99);
  store(kTim3 + kTimCcr1, 30);
  store(kTim3 + kTimCcer, 1);
  const Address idr = kGpioA + kIdr, bit = 0x42000000 + (idr - 0x40000000) * 32 + 6 * 4;
  // In PWM mode 1, the output is active while CNT < CCR when counting up. When counting down, the output is
  // active while CNT <= CCR (RM0008, 14.3.10). A centre-aligned timer counts up and down.
  for (const auto& [control, mode, high] : {std::tuple{0u, kPwmMode1, 30},
                                            {1u << 4, kPwmMode1, 31},
                                            {1u << 5, kPwmMode1, 60},
                                            {0u, 7u << 4, 70}}) {
    const int period = control == 1u << 5 ? 198 : 100;
    store(kTim3 + kTimCr1, control);
    store(kTim3 + kTimCcmr1, mode);
    store(kTim3 + kTimEgr, kUg);
    store(kTim3 + kTimCr1, control | kCen);
    pass(1000);
    int seen = 0, by_bit = 0;
    for (int i = 0; i < period; ++i) {
      const bool level = load(idr) >> 6 & 1;
      const Cycle until = bus_.same_until(idr);
      EXPECT_GT(until, now());
      EXPECT_EQ(bus_.same_until(bit), until);
      seen += level;
      by_bit += static_cast<int>(load(bit));
      pass(1);
      EXPECT_TRUE(now() >= until || (load(idr) >> 6 & 1) == level) << control << " at " << i;
    }
    EXPECT_EQ(seen, high) << control;
    EXPECT_EQ(by_bit, high) << control;
  }
}

TEST_F(TimersTest, CapturesTheCountAtAnEdgeOfEitherInputOfAPair) {
  enable(kIrqTim2);
  store(kTim2 + kTimCcmr1, 1u << 0 | 2u << 8);  // channels 1 and 2 capture TI1
  store(kTim2 + kTimCcer, 1u << 0 | 3u << 4);   // channel 2 captures the falling edge
  store(kTim2 + kTimDier, 1u << 1);
  store(kTim2 + kTimCr1, kCen);
  edge(kPa0, true, 300);
  EXPECT_TRUE(takes(kIrqTim2));
  edge(kPa0, false, 200);
  EXPECT_EQ(load(kTim2 + kTimSr) & 6, 6u);
  EXPECT_EQ(load(kTim2 + kTimCcr1), 300u);
  EXPECT_EQ(load(kTim2 + kTimCcr1 + 4), 501u);
  EXPECT_EQ(load(kTim2 + kTimSr) & 6, 0u) << "reading the capture clears its flag";
  edge(kPa0, true, 10);
  edge(kPa0, false, 10);
  edge(kPa0, true, 10);
  EXPECT_EQ(load(kTim2 + kTimSr) & 1u << 9, 1u << 9) << "one capture was lost";
}

TEST_F(TimersTest, CountsAnEncodersEdgesInItsDirection) {
  store(kTim2 + kTimSmcr, 3);
  store(kTim2 + kTimCcmr1, 0x0101);
  store(kTim2 + kTimCr1, kCen);
  const auto turn = [&](Pin first, Pin second, int steps) {
    for (int i = 0; i < steps; ++i)
      edge(i % 2 == 0 ? first : second, !levels_[i % 2 == 0 ? first : second], 50);
  };
  turn(kPa0, kPa1, 8);
  EXPECT_EQ(load(kTim2 + kTimCnt), 8u);
  EXPECT_EQ(load(kTim2 + kTimCr1) & 1u << 4, 0u);
  turn(kPa1, kPa0, 12);
  EXPECT_EQ(load(kTim2 + kTimCnt), 0xFFFCu);
  EXPECT_EQ(load(kTim2 + kTimCr1) & 1u << 4, 1u << 4);
  EXPECT_EQ(load(kTim2 + kTimSr) & kUif, kUif);
}

TEST_F(TimersTest, OneTimerCountsTheOthersUpdates) {
  store(kTim2 + kTimArr, 99);
  store(kTim2 + kTimCr2, 2u << 4);       // TRGO = update
  store(kTim3 + kTimSmcr, 7 | 1u << 4);  // counts ITR1, which is TIM2's TRGO
  store(kTim3 + kTimCr1, kCen);
  store(kTim2 + kTimCr1, kCen);
  pass(1050);
  EXPECT_EQ(load(kTim3 + kTimCnt), 10u);
}

TEST_F(TimersTest, TimerOneHasComplementsRepetitionsAndFourInterrupts) {
  alternate(0, 8);
  alternate(1, 13);
  for (const Irq irq : {kIrqTim1Update, kIrqTim1Capture, kIrqTim1Trigger, kIrqTim1Break}) enable(irq);
  store(kTim1 + kTimArr, 99);
  store(kTim1 + kTimRcr, 3);
  store(kTim1 + kTimCcr1, 25);
  store(kTim1 + kTimCcmr1, kPwmMode1);
  store(kTim1 + kTimCcer, 1 | 4);
  store(kTim1 + kTimEgr, kUg);
  store(kTim1 + kTimSr, 0);
  store(kTim1 + kTimDier, kUie);
  store(kTim1 + kTimBdtr, kMoe | 20);
  store(kTim1 + kTimCr1, kCen);
  EXPECT_DOUBLE_EQ(board_.drive(kPa8).duty, 0.25);
  EXPECT_DOUBLE_EQ(board_.drive(kPb13).duty, 0.75);
  pass(399);
  EXPECT_FALSE(takes(kIrqTim1Update));
  pass(1);
  EXPECT_TRUE(takes(kIrqTim1Update));
  store(kTim1 + kTimSr, 0);
  store(kTim1 + kTimDier, 1u << 1);
  pass(25);
  EXPECT_TRUE(takes(kIrqTim1Capture));
}

TEST_F(TimersTest, PreloadedOutputsChangeAtACommutation) {
  alternate(0, 8);
  enable(kIrqTim1Trigger);
  store(kTim1 + kTimArr, 99);
  store(kTim1 + kTimCcr1, 25);
  store(kTim1 + kTimCcmr1, kPwmMode1);
  store(kTim1 + kTimBdtr, kMoe);
  store(kTim1 + kTimCr1, kCen);
  store(kTim1 + kTimCr2, 1);
  store(kTim1 + kTimCcer, 1);
  EXPECT_EQ(load(kTim1 + kTimCcer), 1u);
  EXPECT_FALSE(board_.drive(kPa8).pwm);
  store(kTim1 + kTimDier, 1u << 5);
  store(kTim1 + kTimEgr, 1u << 5);
  EXPECT_TRUE(board_.drive(kPa8).pwm);
  EXPECT_TRUE(takes(kIrqTim1Trigger));
}

TEST_F(TimersTest, UpdatesFillAWaveByDma) {
  const Address channel2 = kDma1 + 8 + 20, table = kRam + 0x40;
  for (Address i = 0; i < 4; ++i) *bus_.ram().at(table + i, 1) = static_cast<std::uint8_t>(10 * (i + 1));
  store(channel2 + 8, kTim2 + kTimCcr1);
  store(channel2 + 12, table);
  store(channel2 + 4, 4);
  store(channel2, 1 | 1u << 4 | 1u << 7 | 1u << 8);
  store(kTim2 + kTimArr, 99);
  store(kTim2 + kTimDier, 1u << 8);
  store(kTim2 + kTimCr1, kCen);
  for (std::uint32_t i = 1; i <= 4; ++i) {
    pass(100);
    EXPECT_EQ(load(kTim2 + kTimCcr1), 10 * i);
  }
  EXPECT_EQ(load(kDma1) & 0x20, 0x20u);
}

TEST_F(TimersTest, ACompareStartsTheAdc) {
  store(kTim2 + kTimArr, 999);
  store(kTim2 + kTimCcr1 + 4, 500);
  store(kAdcCr2, kAdOn | 3u << 17 | kExtTrig);  // TIM2_CC2
  store(kTim2 + kTimCr1, kCen);
  pass(499);
  EXPECT_EQ(load(kAdcSr), 0u);
  pass(1);
  EXPECT_EQ(load(kAdcSr), kStrt);
  pass(28);
  EXPECT_EQ(load(kAdcSr), kEoc | kStrt);
}

TEST_F(TimersTest, TheirPinsMoveWithTheMapAndJtagKeepsItsOwnUntilItIsFreed) {
  alternate(0, 0);
  alternate(0, 15);
  alternate(1, 3);
  alternate(1, 4);
  store(kTim2 + kTimArr, 99);
  store(kTim2 + kTimCcr1, 50);
  store(kTim2 + kTimCcmr1, kPwmMode1);
  store(kTim2 + kTimCcer, 1);
  store(kTim2 + kTimCr1, kCen);
  EXPECT_TRUE(board_.drive(kPa0).pwm);
  store(kAfioMapr, 1u << 8);
  EXPECT_FALSE(board_.drive(kPa0).pwm);
  EXPECT_EQ(board_.drive(kPa15).mode, PinMode::input_pullup) << "JTDI";
  EXPECT_EQ(board_.drive(kPb3).mode, PinMode::input) << "JTDO";
  EXPECT_EQ(board_.drive(kPb4).mode, PinMode::input_pullup) << "NJTRST";
  store(kAfioMapr, 1u << 8 | 1u << 24);
  EXPECT_EQ(board_.drive(kPb4).mode, PinMode::output);
  EXPECT_EQ(board_.drive(kPa15).mode, PinMode::input_pullup);
  store(kAfioMapr, 1u << 8 | kSwjNoJtag);
  EXPECT_TRUE(board_.drive(kPa15).pwm);
  EXPECT_DOUBLE_EQ(board_.drive(kPa15).duty, 0.5);
}

TEST_F(TimersTest, AUsartsPinMovesWithTheMap) {
  constexpr Pin kPa9 = 1, kPb6 = 5;
  alternate(0, 9);
  alternate(1, 6);
  store(kUsartCr1, kUe | kTe);
  EXPECT_TRUE(board_.drive(kPa9).level);
  EXPECT_FALSE(board_.drive(kPb6).level);
  store(kAfioMapr, 1u << 2 | kSwjNoJtag);
  EXPECT_FALSE(board_.drive(kPa9).level);
  EXPECT_TRUE(board_.drive(kPb6).level);
}

}  // namespace robosim::exec::stm32::timers_test
