// One source file to one object file, and objects to an image.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/sketch/process.h"
#include "sim/sketch/sketch.h"
#include "sim/sketch/toolchain.h"

namespace robosim::sketch {

/// What all compilations of one build share.
struct Toolchain {
  Compiler compiler;
  CompilerFacts facts;
  std::filesystem::path stage;
  const BoardSpec& board;
  Warnings warnings = Warnings::standard;
};

struct Unit {
  enum class Kind { sketch, library, core };
  Kind kind = Kind::sketch;
  std::filesystem::path folder;  ///< the sketch's, the library's, or the stage
  std::string source;            ///< relative to `folder` in a sketch, else absolute
  std::filesystem::path input;   ///< the joined .ino files; `source` is then empty
  std::string place;             ///< what `folder` is called in debug information: "libraries/Servo"
  std::vector<std::filesystem::path> includes;  ///< for -I, besides the core's
};

/// An object file and all that it was made of.
struct Object {
  std::filesystem::path path;
  std::vector<std::filesystem::path> inputs;
};

/// Paths as text, one a line, and back.
std::string join_paths(const std::vector<std::filesystem::path>& paths);
std::vector<std::filesystem::path> split_paths(const std::string& text);

/// A unit of the core goes to `object` at once; any other to the assembly `object` + ".s", in which endless
/// loops are marked (endless.h) before assemble_command. Lists all files read in `object` + ".d".
Command compile_command(const Toolchain& toolchain, const Unit& unit, const std::filesystem::path& object);
Command assemble_command(const Toolchain& toolchain, const std::filesystem::path& object);
/// Only preprocesses, to `output`.
Command preprocess_command(const Toolchain& toolchain, const Unit& unit, const std::filesystem::path& output);
/// Several objects to one.
Command merge_command(const Toolchain& toolchain, const std::vector<std::filesystem::path>& objects,
                      const std::filesystem::path& object);
/// Links to a shared object that exports `robosim_image` only and whose constructors wait in the section
/// `robosim_init_array`. `work` is for the linker's scripts.
Command link_command(const Toolchain& toolchain, const std::vector<std::filesystem::path>& objects,
                     const std::filesystem::path& image, const std::filesystem::path& work);

/// Everything above that shapes a result, as text: part of every cache key.
std::string recipe(const Toolchain& toolchain);

/// The files in a dependency list as the compiler writes it; relative ones are below `folder`.
std::vector<std::filesystem::path> read_dependencies(const std::filesystem::path& list,
                                                     const std::filesystem::path& folder);

/// The header that a failed compilation did not find; empty if it failed otherwise.
std::string missing_header(const std::string& output, Place* place);

/// The compiler's messages with places as the user knows them.
std::string readable(const Toolchain& toolchain, const std::filesystem::path& sketch, std::string output);

/// Throws CompileError for a failed compilation or link.
[[noreturn]] void fail(const std::string& messages);

}  // namespace robosim::sketch
