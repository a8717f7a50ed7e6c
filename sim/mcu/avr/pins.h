// Models the chip's pins: ports, other drivers of pins, and listeners (data sheet DS40002061B, chapter 14).
//
//   PORTx DDRx ──► ┐
//   timers, UARTs ─┴─► drive ──► ChipEnvironment::driven
//   ChipEnvironment::level ─► synchroniser ─► PINx           also reads back the chip's outputs
//   ChipEnvironment's edges, own outputs ────► listeners: interrupts, capture, timers' clock inputs
//
// A value written to PORTx appears in PINx from the second instruction after the write on (14.2.4). Writing 1
// to a bit of PINx toggles the bit in PORTx. PUD switches all pull-ups off. A pin whose digital input is off
// (DIDR0, DIDR1) reads 0. The environment receives PWM and tones as a duty cycle, never as edges. For PINx
// and listeners, the timer computes the levels and edges (Wave).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "hal/board/input_reads.h"
#include "sim/mcu/avr/core.h"

namespace robosim::avr {

class Pins final : public Peripheral {
 public:
  explicit Pins(Core& core);

  void reset(Cycle at) override;

  // --- for peripherals that drive pins
  /// Makes `drive` replace the port's latch from now on. With `even_input` (for a UART's transmitter),
  /// `drive` applies even while DDRx makes the pin an input. Otherwise (for timers), `drive` applies only
  /// while the pin is an output.
  void take(int pin, const PinDrive& drive, bool even_input = false);
  void give_back(int pin);

  /// A timer that can drive a pin with a waveform. The environment receives a duty cycle instead of edges.
  struct Wave {
    bool (*level)(void* self, int pin) = nullptr;  ///< returns the current level
    void (*heard)(void* self, int pin,
                  bool heard) = nullptr;  ///< starts or stops reports of each edge
    void* self = nullptr;
  };
  template <auto Level, auto Heard, typename Owner>
  void add_wave(int pin, Owner* owner) {
    waves_[static_cast<std::size_t>(pin)] = {
        [](void* self, int number) { return (static_cast<Owner*>(self)->*Level)(number); },
        [](void* self, int number, bool heard) { (static_cast<Owner*>(self)->*Heard)(number, heard); },
        owner};
  }
  /// Reports that the level of a pin with a waveform may have changed.
  void wave_edge(int pin, bool level) {
    if (is_output(pin)) tell_listeners(pin, level, core_.now());
  }

  // --- for peripherals that listen to pins
  struct Listener {
    void (*call)(void* self, int pin, bool level, Cycle at) = nullptr;
    void* self = nullptr;
  };
  /// Registers `Method` of `owner`, which is called with (pin, level, cycle) at each level change while
  /// listening is on. Returns the listener's number, for listen().
  template <auto Method, typename Owner>
  int add_listener(int pin, Owner* owner) {
    listeners_.push_back({pin,
                          {[](void* self, int number, bool level, Cycle at) {
                             (static_cast<Owner*>(self)->*Method)(number, level, at);
                           },
                           owner}});
    if (listeners_.size() > kMostListeners) throw std::logic_error("too many listeners: expected at most 64");
    return static_cast<int>(listeners_.size() - 1);
  }
  void listen(int listener, bool on);
  /// Returns the level that was last reported to a pin's listeners.
  bool heard_level(int pin) const { return state_.heard_level[static_cast<std::size_t>(pin)]; }

  /// Returns the current level of a pin, whatever drives the pin.
  bool level(int pin);
  /// Returns the voltage source at a pin, whatever drives the pin; 0 V for pin -1 (no pin).
  Source source(int pin, Cycle at);
  /// Handles an external level change of a pin with a listener.
  void edge(int pin, bool level, Cycle at);

  /// Return the last pin whose input an instruction has read (-1 = none yet), and the cycle of that read.
  int last_read() const { return state_.last_read; }
  Cycle last_read_at() const { return state_.last_read_at; }
  /// Returns the last reads of inputs. Each pin in the result is an index in ChipSpec::pins.
  const InputReads& reads() const { return state_.reads; }
  /// Records that firmware has started the conversion of an analog input.
  void note_conversion() { note(InputReads::kAnalog); }

  /// Returns the pin at a bit of the port with this letter; -1 = none.
  int at(char port, int bit) const;
  /// Returns the pin with this name in the data sheet; -1 = none.
  int named(std::string_view name) const;
  /// Returns the pin of an analog input; -1 = none.
  int analog(int channel) const { return analog_at_[static_cast<std::size_t>(channel)]; }

 private:
  static constexpr std::size_t kMostListeners = 64, kMostPorts = 16, kMostPins = 100, kMostChannels = 16;
  struct Heard {
    int pin;
    Listener listener;
  };
  struct PortState {
    std::uint8_t seen = 0;  ///< levels at the last read
    std::uint8_t latch_before = 0, direction_before = 0;
    Cycle changed_at = 0;
  };
  struct Taken {
    bool taken = false;
    bool even_input = false;
    PinDrive drive;
  };
  struct State {
    std::array<PortState, kMostPorts> ports{};
    std::array<Taken, kMostPins> taken{};
    std::array<bool, kMostPins> heard_level{};
    std::uint64_t listening = 0;  ///< one bit per listener
    bool some_off = false;        ///< a bit of DIDRn is set
    int last_read = -1;
    Cycle last_read_at = 0;
    InputReads reads;
  };

  std::uint8_t read_pins(Address address);
  void note(Pin read) {
    if (core_.cpu.open_handlers() == 0) state_.reads.add(read);
  }
  ReadForecast forecast(Address address, std::uint8_t bits);
  void write_control(Address address, std::uint8_t value);
  void write_digital_off(Address address, std::uint8_t value);
  bool has_pull_ups() const;
  bool is_read(int pin) const;
  void toggle(Address address, std::uint8_t value);
  void toggle_bit(Address address, std::uint8_t value, std::uint8_t bit);
  void write_latch(Address address, std::uint8_t value);
  void write_direction(Address address, std::uint8_t value);
  void set_latch(int port, std::uint8_t value);
  void will_change(int port);
  void changed(int port, std::uint8_t bits);
  bool is_heard(int pin) const;
  bool is_output(int pin) const;
  bool is_pulled_up(int pin) const;
  bool is_high_by_itself(int pin) const;
  bool is_wave(int pin) const;
  bool output_level(int pin) const;
  void tell_drive(int pin);
  void tell_listeners(int pin, bool level, Cycle at);

  Address pin_register(int port) const { return static_cast<Address>(core_.chip.ports[port].address); }
  Address direction_register(int port) const { return static_cast<Address>(pin_register(port) + 1); }
  Address latch_register(int port) const { return static_cast<Address>(pin_register(port) + 2); }

  Core& core_;
  std::vector<int> port_at_;                             ///< by register address; -1 = none
  std::array<std::array<int, 8>, kMostPorts> pin_at_{};  ///< by port and bit; -1 = none
  std::array<int, kMostChannels> analog_at_{};           ///< by channel; -1 = none
  std::vector<Heard> listeners_;
  std::array<Wave, kMostPins> waves_{};
  State state_;
};

}  // namespace robosim::avr
