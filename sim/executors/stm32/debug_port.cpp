#include "sim/executors/stm32/debug_port.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::executors::stm32 {

using namespace robosim::stm32;

namespace {

constexpr unsigned kStatusNumber = 16;

std::string little_endian(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i));
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
    case Fault::Kind::flash_write:
    case Fault::Kind::unmodelled:
    case Fault::Kind::stack:
      return gdb::Signal::fault;
    default:
      return gdb::Signal::illegal;
  }
}

}  // namespace

void DebugPort::plug_into(Machine& machine) {
  machine_ = &machine;
  crashed_ = false;
  for (const std::uint32_t address : breakpoints_) cpu().set_breakpoint(address, true);
  step_began_ = 0;
  step_depth_ = 0;
}

void DebugPort::begin_tick() {
  if (!begun_) {
    begun_ = true;
    halt({});
  } else if (server_.asks_to_halt()) {
    if (server_.attached())
      halt({gdb::Signal::interrupt, {}, 0});
    else
      let_go();
  }
}

void DebugPort::ran(bool at_breakpoint) {
  if (!server_.attached()) return;
  if (const auto& fault = cpu().fault()) {
    if (crashed_) return;
    crashed_ = true;
    return halt({signal_of(fault->kind), {}, 0});
  }
  if (const Watch* watch = changed_watch()) return halt({gdb::Signal::trap, watch->access, watch->address});
  const bool stepped =
      stepping_ && now() != step_began_ && !cpu().is_asleep() && cpu().open_handlers() <= step_depth_;
  if (at_breakpoint || stepped) halt({});
}

void DebugPort::halt(const gdb::Stop& stop) {
  const gdb::Server::Order order = server_.stand_still(*this, stop);
  if (!server_.attached()) return let_go();
  stepping_ = order == gdb::Server::Order::step;
  step_began_ = now();
  step_depth_ = cpu().open_handlers();
  for (Watch& watch : watches_) watch.value = read_memory(watch.address, watch.size);
  cpu().pass_breakpoint();
}

void DebugPort::let_go() {
  for (const std::uint32_t address : breakpoints_) cpu().set_breakpoint(address, false);
  breakpoints_.clear();
  watches_.clear();
  stepping_ = false;
}

const DebugPort::Watch* DebugPort::changed_watch() {
  const Watch* found = nullptr;
  for (Watch& watch : watches_) {
    std::string now = read_memory(watch.address, watch.size);
    if (now == watch.value) continue;
    watch.value = std::move(now);
    found = &watch;
  }
  return found;
}

std::uint32_t DebugPort::pc() const { return cpu().fault() ? cpu().fault()->pc : cpu().next_pc(); }

std::string DebugPort::registers() const {
  std::string bytes;
  for (unsigned number = 0; number <= kStatusNumber; ++number) bytes += read_register(number);
  return bytes;
}

std::string DebugPort::read_register(unsigned number) const {
  if (number < Cpu::kPc) return little_endian(cpu().reg(static_cast<int>(number)));
  if (number == Cpu::kPc) return little_endian(pc());
  if (number == kStatusNumber) return little_endian(cpu().status());
  return "";
}

bool DebugPort::write_register(unsigned number, std::string_view bytes) {
  if (number > kStatusNumber || bytes.size() != 4) return false;
  const std::uint32_t value = from_little_endian(bytes);
  if (number == kStatusNumber) return value == cpu().status();
  if (number == Cpu::kPc && value == pc()) return true;
  return cpu().write_register(static_cast<int>(number), value);
}

std::string DebugPort::read_memory(std::uint32_t address, std::uint32_t size) const {
  std::string bytes;
  for (std::uint32_t at = address; bytes.size() < size; ++at) {
    const std::uint32_t flash = at < kFlashBytes ? at : at - kFlash;
    if (at >= kRam && at < kRam + kRamBytes)
      bytes += static_cast<char>(cpu().byte(at));
    else if (at >= kEepromFlash && at < kFlash + kFlashBytes)
      bytes += static_cast<char>(machine_->eeprom_byte(at));
    else if (flash < firmware_.flash.size())
      bytes += static_cast<char>(firmware_.flash[flash]);
    else
      break;
  }
  return bytes;
}

bool DebugPort::write_memory(std::uint32_t address, std::string_view bytes) {
  // Flash stays what it is: the tested image is the one that is flashed.
  if (address < kRam || address + bytes.size() > kRam + kRamBytes) return false;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    cpu().set_byte(address + static_cast<std::uint32_t>(i), static_cast<std::uint8_t>(bytes[i]));
  return true;
}

bool DebugPort::set_breakpoint(std::uint32_t address, bool set) {
  if (!firmware_.has_code(address) || address % 2 != 0) return false;
  if (set)
    breakpoints_.insert(address);
  else
    breakpoints_.erase(address);
  cpu().set_breakpoint(address, set);
  return true;
}

bool DebugPort::set_watchpoint(std::uint32_t address, std::uint32_t size, gdb::Access access, bool set) {
  if (access != gdb::Access::write || size == 0 || address < kRam || address + size > kRam + kRamBytes)
    return false;
  const auto same = [&](const Watch& watch) { return watch.address == address && watch.size == size; };
  if (set) {
    watches_.push_back({address, size, access, read_memory(address, size)});
  } else {
    const auto found = std::find_if(watches_.begin(), watches_.end(), same);
    if (found != watches_.end()) watches_.erase(found);
  }
  return true;
}

std::string DebugPort::description() const {
  std::string xml =
      "<?xml version=\"1.0\"?><!DOCTYPE target SYSTEM \"gdb-target.dtd\"><target version=\"1.0\">"
      "<architecture>arm</architecture><feature name=\"org.gnu.gdb.arm.m-profile\">";
  for (int r = 0; r < Cpu::kSp; ++r) xml += fmt::format("<reg name=\"r{}\" bitsize=\"32\"/>", r);
  return xml +
         "<reg name=\"sp\" bitsize=\"32\" type=\"data_ptr\"/><reg name=\"lr\" bitsize=\"32\"/>"
         "<reg name=\"pc\" bitsize=\"32\" type=\"code_ptr\"/><reg name=\"xpsr\" bitsize=\"32\"/>"
         "</feature></target>";
}

std::string DebugPort::monitor(const std::string& command) {
  if (command == "time")
    return fmt::format("{:.9f} s simulated, cycle {}\n", 1e-9 * static_cast<double>(machine_->time_of(now())),
                       now());
  return fmt::format("There is no command \"{}\"; there is: time\n", command);
}

}  // namespace robosim::executors::stm32
