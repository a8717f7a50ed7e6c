// One source file to one object file, and objects to an image.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/build/process.h"
#include "sim/build/toolchain.h"

namespace robosim::build {

struct Unit {
  enum class Kind { sketch, library, core };
  Kind kind = Kind::sketch;
  std::filesystem::path folder;  ///< the sketch's, the library's, or the core's
  std::string source;            ///< relative to `folder` in a sketch, else absolute
  std::filesystem::path input;   ///< the joined .ino files; `source` is then empty
  bool archived = false;         ///< goes into an archive of its library's objects
  std::string place;             ///< what `folder` is called in debug information: "libraries/Servo"
  std::vector<std::filesystem::path> searched;  ///< folders for -I, besides its libraries'
  std::vector<std::filesystem::path> includes;  ///< both
};

/// An object file and all that it was made of.
struct Object {
  std::string name;  ///< of its source, as messages have it
  std::filesystem::path path;
  std::vector<std::filesystem::path> inputs;
  std::string archive;  ///< its library's place, if all of that become one archive; else empty
};

/// Paths as text, one a line, and back.
std::string join_paths(const std::vector<std::filesystem::path>& paths);
std::vector<std::filesystem::path> split_paths(const std::string& text);

/// Returns whether the unit is compiled to assembly first, which is changed a little (assembly.h) before
/// assemble_command, for an object in another folder; else it is compiled to `object` at once.
bool through_assembly(const Toolchain& toolchain, const Unit& unit);
/// Returns where the compiler writes the assembly of such a unit, and where the changed assembly goes.
std::filesystem::path compiled_assembly(const std::filesystem::path& object);
std::filesystem::path changed_assembly(const std::filesystem::path& object);
/// Whether the unit's lines are counted: gcov's notes on it are then in `object` + ".gcno", and its data has
/// this name.
bool is_counted(const Toolchain& toolchain, const Unit& unit);
std::string notes_name(const Unit& unit);
/// Lists all files read in `object` + ".d".
Command compile_command(const Toolchain& toolchain, const Unit& unit, const std::filesystem::path& object);
Command assemble_command(const Toolchain& toolchain, const std::filesystem::path& assembly,
                         const std::filesystem::path& object);
/// Only preprocesses, to `output`.
Command preprocess_command(const Toolchain& toolchain, const Unit& unit, const std::filesystem::path& output);
/// The language, macros and folders of a unit in C++, for another parser (reading.h).
std::vector<std::string> reading_words(const Toolchain& toolchain, const Unit& unit);
/// Several objects to one.
Command merge_command(const Toolchain& toolchain, const std::vector<std::filesystem::path>& objects,
                      const std::filesystem::path& object);
/// Several objects to an archive, of which the linker takes what is needed.
Command archive_command(const Toolchain& toolchain, const std::vector<std::filesystem::path>& objects,
                        const std::filesystem::path& archive);
/// Links to an image: for the host a shared object that exports `robosim_image` only and whose constructors
/// wait in the section `robosim_init_array`, for a chip the program as it is flashed. The linker's scripts
/// are written to the image's folder; `places` are the folders that debug information has other names for.
Command link_command(const Toolchain& toolchain, const std::vector<std::filesystem::path>& objects,
                     const std::filesystem::path& image, const Core::Names& places);
/// Makes one of the target's products of an image.
Command product_command(const Target& target, const Product& product, const std::filesystem::path& image,
                        const std::filesystem::path& file);

/// `read`, and the files and folders that compilers read of each sketch.
std::vector<std::filesystem::path> read_by_all(const Toolchain& toolchain,
                                               std::vector<std::filesystem::path> read);

/// Everything above that shapes a result, as text: part of every cache key.
std::string recipe(const Toolchain& toolchain);

/// The files in a dependency list as the compiler writes it; relative ones are below `folder`.
std::vector<std::filesystem::path> read_dependencies(const std::string& text,
                                                     const std::filesystem::path& folder);

}  // namespace robosim::build
