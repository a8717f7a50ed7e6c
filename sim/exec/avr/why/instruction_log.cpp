#include "sim/exec/avr/why/instruction_log.h"

#include <algorithm>

#include "sim/mcu/avr/instruction_effects.h"
#include "sim/mcu/avr/instruction_table.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::Cpu;
using robosim::avr::Instruction;
using robosim::avr::InstructionEffects;
using robosim::avr::InstructionRow;
using robosim::avr::Location;
using robosim::avr::Op;
using robosim::avr::row_of;
using Entry = InstructionLog::Entry;
using Touch = InstructionLog::Touch;

// Limits the log to 64 MB. Older entries are dropped.
constexpr std::size_t kMostEntries = std::size_t{1} << 22;

Entry entry_of(const Cpu& cpu, Cycle began) {
  const Instruction& i = cpu.instruction(cpu.pc());
  Entry entry{cpu.pc(), static_cast<std::uint32_t>(cpu.cycle() - began), 0, cpu.sp()};
  const auto touches = [&](Touch touch, unsigned address, unsigned bytes) {
    entry.touch = touch;
    entry.address = static_cast<std::uint16_t>(address);
    entry.bytes = static_cast<std::uint8_t>(bytes);
  };
  const InstructionRow& row = row_of(i.op);
  if (row.location == Location::flash) {
    touches(Touch::flash, cpu.pair(row.pointer), 1);
  } else if (row.elsewhere && row.location == Location::io) {  // SBI, CBI
    touches(Touch::store, static_cast<unsigned>(i.k), 1);
  } else if (const InstructionEffects effects = effects_of(i, cpu);
             effects.memory != InstructionEffects::Memory::none) {
    touches(effects.memory == InstructionEffects::Memory::load ? Touch::load : Touch::store, effects.address,
            effects.bytes);
  }
  return entry;
}

}  // namespace

InstructionEffects effects_of_logged(const Instruction& i, const Cpu& cpu) {
  InstructionEffects e = effects_of(i, cpu);
  if (row_of(i.op).location == Location::flash) {
    const robosim::avr::RegisterAccess registers = registers_of(i);
    e.reads = registers.reads;
    e.writes = registers.writes;
  }
  return e;
}

void InstructionLog::begin() {
  entries_.clear();
  looked_.clear();
  port_ = {};
  began_ = chip_.cycle();
}

void InstructionLog::before() {
  const Cpu& cpu = chip_.chip().cpu();
  cycle_before_ = cpu.cycle();
  asleep_before_ = chip_.is_asleep();
  handlers_before_ = cpu.open_handlers();
  next_ = entry_of(cpu, began_);
  find_mask();
  byte_before_ = chip_.data(next_.address);
}

void InstructionLog::after() {
  const Cpu& cpu = chip_.chip().cpu();
  if (cpu.cycle() == cycle_before_ || (asleep_before_ && chip_.is_asleep())) return;  // nothing has run
  if (entries_.size() >= kMostEntries) {
    const std::size_t half = kMostEntries / 2;
    entries_.erase(entries_.begin(), entries_.begin() + half);
    std::erase_if(looked_, [&](const Looked& one) { return one.index < half; });
    for (Looked& one : looked_) one.index -= half;
    port_.number = -1;
  }
  if (cpu.open_handlers() > handlers_before_) {  // entered a handler, and perhaps ran the jump in its vector
    next_.pc = 0;
    next_.touch = Touch::nothing;
    next_.interrupts = true;
    next_.sp = cpu.sp();
  }
  next_.enables = cpu.interrupts_enabled();
  if (next_.touch == Touch::store)
    next_.changed = static_cast<std::uint8_t>(byte_before_ ^ chip_.data(next_.address));
  if (next_.touch == Touch::load && next_.address < chip_.spec().ram_address)
    if (const Pin pin = pin_looked_at(next_); pin != kNoPin) looked_.push_back({entries_.size(), pin});
  entries_.push_back(next_);
}

/// The Arduino core's digitalRead() reads a whole port, and soon afterwards selects one bit. Finds this bit,
/// which shows the pin that was read.
void InstructionLog::find_mask() {
  constexpr std::size_t kSoon = 12;
  if (port_.number < 0) return;
  const Instruction& i = chip_.chip().cpu().instruction(next_.pc);
  const bool here = i.a == port_.reg, other = i.b == port_.reg;
  int mask = -1;
  if (i.op == Op::and_ && (here || other)) mask = chip_.data(here ? i.b : i.a);
  if ((i.op == Op::andi || i.op == Op::sbrc || i.op == Op::sbrs) && here) mask = i.b;
  const ChipSpec& chip = chip_.spec();
  for (int pin = 0; mask >= 0 && pin < chip.pin_count; ++pin)
    if (chip.pins[pin].port == port_.number && mask == 1 << chip.pins[pin].bit)
      looked_.push_back({port_.index, adapter_.board_pin(pin)});
  if (mask >= 0 || entries_.size() > port_.index + kSoon) port_.number = -1;
}

Pin InstructionLog::pin_looked_at(const Entry& entry) {
  const ChipSpec& chip = chip_.spec();
  for (int port = 0; port < chip.port_count; ++port) {
    if (entry.address != chip.ports[port].address) continue;
    const Cpu& cpu = chip_.chip().cpu();
    if (cpu.bits_read(entry.pc) != Cpu::kAllBits) return adapter_.last_read();
    port_ = {port, entries_.size(), cpu.instruction(entry.pc).a};
    return kNoPin;
  }
  if (entry.address != chip.at.adc_data && entry.address != chip.at.adc_data + 1) return kNoPin;
  int channel = chip_.data(chip.at.adc_multiplexer) & chip.adc.multiplexer_bits;
  if (chip.adc.high_channels && chip_.data(chip.at.adc_control_b) & chip.adc.high_channels) channel += 8;
  for (int pin = 0; pin < chip.pin_count; ++pin)
    if (chip.pins[pin].analog_channel == channel) return adapter_.board_pin(pin);
  return kNoPin;
}

Pin InstructionLog::pin_of(std::size_t index) const {
  const auto found = std::lower_bound(looked_.begin(), looked_.end(), index,
                                      [](const Looked& one, std::size_t at) { return one.index < at; });
  return found != looked_.end() && found->index == index ? found->pin : kNoPin;
}

}  // namespace robosim::exec::avr
