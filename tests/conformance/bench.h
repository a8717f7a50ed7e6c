// A chip on a bench: the test sets levels and voltages at its pins, and receives a list of the chip's
// actions.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "sim/mcu/avr/chip.h"

namespace robosim::conformance {

class Bench final : public avr::ChipEnvironment {
 public:
  explicit Bench(const ChipSpec& spec, std::span<const std::uint8_t> flash)
      : chip(spec, flash, static_cast<avr::Address>(ram_end(spec) - 1), *this) {
    chip.cpu().on_write<&Bench::report>(spec.at.general[0], this);
    chip.cpu().on_write<&Bench::end>(spec.at.general[1], this);
    eeprom_.fill(0xFF);
    arrives_ = chip.core().events.add<&Bench::arrive>(this);
  }

  /// Runs until the program ends, something stops it, or `cycles` have passed.
  avr::Chip::Stop run(avr::Cycle cycles) { return chip.run_to(chip.cycle() + cycles); }
  /// Connects this USART's output to its input. Each frame arrives when its last bit has been sent.
  void wire_to_itself(int usart) { loop_ = usart; }
  /// Changes a pin's level, and passes the edge to the chip.
  void set_level(int pin, bool level) {
    levels[pin] = level;
    chip.edge(pin, level, chip.cycle());
  }

  std::map<int, bool> levels;          ///< by pin number; a pin that is not listed has its pull-up's level
  std::map<int, double> voltages;      ///< by ADC channel
  std::map<int, double> pin_voltages;  ///< by pin; a pin that is not listed has the voltage of its level
  std::map<int, PinDrive> drives;      ///< how the chip drives each pin
  std::vector<std::pair<avr::Cycle, std::uint16_t>> sent_bytes;
  std::vector<std::pair<avr::Cycle, int>> samples;        ///< time and channel of each ADC conversion
  std::map<int, bool> listens_to;                         ///< whether the chip requests a pin's edges
  std::vector<std::pair<avr::Cycle, avr::Cycle>> frames;  ///< time, and the frame duration from then on
  std::vector<std::uint8_t> reported;
  bool ended = false;
  int resets = 0;

  avr::Chip chip;

 private:
  void report(avr::Address, std::uint8_t byte) { reported.push_back(byte); }
  void arrive(avr::Cycle at) { chip.receive(loop_, sent_bytes.back().second, at); }
  void end(avr::Address, std::uint8_t) {
    ended = true;
    chip.cpu().stop();
  }

  bool level(int pin, bool pull_up, avr::Cycle, ReadIntent) override {
    const auto found = levels.find(pin);
    return found == levels.end() ? pull_up : found->second;
  }
  avr::Cycle level_until(int, avr::Cycle) override { return avr::kNoCycle; }
  Source source(int pin, bool high, avr::Cycle at) override {
    const int channel = chip.core().chip.pins[pin].analog_channel;
    if (channel < 0) {
      const auto found = pin_voltages.find(pin);
      return found == pin_voltages.end() ? supply_volts() * level(pin, high, at, ReadIntent::pin)
                                         : found->second;
    }
    samples.emplace_back(at, channel);
    const auto found = voltages.find(channel);
    return found == voltages.end() ? 0.0 : found->second;
  }
  void driven(int pin, const PinDrive& drive, avr::Cycle) override { drives[pin] = drive; }
  bool wants_edges(int pin, bool wanted, avr::Cycle at) override {
    listens_to[pin] = wanted;
    return level(pin, true, at, ReadIntent::port);
  }
  void sent(int usart, std::uint16_t data, avr::Cycle at) override {
    sent_bytes.emplace_back(at, data);
    if (usart == loop_ && !frames.empty()) chip.core().schedule(arrives_, at + frames.back().second);
  }
  void listens(int, avr::Cycle frame, avr::Cycle at) override { frames.emplace_back(at, frame); }
  std::uint8_t read_eeprom(std::uint16_t address) const override { return eeprom_[address]; }
  void write_eeprom(std::uint16_t address, std::uint8_t value, avr::Cycle) override {
    eeprom_[address] = value;
  }
  void was_reset(std::uint8_t, avr::Cycle) override { ++resets; }

  std::array<std::uint8_t, 4096> eeprom_;
  int loop_ = -1;
  avr::Events::Id arrives_ = 0;
};

}  // namespace robosim::conformance
