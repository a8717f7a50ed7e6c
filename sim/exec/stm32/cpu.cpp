#include "sim/exec/stm32/cpu.h"

#include <cstring>

#include "sim/exec/stm32/engine.h"
#include "sim/exec/stm32/unicorn.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

Cpu::Cpu(const Firmware& firmware, Bus& bus, Engine& engine, const LoopMarks& loop)
    : firmware_(firmware),
      bus_(bus),
      clock_(bus.link().clock),
      nvic_(bus.link().nvic),
      engine_(engine),
      uc_(engine.uc()),
      flash_(bus.flash().data()),
      ram_(bus.ram().data()),
      code_(kFlashBytes / 2 + 2) {
  records(false);
  engine_.begin(*this, ram_);
  for (std::uint32_t i = 0; i < code_.size(); ++i) code_[i].pc = kFlash + 2 * i;
  for (const std::uint32_t pc : loop.first) mark(pc, &Mark::starts);
  for (const std::uint32_t pc : loop.each) mark(pc, &Mark::loop);
  // Marks functions that return values which interrupt handlers have stored. Firmware polls by calling these
  // functions, so each call counts as an access to a peripheral.
  for (const char* name : {"millis", "HAL_GetTick", "_ZN14HardwareSerial9availableEv",
                           "_ZN14HardwareSerial4peekEv", "_ZN14HardwareSerial4readEv"})
    if (const Symbol* symbol = firmware.symbols.find(name)) mark(symbol->address, &Mark::call);
  reset();
  state_.lowest_sp = reg(kSp);
  watch_stack();
}

// Sets the registers to their reset values (PM0056 2.1.3, 2.3.4).
void Cpu::reset() {
  if (!state_.handlers.empty()) state_.handler_cycles += clock_.now - state_.handler_began;
  state_.handlers.clear();
  state_.r = {};
  std::uint32_t vectors[2];
  std::memcpy(vectors, flash_, sizeof vectors);
  set_reg(kSp, vectors[0]);
  set_reg(kLr, 0xFFFFFFFF);
  state_.next = state_.pc = vectors[1] & ~1u;
  state_.other_sp = state_.primask = state_.faultmask = state_.basepri = 0;
  state_.on_process_stack = state_.returning = state_.asleep = false;
  state_.rounds.await();
  state_.predicated = 0;
  set_status(0);
  set_stack_limit(firmware_.globals_end);
}

Cpu::~Cpu() { engine_.end(); }

std::uint8_t* Cpu::ram(Address address, unsigned bytes) const {
  if (address < kRam || address > kRam + kRamBytes - bytes) return nullptr;
  return ram_ + (address - kRam);
}

std::uint32_t Cpu::word(Address address) const {
  std::uint32_t value = 0;
  if (const std::uint8_t* at = ram(address, 4)) std::memcpy(&value, at, 4);
  return value;
}

void Cpu::set_word(Address address, std::uint32_t value) {
  if (std::uint8_t* at = ram(address, 4)) std::memcpy(at, &value, 4);
}

std::uint16_t Cpu::half(Address address) const {
  std::uint16_t value = 0;
  if (const std::uint8_t* const at = memory(address, 2)) std::memcpy(&value, at, 2);
  return value;
}

std::uint32_t Cpu::opcode(std::uint32_t pc) const {
  const std::uint32_t at = pc < kFlashBytes ? pc + kFlash : pc;
  const std::uint32_t first = half(at);
  return first >= 0xE800 ? first << 16 | half(at + 2) : first;
}

bool Cpu::make(std::uint32_t pc, Step& step) const {
  if (!memory(pc, 2)) return false;
  const Thumb thumb = decode_thumb(pc, half(pc), half(pc + 2));
  step = step_of(thumb, decode(half(pc), half(pc + 2)));
  step.pc = pc;
  if (step.kind == Step::Kind::branch && step.value - kFlash < kFlashBytes && step.value != step.next()) {
    step.kind = step.within = direct_kind(step);
    step.value = (step.value - kFlash) / 2;
  }
  const bool is_constant = thumb.n == Thumb::kZero && thumb.m == Thumb::kZero && thumb.d != Thumb::kPc;
  if (thumb.op == Op::ldr && is_constant && thumb.value - kFlash <= kFlashBytes - 4) {
    step.kind = step.within = Step::Kind::ldr_const;
    std::memcpy(&step.value, flash_ + (thumb.value - kFlash), 4);
  }
  if (referee_ && thumb.op <= Op::it) step.kind = step.within = Step::Kind::emulate;
  return true;
}

