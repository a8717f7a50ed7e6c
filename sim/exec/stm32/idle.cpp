#include "sim/exec/stm32/idle.h"

#include <algorithm>

#include "sim/exec/stm32/cpu.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr Cycle kFirstExplored = 20'000, kLastExplored = 2'000'000;
constexpr std::size_t kMostStored = 200;
constexpr int kMostTries = 5, kMostRounds = 1;
// A recording ends after this number of arrivals at other loop heads. One of the other heads then probably
// belongs to the waiting loop.
constexpr int kMostOthers = 4;
// The costs of an arrival at a head, a recorded pass and a recorded read. The unit is the time in which one
// cycle is simulated.
constexpr std::int64_t kCostOfHead = 5, kCostOfRecord = 40, kCostOfLook = 10;
constexpr Cycle kWorthwhile = 60;

}  // namespace

Idle::Idle(Cpu& cpu) : cpu_(cpu), seen_(kRamBytes / 4) { heads_.reserve(kMostHeads); }

void Idle::allow(bool allowed) {
  allowed_ = allowed;
  interrupted();
  for (Head& head : heads_) mark(head, allowed);
}

Idle::Head* Idle::find(std::uint32_t pc) {
  for (Head& head : heads_)
    if (head.pc == pc) return &head;
  return nullptr;
}

void Idle::mark(Head& head, bool marked) {
  if (head.marked == marked) return;
  head.marked = marked;
  cpu_.mark(head.pc, &Cpu::Mark::head, marked);
}

void Idle::pay(Head& head, std::int64_t cycles) {
  if (!head.credit.pay(cycles, cpu_.clock_.now)) mark(head, false);
}

void Idle::explore() {
  const Cycle now = cpu_.clock_.now;
  if (!allowed_ || now < explore_at_) return;
  bool found = false;
  const std::vector<std::uint32_t> jumps = cpu_.last_jumps();
  for (std::size_t i = 0; i < jumps.size(); ++i) {
    // Considers only jumps that occur at least twice in the list.
    if (std::find(jumps.begin(), jumps.begin() + static_cast<std::ptrdiff_t>(i), jumps[i]) ==
        jumps.begin() + static_cast<std::ptrdiff_t>(i))
      continue;
    const std::uint32_t pc = cpu_.leads_back_to(jumps[i]);
    if (pc == 0) continue;
    Head* head = find(pc);
    if (!head) {
      if (heads_.size() == kMostHeads) continue;
      heads_.push_back({});
      head = &heads_.back();
      head->pc = pc;
    }
    if (head->marked || head->credit.is_banned(now)) continue;
    head->credit.begin_anew();
    mark(*head, true);
    found = true;
  }
  explore_every_ =
      found || explore_every_ == 0 ? kFirstExplored : std::min(2 * explore_every_, kLastExplored);
  explore_at_ = now + explore_every_;
}

void Idle::at_head(std::uint32_t pc) {
  Head* const head = find(pc);
  if (!head || !head->marked) return;
  if (recorded_ == head) {
    const Cycle now = cpu_.clock_.now, cycles = now - began_;
    const bool is_same = ends();
    head->cycles = cycles;
    pay(*head, -static_cast<std::int64_t>(2 * cycles) - kCostOfRecord);
    if (is_same) {
      const Cycle horizon = std::min(cpu_.stop_, until_);
      const Cycle passes = horizon > now ? (horizon - 1 - now) / cycles : 0;
      if (passes < 2) return;
      skip(passes - 1, cycles);
      return pay(*head, static_cast<std::int64_t>(passes - 1) *
                            (static_cast<std::int64_t>(cycles) + kCostOfLook * looks_));
    }
    ++tries_;
  } else if (recorded_) {
    if (++others_ < kMostOthers) return;
    pay(*recorded_, -static_cast<std::int64_t>(cpu_.clock_.now - began_));
    interrupted();
    tries_ = 0;
  } else {
    pay(*head, -kCostOfHead);
  }
  const Cycle now = cpu_.clock_.now, least = std::max(kWorthwhile, 4 * head->cycles);
  if (head->marked && tries_ < kMostTries && cpu_.stop_ > now && cpu_.stop_ - now >= least) begin(*head);
}

