#include "sim/exec/stm32/debug_port.h"

#include <fmt/format.h>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr unsigned kStatusNumber = 16;
constexpr int kRegisterBytes = 4;

}  // namespace

void DebugPort::plug_into(Machine& machine) {
  machine_ = &machine;
  power_on();
}

gdb::Signal DebugPort::fault() const {
  if (!cpu().fault()) return gdb::Signal::none;
  switch (cpu().fault()->kind) {
    case Fault::Kind::bad_read:
    case Fault::Kind::bad_write:
    case Fault::Kind::flash_write:
    case Fault::Kind::unmodelled:
    case Fault::Kind::stack:
      return gdb::Signal::fault;
    default:
      return gdb::Signal::illegal;
  }
}

bool DebugPort::has_ram(std::uint32_t address, std::size_t size) const {
  return address >= kRam && address + size <= kRam + kRamBytes;
}

std::uint32_t DebugPort::pc() const { return cpu().fault() ? cpu().fault()->pc : cpu().next_pc(); }

std::string DebugPort::registers() const {
  std::string bytes;
  for (unsigned number = 0; number <= kStatusNumber; ++number) bytes += read_register(number);
  return bytes;
}

std::string DebugPort::read_register(unsigned number) const {
  if (number < Cpu::kPc) return little_endian(cpu().reg(static_cast<int>(number)), kRegisterBytes);
  if (number == Cpu::kPc) return little_endian(pc(), kRegisterBytes);
  if (number == kStatusNumber) return little_endian(cpu().status(), kRegisterBytes);
  return "";
}

bool DebugPort::write_register(unsigned number, std::string_view bytes) {
  if (number > kStatusNumber || bytes.size() != kRegisterBytes) return false;
  const std::uint32_t value = from_little_endian(bytes);
  if (number == kStatusNumber) return value == cpu().status();
  if (number == Cpu::kPc && value == pc()) return true;
  return cpu().write_register(static_cast<int>(number), value);
}

std::string DebugPort::read_memory(std::uint32_t address, std::uint32_t size) const {
  std::string bytes;
  for (std::uint32_t at = address; bytes.size() < size; ++at) {
    const std::uint8_t* const byte = cpu().memory(at, 1);
    if (!byte) break;
    bytes += static_cast<char>(*byte);
  }
  return bytes;
}

std::string DebugPort::description() const {
  std::string xml =
      "<?xml version=\"1.0\"?><!DOCTYPE target SYSTEM \"gdb-target.dtd\"><target version=\"1.0\">"
      "<architecture>arm</architecture><feature name=\"org.gnu.gdb.arm.m-profile\">";
  for (int r = 0; r < Cpu::kSp; ++r) xml += fmt::format("<reg name=\"r{}\" bitsize=\"32\"/>", r);
  return xml +
         "<reg name=\"sp\" bitsize=\"32\" type=\"data_ptr\"/><reg name=\"lr\" bitsize=\"32\"/>"
         "<reg name=\"pc\" bitsize=\"32\" type=\"code_ptr\"/><reg name=\"xpsr\" bitsize=\"32\"/>"
         "</feature></target>";
}

}  // namespace robosim::exec::stm32
