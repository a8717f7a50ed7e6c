// Finds a target's compiler and the genuine Arduino core on this machine.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/build/sketch.h"
#include "sim/build/target.h"

namespace robosim::build {

/// The compiler of a target: always gcc, even if another compiler built Robosim itself. Instrumentation and
/// traces are therefore always equal.
struct Compiler {
  std::filesystem::path cxx;
  std::filesystem::path cc;
  std::string identity;  ///< path, size and time of both programs, which change with every upgrade
};

/// Returns the compiler. Throws ToolMissing with the name of the package.
Compiler find_compiler(const Target& target);

/// The facts that the compiler reports about itself.
struct CompilerFacts {
  std::string name;                      ///< "gcc 12.2.0 x86_64-linux-gnu"
  std::filesystem::path include_folder;  ///< the compiler's own headers: stddef.h, stdarg.h, float.h
};
/// Returns the facts from `cache`, or else from the compiler, which is started for this purpose.
CompilerFacts ask(const Compiler& compiler, const std::filesystem::path& cache);

/// Returns the name and version of the assembler that the compiler uses: "as 2.44".
std::string assembler_name(const Compiler& compiler);

/// The folders of the genuine core's sources and avr-libc's headers. find_core() throws ToolMissing if one of
/// them is missing.
struct GenuineCore {
  std::filesystem::path sources;    ///< cores/arduino
  std::filesystem::path variants;   ///< the boards' pins
  std::filesystem::path libraries;  ///< the core's libraries: EEPROM, SPI, ...
  std::filesystem::path avr_libc;   ///< include/avr
};
GenuineCore find_core();

/// The core as compiled for a target.
struct Core {
  using Names = std::vector<std::pair<std::filesystem::path, std::string>>;
  std::filesystem::path root;                   ///< folder that the compiler works in
  std::string place;                            ///< the name of `root` in debug information
  std::vector<std::filesystem::path> sources;   ///< folders, in the order of linking
  std::filesystem::path serving;                ///< folder compiled without checks, because checks call it
  std::vector<std::filesystem::path> includes;  ///< for -I
  std::vector<std::filesystem::path> system_includes;
  std::vector<std::filesystem::path> includes_with_checks;  ///< before system headers, for images with checks
  std::vector<std::filesystem::path> libraries;             ///< folders of libraries that belong to the core
  std::filesystem::path stand_ins;            ///< folder of libraries that replace others, or empty
  std::vector<std::filesystem::path> linked;  ///< files that the linker adds by itself
  std::vector<std::string> machine;           ///< options that name the chip
  std::vector<std::string> link;              ///< options for the linker
  Names places;                               ///< names of folders in debug information; the last match wins
  Names readable;                             ///< prefixes in messages, and their replacements for users
};

/// The kind of registers for the sketch and its libraries, on a target without real registers.
enum class Registers {
  objects,  ///< class objects (hal/arduino/avr/io.h): the effect of each access is compiled in
  memory,   ///< bytes with addresses, for libraries that store addresses: accesses to memory are watched
  as_avr,   ///< like `memory`, for libraries that support only an AVR: macros claim that the target is an AVR
};

/// The settings that all compilations of one build share.
struct Toolchain {
  const Target& target;
  Compiler compiler;
  CompilerFacts facts;
  Core core;
  const BoardSpec& board;
  Warnings warnings = Warnings::standard;
  bool sanitize = false;
  bool coverage = false;
  Registers registers = Registers::objects;
  bool untrusted = false;
  bool all_messages = false;
  ProjectRules rules = {};
  bool narrow_ints = false;                ///< the sketch's ints have 16 bits (narrow_ints.h)
  std::function<void()> core_begins = {};  ///< as in the Request
  std::string static_checks = {};          ///< static_checks_identity()
};

/// Returns the core for a target and board. With Robosim's hal, the core is a folder of links in the cache.
/// The links lead to the genuine core's portable sources, to avr-libc's list of registers, and to the hal.
/// Nothing is copied.
///
///   core/Print.h, core/Print.cpp, ...   avr/iom328p.h   hal -> hal of this Robosim
///
/// For the target avr, the core is the installed genuine core with hal/avr. Throws InputError if the board's
/// chip belongs to another target.
Core core_for(const Target& target, const BoardSpec& board, const GenuineCore& genuine,
              const std::filesystem::path& cache);

/// Returns the path of a program of the target. Throws ToolMissing.
std::filesystem::path find_tool(const Target& target, const Program& program);
/// Returns the path of the program that lists a source's functions. Throws ToolMissing.
std::filesystem::path find_ctags();

}  // namespace robosim::build
