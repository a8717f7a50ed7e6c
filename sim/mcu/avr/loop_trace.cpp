#include "sim/mcu/avr/loop_trace.h"

#include <algorithm>

#include "hal/board/avr_registers.h"

namespace robosim::avr {
namespace {

constexpr int kMostSteps = 400;
constexpr std::int64_t kWidestCounter = 0xFF;

}  // namespace

LoopTrace::LoopTrace(Core& core) : core_(core), extrapolation_(core.cpu), seen_(core.cpu.data.size()) {}

void LoopTrace::begin() {
  extrapolation_.begin();
  ++number_;
  steps_ = 0;
  flags_written_ = 0;
  pass_.reads.clear();
  pass_.looks.clear();
  pass_.flags_read = 0;
  pass_.enables_interrupts = false;
  pass_.visits = 0;
  pass_.sp = core_.cpu.sp();
  began_ = core_.now();
  jumps_before_ = core_.cpu.state.jump_count;
}

void LoopTrace::reads(Address address) {
  if (seen_[address] == number_) return;
  seen_[address] = number_;
  pass_.reads.push_back({address, core_.cpu.data[address]});
}

void LoopTrace::writes(Address address) { seen_[address] = number_; }

void LoopTrace::reads_flags(std::uint8_t flags) {
  const auto first = static_cast<std::uint8_t>(flags & ~flags_written_ & ~pass_.flags_read);
  pass_.flags_read |= first;
  pass_.flags = static_cast<std::uint8_t>((pass_.flags & ~first) | (core_.cpu.sreg() & first));
}

bool LoopTrace::before() {
  if (++steps_ > kMostSteps) return false;
  const Cpu& cpu = core_.cpu;
  instruction_ = cpu.instruction(cpu.pc());
  effects_ = effects_of(instruction_, cpu);
  looked_.reset();
  if (effects_.elsewhere) return false;
  each(effects_.reads, [this](unsigned reg) { reads(static_cast<Address>(reg)); });
  if (effects_.flags_read) reads_flags(effects_.flags_read);
  if (effects_.memory != InstructionEffects::Memory::none && !touches_memory()) return false;
  extrapolation_.follow(instruction_, effects_);
  each(effects_.writes, [this](unsigned reg) { writes(static_cast<Address>(reg)); });
  flags_written_ |= effects_.flags_written;
  if (instruction_.op == Op::bset && instruction_.b == Cpu::kI) pass_.enables_interrupts = true;
  return true;
}

bool LoopTrace::touches_memory() {
  const Cpu& cpu = core_.cpu;
  const bool loads = effects_.memory == InstructionEffects::Memory::load;
  for (unsigned i = 0; i < effects_.bytes; ++i) {
    const auto address = static_cast<Address>(effects_.address + i);
    if (address > cpu.last_ram()) return false;
    if (address < reg::kFirstIo || address >= cpu.chip().ram_address) {
      loads ? reads(address) : writes(address);
    } else if (address == reg::kSreg) {
      if (loads) {
        reads_flags(0xFF);
      } else {
        flags_written_ = 0xFF;
        pass_.enables_interrupts |= (cpu.data[instruction_.a] & Cpu::kI) != 0;
      }
    } else if (!loads) {
      return false;
    } else if (address != reg::kSpL && address != reg::kSpH && !looks_at(address)) {
      return false;
    }
  }
  return true;
}

bool LoopTrace::looks_at(Address address) {
  const Cycle at = core_.now() + effects_.touched;
  const std::uint8_t bits = core_.cpu.bits_read(core_.cpu.pc());
  const ReadForecast forecast = core_.cpu.forecast(address, bits);
  if (forecast.until <= at) return false;
  looked_ = forecast.value_at(at);
  counter_ = forecast.counts() && !extrapolation_.has_counter() && effects_.writes != 0;
  pass_.looks.push_back({address, *looked_, bits, counter_, at - began_});
  return true;
}

bool LoopTrace::after() {
  const Cpu& cpu = core_.cpu;
  if (looked_ && effects_.writes != 0 && cpu.data[instruction_.a] != *looked_) return false;
  if (looked_ && counter_) extrapolation_.counter_read(instruction_.a);
  return !extrapolation_.has_counter() || extrapolation_.agrees(effects_.writes);
}

void LoopTrace::visited(std::uint32_t pc) {
  ++pass_.visits;
  pass_.visited = pc;
  pass_.visited_after = core_.now() - began_;
}

bool LoopTrace::ends(Pass& pass) {
  const Cpu& cpu = core_.cpu;
  const std::uint32_t jumps = cpu.state.jump_count - jumps_before_;
  if (cpu.sp() != pass_.sp || jumps > cpu.state.jumps.size() || pass_.visits > 1) return false;
  for (const Pass::Byte& byte : pass_.reads) {
    if (cpu.data[byte.address] != byte.value) return false;
    extrapolation_.hold(byte.address);
  }
  if ((cpu.sreg() ^ pass_.flags) & pass_.flags_read) return false;
  extrapolation_.hold_flags(pass_.flags_read);
  pass_.window =
      extrapolation_.has_counter() ? static_cast<int>(std::min(extrapolation_.window(), kWidestCounter)) : 0;
  pass_.cycles = core_.now() - began_;
  pass_.jumps.clear();
  for (std::uint32_t i = jumps_before_; i != cpu.state.jump_count; ++i)
    pass_.jumps.push_back(cpu.state.jumps[i % cpu.state.jumps.size()]);
  std::swap(pass, pass_);
  return true;
}

}  // namespace robosim::avr
