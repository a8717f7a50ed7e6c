#include "sim/exec/avr/why/backward_slice.h"

#include <algorithm>

#include "sim/base/elf/avr_addresses.h"
#include "sim/mcu/avr/instruction_effects.h"
#include "sim/mcu/avr/instruction_table.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::each;
using robosim::avr::effects_of;
using robosim::avr::Instruction;
using robosim::avr::InstructionEffects;
using robosim::avr::is_call;
using robosim::avr::Op;
using Entry = InstructionLog::Entry;
using Touch = InstructionLog::Touch;

}  // namespace

void BackwardSlice::plug_into(Machine& machine) {
  machine_ = &machine;
  branches_.emplace(machine.chip().chip().cpu());
  if (records_) begin();
}

void BackwardSlice::unplug() {
  if (machine_) machine_->log_into(nullptr);
  machine_ = nullptr;
  log_.reset();
  branches_.reset();
  frames_.clear();
}

void BackwardSlice::begin() {
  frames_.clear();
  calls_before_.clear();
  records_ = true;
  if (!machine_) return log_.reset();
  log_.emplace(machine_->chip(), machine_->adapter());
  log_->begin();
  machine_->log_into(&*log_);
  for (const Stack::Call& call : machine_->stack().open_calls()) calls_before_.push_back(call.pc / 2);
}

void BackwardSlice::end() {
  records_ = false;
  if (machine_) machine_->log_into(nullptr);
}

void BackwardSlice::forget() {
  registers_ = {};
  flags_ = {};
  bytes_.clear();
  bits_.clear();
  pending_.clear();
  steps_.clear();
  sends_two_wire_ = false;
}

// --- calls in the log

void BackwardSlice::find_frames() {
  if (!frames_.empty() || !log_) return;
  struct Open {
    Index index;
    std::uint16_t sp;  ///< stack pointer before the call
  };
  std::vector<Open> open;
  const auto& entries = log_->entries();
  const auto& cpu = machine_->chip().chip().cpu();
  frames_.reserve(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& e = entries[i];
    while (!open.empty() && e.sp >= open.back().sp) open.pop_back();
    const auto index = static_cast<Index>(i);
    if (e.interrupts)
      open.push_back({index, static_cast<std::uint16_t>(e.sp + firmware_.chip->return_address_bytes)});
    frames_.push_back(open.empty() ? kNone : open.back().index);
    if (is_call(cpu.instruction(e.pc).op)) open.push_back({index, e.sp});
  }
}

SimTime BackwardSlice::time_of(Index index) const {
  const auto at = static_cast<std::size_t>(index);
  return board_.to_world(machine_->clock_map().time_of(log_->began() + log_->entries()[at].began));
}

std::vector<BackwardSlice::Line> BackwardSlice::lines_of(Index index) const {
  std::vector<Line> lines;
  const auto add = [&](std::uint32_t pc) {
    const std::vector<Line>& here = sketch_.at(pc).lines;
    lines.insert(lines.end(), here.begin(), here.end());
  };
  const auto& entries = log_->entries();
  for (;;) {
    const Entry& e = entries[static_cast<std::size_t>(index)];
    add(e.pc);
    if (e.interrupts) return lines;
    index = frames_[static_cast<std::size_t>(index)];
    if (index == kNone) break;
  }
  for (const std::uint32_t pc : calls_before_) add(pc);
  return lines;
}

// --- questions

void BackwardSlice::set_out(SimTime t) {
  forget();
  find_frames();
  from_ = static_cast<Index>(frames_.size()) - 1;
  Index first = 0;
  while (first < from_) {  // finds the last entry that started at or before `t`
    const Index middle = first + (from_ - first + 1) / 2;
    if (time_of(middle) <= t)
      first = middle;
    else
      from_ = middle - 1;
  }
}

void BackwardSlice::ask(const Effect& effect, SimTime t) {
  if (!log_) return forget();
  set_out(t);
  sends_two_wire_ = effect.sends_two_wire;
  const ChipSpec& chip = *firmware_.chip;
  for (const Pin pin : effect.pins) {
    const int number = machine_->adapter().chip_pin(pin);
    if (number < 0 || chip.pins[number].port < 0) continue;
    const ChipPin& place = chip.pins[number];
    const std::uint32_t port = chip.ports[place.port].address;
    const auto directions = static_cast<std::uint16_t>(port + 1),
               latch = static_cast<std::uint16_t>(port + 2);
    if ((*byte(directions) & (1u << place.bit)) == 0) {  // no output: only its direction matters
      bytes_[directions] = {};
      continue;
    }
    bytes_[latch] = {};
    bits_[latch] |= static_cast<std::uint8_t>(1u << place.bit);
    if (place.timer < 0) continue;
    const TimerSpec& timer = chip.timers[place.timer];
    if (const std::uint16_t compare = timer.compare[place.output]) bytes_[compare] = {};
    const auto control = static_cast<std::uint16_t>(timer.control);
    bytes_[control] = {};
    bits_[control] |= static_cast<std::uint8_t>(0xC0u >> (2 * place.output));
  }
}

