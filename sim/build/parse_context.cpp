#include "sim/build/parse_context.h"

#include "sim/build/cache.h"
#include "sim/build/compile.h"
#include "sim/build/libraries.h"
#include "sim/build/project.h"
#include "sim/build/target.h"
#include "sim/build/toolchain.h"
#include "sim/build/units.h"

namespace robosim::build {

ParseContext parse_context_of(const Request& request) {
  const Image image = build(request);
  const Target& target = find_target(request.target);
  const Cache cache(cache_folder());
  const Compiler compiler = find_compiler(target);
  const GenuineCore genuine = find_core();
  Toolchain toolchain{target, compiler, ask(compiler, cache.folder()),
                      core_for(target, request.board, genuine, cache.folder()), request.board};
  toolchain.rules = request.rules;
  ParseContext context{read_sketch(request.sketch, request.rules), {}, {}};
  std::vector<Library> libraries;
  const auto folders = library_folders(context.sketch.folder, request.libraries, toolchain.core.libraries);
  for (const std::string& name : image.libraries)
    for (const Library& library : libraries_called(name, folders)) {
      libraries.push_back(library);
      break;
    }
  Unit unit = sketch_unit(context.sketch);
  unit.includes = include_folders(unit, libraries);
  context.words = reading_words(toolchain, unit);
  context.readable = read_by_all(toolchain, shared_files(context.sketch, reach_of(context.sketch.folder)));
  context.readable.push_back(context.sketch.folder);
  context.readable.insert(context.readable.end(), unit.includes.begin(), unit.includes.end());
  for (const Library& library : libraries) context.readable.push_back(library.folder);
  if (target.chip) {  // options that avr-gcc has by default
    context.words.push_back("--target=avr");
    for (const std::string& word : toolchain.core.machine) context.words.push_back(word);
    for (const auto& folder : {toolchain.facts.include_folder, genuine.avr_libc.parent_path()})
      context.words.insert(context.words.end(), {"-isystem", folder.string()});
  }
  return context;
}

}  // namespace robosim::build
