// Models the pin interrupts: external interrupts INTn, and pin change interrupts PCINTn (data sheet
// DS40002061B, chapter 13).
//
//   ISCn (EICRA)   sets INTFn      requests the interrupt
//   00             never           while the pin is low
//   01             at both edges   while INTFn is set
//   10             falling edge    while INTFn is set
//   11             rising edge     while INTFn is set
//
// PCMSKg has one bit per pin of group g. While the bit is set, each edge of the pin sets PCIFg.
//
// A request takes effect if its bit in EIMSK or PCICR is set. Entering the vector or writing 1 to the flag
// clears the flag. An edge passes the input's synchroniser: INTFn is set 2 cycles after the edge, PCIFg 3
// cycles (figure 13-1). Edges caused by the chip's own outputs also count.
//
// Edges of INTn wake the chip from every sleep mode. According to section 13.1, their detection requires the
// I/O clock. Real chips detect them without this clock, however, and sketches rely on this behaviour.
//
// A pin has a listener only while its ISCn is not 0, or its bit in EIMSK or PCMSKg is set. Unused pins
// therefore cost nothing.
#pragma once

#include <array>
#include <cstdint>

#include "sim/mcu/avr/pins.h"

namespace robosim::avr {

class ExternalInterrupts final : public Peripheral {
 public:
  ExternalInterrupts(Core& core, Pins& pins);

  void reset(Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  static constexpr std::size_t kMost = 8, kMostGroups = 4;
  enum class Sense : std::uint8_t { low_level, any_edge, falling, rising };

  struct Line {
    int pin = -1;
    int listener = -1;
  };
  struct Group {
    std::array<int, 8> pins{};  ///< -1 = none
    std::array<int, 8> listeners{};
  };
  struct LineState {
    bool listening = false;
    bool level = false;
    Cycle flag_at = kNoCycle;
  };
  struct State {
    std::array<LineState, kMost> lines{};
    std::array<Cycle, kMostGroups> change_flag_at;
    State() { change_flag_at.fill(kNoCycle); }
  };

  void write_sense(Address address, std::uint8_t value);
  void write_enables(Address address, std::uint8_t value);
  void write_flags(Address address, std::uint8_t value);
  void write_flag_bit(Address address, std::uint8_t value, std::uint8_t bit);
  void write_change_enables(Address address, std::uint8_t value);
  void write_change_mask(Address address, std::uint8_t value);
  void write_change_flags(Address address, std::uint8_t value);
  void write_change_flag_bit(Address address, std::uint8_t value, std::uint8_t bit);
  void external_changed(int pin, bool level, Cycle at);
  void pin_changed(int pin, bool level, Cycle at);
  void edge(std::size_t number, bool level, Cycle at);
  void set_flags(Cycle at);
  void schedule();
  void external_entered(int vector);
  void change_entered(int vector);
  bool awaited(int vector, bool is);
  bool change_awaited(int vector, bool is);
  void listen_or_not(std::size_t number);
  void request(std::size_t number);
  void request_change(std::size_t group);

  Sense sense(std::size_t number) const;
  std::size_t lines() const { return core_.chip.external_count; }
  std::size_t groups() const { return core_.chip.change_count; }
  int vector(std::size_t number) const { return core_.chip.external_vector + static_cast<int>(number); }
  int change_vector(std::size_t group) const { return core_.chip.change_vector + static_cast<int>(group); }

  std::uint8_t external_bit(std::size_t number) const {
    return static_cast<std::uint8_t>(1u << (at_.external_bit + number));
  }
  std::uint8_t change_bit(std::size_t group) const {
    return static_cast<std::uint8_t>(1u << (at_.change_bit + group));
  }

  Core& core_;
  const AvrRegisters& at_;
  Pins& pins_;
  std::array<Line, kMost> lines_{};
  std::array<Group, kMostGroups> groups_{};
  Events::Id flags_ = 0;
  State state_;
};

}  // namespace robosim::avr
