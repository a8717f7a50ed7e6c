#include "sim/build/toolchain.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sstream>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/cache.h"
#include "sim/build/process.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

constexpr const char* kPortable[] = {
    "Print.h",     "Print.cpp",    "Printable.h", "Stream.h",      "Stream.cpp", "WString.h",
    "WString.cpp", "WCharacter.h", "IPAddress.h", "IPAddress.cpp", "binary.h",   "Client.h",
    "Server.h",    "Udp.h",        "new",         "new.h",         "new.cpp",    "abi.cpp"};
constexpr const char* kPortPins = "portpins.h";  // from avr-libc: defines PB0, PORTB0, ...

[[noreturn]] void missing(const char* what, const char* package) {
  throw ToolMissing(fmt::format("{} is missing: sudo apt install {}", what, package));
}

std::string identity(const fs::path& program) {
  std::error_code error;
  const fs::path real = fs::canonical(program, error);
  struct stat info {};
  ::stat(program.c_str(), &info);
  return fmt::format("{} {} {}.{}", real.string(), info.st_size, info.st_mtim.tv_sec, info.st_mtim.tv_nsec);
}

std::string answer(const Compiler& compiler, std::vector<std::string> question) {
  const std::string asked = question[0];
  question.insert(question.begin(), compiler.cxx.string());
  CommandResult result = run(Command{std::move(question), "/", {}});
  if (result.status != 0)
    throw ToolMissing(fmt::format("{} fails with {}: {}", compiler.cxx.string(), asked, result.output));
  while (!result.output.empty() && result.output.back() == '\n') result.output.pop_back();
  return result.output;
}

fs::path stage(const BoardSpec& board, const GenuineCore& core, const fs::path& cache) {
  const char* const registers[] = {host_model(board).chip->registers, kPortPins};
  const fs::path hal = data_folder() / "hal";
  std::string links = hal.string() + core.sources.string() + core.avr_libc.string();
  for (const char* name : kPortable) links += name;
  for (const char* name : registers) links += name;
  fs::path folder = cache / (kStage + sha256(links).substr(0, 16));
  std::error_code error;
  if (fs::is_directory(folder, error)) return folder;

  const WorkFolder work{Cache(cache)};
  const fs::path fresh = work.path() / "stage";
  fs::create_directories(fresh / "core");
  fs::create_directories(fresh / "avr");
  for (const char* name : kPortable) fs::create_symlink(core.sources / name, fresh / "core" / name);
  for (const char* name : registers) fs::create_symlink(core.avr_libc / name, fresh / "avr" / name);
  fs::create_symlink(hal, fresh / "hal");
  fs::rename(fresh, folder, error);  // fails if another process was faster
  return folder;
}

/// Returns Robosim's hal, with the genuine core's portable sources.
Core hal_core(const char* hal, const BoardSpec& board, const GenuineCore& genuine, const fs::path& cache) {
  Core core;
  core.root = stage(board, genuine, cache);
  core.place = "robosim";
  core.sources = {core.root / "hal" / hal, core.root / "hal/arduino", core.root / "core"};
  core.serving = core.root / "hal" / hal;
  core.includes = {core.root / "hal/arduino", core.root / "core", core.root};
  core.system_includes = {core.root / "hal/arduino/libc"};
  // STM32duino has a C++ library, unlike Arduino's core for AVR chips.
  if (board.chip->target == std::string_view("stm32"))
    core.system_includes.push_back(core.root / "hal/stm32/cxx");
  core.places = {{core.root, "robosim"}, {core.root / "hal", "robosim"}};
  core.readable = {{core.root / "hal/arduino", ""},
                   {core.root / "hal", "hal/"},
                   {core.root / "core", ""},
                   {core.root, ""}};
  return core;
}

void check_chip(const Target& target, const BoardSpec& board) {
  if (std::string(board.chip->target) == target.name) return;
  throw InputError(fmt::format("the board {} cannot run the target {}: expected a robot with {}", board.name,
                               target.name, one_of(boards_of(target.name))));
}

Core stm32_core(const BoardSpec& board, const GenuineCore& genuine, const fs::path& cache) {
  Core core = hal_core("stm32", board, genuine, cache);
  const fs::path hal = core.root / "hal/stm32";
  core.includes.insert(core.includes.begin(), hal);  // its pins_arduino.h and avr/ precede the host's
  const fs::path script = hal / fmt::format("{}.ld", board.chip->compiler_name);
  core.link = {"-T", script.string()};
  core.linked = {script};
  return core;
}