const Step* Cpu::fetched(const Step& at) {
  const std::uint32_t pc = at.pc, offset = pc - kFlash;
  if (offset >= kFlashBytes) {
    elsewhere_count_ = (elsewhere_count_ + 1) % elsewhere_.size();
    auto& steps = elsewhere_[elsewhere_count_];
    steps = {};
    if (!make(pc, steps[0])) return nullptr;
    steps[1].pc = pc + 2;
    steps[2].pc = pc + 4;
    return steps.data();
  }
  Step& step = code_[offset / 2];
  make(pc, step);
  if (Mark* const mark = mark_at(pc)) {
    mark->kind = step.kind;
    mark->within = step.within;
    step.kind = step.within = Step::Kind::mark;
  }
  return &step;
}

const Step* Cpu::step_at(std::uint32_t pc) {
  const std::uint32_t offset = pc - kFlash;
  if (offset < kFlashBytes) return &code_[offset / 2];
  if (!memory(pc, 2)) return nullptr;
  elsewhere_count_ = (elsewhere_count_ + 1) % elsewhere_.size();
  Step& step = elsewhere_[elsewhere_count_][0];
  step = {};
  step.pc = pc;
  return &step;
}

std::uint32_t Cpu::leads_back_to(std::uint32_t pc) {
  if (pc - kFlash >= kFlashBytes) return 0;
  const Step& step = code_[(pc - kFlash) / 2];
  const Mark* const mark = mark_at(pc);
  const Step::Kind kind = mark ? mark->kind : step.kind;
  const bool branches = kind >= Step::Kind::b && kind <= Step::Kind::ble;
  const std::uint32_t target = kFlash + 2 * step.value;
  return branches && target <= pc ? target : 0;
}

void Cpu::records(bool recording) { writable_ = recording ? 0 : kRamBytes - 3; }

void Cpu::forget(Address page) {
  // Steps contain the constants that their instructions load from flash. An instruction within this distance
  // of the page may load a constant from the page.
  constexpr std::uint32_t kReach = 0x1004;
  const std::uint32_t begin = page - kFlash, end = begin + kPageBytes;
  for (std::uint32_t at = begin > kReach ? begin - kReach : 0; at < std::min(end + kReach, kFlashBytes);
       at += 2)
    code_[at / 2].kind = Step::Kind::fetch;
  uc_ctl_remove_cache(uc_, page, page + kPageBytes);
  uc_ctl_remove_cache(uc_, page - kFlash, page - kFlash + kPageBytes);
}

Cpu::Saved Cpu::save() const { return {state_, engine_.save()}; }

void Cpu::restore(const Saved& saved) {
  state_ = saved.own;
  engine_.restore(saved.monitor);
  idle_.moved_in_time();
  passing_ = 1;
  halting_ = at_breakpoint_ = false;
}

void Cpu::use_referee() {
  referee_ = true;
  for (Step& step : code_) step.kind = Step::Kind::fetch;
}

void Cpu::watch(std::uint32_t pc, std::function<void()> watcher) {
  watcher_ = std::move(watcher);
  mark(pc, &Mark::watched);
}

void Cpu::set_breakpoint(std::uint32_t pc, bool set) { mark(pc, &Mark::breaks, set); }

bool Cpu::write_register(int number, std::uint32_t value) {
  if (number == kPc) {
    if (!firmware_.has_code(value)) return false;
    state_.next = value & ~1u;
    return true;
  }
  set_reg(number, value);
  return true;
}

void Cpu::set_byte(Address address, std::uint8_t value) {
  if (std::uint8_t* const at = ram(address, 1)) *at = value;
}

