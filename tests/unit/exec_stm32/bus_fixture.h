// A test fixture for the peripherals of the Blue Pill, without a processor. The test reads and writes
// registers, and advances time.
#pragma once

#include <gmock/gmock.h>

#include "sim/exec/stm32/bus.h"

namespace robosim::exec::stm32 {

class BusFixture : public testing::Test {
 protected:
  std::uint32_t load(Address address) { return bus_.load(address, 4); }
  void store(Address address, std::uint32_t value) { bus_.store(address, value, 4); }
  Cycle now() { return bus_.link().clock.now; }
  /// Advances time by `cycles`. Updates the peripherals at each event, as the processor does.
  void pass(Cycle cycles) {
    Cycle& clock = bus_.link().clock.now;
    for (const Cycle end = clock + cycles; clock < end;) {
      const Cycle input = bus_.link().clock.cycle_at(bus_.link().board.next_input());
      clock = std::min(end, std::max(std::min(bus_.next_event(), input), clock + 1));
      bus_.update();
      bus_.take_inputs();
    }
  }
  /// Enables the clocks of all peripherals.
  void SetUp() override {
    using namespace robosim::stm32;
    for (const Address enable : {kRccAhbEnr, kRccApb1Enr, kRccApb2Enr}) store(enable, 0xFFFFFFFF);
  }
  void TearDown() override { EXPECT_FALSE(bus_.unmodelled()) << bus_.unmodelled()->what; }
  void enable(robosim::stm32::Irq irq) { store(robosim::stm32::kNvicIser + irq / 32u * 4u, 1u << irq % 32u); }
  /// Returns whether the interrupt is pending, and serves a pending interrupt. The interrupt must be enabled.
  bool takes(robosim::stm32::Irq irq) {
    if (bus_.link().nvic.wakes() != kFirstIrq + irq) return false;
    bus_.link().nvic.enter(kFirstIrq + irq);
    bus_.link().nvic.leave(kFirstIrq + irq);
    return true;
  }

  BoardState board_{*find_board("bluepill")};
  ClockedBoard clocked_{board_};
  FlashMemory flash_;
  Bus bus_{clocked_, flash_, 0};
};

}  // namespace robosim::exec::stm32
