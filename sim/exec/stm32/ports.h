// Ports A, B and C with AFIO and EXTI: how each pin is driven, what it reads, which edges interrupt (RM0008
// 9, 10).
//
// A read of GPIOx_IDR asks the robot for all inputs of the port; one through the bit-band region
// (PM0056 2.2.5) asks for one pin only. Open-drain outputs that are high count as inputs. EXTI and timers
// hear an output of the chip's own as they hear the robot. PWM is told as a duty, never as edges; a program
// that reads the pin sees its level.
#pragma once

#include <array>
#include <functional>

#include "sim/exec/stm32/peripheral.h"

namespace robosim::exec::stm32 {

class Ports final : public Peripheral {
 public:
  /// `alternate` says how the peripheral that has the pin drives it.
  /// `pulse`: what the pin's PWM does now.
  /// `watched`: whether a peripheral wants to hear of its edges.
  Ports(Link& link, std::function<PinDrive(ChipPin)> alternate, std::function<Pulse(ChipPin)> pulse,
        std::function<bool(ChipPin)> watched);

  /// Whether it is a port's, not of AFIO or EXTI.
  static bool owns_port(Address address) {
    using namespace robosim::stm32;
    return address >= kGpioA && address < kGpioA + kPorts * kPortBytes;
  }
  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  /// A port, AFIO or EXTI.
  void reset(Address block) override;
  Cycle same_until(Address address) const override;
  /// One bit of GPIOx_IDR.
  bool read_input(ChipPin pin);
  Cycle input_same_until(ChipPin pin) const;

  /// As it is now; asks the robot.
  bool level(ChipPin pin) const;
  /// The RTC's alarm: line 17.
  void alarmed();
  /// The pins whose edges somebody wants to hear of have changed.
  void watch();

  /// The peripheral drives the pin differently.
  void refresh(ChipPin pin);
  void deliver(const BoardInput& edge);

  Pin last_read() const { return state_.last_read; }
  Cycle last_read_at() const { return state_.last_read_at; }
  /// The port's letter and the offset of a register of it.
  static int port_of(Address address) {
    return static_cast<int>((address - robosim::stm32::kGpioA) / robosim::stm32::kPortBytes);
  }

 private:
  static constexpr int kPorts = 3, kBits = 16;
  struct Port {
    std::array<std::uint32_t, 2> configuration{0x44444444, 0x44444444};  ///< CRL, CRH
    std::uint32_t output = 0;
    std::uint32_t pwm = 0;  ///< a bit for each pin that makes PWM
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
  /// Its number; kNoPin if nothing can be read there.
  Pin note_read(ChipPin pin);
  void refresh_port(int port);
  bool write_port(int port, Address offset, std::uint32_t value);
  bool write_exti(Address address, std::uint32_t value);
  void interrupts_changed();
  void change_map(std::uint32_t map);
  /// Something has come by these lines.
  void came(std::uint32_t lines);
  /// The port that line `line` listens to.
  int source(int line) const;

  Link& link_;
  std::function<PinDrive(ChipPin)> alternate_;
  std::function<Pulse(ChipPin)> pulse_;
  std::function<bool(ChipPin)> watched_;
  std::array<std::array<Pin, kBits>, kPorts> numbers_;
  State state_;
};

}  // namespace robosim::exec::stm32
