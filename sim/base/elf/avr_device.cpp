#include "sim/base/elf/avr_device.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace robosim {

// The chip's name is in the section .note.gnu.avr.deviceinfo, which has little-endian words of 32 bits. The
// first three are the header, and the fourth is the name "AVR". The next seven are start and size of flash,
// RAM and EEPROM, and the size of a table (including this word). The last one is the offset of the chip's
// name from the end of the table.
std::string avr_device(const ElfFile& elf) {
  constexpr std::size_t kTable = 40, kWord = 4;
  const std::string_view note = elf.content_of(".note.gnu.avr.deviceinfo");
  const auto word = [note](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = kWord; i-- > 0;) value = value << 8 | static_cast<unsigned char>(note[at + i]);
    return value;
  };
  if (note.size() < kTable + 2 * kWord) return {};
  const std::uint64_t name = std::uint64_t{kTable} + word(kTable) + word(kTable + kWord);
  if (name >= note.size()) return {};
  const std::string_view rest = note.substr(static_cast<std::size_t>(name));
  return std::string(rest.substr(0, rest.find('\0')));
}

bool is_same_device(std::string_view a, std::string_view b) {
  // The suffixes P, A and PA mean less power or a newer process; PB has more peripherals.
  const auto without_suffix = [](std::string_view name) {
    while (name.ends_with('p') || name.ends_with('a')) name.remove_suffix(1);
    return name;
  };
  return without_suffix(a) == without_suffix(b);
}

}  // namespace robosim
