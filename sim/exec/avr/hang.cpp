#include "sim/exec/avr/hang.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <optional>

#include "sim/base/elf/avr_addresses.h"
#include "sim/exec/avr/registers.h"
#include "sim/mcu/avr/infinite_loop.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::InfiniteLoop;
using robosim::avr::Stores;

constexpr int kMostInstructions = 200'000;
constexpr int kVectorsOfUart = 3, kVectorsOfUsb = 2;

bool is_usb(int vector, const ChipSpec& chip) {
  return chip.usb.address && vector >= chip.usb.vector && vector < chip.usb.vector + kVectorsOfUsb;
}

// Returns the variable of the UART to which `vector` belongs: Serial, Serial1 or another. Returns null if
// `vector` belongs to no UART, or if the image lacks the variable.
const Symbol* serial_of(int vector, const Firmware& firmware) {
  for (int i = 0; i < firmware.chip->uart_count; ++i) {
    const UartSpec& uart = firmware.chip->uarts[i];
    if (vector >= uart.vector && vector < uart.vector + kVectorsOfUart)
      return firmware.symbols.find(uart.number == 0 ? "Serial" : fmt::format("Serial{}", uart.number));
  }
  return nullptr;
}

// Returns the addresses that a handler of the Arduino core's Serial changes; nullopt if `vector` does not
// belong to Serial.
std::optional<Stores> stores_of_serial(int vector, const robosim::avr::Cpu& cpu, const Firmware& firmware) {
  const ChipSpec& chip = *firmware.chip;
  // Assumes that USB handlers may change all addresses, because their state is not in the variable Serial.
  if (is_usb(vector, chip) && firmware.symbols.find("Serial")) return Stores(cpu.data.size(), true);
  const Symbol* const serial = serial_of(vector, firmware);
  if (!serial || serial->address < kAvrData) return std::nullopt;
  Stores stores(cpu.data.size());
  const std::size_t begin = serial->address - kAvrData;
  for (std::size_t at = begin; at < std::min(begin + serial->size, stores.size()); ++at) stores[at] = true;
  return stores;
}

// Returns the addresses that a handler of the Arduino core changes; nullopt if the handler belongs to the
// sketch, or if the addresses are unknown.
std::optional<Stores> stores_of_core(int vector, const robosim::avr::Cpu& cpu, const Firmware& firmware) {
  if (vector == overflow_of(firmware.chip->timers[0])) return robosim::avr::stores_of_handler(cpu, vector);
  return stores_of_serial(vector, cpu, firmware);
}

bool keeps_alive(const InfiniteLoop& round, int vector, const robosim::avr::Cpu& cpu,
                 const Firmware& firmware) {
  const auto stores = stores_of_core(vector, cpu, firmware);
  if (!stores) return true;
  for (std::size_t address = 0; address < stores->size(); ++address)
    if ((*stores)[address] && round.reads[address]) return true;
  return false;
}

}  // namespace

bool hangs(const WatchedChip& watched, const Firmware& firmware) {
  if (watched.is_off()) return true;
  const robosim::avr::Chip& chip = watched.chip();
  if (chip.core().reset_may_come) return false;
  const auto round = robosim::avr::find_infinite_loop(chip.cpu(), kMostInstructions);
  if (!round) return false;
  if (!round->interruptible) return true;
  for (std::uint64_t vectors = chip.may_interrupt(); vectors; vectors &= vectors - 1)
    if (keeps_alive(*round, std::countr_zero(vectors), chip.cpu(), firmware)) return false;
  return true;
}

}  // namespace robosim::exec::avr
