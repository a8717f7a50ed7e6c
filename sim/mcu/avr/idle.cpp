#include "sim/mcu/avr/idle.h"

#include <algorithm>

namespace robosim::avr {
namespace {

constexpr int kExplored = 600;  // instructions per exploration
constexpr std::int64_t kFirstExplored = 20'000, kLastExplored = 2'000'000;
constexpr std::size_t kMostLandings = 24;
// Costs of recording and skipping, in cycles of firmware that the host could have executed in the same time.
constexpr std::int64_t kCostOfHead = 40, kCostOfStep = 40;
constexpr Cycle kWorthwhile = 200;

}  // namespace

void Idle::allow(bool allowed) {
  allowed_ = allowed;
  recorded_ = nullptr;
  exploring_ = 0;
  for (Head& head : heads_) mark(head, allowed);
}

void Idle::moved_in_time() {
  recorded_ = nullptr;
  explore_at_ = std::min(explore_at_, executed() + explore_every_);
  for (Head& head : heads_) head.credit.moved_in_time(core_.now());
}

void Idle::mark(Head& head, bool marked) {
  if (head.marked == marked) return;
  head.marked = marked;
  core_.cpu.set_head(head.pc, marked);
}

Idle::Head* Idle::find(std::uint32_t pc) {
  for (Head& head : heads_)
    if (head.pc == pc) return &head;
  return nullptr;
}

bool Idle::begins_to_explore() {
  if (explore_every_ == 0) explore_every_ = kFirstExplored;
  exploring_ = kExplored;
  landings_.clear();
  return true;
}

void Idle::before() {
  pc_before_ = core_.cpu.pc();
  cycle_before_ = core_.now();
  if (recorded_ && !path_.before()) {
    pay(*recorded_, -kCostOfStep * steps_);
    recorded_ = nullptr;
  }
}

void Idle::after() {
  if (core_.now() == cycle_before_) return;  // a mark stopped run() before any instruction
  if (recorded_) {
    ++steps_;
    if (!path_.after()) {
      pay(*recorded_, -kCostOfStep * steps_);
      recorded_ = nullptr;
    }
  }
  if (exploring_ == 0) return;
  const std::uint32_t pc = core_.cpu.pc();
  const Op op = core_.cpu.instruction(pc_before_).op;
  const bool jumped = (op == Op::rjmp || op == Op::jmp || op == Op::brbs || op == Op::brbc) &&
                      !core_.cpu.is_count(pc_before_);
  if (jumped && pc <= pc_before_) {
    const auto landing = std::find_if(landings_.begin(), landings_.end(),
                                      [pc](const Landing& known) { return known.pc == pc; });
    if (landing != landings_.end()) {
      ++landing->count;
    } else if (landings_.size() < kMostLandings) {
      landings_.push_back({pc, 1});
    }
  }
  if (--exploring_ == 0) explored();
}

void Idle::explored() {
  bool found = false;
  for (const Landing& landing : landings_) {
    if (landing.count < 2) continue;
    Head* head = find(landing.pc);
    if (!head) {
      if (heads_.size() == kMostHeads) continue;
      heads_.push_back({});
      head = &heads_.back();
      head->pc = landing.pc;
    }
    if (head->marked || head->credit.is_banned(core_.now())) continue;
    head->credit.begin_anew();
    mark(*head, true);
    found = true;
  }
  explore_every_ = found ? kFirstExplored : std::min(2 * explore_every_, kLastExplored);
  explore_at_ = executed() + explore_every_;
}

void Idle::pay(Head& head, std::int64_t cycles) {
  if (head.credit.pay(cycles, core_.now())) return;
  mark(head, false);
  head.is_known = false;
}

void Idle::at_head(Cycle horizon) {
  Head* const head = find(core_.cpu.pc());
  if (!head || !head->marked || (recorded_ && recorded_ != head)) return;
  if (recorded_) {
    recorded_ = nullptr;
    head->is_known = path_.ends(head->pass);
    pay(*head, -kCostOfStep * steps_);
    if (!head->is_known) return;
  } else {
    pay(*head, -kCostOfHead);
  }
  if (!head->marked) return;
  if (head->is_known && is_as_recorded(head->pass)) {
    const Cycle passes = passes_before(horizon, head->pass);
    if (passes < 2) return;
    skip(head->pass, passes - 1);
    pay(*head, static_cast<std::int64_t>((passes - 1) * head->pass.cycles));
    return;
  }
  if (horizon < core_.now() + kWorthwhile) return;
  recorded_ = head;
  steps_ = 0;
  path_.begin();
}

bool Idle::is_as_recorded(const LoopTrace::Pass& pass) const {
  const Cpu& cpu = core_.cpu;
  if (cpu.sp() != pass.sp || (cpu.sreg() ^ pass.flags) & pass.flags_read) return false;
  if (pass.enables_interrupts && core_.interrupts.any()) return false;
  for (const LoopTrace::Pass::Byte& byte : pass.reads)
    if (cpu.data[byte.address] != byte.value) return false;
  return true;
}

/// Returns the number of passes from now on that equal `pass` and end before `horizon`.
Cycle Idle::passes_before(Cycle horizon, const LoopTrace::Pass& pass) const {
  const Cycle now = core_.now();
  if (horizon <= now) return 0;
  Cycle most = (horizon - 1 - now) / pass.cycles;
  for (const LoopTrace::Pass::Look& look : pass.looks) {
    const ReadForecast forecast = core_.cpu.forecast(look.address, look.bits);
    const Cycle first = now + look.after;
    if (forecast.until <= first) return 0;
    const std::uint8_t value = forecast.value_at(first);
    const bool is_within = look.counts && value >= look.value && value - look.value <= pass.window;
    if (!is_within && (value ^ look.value) & look.bits) return 0;
    Cycle end = forecast.until;
    if (forecast.counts())
      end = std::min(end, forecast.reaches(look.value + (look.counts ? pass.window : 0) + 1));
    if (end <= first) return 0;
    most = std::min(most, (end - 1 - first) / pass.cycles + 1);
  }
  return most;
}

void Idle::skip(const LoopTrace::Pass& pass, Cycle passes) {
  Cpu::State& state = core_.cpu.state;
  if (pass.visits)
    core_.visitor->left_out(pass.visited, state.cycle + pass.visited_after, pass.cycles, passes);
  state.cycle += passes * pass.cycles;
  skipped_ += passes * pass.cycles;
  const Cycle jumps = passes * pass.jumps.size();
  const Cycle kept = std::min<Cycle>(jumps, state.jumps.size());
  for (Cycle i = jumps - kept; i < jumps; ++i)
    state.jumps[static_cast<std::uint32_t>(state.jump_count + i) % state.jumps.size()] =
        pass.jumps[i % pass.jumps.size()];
  state.jump_count += static_cast<std::uint32_t>(jumps);
}

}  // namespace robosim::avr
