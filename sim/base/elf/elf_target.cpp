#include "sim/base/elf/elf_target.h"

#include <elf.h>
#include <fmt/format.h>

#include <cstring>

#include "sim/base/elf/elf_file.h"

namespace robosim {

std::string target_of_elf(std::string_view content, const std::string& file) {
  Elf32_Ehdr header{};
  if (ElfFile::is_one(content)) std::memcpy(&header, content.data(), sizeof header);
  const bool is_known = header.e_ident[EI_CLASS] == ELFCLASS32 && header.e_ident[EI_DATA] == ELFDATA2LSB &&
                        header.e_ident[EI_VERSION] == EV_CURRENT;
  if (is_known && header.e_machine == EM_AVR) return "avr";
  if (is_known && header.e_machine == EM_ARM) return "stm32";
  throw InputError({file},
                   "expected a program for a chip that Robosim knows (an AVR or an ARM microcontroller)");
}

InputError wrong_target(const std::string& file, std::string_view is, std::string_view wanted) {
  return InputError(
      {file}, fmt::format("expected an image for the target {}, got one for the target {}", wanted, is));
}

}  // namespace robosim