void Cpu::set_at(std::uint32_t pc, Address variable, std::uint32_t value) {
  state_.early = EarlySet{pc, variable, value};
  mark(pc, &Mark::sets);
}

void Cpu::fail(Fault::Kind kind, std::uint32_t pc, std::uint32_t address) {
  if (!state_.fault) state_.fault = Fault{kind, pc, address};
  stop_ = 0;
}

// Records the jump to `pc`, and reports a fault, because there is no code at `pc`.
void Cpu::jumped_nowhere(std::uint32_t pc) {
  note_jump();
  fail(Fault::Kind::bad_jump, pc);
}

bool Cpu::begins(std::uint32_t pc) {
  const Instruction instruction = decode(half(pc), half(pc + 2));
  if (pc != state_.next) {
    clock_.now += kRefill_cycles;
    note_jump();
  }
  state_.next = pc;
  if (!memory(pc, 2) || (clock_.now >= stop_ && (state_.predicated == 0 || state_.fault))) return false;
  state_.pc = pc;
  state_.next = pc + instruction.bytes;
  clock_.now += instruction.cycles;
  return true;
}

bool Cpu::halts_at(std::uint32_t pc) {
  const Mark* const mark = mark_at(pc);
  if (mark && mark->breaks && std::exchange(passing_, 1) != pc) halting_ = true;
  if (!halting_ || state_.predicated > 0) return false;
  halting_ = false;
  at_breakpoint_ = true;
  passing_ = pc;
  return true;
}

void Cpu::reached(const Mark& mark) {
  if (idle_.is_recording() && (mark.sets || mark.watched || mark.counted)) idle_.interrupted();
  if (mark.loop || (mark.starts && !state_.rounds.is_running())) {
    state_.rounds.began(clock_.time_of(clock_.now));
    idle_.round_began();
  }
  if (mark.call && state_.handlers.empty()) {
    state_.last_io = clock_.now;
    state_.last_io_pc = state_.pc;
  }
  if (mark.sets && state_.early) {
    set_word(state_.early->variable, state_.early->value);
    state_.early.reset();
  }
  if (mark.watched && watcher_) watcher_();
  if (mark.counted) lines_->ran(mark.pc);
}

Cycle Cpu::handler_cycles() const {
  return state_.handler_cycles + (state_.handlers.empty() ? 0 : clock_.now - state_.handler_began);
}

std::vector<std::uint32_t> Cpu::last_jumps() const {
  std::vector<std::uint32_t> jumps;
  const std::uint32_t all = state_.jump_count - (state_.handlers.empty() ? 0 : state_.handlers.back().jumps);
  const std::uint32_t kept = std::min<std::uint32_t>(all, static_cast<std::uint32_t>(state_.jumps.size()));
  for (std::uint32_t i = 1; i <= kept; ++i)
    jumps.push_back(state_.jumps[(state_.jump_count - i) % state_.jumps.size()]);
  return jumps;
}

void Cpu::forget_jumps(std::uint32_t count) {
  // Clears the elements of the deleted jumps. These jumps had overwritten older jumps, which are lost.
  const std::uint32_t more =
      std::min<std::uint32_t>(state_.jump_count - count, static_cast<std::uint32_t>(state_.jumps.size()));
  for (std::uint32_t i = 0; i < more; ++i) state_.jumps[(count + i) % state_.jumps.size()] = 0;
  state_.jump_count = count;
}

void Cpu::run_to(Cycle cycle) {
  if (state_.asleep || state_.fault) return;
  stop_ = cycle;
  ends_ = falls_asleep_ = false;
  idle_.runs_anew();
  run();
  idle_.explore();
  if (state_.fault) return;
  if (state_.returning) return leave();
  state_.asleep = falls_asleep_;
}

void Cpu::sleep_to(Cycle cycle) {
  if (state_.waits_for_event
          ? nvic_.next(state_.primask | state_.faultmask, state_.basepri) || nvic_.take_event()
          : nvic_.wakes()) {
    state_.asleep = false;
    return;
  }
  if (cycle <= clock_.now) return;
  state_.sleep_cycles += cycle - clock_.now;
  clock_.now = cycle;
}

}  // namespace robosim::exec::stm32
