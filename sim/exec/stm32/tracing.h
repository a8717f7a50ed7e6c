// The debug components that programs themselves use (RM0008 31; PM0056 lacks them: ARM DDI 0337E 11, 17).
// They are the cycle counter DWT_CYCCNT, and ITM, which accepts all output, and drops it. Other registers of
// DWT, ITM, TPIU and DBGMCU store what is written.
#pragma once

#include <map>

#include "sim/exec/stm32/peripheral.h"

namespace robosim::exec::stm32 {

class Tracing final : public Peripheral {
 public:
  explicit Tracing(Link& link) : link_(link) { link.snapshots.add(state_); }

  static bool owns(Address address);
  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;

 private:
  struct State {
    std::map<Address, std::uint32_t> kept;
    bool counts = false;
    std::uint32_t held = 0;
    Cycle zero_at = 0;
  };

  std::uint32_t cycles() const;

  Link& link_;
  State state_;
};

}  // namespace robosim::exec::stm32
