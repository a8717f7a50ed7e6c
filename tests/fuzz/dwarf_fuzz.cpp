// Looks up functions, source lines and variables in the debug information of an arbitrary ELF file. Corrupt
// information yields no results or wrong ones, within the bounds of memory and time that libFuzzer sets.
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "sim/base/descriptor.h"
#include "sim/base/file.h"
#include "sim/exec/elf/debug_info.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace robosim;
  const Descriptor file(::memfd_create("fuzz", MFD_CLOEXEC));
  const std::string content(reinterpret_cast<const char*>(data), size);
  require(file.is_open() && write_all(file.get(), content) == 0, "the file can be written");
  const exec::DebugInfo info("/proc/self/fd/" + std::to_string(file.get()));
  std::size_t found = info.lines().size() + info.numbers().size() + info.code_of("loop").itself.size();
  found += info.entries_of("delay").size();
  for (std::uint32_t pc = 0; pc < 0x200; pc += 2)
    found += info.frames(pc).size() + info.place(pc).file.size();
  for (std::uint32_t address = 0x100; address < 0x110; ++address)
    found += info.variable_at(0x800000 + address).name.size();
  require(found < 100'000'000, "no more is found than the limits allow");
  return 0;
}
