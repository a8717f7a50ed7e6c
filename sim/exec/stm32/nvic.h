// Models the interrupt controller NVIC and the system control block SCB (PM0056 4.3, 4.4; exceptions 2.3).
// Selects the exception that the processor takes next.
//
// A lower number is a higher priority. The chip implements the upper four of the 8 priority bits, and uses
// all four for preemption. An exception preempts running code if its priority is strictly higher. If several
// exceptions are pending, the exception with the highest priority is taken first. Among equal priorities, the
// lowest exception number is first.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "hal/stm32/addresses.h"

namespace robosim::exec::stm32 {

using robosim::stm32::Address;

/// The number of an exception. SysTick has the number 15, and the first interrupt has the number 16.
using Exception = int;
constexpr Exception kSvcall = 11, kPendSv = 14, kSysTick = 15, kFirstIrq = 16;
constexpr int kExceptions = kFirstIrq + robosim::stm32::kIrqCount;

class Nvic {
 public:
  Nvic();

  static bool owns(Address address);
  /// Reads a register into `value`. Returns false for a register that is not modelled.
  bool read(Address address, std::uint32_t& value) const;
  bool write(Address address, std::uint32_t value);

  void pend(Exception exception);
  void unpend(Exception exception) { pending_ &= ~bit(exception); }
  /// Sets a peripheral's interrupt line. While the line is high, the interrupt becomes pending again after
  /// its handler.
  void set_line(robosim::stm32::Irq irq, bool high);

  /// Returns whether firmware has requested a reset since the last call.
  bool take_reset_request() { return std::exchange(reset_requested_, false); }

  // --- the event register, for which WFE waits (PM0056 2.5.2)
  void set_event() { event_ = true; }
  bool take_event() { return std::exchange(event_, false); }

  bool is_enabled(robosim::stm32::Irq irq) const { return enabled_ & bit(kFirstIrq + irq); }
  bool any_pending() const { return (pending_ | lines_) & enabled_; }
  /// Returns the exception that would preempt running code if PRIMASK and BASEPRI were clear; 0 = none.
  Exception wakes() const { return candidate(0); }
  /// Returns the exception that the processor takes now; 0 = none.
  Exception next(bool primask, std::uint32_t basepri) const { return primask ? 0 : candidate(basepri); }

  void enter(Exception exception);
  void leave(Exception exception);
  /// Returns whether a handler has begun but has not ended.
  bool in_handler() const { return active_ != 0; }

  std::uint32_t vectors() const { return vtor_; }
  bool traps_division() const { return ccr_ & robosim::stm32::kDiv0Trap; }
  bool sleeps_on_exit() const { return scr_ & robosim::stm32::kSleepOnExit; }

 private:
  using Bits = std::uint64_t;  ///< a set of exceptions, one bit each

  static constexpr Bits bit(Exception exception) { return Bits{1} << exception; }
  Exception candidate(std::uint32_t basepri) const;
  unsigned current_priority() const;
  Exception lowest_active() const;
  std::uint32_t irq_word(Bits bits, Address offset) const;
  std::uint32_t control_state() const;
  bool write_scb(Address address, std::uint32_t value);

  Bits pending_ = 0, active_ = 0, lines_ = 0;
  Bits enabled_;
  std::array<std::uint8_t, 64> priority_{};
  bool reset_requested_ = false, event_ = false;
  std::uint32_t vtor_ = 0, scr_ = 0, ccr_ = 0x200, shcsr_ = 0;
};

}  // namespace robosim::exec::stm32
