#include "sim/detect/avr/missed_interrupts.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/exec/avr/registers.h"

namespace robosim::detect::avr {
namespace {

constexpr std::size_t kMostPlaces = 64, kJumpsOfHandler = 8;
constexpr std::uint8_t kModeMask = 0x03, kHighModeBit = 0x08, kClockMask = 0x07;

constexpr const char* kBeBrief =
    "Keep interrupts off only while copying a number, and let handlers only record events: leave the work to "
    "loop().";

}  // namespace

MissedInterrupts::MissedInterrupts(const RunningProgram& program, const std::vector<Pin>& counted)
    : program_(program),
      machine_(program.machine),
      cpu_(machine_.chip().chip().cpu()),
      timer_(machine_.chip().spec().timers[0]) {
  const ChipSpec& spec = machine_.chip().spec();
  for (const Pin pin : counted) {
    const int place = machine_.adapter().chip_pin(pin);
    if (place >= 0 && spec.pins[place].external >= 0)
      pins_[spec.external_vector + spec.pins[place].external] = pin;
  }
  robosim::avr::Core& core = machine_.chip().chip().core();
  core.on_lost = [](void* self, int vector) { static_cast<MissedInterrupts*>(self)->lost(vector); };
  core.on_lost_self = this;
  if (program.firmware.find_variable("timer0_millis")) machine_.chip().show_handlers(*this);
}

MissedInterrupts::~MissedInterrupts() { machine_.chip().chip().core().on_lost = nullptr; }

/// Returns the reason why the handler is delayed at this moment, such as "because a handler was still
/// running".
std::string MissedInterrupts::held_off() const {
  return machine_.chip().in_handler() ? "because a handler was still running"
                                      : "because all interrupts, or only this one, were off "
                                        "(noInterrupts(), cli())";
}

void MissedInterrupts::see(const char* detector, const std::string& what, const SourceLine& where,
                           std::int64_t times) {
  seen_.add({detector, what, kBeBrief, where, 1e-9 * static_cast<double>(machine_.now()), times});
}

void MissedInterrupts::lost(int vector) {
  const auto pin = pins_.find(vector);
  const ChipSpec& spec = machine_.chip().spec();
  const bool is_edge = vector >= spec.external_vector && vector < spec.external_vector + spec.external_count;
  if (is_edge && pin == pins_.end()) return;
  const std::pair<int, std::uint32_t> key{vector, machine_.chip().last_pc()};
  if (places_.size() >= kMostPlaces && !places_.contains(key)) return;
  const auto [place, is_new] = places_.try_emplace(key);
  if (is_new) place->second = program_.diagnosis().where_now();
  if (is_edge)
    return see(result::detector("lost_edge"),
               fmt::format("an edge at pin {} was lost: the previous edge was still waiting for its handler, "
                           "{}; a counter of the edges falls behind",
                           pin->second, held_off()),
               place->second, 1);
  see(result::detector("lost_byte"),
      fmt::format("a received byte was lost: the chip's receive buffer was full, {}", held_off()),
      place->second, 1);
}

/// Returns the number of cycles between overflows of timer 0; 0 if the sketch has changed the timer mode
/// that the Arduino core sets.
Cycle MissedInterrupts::tick() const {
  const std::uint8_t a = cpu_.data[timer_.control];
  const std::uint8_t b = cpu_.data[timer_.control_b ? timer_.control_b : timer_.control + 1];
  const bool counts_to_255 = (a & kModeMask) != 1 && (a & kModeMask) != 2 && !(b & kHighModeBit);
  return counts_to_255 ? Cycle{256} * timer_.prescalers[b & kClockMask] : 0;
}

void MissedInterrupts::entered(int vector, Cycle at) {
  if (vector != exec::avr::overflow_of(timer_)) return;
  const Cycle period = tick(), slept = machine_.chip().sleep_cycles(), bitten = machine_.chip().last_bite();
  const bool goes_on =
      flagged_ != 0 && period == period_ && slept == slept_ && bitten == bitten_ && period > 0;
  const Cycle passed = goes_on ? (at - flagged_) / period : 0;
  flagged_ = passed > 0 ? std::min(flagged_ + passed * period, at) : at;
  period_ = period;
  slept_ = slept;
  bitten_ = bitten;
  if (passed > 1) ticks_lost(static_cast<std::int64_t>(passed - 1), at);
}

void MissedInterrupts::ticks_lost(std::int64_t ticks, Cycle at) {
  // If another handler delayed this interrupt, that handler has just returned. The last jump before this
  // interrupt is then the RETI of that handler. After RETI, the chip executes one more instruction (data
  // sheet DS40002061B, 7.7), which may be a jump, too.
  const std::vector<std::uint32_t> jumps = machine_.chip().last_jumps();
  const auto is_return = [&](std::size_t i) {
    return jumps.size() > i && cpu_.instruction(jumps[i] / 2).op == robosim::avr::Op::reti;
  };
  const bool handler = is_return(1) || is_return(2);
  // If the handler belongs to the Arduino core, reports the last jump in user code while the handler ran.
  SourceLine where = handler ? SourceLine{} : program_.debug.place(machine_.chip().interrupted_pc());
  for (std::size_t i = is_return(1) ? 1 : 2;
       handler && where.file.empty() && i < std::min(jumps.size(), kJumpsOfHandler); ++i)
    where = program_.debug.place(jumps[i]);
  if (where.file.empty()) where = program_.diagnosis().where_now();
  const double tick_us = 1e6 * static_cast<double>(period_) / machine_.chip().clock_hz();
  const double off_us = 1e6 * static_cast<double>(at - flagged_ + static_cast<Cycle>(ticks) * period_) /
                        machine_.chip().clock_hz();
  see(result::detector("lost_tick"),
      fmt::format("millis() lost {} of {:.3f} ms: timer 0 overflowed again before its handler could run, "
                  "because {} for at least {:.1f} ms, until here",
                  ticks == 1 ? "a tick" : fmt::format("{} ticks", ticks), 1e-3 * tick_us,
                  handler ? "a handler was running"
                          : "all interrupts, or only this one, were off (noInterrupts(), cli(), TIMSK0)",
                  1e-3 * off_us),
      where, ticks);
}

}  // namespace robosim::detect::avr
