#include "sim/build/algorithm.h"

#include "sim/base/file.h"
#include "sim/build/process.h"
#include "sim/build/sketch.h"
#include "sim/build/target.h"
#include "sim/build/toolchain.h"

namespace robosim::build {
namespace fs = std::filesystem;

Algorithm::Algorithm(const fs::path& source) : folder_(Cache(cache_folder())) {
  static_cast<void>(read_file(source));  // reports a missing file in Robosim's own words
  const Compiler compiler = find_compiler(find_target("host"));
  const fs::path headers = data_folder() / "sim/map/cells/include";
  const CommandResult compiled =
      run(Command{{compiler.cxx.string(), "-std=c++20", "-O2", "-g", "-shared", "-fPIC", "-Wall", "-Wextra",
                   "-fdiagnostics-color=never", "-I" + headers.string(), "-Wl,--no-undefined",
                   source.string(), "-o", shared_object().string()},
                  fs::current_path(),
                  {}});
  if (compiled.status != 0) throw CompileError(compiled.output);
}

}  // namespace robosim::build
