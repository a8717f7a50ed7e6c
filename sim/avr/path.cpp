#include "sim/avr/path.h"

#include <algorithm>

#include "hal/board/avr_registers.h"

namespace robosim::avr {
namespace {

constexpr int kMostSteps = 400;
constexpr std::int64_t kWidestCounter = 0xFF;

}  // namespace

Path::Path(Core& core) : core_(core), ramp_(core.cpu), seen_(core.cpu.data.size()) {}

void Path::begin() {
  ramp_.begin();
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

void Path::reads(Address address) {
  if (seen_[address] == number_) return;
  seen_[address] = number_;
  pass_.reads.push_back({address, core_.cpu.data[address]});
}

void Path::writes(Address address) { seen_[address] = number_; }

void Path::reads_flags(std::uint8_t flags) {
  const auto first = static_cast<std::uint8_t>(flags & ~flags_written_ & ~pass_.flags_read);
  pass_.flags_read |= first;
  pass_.flags = static_cast<std::uint8_t>((pass_.flags & ~first) | (core_.cpu.sreg() & first));
}

bool Path::before() {
  if (++steps_ > kMostSteps) return false;
  const Cpu& cpu = core_.cpu;
  instruction_ = cpu.instruction(cpu.pc());
  effects_ = effects_of(instruction_, cpu);
  looked_.reset();
  if (effects_.elsewhere) return false;
  each(effects_.reads, [this](unsigned reg) { reads(static_cast<Address>(reg)); });
  if (effects_.flags_read) reads_flags(effects_.flags_read);
  if (effects_.memory != Effects::Memory::none && !touches_memory()) return false;
  ramp_.follow(instruction_, effects_);
  each(effects_.writes, [this](unsigned reg) { writes(static_cast<Address>(reg)); });
  flags_written_ |= effects_.flags_written;
  if (instruction_.op == Op::bset && instruction_.b == Cpu::kI) pass_.enables_interrupts = true;
  return true;
}

bool Path::touches_memory() {
  const Cpu& cpu = core_.cpu;
  const bool loads = effects_.memory == Effects::Memory::load;
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

bool Path::looks_at(Address address) {
  const Cycle at = core_.now() + effects_.touched;
  const std::uint8_t bits = core_.cpu.bits_read(core_.cpu.pc());
  const Outlook outlook = core_.cpu.outlook(address, bits);
  if (outlook.until <= at) return false;
  looked_ = outlook.value_at(at);
  counter_ = outlook.counts() && !ramp_.has_counter() && effects_.writes != 0;
  pass_.looks.push_back({address, *looked_, bits, counter_, at - began_});
  return true;
}

bool Path::after() {
  const Cpu& cpu = core_.cpu;
  if (looked_ && effects_.writes != 0 && cpu.data[instruction_.a] != *looked_) return false;
  if (looked_ && counter_) ramp_.counter_read(instruction_.a);
  return !ramp_.has_counter() || ramp_.agrees(effects_.writes);
}

void Path::visited(std::uint32_t pc) {
  ++pass_.visits;
  pass_.visited = pc;
  pass_.visited_after = core_.now() - began_;
}

bool Path::ends(Pass& pass) {
  const Cpu& cpu = core_.cpu;
  const std::uint32_t jumps = cpu.state.jump_count - jumps_before_;
  if (cpu.sp() != pass_.sp || jumps > cpu.state.jumps.size() || pass_.visits > 1) return false;
  for (const Pass::Byte& byte : pass_.reads) {
    if (cpu.data[byte.address] != byte.value) return false;
    ramp_.hold(byte.address);
  }
  if ((cpu.sreg() ^ pass_.flags) & pass_.flags_read) return false;
  ramp_.hold_flags(pass_.flags_read);
  pass_.window = ramp_.has_counter() ? static_cast<int>(std::min(ramp_.window(), kWidestCounter)) : 0;
  pass_.cycles = core_.now() - began_;
  pass_.jumps.clear();
  for (std::uint32_t i = jumps_before_; i != cpu.state.jump_count; ++i)
    pass_.jumps.push_back(cpu.state.jumps[i % cpu.state.jumps.size()]);
  std::swap(pass, pass_);
  return true;
}

}  // namespace robosim::avr
