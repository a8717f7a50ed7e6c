#include "sim/build/units.h"

namespace robosim::build {
namespace fs = std::filesystem;

Unit sketch_unit(const Sketch& sketch) {
  Unit unit;
  unit.folder = sketch.folder;
  unit.place = ".";
  unit.searched = sketch.includes;
  return unit;
}

Unit library_unit(const Toolchain& toolchain, const Library& library, const std::string& source) {
  Unit unit;
  unit.kind = Unit::Kind::library;
  unit.folder = library.folder;
  unit.place = "libraries/" + library.name;
  unit.archived = library.archive && toolchain.target.chip;
  unit.source = (library.folder / source).string();
  unit.searched = toolchain.rules.includes;
  return unit;
}

std::string name_of(const Sketch& sketch, const Unit& unit) {
  if (!unit.input.empty()) return sketch.inos[0];
  if (unit.kind == Unit::Kind::sketch) return unit.source;
  return unit.place + unit.source.substr(unit.folder.string().size());
}

std::vector<fs::path> include_folders(const Unit& unit, const std::vector<Library>& libraries) {
  std::vector<fs::path> folders = unit.searched;
  for (const Library& library : libraries)
    folders.insert(folders.end(), library.includes.begin(), library.includes.end());
  return folders;
}

Core::Names names_of_folders(const Sketch& sketch, const std::vector<Library>& libraries,
                             const Toolchain& toolchain, const fs::path& work) {
  Core::Names names = {{work, "."}, {toolchain.core.root, toolchain.core.place}};
  for (const Library& library : libraries) names.emplace_back(library.folder, "libraries/" + library.name);
  names.emplace_back(sketch.folder, ".");
  return names;
}

}  // namespace robosim::build