Core genuine_core(const BoardSpec& board, const GenuineCore& genuine) {
  const ChipSpec& chip = *board.chip;
  const fs::path libc = genuine.avr_libc.parent_path();
  const fs::path archives = libc.parent_path() / "lib" / chip.architecture;
  const fs::path variant = genuine.variants / board.variant;
  Core core;
  core.root = genuine.sources;
  core.place = "arduino";
  core.sources = {genuine.sources, data_folder() / "hal/avr"};
  core.includes = {genuine.sources, variant};
  core.libraries = {genuine.libraries};
  core.includes_with_checks = {data_folder() / "hal/avr/with_checks"};
  core.linked = {archives / "libc.a", archives / "libm.a",
                 archives / fmt::format("crt{}.o", chip.compiler_name)};
  core.machine = {fmt::format("-mmcu={}", chip.compiler_name)};
  // Arduino's builder itself adds this option for this chip; no file of its platform contains it.
  if (chip.linked_relaxed) core.link = {"-Wl,--relax"};
  core.places = {{variant, "arduino/variant"}, {libc, "avr-libc"}, {core.sources[1], "robosim"}};
  core.readable = {{genuine.sources, ""}, {variant, ""}, {genuine.libraries, "libraries/"}, {libc, ""}};
  return core;
}

}  // namespace

fs::path find_tool(const Target& target, const Program& program) {
  fs::path path;
  // Uses the program for the machine that Robosim itself runs on. Under an emulator (qemu-user), plain `g++`
  // is for another machine.
  if (target.native && *ROBOSIM_MACHINE)
    path = find_program(fmt::format("{}-{}", ROBOSIM_MACHINE, program.name));
  if (path.empty()) path = find_program(program.name);
  if (path.empty()) missing(program.name, program.package);
  return path;
}

Compiler find_compiler(const Target& target) {
  Compiler compiler{find_tool(target, target.cxx), find_tool(target, target.cc), {}};
  compiler.identity = identity(compiler.cxx) + " " + identity(compiler.cc);
  return compiler;
}

CompilerFacts ask(const Compiler& compiler, const fs::path& cache) {
  const fs::path file = cache / ("compiler-" + sha256(compiler.identity).substr(0, 16));
  std::error_code error;
  if (!fs::exists(file, error)) {
    const std::string version = answer(compiler, {"-dumpfullversion", "-dumpversion"});
    const std::string machine = answer(compiler, {"-dumpmachine"});
    const std::string include = answer(compiler, {"-print-file-name=include"});
    if (!fs::exists(fs::path(include) / "stdint-gcc.h", error) &&
        !fs::exists(fs::path(include) / "unwind-arm-common.h", error))
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

std::string assembler_name(const Compiler& compiler) {
  const std::string first =
      answer(compiler, {"-Wa,--version", "-c", "-x", "assembler", "-o", "/dev/null", "/dev/null"});
  const std::string line =
      first.substr(0, first.find('\n'));  // "GNU assembler (GNU Binutils for Debian) 2.44"
  return "as " + line.substr(line.find_last_of(' ') + 1);
}

GenuineCore find_core() {
  const fs::path platform = "/usr/share/arduino/hardware/arduino/avr";
  GenuineCore core{platform / "cores/arduino", platform / "variants", platform / "libraries",
                   "/usr/lib/avr/include/avr"};
  std::error_code error;
  if (!fs::exists(core.sources / "Print.cpp", error)) missing("The Arduino core", "arduino-core-avr");
  if (!fs::exists(core.avr_libc / kPortPins, error)) missing("avr-libc", "avr-libc");
  return core;
}

Core core_for(const Target& target, const BoardSpec& board, const GenuineCore& genuine,
              const fs::path& cache) {
  if (!target.chip) {
    Core core = hal_core(target.hal, board, genuine, cache);
    core.libraries = {genuine.libraries};
    core.stand_ins = core.root / "hal/libraries";
    return core;
  }
  check_chip(target, board);
  return target.hal ? stm32_core(board, genuine, cache) : genuine_core(board, genuine);
}

fs::path find_ctags() {
  fs::path path = find_program("arduino-ctags");
  if (path.empty()) missing("arduino-ctags", "arduino-ctags");
  return path;
}

}  // namespace robosim::build
