#include "sim/detect/avr/stack_margin.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace robosim::detect::avr {
namespace {

using robosim::avr::Cpu;

constexpr int kLeast = 16;
constexpr std::size_t kMostOpenCalls = 32;

std::uint64_t bit(int vector) { return std::uint64_t{1} << vector; }

}  // namespace

StackMargin::StackMargin(const RunningProgram& program)
    : machine_(program.machine),
      firmware_(program.firmware),
      debug_(program.debug),
      cpu_(machine_.chip().chip().cpu()),
      main_(program.firmware.find("main").value_or(0)),
      heap_(program.firmware.find_variable("__brkval").value_or(0)),
      low_(std::exchange(cpu_.on_sp_low, Cpu::call<&StackMargin::went_low>(this))),
      written_(std::exchange(cpu_.on_sp_written, Cpu::call<&StackMargin::pointer_written>(this))),
      handlers_(machine_.chip().spec().vectors) {
  nearest_.room = program.firmware.last_ram + 1;
  WatchedChip& chip = machine_.chip();
  chip.show_handlers(*this);
  if (main_ != 0) chip.show(*this, main_);
}

StackMargin::~StackMargin() {
  cpu_.on_sp_low = low_;
  cpu_.on_sp_written = written_;
}

int StackMargin::heap_end() const {
  const int end = heap_ != 0 ? cpu_.pair(heap_) : 0;
  return std::max<int>(end, firmware_.globals_end);
}

/// Returns the addresses of the last instruction and of the active calls. Stops at the return address
/// `until`, since calls further out belong to the interrupted code.
StackMargin::Chain StackMargin::here(std::uint32_t until) const {
  Chain chain = {machine_.chip().last_pc()};
  machine_.stack().each_call(until, [&](const exec::avr::Stack::Call& call) {
    chain.push_back(call.pc);
    return chain.size() > kMostOpenCalls;
  });
  return chain;
}

/// Returns the innermost line of user code in the chain; empty if it contains only the Arduino core's code.
SourceLine StackMargin::place(const Chain& chain) const {
  for (const std::uint32_t pc : chain)
    if (const SourceLine& where = debug_.place(pc); !where.file.empty()) return where;
  return {};
}

void StackMargin::went_low() {
  low_();
  look();
}

void StackMargin::pointer_written() {
  written_();
  look();
}

void StackMargin::look() {
  const WatchedChip& chip = machine_.chip();
  has_own_stacks_ = has_own_stacks_ || chip.has_own_stack();
  if (has_own_stacks_ || !chip.is_stack_pointer_whole()) return;
  const auto open = static_cast<std::size_t>(chip.open_handlers());
  if (open == 0) {
    open_.clear();
    if (cpu_.interrupts_enabled()) look_at_main();
  } else if (open == open_.size()) {  // if the two counts differ, a handler is about to start
    look_at_handler();
  }
  await_deeper();
}

void StackMargin::look_at_main() {
  const int end = heap_end(), room = cpu_.sp() + 1 - end;
  if (room > nearest_.room || room < 0) return;
  if (room < nearest_.room) nearest_ = {room, end > firmware_.globals_end, 0, here(0), machine_.now()};
  nearest_.may_come |= machine_.chip().chip().may_interrupt();
}

void StackMargin::look_at_handler() {
  const Open& open = open_.back();
  Handler& handler = handlers_[static_cast<std::size_t>(open.vector)];
  handler.nests = handler.nests || cpu_.interrupts_enabled();
  const int bytes = open.began - cpu_.sp();
  if (bytes <= handler.bytes) return;
  handler.bytes = bytes;
  handler.where = here(open.interrupted);
}

void StackMargin::visited(std::uint32_t, Cycle) {
  if (!has_own_stacks_) look();
}

