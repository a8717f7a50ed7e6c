// The commands that compile one source file to one object file, and link objects to an image.
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
  std::filesystem::path folder;  ///< folder of the sketch, the library, or the core
  std::string source;            ///< relative to `folder` in a sketch, else absolute
  std::filesystem::path input;   ///< the joined .ino files; `source` is then empty
  bool archived = false;         ///< put into an archive of its library's objects
  std::string place;             ///< the name of `folder` in debug information: "libraries/Servo"
  std::vector<std::filesystem::path> searched;  ///< folders for -I, in addition to its libraries'
  std::vector<std::filesystem::path> includes;  ///< both
};

/// An object file and all files that it was made from.
struct Object {
  std::string name;  ///< of its source, as in messages
  std::filesystem::path path;
  std::vector<std::filesystem::path> inputs;
  std::string archive;  ///< its library's place, if that library becomes one archive; else empty
};

/// Convert paths to text, one per line, and back.
std::string join_paths(const std::vector<std::filesystem::path>& paths);
std::vector<std::filesystem::path> split_paths(const std::string& text);

/// Throws InputError for bytecode of link-time optimisation in an object that no such compilation has made:
/// written in assembler, it is of the sketch's author, and the compiler would trust it.
void check_object(const Toolchain& toolchain, const Unit& unit, const std::filesystem::path& object);

/// Returns whether the unit is compiled to assembly first. That is changed a little (assembly.h) before
/// assemble_command, for an object in another folder. Otherwise it is compiled to `object` directly.
bool through_assembly(const Toolchain& toolchain, const Unit& unit);
/// Returns where the compiler writes the assembly of such a unit, and where the changed assembly goes.
std::filesystem::path compiled_assembly(const std::filesystem::path& object);
std::filesystem::path changed_assembly(const std::filesystem::path& object);
/// Returns whether the unit's lines are counted: gcov's notes on it are then in `object` + ".gcno", and its
/// data has this name.
bool is_counted(const Toolchain& toolchain, const Unit& unit);
std::string notes_name(const Unit& unit);
/// Also lists all files read in `object` + ".d".
Command compile_command(const Toolchain& toolchain, const Unit& unit, const std::filesystem::path& object);
Command assemble_command(const Toolchain& toolchain, const std::filesystem::path& assembly,
                         const std::filesystem::path& object);
/// Only preprocesses, to `output`.
Command preprocess_command(const Toolchain& toolchain, const Unit& unit, const std::filesystem::path& output);
/// Returns the language, macros and folders of a C++ unit, for another parser (parse_context.h).
std::vector<std::string> reading_words(const Toolchain& toolchain, const Unit& unit);
/// Merges several objects into one.
Command merge_command(const Toolchain& toolchain, const std::vector<std::filesystem::path>& objects,
                      const std::filesystem::path& object);
/// Makes an archive of several objects, from which the linker takes those that are needed.
Command archive_command(const Toolchain& toolchain, const std::vector<std::filesystem::path>& objects,
                        const std::filesystem::path& archive);
/// Links an image. For the host it is a shared object that exports `robosim_image` only. Its constructors are
/// in the section `robosim_init_array`. For a chip it is the program to flash. The linker's scripts are
/// written to the image's folder; `places` are the folders that have other names in debug information.
Command link_command(const Toolchain& toolchain, const std::vector<std::filesystem::path>& objects,
                     const std::filesystem::path& image, const Core::Names& places);
/// Makes one of the target's products from an image.
Command product_command(const Target& target, const Product& product, const std::filesystem::path& image,
                        const std::filesystem::path& file);

/// Returns `read`, and the files and folders that compilers read of each sketch.
std::vector<std::filesystem::path> read_by_all(const Toolchain& toolchain,
                                               std::vector<std::filesystem::path> read);

/// Returns everything above that affects a result, as text: part of every cache key.
std::string recipe(const Toolchain& toolchain);

/// Returns the files in a compiler's dependency list; relative ones are below `folder`.
std::vector<std::filesystem::path> read_dependencies(const std::string& text,
                                                     const std::filesystem::path& folder);

}  // namespace robosim::build
