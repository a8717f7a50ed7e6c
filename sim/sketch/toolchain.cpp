#include "sim/sketch/toolchain.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sstream>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/sketch/process.h"

namespace robosim::sketch {
namespace fs = std::filesystem;

namespace {

constexpr const char* kPortable[] = {
    "Print.h",     "Print.cpp",    "Printable.h", "Stream.h",      "Stream.cpp", "WString.h",
    "WString.cpp", "WCharacter.h", "IPAddress.h", "IPAddress.cpp", "binary.h",   "Client.h",
    "Server.h",    "Udp.h",        "new",         "new.h",         "new.cpp",    "abi.cpp"};
constexpr const char* kRegisters[] = {"iom328p.h", "portpins.h"};

[[noreturn]] void missing(const char* what, const char* package) {
  throw ToolMissing(fmt::format("{} is missing: sudo apt install {}", what, package));
}

// The program for the machine that Robosim itself runs on: under an emulator (qemu-user) plain `g++` is
// another's.
fs::path require(const char* program, const char* package) {
  fs::path path;
  if (*ROBOSIM_MACHINE) path = find_program(fmt::format("{}-{}", ROBOSIM_MACHINE, program));
  if (path.empty()) path = find_program(program);
  if (path.empty()) missing(program, package);
  return path;
}

std::string identity(const fs::path& program) {
  std::error_code error;
  const fs::path real = fs::canonical(program, error);
  struct stat info {};
  ::stat(program.c_str(), &info);
  return fmt::format("{} {} {}.{}", real.string(), info.st_size, info.st_mtim.tv_sec, info.st_mtim.tv_nsec);
}

std::string answer(const Compiler& compiler, const char* question) {
  Outcome outcome = run(Command{{compiler.cxx.string(), question}, "/", {}});
  if (outcome.status != 0)
    throw ToolMissing(
        fmt::format("{} does not answer {}: {}", compiler.cxx.string(), question, outcome.output));
  while (!outcome.output.empty() && outcome.output.back() == '\n') outcome.output.pop_back();
  return outcome.output;
}

}  // namespace

Compiler find_compiler() {
  Compiler compiler{require("g++", "g++"), require("gcc", "gcc"), {}};
  compiler.identity = identity(compiler.cxx) + " " + identity(compiler.cc);
  return compiler;
}

CompilerFacts ask(const Compiler& compiler, const fs::path& cache) {
  const fs::path file = cache / ("compiler-" + sha256(compiler.identity).substr(0, 16));
  std::error_code error;
  if (!fs::exists(file, error)) {
    const std::string version = answer(compiler, "-dumpfullversion");
    const std::string machine = answer(compiler, "-dumpmachine");
    const std::string include = answer(compiler, "-print-file-name=include");
    if (!fs::exists(fs::path(include) / "stdint-gcc.h", error))
      throw ToolMissing(fmt::format("{} is not gcc: sudo apt install g++", compiler.cxx.string()));
    write_file(file, fmt::format("gcc {} {}\n{}\n", version, machine, include));
  }
  std::istringstream lines(read_file(file));
  CompilerFacts facts;
  std::string include;
  std::getline(lines, facts.name);
  std::getline(lines, include);
  facts.include_folder = include;
  return facts;
}

GenuineCore find_core() {
  const fs::path platform = "/usr/share/arduino/hardware/arduino/avr";
  GenuineCore core{platform / "cores/arduino", platform / "libraries", "/usr/lib/avr/include/avr"};
  std::error_code error;
  if (!fs::exists(core.sources / "Print.cpp", error)) missing("The Arduino core", "arduino-core-avr");
  if (!fs::exists(core.avr_libc / "iom328p.h", error)) missing("avr-libc", "avr-libc");
  return core;
}

fs::path stage(const GenuineCore& core, const fs::path& cache) {
  const fs::path hal = data_folder() / "hal";
  std::string links = hal.string() + core.sources.string() + core.avr_libc.string();
  for (const char* name : kPortable) links += name;
  for (const char* name : kRegisters) links += name;
  fs::path folder = cache / ("stage-" + sha256(links).substr(0, 16));
  std::error_code error;
  if (fs::is_directory(folder, error)) return folder;

  const fs::path fresh = folder.string() + ".tmp" + std::to_string(::getpid());
  fs::remove_all(fresh);
  fs::create_directories(fresh / "core");
  fs::create_directories(fresh / "avr");
  for (const char* name : kPortable) fs::create_symlink(core.sources / name, fresh / "core" / name);
  for (const char* name : kRegisters) fs::create_symlink(core.avr_libc / name, fresh / "avr" / name);
  fs::create_symlink(hal, fresh / "hal");
  fs::rename(fresh, folder, error);
  if (error) fs::remove_all(fresh);  // another process was first
  return folder;
}

fs::path find_ctags() {
  fs::path path = find_program("arduino-ctags");
  if (path.empty()) missing("arduino-ctags", "arduino-ctags");
  return path;
}
fs::path find_binutil(const std::string& name) { return require(name.c_str(), "binutils"); }

}  // namespace robosim::sketch