Idle::State Idle::state() const {
  State state;
  std::copy_n(cpu_.state_.r.begin(), state.registers.size(), state.registers.begin());
  state.others = {cpu_.state_.flags.pack(), cpu_.state_.primask,  cpu_.state_.faultmask,
                  cpu_.state_.basepri,      cpu_.state_.other_sp, cpu_.state_.on_process_stack};
  return state;
}

void Idle::begin(Head& head) {
  recorded_ = &head;
  cpu_.records(true);
  state_ = state();
  stored_.clear();
  ++number_;
  began_ = cpu_.clock_.now;
  until_ = kNoCycle;
  rounds_ = others_ = looks_ = 0;
  jumps_before_ = cpu_.state_.jump_count;
}

bool Idle::ends() {
  recorded_ = nullptr;
  cpu_.records(false);
  return rounds_ <= kMostRounds && state() == state_ &&
         std::all_of(stored_.begin(), stored_.end(),
                     [&](const Word& word) { return cpu_.word(word.address) == word.value; });
}

void Idle::stores(std::uint32_t address, std::uint32_t bytes) {
  if (!recorded_) return;
  for (std::uint32_t at = address & ~3u; at < address + bytes; at += 4) {
    std::uint32_t& seen = seen_[(at - kRam) / 4];
    if (seen == number_) continue;
    seen = number_;
    if (stored_.size() == kMostStored) return interrupted();
    stored_.push_back({at, cpu_.word(at)});
  }
}

void Idle::looks(Cycle until) {
  if (until <= cpu_.clock_.now) interrupted();
  until_ = std::min(until_, until);
  ++looks_;
}

void Idle::round_began() {
  ++rounds_;
  round_at_ = cpu_.clock_.now;
}

void Idle::interrupted() {
  if (!recorded_) return;
  ++tries_;
  pay(*recorded_, -kCostOfRecord);
  recorded_ = nullptr;
  cpu_.records(false);
}

void Idle::runs_anew() {
  interrupted();
  tries_ = 0;
}

void Idle::moved_in_time() {
  runs_anew();
  const Cycle now = cpu_.clock_.now;
  explore_at_ = std::min(explore_at_, now + explore_every_);
  for (Head& head : heads_) head.credit.moved_in_time(now);
}

void Idle::skip(Cycle passes, Cycle cycles) {
  Clock& clock = cpu_.clock_;
  if (rounds_ > 0) {
    // The durations of the rounds of loop() differ, because times are rounded to nanoseconds. The pattern of
    // these durations repeats after at most this number of rounds.
    constexpr Cycle kDifferent = 40;
    const Cycle first = round_at_ + cycles;
    const Cycle one_by_one = std::min(passes, kDifferent);
    for (Cycle i = 0; i < one_by_one; ++i) cpu_.state_.rounds.began(clock.time_of(first + i * cycles));
    if (passes > one_by_one)
      cpu_.state_.rounds.went_on(clock.time_of(first + (passes - 1) * cycles), passes - one_by_one);
  }
  const std::uint32_t jumps = cpu_.state_.jump_count - jumps_before_;
  const auto kept = static_cast<std::uint32_t>(cpu_.state_.jumps.size());
  if (jumps == 1) {
    const std::uint32_t from = cpu_.state_.jumps[(cpu_.state_.jump_count - 1) % kept];
    for (Cycle i = std::min<Cycle>(passes, kept); i > 0; --i)
      cpu_.state_.jumps[cpu_.state_.jump_count++ % kept] = from;
  } else if (jumps > 0 && jumps < kept) {
    const Cycle repeated = std::min<Cycle>(passes, (kept + jumps - 1) / jumps) * jumps;
    for (Cycle i = 0; i < repeated; ++i) {
      cpu_.state_.jumps[cpu_.state_.jump_count % kept] =
          cpu_.state_.jumps[(cpu_.state_.jump_count - jumps) % kept];
      ++cpu_.state_.jump_count;
    }
  }
  clock.now += passes * cycles;
  skipped_ += passes * cycles;
}

}  // namespace robosim::exec::stm32
