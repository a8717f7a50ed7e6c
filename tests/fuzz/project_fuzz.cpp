// Reads arbitrary bytes as files of other tools: platformio.ini, sketch.yaml and arduino-cli's
// build.options.json. Each file is rejected, or it describes a project. The project names no board, a known
// board, or a board that is rejected. The first byte selects the file.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "sim/base/error.h"
#include "sim/build/project/project.h"
#include "tests/fuzz/require.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace robosim;
namespace fs = std::filesystem;

/// A sketch's folder for all inputs, which is removed at the end of the program.
struct Folder {
  const test::TemporaryFolder temporary;
  const fs::path path = temporary.path();
  Folder() {
    for (const char* sub : {"src", "lib", "include", ".pio/libdeps/uno"}) fs::create_directories(path / sub);
  }
};

void check(const project::Project& project) {
  for (const std::string& flag : project.flags)
    require(flag.rfind("-D", 0) == 0 || flag.rfind("-U", 0) == 0, "only macros are set");
  for (const std::string& remark : project.remarks) require(!remark.empty(), "remarks say something");
  require(!project.board || !project.board_name.empty(), "a board is one that the file names");
  project::check_board(project);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const Folder folder;
  constexpr const char* kFiles[] = {"platformio.ini", "sketch.yaml", "build.options.json"};
  const fs::path file = folder.path / kFiles[data[0] % 3];
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    if (data[0] % 3 == 2) {
      check(project::project_of_image(folder.path / "Sketch.ino.elf"));
      project::sketch_of_image(folder.path / "Sketch.ino.elf");
    } else {
      check(project::read_project(folder.path));
    }
  } catch (const InputError& error) {
    require(!error.message().empty(), "errors say something");
  }
  fs::remove(file);
  return 0;
}