void BackwardSlice::ask_place(SimTime t) {
  if (!log_) return forget();
  set_out(t);
  if (from_ == kNone) return;
  const std::vector<Line> lines = lines_of(from_);
  for (std::size_t i = 0; i < lines.size(); ++i)
    note(lines[i], static_cast<int>(i), CauseStep::Kind::computes, time_of(from_));
  const Want want{0, lines.empty() ? nullptr : lines[0]};
  want_branch(from_, want);
  // The firmware may be in a waiting loop. Therefore follows only the last branch, which keeps the firmware
  // in the loop.
  Index index = from_;
  const auto pc = [&] { return log_->entries()[static_cast<std::size_t>(index)].pc; };
  while (sketch_.at(pc()).lines.empty() && frames_[static_cast<std::size_t>(index)] != kNone &&
         frames_[static_cast<std::size_t>(index)] != index)
    index = frames_[static_cast<std::size_t>(index)];
  pending_[frames_[static_cast<std::size_t>(index)]].push_back({kLast, want});
}

// --- backward

void BackwardSlice::follow(bool adjoins) {
  if (!log_) return;
  if (frames_.empty()) {  // begin() has started a new log since ask()
    find_frames();
    from_ = static_cast<Index>(frames_.size()) - 1;
    pending_.clear();
    if (!adjoins) registers_ = {}, flags_ = {};
    for (std::optional<Want>& wanted : registers_)
      if (wanted) wanted->by = kLater;
    for (auto& [address, wanted] : bytes_) wanted.by = kLater;
  }
  for (Index index = from_; index >= 0; --index) {
    if (sends_two_wire_ && sends(index)) take(index, {}, CauseStep::Kind::computes);
    visit(index);
  }
  from_ = kNone;
  sends_two_wire_ = false;
}

/// Returns whether an entry stores a byte to send in TWDR.
bool BackwardSlice::sends(Index index) const {
  constexpr std::uint16_t kTwdr = 3;  // after TWBR
  const Entry& e = log_->entries()[static_cast<std::size_t>(index)];
  const std::uint16_t twi = firmware_.chip->twi.address;
  return twi != 0 && e.touch == Touch::store && e.address == twi + kTwdr;
}

std::optional<BackwardSlice::Want> BackwardSlice::take_wanted(Index index) {
  const Entry& e = log_->entries()[static_cast<std::size_t>(index)];
  const auto& cpu = machine_->chip().chip().cpu();
  const Instruction& i = cpu.instruction(e.pc);
  const InstructionEffects effects = effects_of_logged(i, cpu);
  std::optional<Want> best;
  const auto made = [&](std::optional<Want>& wanted) {
    if (wanted && (!best || wanted->far < best->far)) best = wanted;
    wanted.reset();
  };
  each(effects.writes, [&](unsigned reg) { made(registers_[reg]); });
  each(effects.flags_written, [&](unsigned flag) { made(flags_[flag]); });
  if (e.touch != Touch::store) return best;
  for (unsigned at = e.address; at < e.address + e.bytes; ++at) {
    const auto found = bytes_.find(static_cast<std::uint16_t>(at));
    if (found == bytes_.end()) continue;
    const auto bits = bits_.find(found->first);
    if (bits != bits_.end() && (e.changed & bits->second) == 0) continue;
    std::optional<Want> wanted = found->second;
    if (is_call(i.op))
      wanted.reset();
    else
      made(wanted);
    if (bits != bits_.end()) {
      bits->second &= static_cast<std::uint8_t>(~e.changed);
      if (bits->second != 0) continue;
      bits_.erase(bits);
    }
    bytes_.erase(found);
  }
  return best;
}

void BackwardSlice::visit(Index index) {
  // Within this call, no branch decided whether the pending instructions ran. Therefore their cause is the
  // branch that decided whether the call ran.
  if (const auto inside = pending_.find(index); inside != pending_.end()) {
    const std::vector<Pending> waiting = std::move(inside->second);
    pending_.erase(inside);
    for (const Pending& one : waiting) want_branch(index, one.want);
  }
  visit_branch(index);
  visit_skipped_writes(index);
  if (const auto wanted = take_wanted(index)) take(index, *wanted, CauseStep::Kind::computes);
}

void BackwardSlice::take(Index index, Want want, CauseStep::Kind kind) {
  const Entry& e = log_->entries()[static_cast<std::size_t>(index)];
  const std::vector<Line> lines = lines_of(index);
  if (lines.empty() && frames_[static_cast<std::size_t>(index)] == kNone && e.touch == Touch::store)
    return note_variable(kAvrData + e.address, want);  // the start-up code wrote the initial value
  if (!lines.empty()) {
    if (want.line && lines[0] != want.line) ++want.far;
    want.line = lines[0];
  }
  if (want.far > kFarthest) return;
  const bool adapter = comes_from_outside(index, want);
  if (!adapter)
    for (std::size_t i = 0; i < lines.size(); ++i)
      note(lines[i], want.far + static_cast<int>(i), kind, time_of(index));
  if (e.touch == Touch::flash) note_variable(e.address, want);
  if (!adapter) want_operands(index, want);
  want_branch(index, want);
}

