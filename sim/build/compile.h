// Creates the commands that compile one source file to one object file, and link objects to an image.
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
  std::string source;            ///< relative to `folder` in a sketch, otherwise absolute
  std::filesystem::path input;   ///< the joined .ino files, or empty; if it is set, `source` is empty
  bool archived = false;         ///< the object becomes part of its library's archive
  std::string place;             ///< the name of `folder` in debug information: "libraries/Servo"
  std::vector<std::filesystem::path> searched;  ///< folders for -I, in addition to the libraries' folders
  std::vector<std::filesystem::path> includes;  ///< all folders for -I
};

/// An object file and all files that it was compiled from.
struct Object {
  std::string name;  ///< name of the source, as in messages
  std::filesystem::path path;
  std::vector<std::filesystem::path> inputs;
  std::string archive;  ///< Unit::place of the library if its objects become one archive; otherwise empty
};

/// Convert paths to text, one per line, and back.
std::string join_paths(const std::vector<std::filesystem::path>& paths);
std::vector<std::filesystem::path> split_paths(const std::string& text);

/// Throws InputError if an object contains unexpected bytecode of link-time optimisation. Only assembler code
/// in a sketch can insert such bytecode, which the compiler would trust.
void check_object(const Toolchain& toolchain, const Unit& unit, const std::filesystem::path& object);

/// Returns whether the unit is compiled to assembly first. The assembly is then changed (assembly.h), and
/// assemble_command writes the object to another folder. Other units are compiled to `object` directly.
bool through_assembly(const Toolchain& toolchain, const Unit& unit);
/// Return the paths of the compiler's assembly, and of the changed assembly. They apply to a unit that is
/// compiled to assembly first.
std::filesystem::path compiled_assembly(const std::filesystem::path& object);
std::filesystem::path changed_assembly(const std::filesystem::path& object);
/// Returns whether the unit's lines are counted. gcov's notes are then in `object` + ".gcno". notes_name()
/// returns the name that the notes and the counters share.
bool is_counted(const Toolchain& toolchain, const Unit& unit);
std::string notes_name(const Unit& unit);
/// Returns a command that compiles the unit. The command writes a list of all files that it reads to
/// `object` + ".d".
Command compile_command(const Toolchain& toolchain, const Unit& unit, const std::filesystem::path& object);
Command assemble_command(const Toolchain& toolchain, const std::filesystem::path& assembly,
                         const std::filesystem::path& object);
/// Returns a command that prints the compiler's messages about the unit. `options` must prevent other output.
Command check_command(const Toolchain& toolchain, const Unit& unit, const std::vector<std::string>& options,
                      const std::filesystem::path& scratch);
/// Returns a command that only preprocesses the unit, to `output`.
Command preprocess_command(const Toolchain& toolchain, const Unit& unit, const std::filesystem::path& output);
/// Returns options with which another parser can read a C++ unit: language, macros and include folders
/// (parse_context.h).
std::vector<std::string> reading_words(const Toolchain& toolchain, const Unit& unit);
/// Returns a command that merges several objects into one object.
Command merge_command(const Toolchain& toolchain, const std::vector<std::filesystem::path>& objects,
                      const std::filesystem::path& object);
/// Returns a command that archives several objects. The linker selects those that are needed.
Command archive_command(const Toolchain& toolchain, const std::vector<std::filesystem::path>& objects,
                        const std::filesystem::path& archive);
/// Returns a command that links an image. For the host, the image is a shared object that exports only
/// `robosim_image`, with its constructors in the section `robosim_init_array`. For a chip, it is the program
/// to flash. The linker's scripts are written to the image's folder. `places` contains folders, and their
/// names in debug information.
Command link_command(const Toolchain& toolchain, const std::vector<std::filesystem::path>& objects,
                     const std::filesystem::path& image, const Core::Names& places);
/// Returns a command that makes one of the target's products from an image.
Command product_command(const Target& target, const Product& product, const std::filesystem::path& image,
                        const std::filesystem::path& file);

/// Returns `read` together with the files and folders that compilers read for every sketch.
std::vector<std::filesystem::path> read_by_all(const Toolchain& toolchain,
                                               std::vector<std::filesystem::path> read);

/// Returns a text of all options and versions that affect a result. The text is part of every cache key.
std::string recipe(const Toolchain& toolchain);

/// Returns the files in a compiler's dependency list. Relative paths are below `folder`.
std::vector<std::filesystem::path> read_dependencies(const std::string& text,
                                                     const std::filesystem::path& folder);

}  // namespace robosim::build
