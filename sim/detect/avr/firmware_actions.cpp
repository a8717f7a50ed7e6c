#include "sim/detect/avr/firmware_actions.h"

#include "hal/board/avr_timer.h"
#include "sim/detect/avr/call_site.h"
#include "sim/exec/avr/registers.h"
#include "sim/mcu/avr/instruction_table.h"

namespace robosim::detect::avr {
namespace {

using robosim::avr::Instruction;
using robosim::avr::Location;
using Kind = FirmwareAction::Kind;

std::uint32_t control_b(const TimerSpec& timer) {
  return timer.control_b ? timer.control_b : timer.control + 1;
}

}  // namespace

FirmwareActions::FirmwareActions(const RunningProgram& program)
    : program_(program), cpu_(program.machine.chip().chip().cpu()), actions_(program.board) {
  find_functions();
  find_stores();
  robosim::avr::Core& core = program.machine.chip().chip().core();
  core.on_conversion_self = this;
  core.on_conversion = [](void* self, int pin, double error) {
    static_cast<FirmwareActions*>(self)->converted(pin, error);
  };
}

FirmwareActions::~FirmwareActions() { program_.machine.chip().chip().core().on_conversion = nullptr; }

void FirmwareActions::converted(int pin, double error) {
  tell(Kind::conversion, program_.machine.adapter().board_pin(pin), static_cast<int64_t>(1e9 * error), 0,
       [&] { return program_.diagnosis().sketch_line(); });
}

void FirmwareActions::find_functions() {
  const auto find = [&](const char* name, Kind kind, int number) {
    for (exec::DebugInfo::Entry& entry : program_.debug.entries_of(name)) {
      const std::uint32_t address = entry.address;
      if (!functions_.contains(address)) program_.machine.chip().show(*this, address);
      functions_.insert({address, {kind, number, std::move(entry)}});
    }
  };
  find("analogWrite", Kind::analog_write, 0);
  find("attachInterrupt", Kind::attach_interrupt, 0);
  find("delay", Kind::delay, 0);
  for (int number = 0; const char* const name : kPinFunctions) find(name, Kind::missing_pin, number++);
}

void FirmwareActions::find_stores() {
  const ChipSpec& chip = cpu_.chip();
  for (std::uint32_t pc = 0; 2 * pc < program_.firmware.code_end; pc += cpu_.instruction(pc).words) {
    const Instruction& i = cpu_.instruction(pc);
    const robosim::avr::InstructionRow& row = robosim::avr::row_of(i.op);
    if (!row.stores || (row.location != Location::address && row.location != Location::io)) continue;
    const auto address = static_cast<std::uint32_t>(i.k);
    for (int timer = 0; timer < chip.timer_count; ++timer) {
      const TimerSpec& spec = chip.timers[timer];
      if (spec.bits == kHighSpeedBits) continue;
      Store store{timer, -1, address == control_b(spec)};
      for (int output = 0; output < channels(spec); ++output)
        if (address == spec.compare[output]) store.output = output;
      if (address != spec.control && !store.is_b && store.output < 0) continue;
      stores_[2 * pc] = store;
      program_.machine.chip().show(*this, 2 * pc);
    }
  }
}

void FirmwareActions::visited(std::uint32_t pc, Cycle) {
  const auto [first, last] = functions_.equal_range(pc);
  for (auto function = first; function != last; ++function) called(function->second);
  if (const auto store = stores_.find(pc); store != stores_.end())
    stored(store->second, cpu_.data[cpu_.instruction(pc / 2).a]);
}

void FirmwareActions::tell(Kind kind, int64_t first, int64_t second, int64_t third,
                           const std::function<SourceLine()>& where) {
  actions_.acted({kind, {first, second, third}}, program_.machine.now(), where);
}

void FirmwareActions::called(const Function& function) {
  const std::vector<exec::DebugInfo::Argument>& arguments = function.entry.arguments;
  // The compiler may omit the upper bytes of an argument if the function does not use these bytes. Then the
  // remaining register or constant is not the argument.
  const auto value = [&](std::size_t number, std::size_t size) -> std::optional<std::int64_t> {
    if (number >= arguments.size()) return std::nullopt;
    const exec::DebugInfo::Argument& argument = arguments[number];
    if (argument.registers.empty() && size == 1 && argument.constant) return *argument.constant & 0xFF;
    if (argument.registers.size() != size) return std::nullopt;
    std::int64_t bytes = 0;
    for (std::size_t i = size; i-- > 0;) bytes = bytes << 8 | cpu_.data[argument.registers[i]];
    return bytes;
  };
  const auto caller = [&] {
    return program_.debug.place(function.entry.is_inlined ? function.entry.address : caller_of(function));
  };
  constexpr std::size_t kByte = 1, kInt = 2, kLong = 4;
  const std::optional<std::int64_t> first = value(0, function.kind == Kind::delay ? kLong : kByte),
                                    second = value(1, kInt);
  if (!first || (function.kind == Kind::analog_write && !second)) return;
  if (function.kind == Kind::missing_pin) {
    const BoardSpec& board = program_.board;
    if (*first >= board.pin_count || !board.pins[*first].digital)
      tell(function.kind, *first, function.number, 0, caller);
    return;
  }
  tell(function.kind, *first, function.kind == Kind::analog_write ? static_cast<std::int16_t>(*second) : 0, 0,
       caller);
}

std::uint32_t FirmwareActions::caller_of(const Function& function) const {
  using robosim::avr::Op;
  const std::uint32_t site = call_site(cpu_), last = site / 2, words = cpu_.chip().flash_bytes / 2;
  const std::uint32_t call = last > 0 && cpu_.instruction(last - 1).op == Op::call ? last - 1 : last;
  const Op op = cpu_.instruction(call).op;
  if (op != Op::call && op != Op::rcall) return site;
  // If the call instruction calls another function, that function has ended with a jump to this one.
  std::uint32_t pc = robosim::avr::target_of(cpu_.instruction(call), call, words);
  const std::uint32_t entry = function.entry.address / 2;
  if (pc == entry) return site;
  const std::string other = program_.debug.place(2 * pc).function;
  for (; 2 * pc < program_.firmware.code_end; pc += cpu_.instruction(pc).words) {
    const Instruction& i = cpu_.instruction(pc);
    if (program_.debug.place(2 * pc).function != other) break;
    if ((i.op == Op::jmp || i.op == Op::rjmp) && robosim::avr::target_of(i, pc, words) == entry)
      return 2 * pc;
  }
  return site;
}

void FirmwareActions::stored(const Store& store, std::uint8_t value) {
  const TimerSpec& timer = cpu_.chip().timers[store.timer];
  const std::uint8_t a = cpu_.data[timer.control], b = cpu_.data[control_b(timer)];
  const auto makes_pwm = [&](std::uint8_t with_a, std::uint8_t with_b) {
    return robosim::avr::counting(timer, with_a, with_b).kind == robosim::avr::Counting::Kind::pwm;
  };
  const auto here = [&] { return program_.diagnosis().sketch_line(); };
  if (store.output >= 0) {
    if (!makes_pwm(a, b) && robosim::avr::connection(a, store.output) & 2)
      tell(Kind::compare_write, timer.number, store.output, 0, here);
    return;
  }
  const bool made_pwm = makes_pwm(a, b), makes = store.is_b ? makes_pwm(a, value) : makes_pwm(value, b);
  if (made_pwm == makes) return;
  int connected = 0;
  for (int output = 0; output < channels(timer); ++output)
    if (robosim::avr::connection(a, output) & 2) connected |= 1 << output;
  tell(Kind::timer_mode, timer.number, makes, connected, here);
}

}  // namespace robosim::detect::avr
