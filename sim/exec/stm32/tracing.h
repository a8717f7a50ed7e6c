// Models the debug components that programs may use themselves: the cycle counter DWT_CYCCNT, and the trace
// output ITM. ITM accepts and drops all output. The other registers of DWT, ITM, TPIU and DBGMCU only store
// the written values. Sources: RM0008 31; ARM DDI 0337E 11 and 17, since PM0056 does not describe DWT and
// ITM.
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
