// The compiler and the genuine Arduino core, as they are installed on this machine.
#pragma once

#include <filesystem>
#include <string>

namespace robosim::sketch {

/// gcc, whatever Robosim itself was built by: one compiler, one instrumentation, one trace.
struct Compiler {
  std::filesystem::path cxx;
  std::filesystem::path cc;
  std::string identity;  ///< path, size and time of both programs: changes with every upgrade
};

/// Throws ToolMissing, naming the package.
Compiler find_compiler();

/// What the compiler says of itself.
struct CompilerFacts {
  std::string name;                      ///< "gcc 12.2.0 x86_64-linux-gnu"
  std::filesystem::path include_folder;  ///< its own headers: stddef.h, stdarg.h, float.h
};
/// Starts the compiler unless `cache` knows the answer.
CompilerFacts ask(const Compiler& compiler, const std::filesystem::path& cache);

/// Where the genuine core's sources and avr-libc's headers are. Throws ToolMissing.
struct GenuineCore {
  std::filesystem::path sources;    ///< cores/arduino
  std::filesystem::path libraries;  ///< the core's libraries: EEPROM, SPI, ...
  std::filesystem::path avr_libc;   ///< include/avr
};
GenuineCore find_core();

/// A folder of links to the genuine core's portable sources, to avr-libc's list of registers, and to our hal.
/// Made once in the cache; nothing is copied.
///
///   core/Print.h, core/Print.cpp, ...   avr/iom328p.h   hal -> hal of this Robosim
std::filesystem::path stage(const GenuineCore& core, const std::filesystem::path& cache);

/// The program that lists a source's functions. Throws ToolMissing.
std::filesystem::path find_ctags();
/// nm, objcopy. Throws ToolMissing.
std::filesystem::path find_binutil(const std::string& name);

}  // namespace robosim::sketch
