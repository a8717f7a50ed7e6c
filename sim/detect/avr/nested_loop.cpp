#include "sim/detect/avr/nested_loop.h"

#include <fmt/format.h>

#include "sim/detect/avr/call_site.h"

namespace robosim::detect::avr {
namespace {

constexpr std::size_t kFewest = 3;  // a finding has at least this many active calls
constexpr std::size_t kMost = 64;   // at most this many active calls are recorded

}  // namespace

NestedLoop::NestedLoop(const RunningProgram& program) : program_(program) {
  // If only main() calls loop(), the compiler inlines loop(), and `loop` is missing.
  if (const auto begin = program.firmware.find("loop")) program.machine.chip().show(*this, *begin);
}

void NestedLoop::visited(std::uint32_t, Cycle) {
  const robosim::avr::Cpu& cpu = program_.machine.chip().chip().cpu();
  const std::uint16_t sp = cpu.sp();
  while (!open_.empty() && open_.back() <= sp) open_.pop_back();
  if (open_.size() < kMost) open_.push_back(sp);
  if (open_.size() <= deepest_) return;
  deepest_ = open_.size();
  if (deepest_ < kFewest) return;
  const double now_s = 1e-9 * static_cast<double>(program_.machine.now());
  const int bytes = (open_.front() - sp) / static_cast<int>(deepest_ - 1);
  const int left =
      static_cast<int>(program_.machine.stack().room_bytes()) - (program_.firmware.last_ram - sp);
  const double first_s = deepest_ == kFewest ? now_s : seen_.first_s;
  seen_ = {result::detector("nested_loop"),
           fmt::format(
               "loop() is called from within itself and does not return: {} calls are open at {:.2f} s, each "
               "takes {} bytes of the stack, and {} bytes are left before the stack reaches the variables",
               deepest_, now_s, bytes, left > 0 ? left : 0),
           "Return from loop(): main() calls it repeatedly.",
           program_.debug.place(call_site(cpu)),
           first_s,
           static_cast<int>(deepest_ - 1)};
}

std::vector<Detected> NestedLoop::found(SimTime) const {
  return deepest_ < kFewest ? std::vector<Detected>{} : std::vector<Detected>{seen_};
}

}  // namespace robosim::detect::avr
