// type = "pca9685": a driver of 16 PWM channels (NXP data sheet, revision 4), for servos and LEDs.
//
//   one period   4096 counts of 25 MHz / (PRE_SCALE + 1); PRE_SCALE 3 to 255, writable only during sleep
//   channel n    on at LEDn_ON, off at LEDn_OFF (counts); bit 12 of either: always on, always off
//
// Other parts refer to the channels as pins: "pwm.12". Channels change at the STOP of a transfer, without
// waiting for the next period. Outputs that have changed and then stayed the same for 50 ms are reported. The
// report contains the on-times of all channels that are not off: "0:1500us 3:on". After power-on the driver
// sleeps (MODE1 = 0x11), without output. The register number advances only if the bit AI of MODE1 is set.
//
// Not modelled: addresses for several chips, outputs that change at the acknowledge (OCH), inverted or
// open-drain outputs (MODE2), an external clock.
#pragma once

#include "sim/robot/parts/settled_text.h"
#include "sim/robot/parts/two_wire.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_pca9685(PartReader&);

class Pca9685Spec final : public PartSpec {
 public:
  std::uint8_t address = 0;
  /// The place of the chip's outputs in the netlist (netlist.h): output_pin(index, 0) to (index, 15).
  int index = 0;

  std::unique_ptr<Part> make(PartContext&) const override;
};

class Pca9685Part final : public Part, public RegisterDevice, public TextOutput {
 public:
  Pca9685Part(const Pca9685Spec&, PartContext&);

  void register_with(PartRegistry&) override;
  const std::string& name() const override { return spec_.name; }
  std::string poll_text(SimTime) override;
  /// Appends the number of channels that are not off.
  void read(std::vector<Reading>&) const override;
  using RegisterDevice::read;
  void stop(SimTime) override;

 private:
  void set(std::uint8_t number, std::uint8_t value, SimTime t) override;
  std::uint8_t get(std::uint8_t number, SimTime) override { return state_.registers[number]; }
  std::uint8_t behind(std::uint8_t number) const override;
  /// Returns the drive of channel `n`.
  PinDrive channel(int n) const;
  /// Returns the report of a channel; "" while the channel is off.
  std::string pulse(int n) const;

  struct State {
    std::array<std::uint8_t, 256> registers{};
    Cursor cursor;
    SimTime changed_at = 0;
    SettledText text;
  };

  const Pca9685Spec& spec_;
  PartContext& context_;
  State state_;
};

}  // namespace robosim::robot
