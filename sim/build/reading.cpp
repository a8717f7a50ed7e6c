#include "sim/build/reading.h"

#include "sim/build/cache.h"
#include "sim/build/compile.h"
#include "sim/build/libraries.h"
#include "sim/build/target.h"
#include "sim/build/toolchain.h"
#include "sim/build/units.h"

namespace robosim::build {

Reading reading_of(const Request& request) {
  Request host = request;
  host.target = "host";
  const Image image = build(host);
  const Target& target = find_target(host.target);
  const Cache cache(cache_folder());
  const Compiler compiler = find_compiler(target);
  Toolchain toolchain{target, compiler, ask(compiler, cache.folder()),
                      core_for(target, host.board, find_core(), cache.folder()), host.board};
  toolchain.rules = host.rules;
  Reading reading{read_sketch(host.sketch, host.rules), {}};
  std::vector<Library> libraries;
  const auto folders = library_folders(reading.sketch.folder, host.libraries, toolchain.core.libraries);
  for (const std::string& name : image.libraries)
    for (const Library& library : libraries_called(name, folders)) {
      libraries.push_back(library);
      break;
    }
  Unit unit = sketch_unit(reading.sketch);
  unit.includes = include_folders(unit, libraries);
  reading.words = reading_words(toolchain, unit);
  return reading;
}

}  // namespace robosim::build
