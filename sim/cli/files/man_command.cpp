#include "sim/cli/files/man_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/cli/man_page.h"
#include "sim/cli/output.h"

namespace robosim::cli {
namespace fs = std::filesystem;

int man_command(const ManArguments& arguments) {
  const std::vector<CommandGroup> groups = command_groups();
  if (arguments.out.empty()) {
    if (arguments.command.empty()) print(man_page(groups));
    for (const CommandGroup& group : groups)
      for (const CommandHelp& command : group.commands)
        if (command.name == arguments.command) print(man_page(command));
    return 0;
  }
  const fs::path folder = arguments.out;
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error))
    throw InputError({arguments.out}, "this folder cannot be created; name another with --out");
  write_file(folder / "robosim.1", man_page(groups));
  for (const CommandGroup& group : groups)
    for (const CommandHelp& command : group.commands)
      write_file(folder / fmt::format("robosim-{}.1", command.name), man_page(command));
  return 0;
}

}  // namespace robosim::cli
