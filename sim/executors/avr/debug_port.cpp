#include "sim/executors/avr/debug_port.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::executors::avr {
namespace {

constexpr std::uint32_t kData = 0x800000, kEeprom = 0x810000;
constexpr unsigned kSregNumber = 32, kSpNumber = 33, kPcNumber = 34;

std::string little_endian(std::uint32_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

std::uint32_t from_little_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

gdb::Signal signal_of(Fault::Kind kind) {
  switch (kind) {
    case Fault::Kind::bad_read:
    case Fault::Kind::bad_write:
    case Fault::Kind::stack:
      return gdb::Signal::fault;
    default:
      return gdb::Signal::illegal;
  }
}

}  // namespace

DebugPort::DebugPort(gdb::Server& server, const Firmware& firmware, BoardState& board)
    : server_(server), firmware_(firmware), board_(board) {}

void DebugPort::plug_into(Machine& machine) {
  machine_ = &machine;
  crashed_ = false;
  for (const std::uint32_t address : breakpoints_) chip().set_trap(Chip::kBreakpoint, address);
  chip().step_singly(stepping_ || !watches_.empty());
  step_began_ = 0;
  step_depth_ = 0;
}

void DebugPort::begin_tick() {
  if (!begun_) {
    begun_ = true;
    halt({});
  } else if (server_.asks_to_halt()) {
    if (server_.attached()) {
      halt({gdb::Signal::interrupt, {}, 0});
    } else {
      let_go();
    }
  }
}

void DebugPort::ran(bool at_breakpoint) {
  if (!server_.attached()) return;
  if (const auto& fault = chip().fault()) {
    if (crashed_) return;
    crashed_ = true;
    return halt({signal_of(fault->kind), {}, 0});
  }
  if (const Watch* watch = changed_watch())
    return halt({gdb::Signal::trap, watch->access, kData + watch->address});
  const bool stepped = stepping_ && chip().cycle() != step_began_ && !chip().is_asleep() &&
                       chip().open_handlers() <= step_depth_;
  if (at_breakpoint || stepped) halt({});
}

void DebugPort::halt(const gdb::Stop& stop) {
  const gdb::Server::Order order = server_.stand_still(*this, stop);
  if (!server_.attached()) return let_go();
  stepping_ = order == gdb::Server::Order::step;
  step_began_ = chip().cycle();
  step_depth_ = chip().open_handlers();
  for (Watch& watch : watches_) watch.value = read_memory(kData + watch.address, watch.size);
  chip().step_singly(stepping_ || !watches_.empty());
}

void DebugPort::let_go() {
  for (const std::uint32_t address : breakpoints_) chip().clear_trap(Chip::kBreakpoint, address);
  breakpoints_.clear();
  watches_.clear();
  stepping_ = false;
  chip().step_singly(false);
}

const DebugPort::Watch* DebugPort::changed_watch() {
  const Watch* found = nullptr;
  for (Watch& watch : watches_) {
    std::string now = read_memory(kData + watch.address, watch.size);
    if (now == watch.value) continue;
    watch.value = std::move(now);
    found = &watch;
  }
  return found;
}

std::uint32_t DebugPort::data_end() const { return kData + firmware_.last_ram + 1u; }

std::uint32_t DebugPort::flash_end() const {
  return std::max(kFlashBytes, static_cast<std::uint32_t>(firmware_.flash.size()));
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
    } else if (at >= kData && at < data_end()) {
      bytes += static_cast<char>(machine_->peek(static_cast<reg::Address>(at - kData)));
    } else if (at >= kEeprom && at < kEeprom + board_.spec().eeprom_bytes) {
      bytes += static_cast<char>(board_.eeprom()[at - kEeprom]);
    } else {
      break;
    }
  }
  return bytes;
}

bool DebugPort::write_memory(std::uint32_t address, std::string_view bytes) {
  // Flash stays what it is: the tested image is the one that is flashed. EEPROM is the firmware's to write.
  if (address < kData || address + bytes.size() > data_end()) return false;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    machine_->poke(static_cast<reg::Address>(address - kData + i), static_cast<std::uint8_t>(bytes[i]));
  return true;
}

bool DebugPort::set_breakpoint(std::uint32_t address, bool set) {
  if (address >= flash_end() || address % 2 != 0) return false;
  if (set) {
    breakpoints_.insert(address);
    chip().set_trap(Chip::kBreakpoint, address);
  } else if (breakpoints_.erase(address) > 0) {
    chip().clear_trap(Chip::kBreakpoint, address);
  }
  return true;
}

bool DebugPort::set_watchpoint(std::uint32_t address, std::uint32_t size, gdb::Access access, bool set) {
  if (access != gdb::Access::write || address < kData || size == 0 || address + size > data_end())
    return false;
  const std::uint32_t at = address - kData;
  const auto same = [&](const Watch& watch) { return watch.address == at && watch.size == size; };
  if (set) {
    watches_.push_back({at, size, access, read_memory(address, size)});
  } else {
    const auto found = std::find_if(watches_.begin(), watches_.end(), same);
    if (found != watches_.end()) watches_.erase(found);
  }
  return true;
}

std::string DebugPort::monitor(const std::string& command) {
  if (command == "time")
    return fmt::format("{:.9f} s simulated, cycle {}\n",
                       1e-9 * static_cast<double>(machine_->link().time_of(chip().cycle())), chip().cycle());
  return fmt::format("There is no command \"{}\"; there is: time\n", command);
}

}  // namespace robosim::executors::avr
