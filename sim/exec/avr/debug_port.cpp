#include "sim/exec/avr/debug_port.h"

#include <algorithm>

#include "sim/base/elf/avr_addresses.h"

namespace robosim::exec::avr {
namespace {

constexpr unsigned kSregNumber = 32, kSpNumber = 33, kPcNumber = 34;

}  // namespace

void DebugPort::plug_into(Machine& machine) {
  machine_ = &machine;
  power_on();
  resume();
}

gdb::Signal DebugPort::fault() const {
  if (!chip().fault()) return gdb::Signal::none;
  switch (chip().fault()->kind) {
    case Fault::Kind::bad_read:
    case Fault::Kind::bad_write:
    case Fault::Kind::stack:
      return gdb::Signal::fault;
    default:
      return gdb::Signal::illegal;
  }
}

bool DebugPort::has_ram(std::uint32_t address, std::size_t size) const {
  return address >= kAvrData && address + size <= data_end();
}

void DebugPort::poke(std::uint32_t address, std::uint8_t value) {
  machine_->poke(static_cast<reg::Address>(address - kAvrData), value);
}

void DebugPort::trap(std::uint32_t address, bool set) {
  if (set)
    chip().set_trap(WatchedChip::kBreakpoint, address);
  else
    chip().clear_trap(WatchedChip::kBreakpoint, address);
}

std::uint32_t DebugPort::data_end() const { return kAvrData + firmware_.last_ram + 1u; }

std::uint32_t DebugPort::flash_end() const {
  return std::max(firmware_.chip->flash_bytes, static_cast<std::uint32_t>(firmware_.flash.size()));
}

std::uint32_t DebugPort::pc() const { return chip().fault() ? chip().fault()->pc : chip().pc(); }

std::string DebugPort::registers() const {
  std::string bytes;
  for (unsigned number = 0; number <= kPcNumber; ++number) bytes += read_register(number);
  return bytes;
}

std::string DebugPort::read_register(unsigned number) const {
  if (number < kSregNumber) return little_endian(chip().data(static_cast<reg::Address>(number)), 1);
  if (number == kSregNumber) return little_endian(chip().status(), 1);
  if (number == kSpNumber) return little_endian(chip().sp(), 2);
  if (number == kPcNumber) return little_endian(pc(), 4);
  return "";
}

bool DebugPort::write_register(unsigned number, std::string_view bytes) {
  if (number > kPcNumber || bytes.size() != read_register(number).size()) return false;
  const std::uint32_t value = from_little_endian(bytes);
  if (number < kSregNumber) {
    machine_->poke(static_cast<reg::Address>(number), static_cast<std::uint8_t>(value));
  } else if (number == kSregNumber) {
    chip().set_status(static_cast<std::uint8_t>(value));
  } else if (number == kSpNumber) {
    machine_->poke(reg::kSpL, static_cast<std::uint8_t>(value));
    machine_->poke(reg::kSpH, static_cast<std::uint8_t>(value >> 8));
  } else if (value != pc()) {
    if (value >= flash_end() || value % 2 != 0) return false;
    chip().set_pc(value);
  }
  return true;
}

std::string DebugPort::read_memory(std::uint32_t address, std::uint32_t size) const {
  std::string bytes;
  for (std::uint32_t at = address; bytes.size() < size; ++at) {
    if (at < flash_end()) {
      bytes += static_cast<char>(at < firmware_.flash.size() ? firmware_.flash[at] : 0xFF);
    } else if (at >= kAvrData && at < data_end()) {
      bytes += static_cast<char>(machine_->peek(static_cast<reg::Address>(at - kAvrData)));
    } else if (at >= kAvrEeprom && at < kAvrEeprom + board_.spec().eeprom_bytes) {
      bytes += static_cast<char>(board_.read_eeprom(static_cast<std::uint16_t>(at - kAvrEeprom)));
    } else {
      break;
    }
  }
  return bytes;
}

}  // namespace robosim::exec::avr
