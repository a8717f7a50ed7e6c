#include "sim/build/reading.h"

#include "sim/build/cache.h"
#include "sim/build/compile.h"
#include "sim/build/libraries.h"
#include "sim/build/project.h"
#include "sim/build/target.h"
#include "sim/build/toolchain.h"
#include "sim/build/units.h"

namespace robosim::build {

Reading reading_of(const Request& request) {
  const Image image = build(request);
  const Target& target = find_target(request.target);
  const Cache cache(cache_folder());
  const Compiler compiler = find_compiler(target);
  const GenuineCore genuine = find_core();
  Toolchain toolchain{target, compiler, ask(compiler, cache.folder()),
                      core_for(target, request.board, genuine, cache.folder()), request.board};
  toolchain.rules = request.rules;
  Reading reading{read_sketch(request.sketch, request.rules), {}, {}};
  std::vector<Library> libraries;
  const auto folders = library_folders(reading.sketch.folder, request.libraries, toolchain.core.libraries);
  for (const std::string& name : image.libraries)
    for (const Library& library : libraries_called(name, folders)) {
      libraries.push_back(library);
      break;
    }
  Unit unit = sketch_unit(reading.sketch);
  unit.includes = include_folders(unit, libraries);
  reading.words = reading_words(toolchain, unit);
  reading.readable = read_by_all(toolchain, shared_files(reading.sketch, reach_of(reading.sketch.folder)));
  reading.readable.push_back(reading.sketch.folder);
  reading.readable.insert(reading.readable.end(), unit.includes.begin(), unit.includes.end());
  for (const Library& library : libraries) reading.readable.push_back(library.folder);
  if (target.chip) {  // the compiler's defaults
    reading.words.push_back("--target=avr");
    for (const std::string& word : toolchain.core.machine) reading.words.push_back(word);
    for (const auto& folder : {toolchain.facts.include_folder, genuine.avr_libc.parent_path()})
      reading.words.insert(reading.words.end(), {"-isystem", folder.string()});
  }
  return reading;
}

}  // namespace robosim::build
