#include "sim/exec/gdb/debug_port.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace robosim::exec::gdb {

std::string DebugPort::little_endian(std::uint32_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

std::uint32_t DebugPort::from_little_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

void DebugPort::power_on() {
  crashed_ = false;
  step_began_ = 0;
  step_depth_ = 0;
  for (const std::uint32_t address : breakpoints_) trap(address, true);
}

void DebugPort::begin_tick() {
  if (!begun_) {
    begun_ = true;
    halt({});
  } else if (server_.asks_to_halt()) {
    if (server_.attached())
      halt({Signal::interrupt, {}, 0});
    else
      let_go();
  }
}

void DebugPort::ran(bool at_breakpoint) {
  if (!server_.attached()) return;
  if (const Signal signal = fault(); signal != Signal::none) {
    if (crashed_) return;
    crashed_ = true;
    return halt({signal, {}, 0});
  }
  if (const Watch* watch = changed_watch()) return halt({Signal::trap, watch->access, watch->address});
  const bool stepped = stepping_ && cycle() != step_began_ && !is_asleep() && open_handlers() <= step_depth_;
  if (at_breakpoint || stepped) halt({});
}

void DebugPort::halt(const Stop& stop) {
  const Server::Order order = server_.stand_still(*this, stop);
  if (!server_.attached()) return let_go();
  stepping_ = order == Server::Order::step;
  step_began_ = cycle();
  step_depth_ = open_handlers();
  for (Watch& watch : watches_) watch.value = read_memory(watch.address, watch.size);
  resume();
}

void DebugPort::let_go() {
  for (const std::uint32_t address : breakpoints_) trap(address, false);
  breakpoints_.clear();
  watches_.clear();
  stepping_ = false;
  resume();
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

bool DebugPort::write_memory(std::uint32_t address, std::string_view bytes) {
  if (!has_ram(address, bytes.size())) return false;
  for (const char byte : bytes) poke(address++, static_cast<std::uint8_t>(byte));
  return true;
}

bool DebugPort::set_breakpoint(std::uint32_t address, bool set) {
  if (!has_code(address) || address % 2 != 0) return false;
  if (set)
    breakpoints_.insert(address);
  else
    breakpoints_.erase(address);
  trap(address, set);
  return true;
}

bool DebugPort::set_watchpoint(std::uint32_t address, std::uint32_t size, Access access, bool set) {
  if (access != Access::write || size == 0 || !has_ram(address, size)) return false;
  const auto same = [&](const Watch& watch) { return watch.address == address && watch.size == size; };
  if (set) {
    watches_.push_back({address, size, access, read_memory(address, size)});
  } else {
    const auto found = std::find_if(watches_.begin(), watches_.end(), same);
    if (found != watches_.end()) watches_.erase(found);
  }
  return true;
}

std::string DebugPort::monitor(const std::string& command) {
  if (command == "time")
    return fmt::format("{:.9f} s simulated, cycle {}\n", 1e-9 * static_cast<double>(time()), cycle());
  return fmt::format("There is no command \"{}\"; there is: time\n", command);
}

}  // namespace robosim::exec::gdb