void BackwardSlice::want_operands(Index index, Want want) {
  const Entry& e = log_->entries()[static_cast<std::size_t>(index)];
  const auto& cpu = machine_->chip().chip().cpu();
  const InstructionEffects effects = effects_of_logged(cpu.instruction(e.pc), cpu);
  const auto also = [&](std::optional<Want>& wanted) {
    const Index by = wanted ? wanted->by : index;
    if (!wanted || want.far < wanted->far) wanted = want;
    wanted->by = by;
  };
  each(effects.reads, [&](unsigned reg) { also(registers_[reg]); });
  each(effects.flags_read, [&](unsigned flag) { also(flags_[flag]); });
  if (e.touch != Touch::load) return;
  for (unsigned at = e.address; at < e.address + e.bytes; ++at) {
    if (at < firmware_.chip->ram_address) continue;
    std::optional<Want> wanted;
    const auto known = bytes_.find(static_cast<std::uint16_t>(at));
    if (known != bytes_.end()) wanted = known->second;
    also(wanted);
    bytes_[static_cast<std::uint16_t>(at)] = *wanted;
  }
}

bool BackwardSlice::comes_from_outside(Index index, Want want) {
  const Entry& e = log_->entries()[static_cast<std::size_t>(index)];
  if (e.touch != Touch::load) return false;
  const ChipSpec& chip = *firmware_.chip;
  if (const Pin pin = log_->pin_of(static_cast<std::size_t>(index)); pin != kNoPin) {
    note(want.line, want.far, CauseStep::Kind::reads, time_of(index), pin);
    return true;
  }
  bool clock = false, received = false;
  for (int i = 0; i < chip.timer_count; ++i)
    clock |= e.address >= chip.timers[i].count && e.address < chip.timers[i].count + chip.timers[i].bits / 8;
  for (const char* const variable : {"timer0_millis", "timer0_overflow_count"})
    if (const auto kept = firmware_.find_variable(variable))
      clock |= e.address >= *kept && e.address < *kept + 4;
  for (int i = 0; i < chip.uart_count; ++i) received |= e.address == chip.uarts[i].data;
  if (!clock && !received) return false;
  note(want.line, want.far, clock ? CauseStep::Kind::asks_time : CauseStep::Kind::receives, time_of(index));
  return true;
}

// --- results

void BackwardSlice::note(Line line, int far, CauseStep::Kind kind, SimTime t, Pin pin) {
  if (!line) return;
  const auto [known, fresh] = steps_.try_emplace({line, pin});
  CauseStep& step = known->second;
  if (fresh) step = {kind, *line, t, far, pin};
  step.far = std::min(step.far, far);
  step.t = std::max(step.t, t);
}

void BackwardSlice::note_variable(std::uint32_t address, Want want) {
  for (const Line declaration : sketch_.declarations(address))
    note(declaration, want.far + 1, CauseStep::Kind::keeps, 0);
}

std::vector<std::uint16_t> BackwardSlice::open_bytes() const {
  std::vector<std::pair<int, std::uint16_t>> open;
  for (const auto& [address, want] : bytes_) open.emplace_back(want.far, address);
  std::sort(open.begin(), open.end());
  std::vector<std::uint16_t> addresses;
  for (const auto& [far, address] : open) addresses.push_back(address);
  return addresses;
}

std::optional<std::uint8_t> BackwardSlice::byte(std::uint16_t address) const {
  return machine_ ? std::optional(machine_->chip().data(address)) : std::nullopt;
}

void BackwardSlice::give_up(const std::vector<std::uint16_t>& bytes) {
  for (const std::uint16_t address : bytes) bytes_.erase(address), bits_.erase(address);
}

bool BackwardSlice::open_registers() const {
  return std::any_of(registers_.begin(), registers_.end(), [](const auto& want) { return want.has_value(); });
}

void BackwardSlice::close() {
  for (const auto& [address, want] : bytes_)
    if (address >= firmware_.chip->ram_address) note_variable(kAvrData + address, want);
  bytes_.clear();
}

std::vector<CauseStep> BackwardSlice::steps() const {
  std::vector<CauseStep> steps;
  for (const auto& [line, step] : steps_) steps.push_back(step);
  std::sort(steps.begin(), steps.end(), [](const CauseStep& a, const CauseStep& b) {
    return std::tie(a.far, b.t, a.where.file, a.where.line) <
           std::tie(b.far, a.t, b.where.file, b.where.line);
  });
  return steps;
}

}  // namespace robosim::exec::avr
