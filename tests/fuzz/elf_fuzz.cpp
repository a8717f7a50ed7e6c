// Reads arbitrary bytes as a program for a chip, in ELF and in Intel HEX. Either the file is rejected with a
// message that names it, or its content is not longer than the file.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "sim/base/elf/elf_file.h"
#include "sim/base/elf/elf_target.h"
#include "sim/base/error.h"
#include "sim/exec/elf/intel_hex.h"
#include "sim/exec/elf/program.h"
#include "tests/fuzz/require.h"

namespace {

using namespace robosim;

template <class Read>
void refused_or(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    require(error.place().file == "fuzz", "errors name the file");
    require(!error.message().empty(), "errors say something");
  }
}

unsigned sum(std::string_view bytes) {
  unsigned all = 0;
  for (const char c : bytes) all += static_cast<unsigned char>(c);
  return all;
}

void read_elf(std::string_view content) {
  const ElfFile elf(std::string(content), "fuzz");
  unsigned all = 0;
  refused_or([&] {
    for (const ElfSegment& segment : elf.segments()) all += sum(segment.bytes);
  });
  refused_or([&] { all += static_cast<unsigned>(elf.sections().size()); });
  refused_or([&] {
    for (const ElfSymbol& symbol : elf.symbols()) all += sum(symbol.name);
  });
  refused_or([&] { all += sum(target_of_elf(content, "fuzz")); });
  require(all + 1 != 0 || !content.empty(), "everything lies within the file");
  const BoardSpec& board = *find_board("uno");
  refused_or([&] {
    const auto flash = exec::flash_content(elf, elf.segments(), 0, board.flash_bytes, board);
    require(flash.bytes.size() <= static_cast<std::size_t>(board.flash_bytes), "it fits");
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  refused_or([&] { read_elf(text); });
  refused_or([&] { require(exec::read_intel_hex(text, "fuzz", 32256, 32768).size() <= 32256, "it fits"); });
  return 0;
}
