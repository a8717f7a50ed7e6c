#include "sim/executors/avr/stack.h"

#include <algorithm>

namespace robosim::executors::avr {
namespace {

constexpr std::uint8_t kPaint = 0xC5;
constexpr std::uint32_t kTop = reg::kLastRam;
constexpr int kCanary_bytes = 8;
constexpr std::uint32_t kPastReach_bytes = 64;
constexpr std::size_t kMostCalls = 12;

}  // namespace

Stack::Stack(Chip& chip, const Firmware& firmware)
    : chip_(chip),
      firmware_(firmware),
      heap_pointer_(firmware.find_variable("__brkval").value_or(0)),
      heap_end_(firmware.globals_end) {
  std::fill(chip.memory() + heap_end_, chip.memory() + kTop + 1, kPaint);
}

void Stack::look() {
  if (heap_pointer_) {
    const int end = chip_.data(heap_pointer_) | chip_.data(static_cast<reg::Address>(heap_pointer_ + 1)) << 8;
    if (end > heap_end_ && end <= static_cast<int>(kTop)) heap_end_ = static_cast<std::uint16_t>(end);
  }
  if (chip_.sp() < heap_end_ || (chip_.data(heap_end_) != kPaint && has_overflown()))
    chip_.fail(Fault::Kind::stack, chip_.pc(), 0);
}

bool Stack::has_overflown() const {
  // A write behind the last variable takes the paint away too; the stack leaves none above it.
  int paint = 0;
  if (chip_.sp() < heap_end_) return true;
  if (chip_.data(heap_end_) == kPaint && chip_.data(static_cast<reg::Address>(heap_end_ + 1)) == kPaint)
    return false;
  for (std::uint32_t at = heap_end_; at <= kTop && at <= chip_.sp(); ++at) {
    paint = chip_.data(static_cast<reg::Address>(at)) == kPaint ? paint + 1 : 0;
    if (paint >= kCanary_bytes) return false;
  }
  return true;
}

std::uint32_t Stack::most_bytes() const {
  std::uint32_t at = heap_end_;
  // What the heap has left behind lies below the first long stretch of paint.
  int paint = 0;
  for (std::uint32_t i = heap_end_; i <= kTop; ++i) {
    paint = chip_.data(static_cast<reg::Address>(i)) == kPaint ? paint + 1 : 0;
    if (paint >= kCanary_bytes) {
      at = i;
      break;
    }
  }
  while (at <= kTop && chip_.data(static_cast<reg::Address>(at)) == kPaint) ++at;
  return kTop + 1 - at;
}

std::uint32_t Stack::return_address(std::uint32_t at) const {
  return 2u * static_cast<std::uint32_t>(chip_.data(static_cast<reg::Address>(at)) << 8 |
                                         chip_.data(static_cast<reg::Address>(at + 1)));
}

bool Stack::find_call(std::uint32_t pc, Call& call) const {
  if (pc < 4 || pc > firmware_.code_end) return false;
  const auto word = [&](std::uint32_t at) { return firmware_.flash[at] | firmware_.flash[at + 1] << 8; };
  if ((word(pc - 4) & 0xFE0E) == 0x940E) {
    call = {pc - 4, false};
    return true;
  }
  const int last = word(pc - 2);
  if (last == 0x9509 || (last & 0xF000) == 0xD000) {
    call = {pc - 2, last == 0x9509};
    return true;
  }
  return false;
}

std::vector<Stack::Call> Stack::open_calls() const {
  std::vector<Call> calls;
  Call call;
  for (std::uint32_t at = chip_.sp() + 1u; at < kTop && calls.size() < kMostCalls; ++at) {
    if (at < reg::kFirstRam || !find_call(return_address(at), call)) continue;
    calls.push_back(call);
    ++at;
  }
  return calls;
}

std::vector<Stack::Call> Stack::past_calls() const {
  std::vector<Call> calls;
  Call call;
  const std::uint32_t sp = std::min<std::uint32_t>(chip_.sp(), kTop);
  const std::uint32_t end =
      std::max<std::uint32_t>(sp > kPastReach_bytes ? sp - kPastReach_bytes : 0, heap_end_);
  for (std::uint32_t at = sp; at-- > end && calls.size() < kMostCalls;)
    if (find_call(return_address(at), call)) calls.push_back(call);
  return calls;
}

std::uint32_t Stack::last_return() const {
  const std::uint32_t sp = chip_.sp();
  return sp > reg::kFirstRam && sp <= kTop ? return_address(sp - 1) : 0;
}

}  // namespace robosim::executors::avr
