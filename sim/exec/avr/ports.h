// The ports with what else drives their pins (timers) and what listens to them (interrupts).
//
// PWM is told as a duty (hal/board/avr_timer.h), never as edges. tone() and Servo switch pins in interrupt
// handlers: these edges are told one by one.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/exec/avr/link.h"

namespace robosim::exec::avr {

class Ports {
 public:
  explicit Ports(Link& link);

  /// Whether these registers are written and read here.
  bool owns(reg::Address address) const { return registers_[address].port >= 0; }
  void write(reg::Address address, std::uint8_t value);
  /// Of a PIN register. Only the pins that the instruction looks at are asked: a sensor's answer may be
  /// costly, and may use up a sample of its noise.
  std::uint8_t read(reg::Address address);

  /// The timer whose PWM a write to this register changes; -1 = none. Of 16-bit registers the low byte
  /// counts.
  int timer_of(reg::Address address) const { return registers_[address].timer; }
  /// Whether a write to this register may change which edges are noticed.
  bool selects_interrupts(reg::Address address) const { return registers_[address].selects_interrupts; }
  /// A register of timer `number` has changed.
  void timer_changed(int number);
  /// A register has changed that says which edges are noticed.
  void interrupts_changed();
  void deliver(const BoardInput& edge);
  /// All registers are 0 again.
  void was_reset();

  Pin last_read() const { return last_read_; }
  Cycle last_read_at() const { return last_read_at_; }

 private:
  struct Port {
    avr_ioport_t* module = nullptr;
    std::array<Pin, 8> pins{};  ///< by bit; kNoPin where the board has none
    std::uint8_t seen = 0;      ///< levels found at the last look
  };
  /// What a register is to this class.
  struct Register {
    int port = -1;
    int timer = -1;
    bool selects_interrupts = false;
  };

  Port& port_at(int number) { return ports_[static_cast<std::size_t>(number)]; }
  reg::Address pin_register(int port) const { return static_cast<reg::Address>(chip_.ports[port].address); }
  reg::Address direction_register(int port) const {
    return static_cast<reg::Address>(chip_.ports[port].address + 1);
  }
  reg::Address latch_register(int port) const {
    return static_cast<reg::Address>(chip_.ports[port].address + 2);
  }
  reg::Address control_register(int timer) const {
    return static_cast<reg::Address>(chip_.timers[timer].control);
  }
  const ChipPin& place_of(Pin pin) const;
  PinDrive drive_of(Pin pin) const;
  PinDrive timer_drive(int timer, int channel) const;
  int connection(int timer, int channel) const;
  void refresh(Pin pin);
  void refresh_port(int port);
  std::uint8_t asked_bits() const;
  void want_edges(Pin pin, bool wanted);
  bool notices_edges(Pin pin) const;
  void follow_levels();

  Link& link_;
  const ChipSpec& chip_;
  std::vector<Port> ports_;
  std::vector<std::array<Pin, 2>> timer_pins_;  ///< by timer and its output
  std::vector<Register> registers_;             ///< by address
  std::vector<Pin> digital_pins_;
  Pin last_read_ = kNoPin;
  Cycle last_read_at_ = 0;
};

}  // namespace robosim::exec::avr
