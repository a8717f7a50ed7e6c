#include "sim/cli/run/debugger.h"

#include <fmt/format.h>

#include "sim/base/error.h"
#include "sim/base/shell_word.h"
#include "sim/build/process.h"

namespace robosim::cli {
namespace fs = std::filesystem;

void check_debugger(int port, const std::string& target) {
  if (port > 0 && target == "host")
    throw InputError("--gdb requires an emulated chip: give --target avr or stm32");
}

std::string debugger_command(const fs::path& elf, const fs::path& sources, const std::string& target,
                             int port) {
  const std::string own = target == "avr" ? "avr-gdb" : "gdb-multiarch";
  std::string debugger = own;
  for (const std::string& name : {own, std::string("gdb-multiarch")}) {
    if (build::find_program(name).empty()) continue;
    debugger = name;
    break;
  }
  const auto word = [](const fs::path& path) {
    return shell_word(fs::absolute(path).lexically_normal().string());
  };
  const std::string folder = sources.empty() ? "" : " -d " + word(sources);
  return fmt::format("{}{} {} -ex 'target remote :{}'", debugger, folder, word(elf), port);
}

}  // namespace robosim::cli