void StackMargin::entered(int vector, Cycle) {
  if (has_own_stacks_) return;
  const int open = machine_.chip().open_handlers();
  open_.resize(static_cast<std::size_t>(open - 1));
  if (open > 1) handlers_[static_cast<std::size_t>(open_.back().vector)].nests = true;
  open_.push_back({vector, cpu_.sp(), machine_.chip().interrupted_pc()});
  ran_ |= bit(vector);
  Handler& handler = handlers_[static_cast<std::size_t>(vector)];
  if (handler.bytes == 0) {
    handler.bytes = cpu_.chip().return_address_bytes;
    handler.where = {2 * cpu_.entry_of(vector)};
  }
  await_deeper();
}

void StackMargin::left() {
  if (has_own_stacks_ || open_.empty()) return;
  look_at_handler();
  open_.pop_back();
  await_deeper();
}

/// Makes the chip call look() when the stack gets deeper than before. If a handler that has run was disabled
/// at the main program's deepest moment, an equal depth is enough.
void StackMargin::await_deeper() {
  int watch = 0;
  if (open_.empty()) {
    watch = heap_end() + nearest_.room - ((ran_ & ~nearest_.may_come) == 0 ? 1 : 0);
  } else {
    watch = open_.back().began - handlers_[static_cast<std::size_t>(open_.back().vector)].bytes;
  }
  // WatchedChip itself must be called whenever the stack is deeper than ever before.
  watch = std::clamp<int>(watch, machine_.chip().lowest_sp(), 0xFFFF);
  cpu_.state.sp_watch = static_cast<std::uint16_t>(watch);
}

/// Returns a description such as "the handler at Count.ino:3" or "the core's handler __vector_16, in
/// wiring.c".
std::string StackMargin::name(int vector) const {
  const Handler& handler = handlers_[static_cast<std::size_t>(vector)];
  const SourceLine where = place(handler.where);
  if (!where.file.empty()) return fmt::format("the handler at {}:{}", where.file, where.line);
  const auto frames = debug_.frames(handler.where.front());
  const std::string file =
      frames.empty() ? "" : std::filesystem::path(frames.back().file).filename().string();
  return fmt::format("the core's handler __vector_{}{}", vector, file.empty() ? "" : ", in " + file);
}

std::vector<Detected> StackMargin::found(SimTime) const {
  if (has_own_stacks_ || !firmware_.named) return {};
  int deepest = 0, bytes = 0;  // deepest: vector of the deepest handler that never enables interrupts
  std::string names;
  const auto take = [&](int vector) {
    const int its = handlers_[static_cast<std::size_t>(vector)].bytes;
    names += fmt::format("{}{} takes {} bytes of stack", names.empty() ? "" : ", and within it ",
                         name(vector), its);
    bytes += its;
  };
  for (int vector = 1; vector < static_cast<int>(handlers_.size()); ++vector) {
    const Handler& handler = handlers_[static_cast<std::size_t>(vector)];
    if (handler.bytes == 0 || !(nearest_.may_come & bit(vector))) continue;
    if (handler.nests)
      take(vector);
    else if (handler.bytes > handlers_[static_cast<std::size_t>(deepest)].bytes || deepest == 0)
      deepest = vector;
  }
  if (deepest != 0) take(deepest);
  const int left = nearest_.room - bytes;
  if (bytes == 0 || left >= kLeast) return {};
  Detected seen;
  seen.detector = result::detector("stack_margin");
  const char* const next = nearest_.has_heap ? "the heap" : "variables";
  const std::string end =
      left < 0 ? fmt::format("occasionally overwrites {} bytes of {}", -left, next)
               : fmt::format("leaves {} bytes of RAM; with one more call it occasionally overwrites {}", left,
                             next);
  seen.what = fmt::format(
      "an interrupt at the wrong moment {}: {}, and only {} bytes are free where the main program is deepest",
      end, names, nearest_.room);
  seen.mend =
      "Store texts in flash (F(\"…\"), PROGMEM), make buffers and arrays smaller, and avoid recursion.";
  seen.where = place(nearest_.where);
  seen.first_s = 1e-9 * static_cast<double>(nearest_.at);
  return {seen};
}

}  // namespace robosim::detect::avr
