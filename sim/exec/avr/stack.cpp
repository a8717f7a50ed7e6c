#include "sim/exec/avr/stack.h"

namespace robosim::exec::avr {
namespace {

constexpr std::size_t kMostScannedCalls = 12;
constexpr int kIcall = 0x9509, kEicall = 0x9519;

}  // namespace

Stack::Stack(WatchedChip& chip, const Firmware& firmware)
    : chip_(chip),
      firmware_(firmware),
      heap_pointer_(firmware.find_variable("__brkval").value_or(0)),
      state_{firmware.globals_end} {
  chip_.set_stack_limit(state_.heap_end);
}

void Stack::look() {
  if (!heap_pointer_) return;
  const int end = chip_.data(heap_pointer_) | chip_.data(static_cast<reg::Address>(heap_pointer_ + 1)) << 8;
  if (end <= state_.heap_end || end > firmware_.last_ram) return;
  state_.heap_end = static_cast<std::uint16_t>(end);
  chip_.set_stack_limit(state_.heap_end);
}

std::uint32_t Stack::return_address(std::uint32_t at) const {
  return chip_.return_address(static_cast<reg::Address>(at));
}

bool Stack::find_call(std::uint32_t pc, Call& call) const {
  if (pc < 4 || pc > firmware_.code_end) return false;
  const auto word = [&](std::uint32_t at) { return firmware_.word(at); };
  if ((word(pc - 4) & 0xFE0E) == 0x940E) {
    call = {pc - 4, false};
    return true;
  }
  const int last = word(pc - 2);
  const bool by_pointer = last == kIcall || last == kEicall;
  if (by_pointer || (last & 0xF000) == 0xD000) {
    call = {pc - 2, by_pointer};
    return true;
  }
  return false;
}

std::vector<Stack::Call> Stack::open_calls() const {
  std::vector<Call> calls;
  each_call(0, [&](const Call& call) {
    calls.push_back(call);
    return calls.size() >= kMostScannedCalls;
  });
  return calls;
}

std::uint32_t Stack::last_return() const {
  const std::uint32_t sp = chip_.sp();
  const std::uint32_t bytes = firmware_.chip->return_address_bytes;
  const bool in_ram = sp >= firmware_.chip->ram_address + bytes - 1 && sp <= firmware_.last_ram;
  return in_ram ? return_address(sp + 1 - bytes) : 0;
}

}  // namespace robosim::exec::avr
