// Simulates one AVR chip: processor, peripherals and pins. The caller provides the flash and the environment,
// and runs the chip until a given cycle.
//
//   Chip ── Core: Cpu, Events, Interrupts
//     ├──── Pins ── ExternalInterrupts, Timer ×n, Usart ×n, Adc, …   one file each
//     └──── Power: sleep modes, PRR, CLKPR, reset flags in MCUSR
//
// Runs are deterministic. Equal flash and equal environments give equal runs, regardless of how many calls of
// run_to() divide the run.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/mcu/avr/core.h"
#include "sim/mcu/avr/idle.h"
#include "sim/mcu/avr/pins.h"
#include "sim/mcu/avr/power.h"
#include "sim/mcu/avr/usart.h"

namespace robosim::avr {

class UsbHost;

class Chip {
 public:
  /// `last_ram` is the last address of data memory, which can be after the end of the chip's own RAM.
  Chip(const ChipSpec& spec, std::span<const std::uint8_t> flash, Address last_ram, ChipEnvironment& around,
       std::int64_t oscillator_hz = 16'000'000);
  ~Chip();
  Chip(const Chip&) = delete;
  Chip& operator=(const Chip&) = delete;

  using Stop = Cpu::Stop;

  /// Runs until cycle `until`. An instruction that crosses `until` is completed.
  Stop run_to(Cycle until);
  /// Makes run_to() return after each instruction, and after each time skip during sleep.
  void step_singly(bool singly) { singly_ = singly; }

  Cycle cycle() const { return core_.now(); }
  bool is_asleep() const { return power_.is_asleep(); }
  Cycle sleep_cycles() const { return power_.slept(cycle()); }

  /// Returns the enabled interrupts that can occur without further register accesses by firmware; one bit per
  /// vector.
  std::uint64_t may_interrupt() const;

  // --- external inputs
  /// Reports a level change of a pin whose edges were requested; `pin` is an index in ChipSpec::pins.
  void edge(int pin, bool level, Cycle at) { pins_.edge(pin, level, at); }
  /// Delivers a whole frame to a UART, or a byte to the USB serial line, at cycle `at`. `line` is an index in
  /// ChipSpec::uarts; the number after the last UART is USB. The data is lost if the receiver is off.
  void receive(int line, std::uint16_t data, Cycle at);
  /// Requests a call of ChipEnvironment::called() at `cycle`; a new request replaces the old one.
  void call_at(Cycle cycle) { core_.schedule(call_, cycle); }
  /// Resets the chip as the reset pin or a power-on does, and adds `flags` to MCUSR.
  void reset(std::uint8_t flags);

  Cpu& cpu() { return core_.cpu; }
  const Cpu& cpu() const { return core_.cpu; }
  Core& core() { return core_; }
  const Core& core() const { return core_; }
  /// Returns the object that skips waiting loops (idle.h). Skipping has no effect on firmware or the
  /// environment.
  Idle& idle() { return idle_; }
  const Idle& idle() const { return idle_; }
  Pins& pins() { return pins_; }

  /// Saves all state that changes while the chip runs, except the environment's state.
  SnapshotRegistry::Snapshot save() const { return core_.snapshots.save(); }
  /// Restores a snapshot of this chip, or of a chip that was constructed with equal arguments.
  void restore(const SnapshotRegistry::Snapshot& saved);

 private:
  void make_peripherals();
  void power_on();
  void do_due();
  bool may_pass_mark();
  void called(Cycle at) { core_.environment.called(at); }
  void reset_later(std::uint8_t flags);

  Core core_;
  Pins pins_;
  Power power_;
  Idle idle_;
  std::vector<std::unique_ptr<Peripheral>> peripherals_;
  std::vector<Usart*> usarts_;
  UsbHost* usb_host_ = nullptr;
  Events::Id call_ = 0;
  bool singly_ = false;
  std::uint8_t reset_flags_ = 0;  ///< MCUSR flags of the reset that a peripheral requests
};

}  // namespace robosim::avr
