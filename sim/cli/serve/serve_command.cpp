#include "sim/cli/serve/serve_command.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim::cli {

int serve_command(const ServeArguments& arguments) {
  namespace fs = std::filesystem;
  const std::string folder = arguments.folder.empty() ? "." : arguments.folder;
  if (!fs::is_directory(folder)) throw InputError({folder}, "is not a folder: robosim serve requires one");
  const fs::path program = helper_folder() / "robosim-serve";
  if (!fs::exists(program))
    throw ToolMissing("robosim serve was not built: install libcpp-httplib-dev and build Robosim again");
  const std::string port = std::to_string(arguments.port);
  // In a checkout, the script `robosim` sets this to its own path. It builds missing programs before a run.
  const char* wrapper = std::getenv("ROBOSIM_WRAPPER");
  const std::string robosim = wrapper ? wrapper : fs::read_symlink("/proc/self/exe").string();
  ::execl(program.c_str(), program.c_str(), folder.c_str(), arguments.address.c_str(), port.c_str(),
          robosim.c_str(), nullptr);
  throw InputError({program.string()}, std::string("cannot be started: ") + std::strerror(errno));
}

}  // namespace robosim::cli
