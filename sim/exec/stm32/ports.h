// Models ports A, B and C with AFIO and EXTI: pin drives, pin levels and edge interrupts (RM0008 9, 10).
//
// A read of GPIOx_IDR samples all inputs of the port from the robot. A read through the bit-band region
// (PM0056 2.2.5) samples only one pin. Open-drain outputs that are high count as inputs. EXTI and timers
// receive edges from the robot and from the chip's own outputs. PWM is reported as a duty cycle, never as
// edges. A read of a pin with PWM returns the pin's present level.
#pragma once

#include <array>
#include <functional>

#include "sim/exec/stm32/peripheral.h"

namespace robosim::exec::stm32 {

class Ports final : public Peripheral {
 public:
  /// `alternate` must return the way in which the peripheral that owns a pin drives the pin. `pulse` must
  /// return the present level of a pin with PWM. `watched` must return whether a peripheral needs the edges
  /// of a pin.
  Ports(Link& link, std::function<PinDrive(ChipPin)> alternate, std::function<Pulse(ChipPin)> pulse,
        std::function<bool(ChipPin)> watched);

  /// Returns whether the register belongs to a port, not to AFIO or EXTI.
  static bool owns_port(Address address) {
    using namespace robosim::stm32;
    return address >= kGpioA && address < kGpioA + kPorts * kPortBytes;
  }
  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  /// Resets a port, AFIO or EXTI.
  void reset(Address block) override;
  Cycle same_until(Address address) const override;
  /// Returns one bit of GPIOx_IDR.
  bool read_input(ChipPin pin);
  Cycle input_same_until(ChipPin pin) const;

  /// Samples the pin from the robot, and returns its present level.
  bool level(ChipPin pin) const;
  /// Handles the RTC alarm, which is EXTI line 17.
  void alarmed();
  /// Handles a change in the set of pins with listeners for edges.
  void watch();

  /// Reports to the board how the pin is driven now.
  void refresh(ChipPin pin);
  void deliver(const BoardInput& edge);

  Pin last_read() const { return state_.last_read; }
  Cycle last_read_at() const { return state_.last_read_at; }
  /// Returns the number of the port that has the register.
  static int port_of(Address address) {
    return static_cast<int>((address - robosim::stm32::kGpioA) / robosim::stm32::kPortBytes);
  }

 private:
  static constexpr int kPorts = 3, kBits = 16;
  struct Port {
    std::array<std::uint32_t, 2> configuration{0x44444444, 0x44444444};  ///< CRL, CRH
    std::uint32_t output = 0;
    std::uint32_t pwm = 0;  ///< one bit for each pin with PWM
  };

  struct State {
    std::array<Port, kPorts> ports;
    std::array<std::uint32_t, 4> sources{};
    std::uint32_t mask = 0, events = 0, rising = 0, falling = 0, pending = 0, software = 0;
    Pin last_read = kNoPin;
    Cycle last_read_at = 0;
  };

  std::uint32_t configuration(ChipPin pin) const;
  PinDrive drive_of(ChipPin pin) const;
  Pin number_of(ChipPin pin) const {
    return numbers_[static_cast<std::size_t>(pin.port)][static_cast<std::size_t>(pin.bit)];
  }
  bool makes_pwm(ChipPin pin) const {
    return state_.ports[static_cast<std::size_t>(pin.port)].pwm >> pin.bit & 1;
  }
  /// Notes a read of the pin. Returns the board's pin; kNoPin if the pin does not exist or is analog.
  Pin note_read(ChipPin pin);
  void refresh_port(int port);
  bool write_port(int port, Address offset, std::uint32_t value);
  bool write_exti(Address address, std::uint32_t value);
  void interrupts_changed();
  void change_map(std::uint32_t map);
  /// Handles edges on a set of EXTI lines, one bit each.
  void came(std::uint32_t lines);
  /// Returns the port to which EXTI line `line` is connected.
  int source(int line) const;

  Link& link_;
  std::function<PinDrive(ChipPin)> alternate_;
  std::function<Pulse(ChipPin)> pulse_;
  std::function<bool(ChipPin)> watched_;
  std::array<std::array<Pin, kBits>, kPorts> numbers_;
  State state_;
};

}  // namespace robosim::exec::stm32
