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

bool DebugPort::steps_singly() const {
  const Search* const again = search();
  if (!again) return stepping_ || !watches_.empty();
  const bool watches = again->goal == Search::Goal::look && !watches_.empty();
  return watches || here_.t >= again->closely_from;
}

void DebugPort::begin_tick() {
  if (Search* const again = search()) return begin_tick_again(*again);
  if (!begun_) {
    begun_ = true;
    halt({});
  } else if (server_.asks_to_halt()) {
    if (server_.attached())
      halt({.signal = Signal::interrupt});
    else
      let_go();
  }
}

void DebugPort::ran(bool at_breakpoint) {
  if (!server_.attached()) return;
  if (Search* const again = search())
    return again->goal == Search::Goal::look ? look(*again, at_breakpoint) : seek(*again, at_breakpoint);
  if (const Signal signal = fault(); signal != Signal::none) {
    if (crashed_) return;
    crashed_ = true;
    return halt({.signal = signal});
  }
  if (const Watch* watch = changed_watch()) return halt({Signal::trap, watch->access, watch->address});
  const bool stepped = stepping_ && cycle() != step_began_ && !is_asleep() && open_handlers() <= step_depth_;
  if (at_breakpoint || stepped) halt({});
}

void DebugPort::halt(Stop stop) {
  for (;;) {
    const Server::Order order = server_.stand_still(*this, stop);
    if (!server_.attached()) return let_go();
    stepping_ = order == Server::Order::step;
    if (order == Server::Order::go || stepping_) break;
    if (server_.history()->reaches_back()) go_back(order == Server::Order::step_back);
    stop = {.edge = Edge::begin};
  }
  step_began_ = cycle();
  step_depth_ = open_handlers();
  read_watches();
  resume();
}

void DebugPort::let_go() {
  if (Search* const again = search()) again->goal = Search::Goal::none;
  for (const std::uint32_t address : breakpoints_) trap(address, false);
  breakpoints_.clear();
  watches_.clear();
  stepping_ = false;
  resume();
}

void DebugPort::read_watches() {
  for (Watch& watch : watches_) watch.value = read_memory(watch.address, watch.size);
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

// --- reverse execution

/// Returns the current search; null if the run is not being repeated for a search.
Search* DebugPort::search() const {
  History* const history = server_.history();
  return history && history->search.goal != Search::Goal::none ? &history->search : nullptr;
}

void DebugPort::go_back(bool steps) {
  server_.history()->search = {.present = time(), .steps = steps, .depth = open_handlers()};
  throw LeftRun();
}

void DebugPort::restored() {
  restored_ = true;
  crashed_ = fault() != Signal::none;
}

void DebugPort::begin_tick_again(Search& search) {
  here_ = {.t = time(), .pc = pc()};
  if (std::exchange(restored_, false)) {
    read_watches();
    if (server_.asks_to_halt()) {
      if (!server_.attached()) return let_go();
      here_.stop.signal = Signal::interrupt;
      search.found = search.target = here_;
      if (search.goal == Search::Goal::look) throw LeftRun();
    }
  }
  resume_again();
  if (search.goal == Search::Goal::look)
    look(search, false);
  else
    seek(search, false);
}

void DebugPort::look(Search& search, bool at_breakpoint) {
  const auto find = [&](const Place& place) {
    if (!search.found || search.found->t != place.t) search.before = search.found;
    search.found = place;
  };
  if (const Watch* watch = changed_watch()) {
    here_.stop = {Signal::trap, watch->access, watch->address};
    find(here_);
  }
  here_ = {time(), {}, at_breakpoint, pc()};
  if (fault() != Signal::none) {
    // gdb displays the place of the failed instruction. A reverse step therefore skips this place.
    const auto& found = search.found;
    if (search.steps && found && found->pc == here_.pc && !found->stop.access) search.found = search.before;
    throw LeftRun();
  }
  if (here_.t >= search.present) throw LeftRun();
  if (search.steps && here_.t < search.closely_from) return;
  const bool steps_here = search.steps && !is_asleep() && open_handlers() <= search.depth;
  if (at_breakpoint || steps_here) find(here_);
}

void DebugPort::seek(Search& search, bool at_breakpoint) {
  const SimTime t = time();
  if (t < search.target.t || (t == search.target.t && search.target.at_breakpoint && !at_breakpoint)) return;
  search.goal = Search::Goal::none;
  halt(search.target.stop);
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
  return fmt::format("Unknown command \"{}\": expected time\n", command);
}

}  // namespace robosim::exec::gdb
