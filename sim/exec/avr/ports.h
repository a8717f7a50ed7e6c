// Ports B, C and D with what else drives their pins (timers) and what listens to them (interrupts).
//
// PWM is told as a duty (hal/board/avr_timer.h), never as edges. tone() and Servo switch pins in interrupt
// handlers: these edges are told one by one.
#pragma once

#include <array>
#include <cstdint>

#include "sim/exec/avr/link.h"

namespace robosim::exec::avr {

class Ports {
 public:
  explicit Ports(Link& link);

  /// Whether these registers are written and read here.
  static bool owns(reg::Address address) { return address >= reg::kPinB && address < reg::kPinB + 9; }
  void write(reg::Address address, std::uint8_t value);
  /// Of a PIN register. Only the pins that the instruction looks at are asked: a sensor's answer may be
  /// costly, and may use up a sample of its noise.
  std::uint8_t read(reg::Address address);

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
  static constexpr int kPorts = 3;

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
  std::array<avr_ioport_t*, kPorts> modules_{};
  std::array<std::uint8_t, kPorts> seen_{};  ///< levels found at the last look
  Pin last_read_ = kNoPin;
  Cycle last_read_at_ = 0;
};

}  // namespace robosim::exec::avr
