#include "sim/build/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/cache.h"
#include "sim/build/division.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

void append(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

enum class Language { cxx, c, assembler };

Language language(const Unit& unit) {
  const fs::path extension = fs::path(unit.source).extension();
  if (extension == ".S" || extension == ".s") return Language::assembler;
  return extension == ".c" ? Language::c : Language::cxx;
}

std::vector<std::string> warning_flags(const Toolchain& toolchain, const Unit& unit) {
  if (unit.kind == Unit::Kind::core) return {"-w"};
  switch (toolchain.warnings) {
    case Warnings::none:
      return {"-w"};
    case Warnings::standard: {
      if (unit.kind == Unit::Kind::library) return {"-w"};  // users of a library cannot fix its warnings
      // These warnings are off by default. without_style_warnings() keeps only those about likely mistakes.
      std::vector<std::string> words = {"-Wparentheses",     "-Wempty-body",
                                        "-Wtype-limits",     "-Wlogical-op",
                                        "-Wbool-compare",    "-Wlogical-not-parentheses",
                                        "-Wunused-value",    "-Wshadow",
                                        "-Wunused-variable", "-Wunused-but-set-variable"};
      // avr-gcc 5 lacks these warnings. The warning about a forgotten `break` is silent if a comment replaces
      // the `break`.
      if (toolchain.target.native)
        append(words, {"-Wimplicit-fallthrough=1", "-Wtautological-compare", "-Wduplicated-cond"});
      if (toolchain.sanitize) append(words, toolchain.target.sanitizer.warnings);
      return words;
    }
    case Warnings::more:
      return {"-Wall"};
    case Warnings::all:
      return {"-Wall", "-Wextra"};
  }
  return {};
}

/// Defines a macro that maps a pin's number to `of(pin)`. The macro lists only pins whose result differs from
/// `otherwise`.
template <typename Of>
std::string pin_macro(const char* name, const BoardSpec& board, const char* otherwise, Of of) {
  std::string text = otherwise;
  for (int pin = board.pin_count; pin-- > 0;)
    if (const std::string value = of(board.pins[pin]); value != otherwise)
      text = fmt::format("(p)=={}?{}:{}", pin, value, text);
  return fmt::format("-D{}(p)=({})", name, text);
}

/// Returns the board's values that Robosim's headers and the host's core need at compile time
/// (hal/host/chip.h, hal/arduino/pins_arduino.h).
std::vector<std::string> host_definitions(const BoardSpec& board) {
  const BoardSpec& model = host_model(board);
  const int serial_lines = board.chip->uart_count + (board.chip->usb.address ? 1 : 0);
  int analog_inputs = 0;
  bool every_pin_interrupts = true;
  for (Pin pin = 0; pin < board.pin_count; ++pin) {
    if (pin >= board.analog_pin_0 && board.pins[pin].analog_channel >= 0) ++analog_inputs;
    if (board.pins[pin].interrupt < 0) every_pin_interrupts = false;
  }
  std::vector<std::string> words = {fmt::format("-D{}", model.chip->macro),
                                    fmt::format("-DROBOSIM_REGISTERS=<avr/{}>", model.chip->registers),
                                    fmt::format("-DROBOSIM_CLOCK_HZ={}L", model.clock_hz),
                                    fmt::format("-DROBOSIM_PINS={}", board.pin_count),
                                    fmt::format("-DROBOSIM_DIGITAL_PINS={}", last_digital_pin(board) + 1),
                                    fmt::format("-DROBOSIM_ANALOG_PIN_0={}", board.analog_pin_0),
                                    fmt::format("-DROBOSIM_ANALOG_INPUTS={}", analog_inputs),
                                    fmt::format("-DROBOSIM_SERIAL_LINES={}", serial_lines),
                                    fmt::format("-DROBOSIM_LED_BUILTIN={}", board.led_builtin)};
  if (quotient_by_zero(board) == QuotientByZero::zero) words.emplace_back("-DROBOSIM_ZERO_BY_ZERO");
  if (every_pin_interrupts) {
    words.emplace_back("-DROBOSIM_EVERY_PIN_INTERRUPTS");
  } else {
    words.push_back(pin_macro("ROBOSIM_INTERRUPT_OF", board, "-1",
                              [](const PinSpec& pin) { return std::to_string(pin.interrupt); }));
  }
  words.push_back(
      pin_macro("ROBOSIM_HAS_PWM", board, "0", [](const PinSpec& pin) { return pin.pwm ? "1" : "0"; }));
  // If the chip's own bus pins are unknown, uses those of the AVR board that the host simulates
  // (host_model()).
  const BoardSpec& buses = board.chip->spi.address ? board : model;
  const auto pin_of = [&](const char* name, const char* chip_name) {
    words.push_back(fmt::format("-DROBOSIM_PIN_{}={}", name, find_pin(buses, chip_name)));
  };
  pin_of("SS", buses.chip->spi.select);
  pin_of("MOSI", buses.chip->spi.out);
  pin_of("MISO", buses.chip->spi.in);
  pin_of("SCK", buses.chip->spi.clock);
  pin_of("SDA", buses.chip->twi.data);
  pin_of("SCL", buses.chip->twi.clock);
  if (board.pin_names) words.push_back(fmt::format("-DROBOSIM_PIN_NAMES=\"{}\"", board.pin_names));
  return words;
}

std::vector<std::string> definitions(const Toolchain& toolchain) {
  std::vector<std::string> words = {fmt::format("-DF_CPU={}L", toolchain.board.clock_hz), "-DARDUINO=10819",
                                    fmt::format("-D{}", toolchain.board.macro)};
  // Makes a build independent of the time of day and of the files' times.
  append(words, {"-Wno-builtin-macro-redefined", "-D__DATE__=\"Jan  1 1970\"", "-D__TIME__=\"00:00:00\"",
                 "-D__TIMESTAMP__=\"Thu Jan  1 00:00:00 1970\""});
  append(words, toolchain.target.definitions);
  if (const BoardSpec& board = toolchain.board; toolchain.target.chip && board.usb_product)
    append(words, {"-DUSB_VID=0x2341", fmt::format("-DUSB_PID=0x{:04x}", board.usb_id),
                   "-DUSB_MANUFACTURER=\"Unknown\"", fmt::format("-DUSB_PRODUCT=\"{}\"", board.usb_product)});
  if (!toolchain.target.chip) append(words, host_definitions(toolchain.board));
  append(words, toolchain.rules.flags);
  return words;
}

/// Adds options that remove the names of this machine's folders from the output. The last matching option
/// wins.
void add_prefix_maps(std::vector<std::string>& words, const Toolchain& toolchain, const Core::Names& places) {
  const auto map = [&](const fs::path& from, const std::string& to) {
    words.push_back(fmt::format("{}={}={}", toolchain.target.prefix_map, from.string(), to));
  };
  map(toolchain.facts.include_folder, "robosim/gcc");
  for (const auto& [folder, name] : toolchain.core.places) map(folder, name);
  for (const auto& [folder, name] : places) map(folder, name);
}

/// Returns the short name of a library's folder with headers: "libraries/Servo", "libraries/Servo/src".
std::string place_of_headers(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return "libraries/" + (name == "src" ? (folder.parent_path().filename() / name).string() : name);
}

Core::Names places_of(const Unit& unit) {
  Core::Names places;
  for (const fs::path& folder : unit.includes)
    if (unit.kind == Unit::Kind::sketch && folder != unit.folder)
      places.emplace_back(folder, place_of_headers(folder));
  // Compilers work in the unit's folder, and debuggers put this folder's name before a file's name. The
  // folder's name is therefore removed from file names.
  const bool core = unit.kind == Unit::Kind::core;
  places.emplace_back(unit.folder, core ? unit.place : ".");
  if (unit.kind == Unit::Kind::sketch) places.emplace_back(unit.folder.string() + "/", "");
  if (unit.kind == Unit::Kind::library) places.emplace_back(unit.folder.string() + "/", unit.place + "/");
  return places;
}

void add_checks(std::vector<std::string>& words, const Toolchain& toolchain, const Unit& unit) {
  const Sanitizer& sanitizer = toolchain.target.sanitizer;
  if (unit.kind != Unit::Kind::core) {
    append(words, sanitizer.undefined);
    // gcc can instrument memory accesses for only one purpose. If registers are not objects, that purpose is
    // to watch the registers' memory.
    if (toolchain.registers == Registers::objects) append(words, sanitizer.addresses);
  } else if (fs::path(unit.source).parent_path() == toolchain.core.serving) {
    append(words, sanitizer.definitions);
  } else {
    append(words, sanitizer.addresses);
  }
}

void add_counting(std::vector<std::string>& words, const Toolchain& toolchain, const Unit& unit) {
  const Counting& counting = toolchain.target.coverage;
  if (unit.kind == Unit::Kind::sketch) append(words, counting.own);
  if (unit.kind == Unit::Kind::core) append(words, counting.definitions);
}

/// Adds macros and the folders of headers.
void add_headers(std::vector<std::string>& words, const Toolchain& toolchain, const Unit& unit) {
  append(words, definitions(toolchain));
  // Prevents gcc from loading a precompiled header, Foo.h.gch. gcc loads it only if Foo.h is the first header
  // that a source includes.
  append(words, {"-include", (data_folder() / "hal/arduino/first_include.h").string()});
  for (const auto* folders : {&toolchain.core.includes, &unit.includes})
    for (const fs::path& folder : *folders) words.push_back("-I" + folder.string());
  if (toolchain.sanitize)
    for (const fs::path& folder : toolchain.core.includes_with_checks)
      append(words, {"-isystem", folder.string()});
  for (const fs::path& folder : toolchain.core.system_includes) append(words, {"-isystem", folder.string()});
  if (toolchain.target.hal) append(words, {"-isystem", toolchain.facts.include_folder.string()});
}

std::vector<std::string> base_words(const Toolchain& toolchain, const Unit& unit) {
  const Target& target = toolchain.target;
  const bool core = unit.kind == Unit::Kind::core;
  const Language written_in = language(unit);
  const auto& compiler = written_in == Language::cxx ? toolchain.compiler.cxx : toolchain.compiler.cc;
  std::vector<std::string> words = {compiler.string()};
  words.push_back(core ? target.core_level : target.own_level);
  append(words, target.code);
  if (written_in == Language::cxx) append(words, target.cxx_code);
  if (written_in == Language::c) append(words, target.c_code);
  append(words, core ? target.core : target.own);
  if (!core && toolchain.registers != Registers::objects) append(words, target.memory);
  if (!core && toolchain.registers == Registers::as_avr) append(words, target.as_avr);
  if (toolchain.sanitize) add_checks(words, toolchain, unit);
  if (toolchain.coverage) add_counting(words, toolchain, unit);
  append(words, warning_flags(toolchain, unit));
  append(words, toolchain.core.machine);
  add_headers(words, toolchain, unit);
  add_prefix_maps(words, toolchain, places_of(unit));
  return words;
}

/// Throws InputError for a name that compilers would misread: '-' begins an option, '@' names a file of more
/// options. Compilers also pass the last part of a source's path on as a separate argument (-dumpbase).
void check_name(const std::string& source) {
  for (const std::string& word : {source, fs::path(source).filename().string()})
    if (word.starts_with('-') || word.starts_with('@'))
      throw InputError({source}, fmt::format("cannot be compiled: expected a name that does not begin with "
                                             "'{}', which compilers read as an option; rename it",
                                             word[0]));
}

void add_source(std::vector<std::string>& words, const Unit& unit) {
  check_name(unit.source);
  if (language(unit) == Language::assembler) append(words, {"-x", "assembler-with-cpp"});
  if (unit.input.empty())
    words.push_back(unit.source);
  else
    append(words, {"-x", "c++", "-"});
}

}  // namespace

std::string join_paths(const std::vector<fs::path>& paths) {
  std::string text;
  for (const fs::path& path : paths) text += path.string() + '\n';
  return text;
}

std::vector<fs::path> split_paths(const std::string& text) {
  std::vector<fs::path> paths;
  for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    paths.emplace_back(text.substr(at, end - at));
  return paths;
}

std::vector<std::string> reading_words(const Toolchain& toolchain, const Unit& unit) {
  std::vector<std::string> words = {"-std=gnu++14", "-nostdinc", "-nostdinc++"};
  add_headers(words, toolchain, unit);
  return words;
}

void check_object(const Toolchain& toolchain, const Unit& unit, const fs::path& object) {
  const std::vector<std::string>& code = toolchain.target.code;
  const bool links_bytecode = std::find(code.begin(), code.end(), "-flto") != code.end();
  const bool is_bytecode = language(unit) != Language::assembler && !toolchain.sanitize;
  if (!links_bytecode || is_bytecode || read_made(object).find(".gnu.lto_") == std::string::npos) return;
  throw InputError({unit.source},
                   "cannot be compiled: expected no sections named .gnu.lto_*, which only compilers may "
                   "write");
}

bool through_assembly(const Toolchain& toolchain, const Unit& unit) {
  return !toolchain.target.chip && unit.kind != Unit::Kind::core;
}

fs::path compiled_assembly(const fs::path& object) { return object.string() + ".gcc.s"; }
fs::path changed_assembly(const fs::path& object) { return object.string() + ".s"; }

bool is_counted(const Toolchain& toolchain, const Unit& unit) {
  return toolchain.coverage && unit.kind == Unit::Kind::sketch;
}

std::string notes_name(const Unit& unit) {
  std::string name = unit.input.empty() ? unit.source : "ino";
  std::replace(name.begin(), name.end(), '/', '#');
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

Command compile_command(const Toolchain& toolchain, const Unit& unit, const fs::path& object) {
  std::vector<std::string> words = base_words(toolchain, unit);
  append(words, {"-MD", "-MF", object.string() + ".d"});
  if (is_counted(toolchain, unit))
    append(words, {"-fprofile-note=" + object.string() + ".gcno", "-dumpbase", notes_name(unit)});
  if (through_assembly(toolchain, unit))
    append(words, {"-S", "-o", compiled_assembly(object).string()});
  else
    append(words, {"-c", "-o", object.string()});
  add_source(words, unit);
  return {std::move(words), unit.folder, unit.input, object.parent_path()};
}

Command assemble_command(const Toolchain& toolchain, const fs::path& assembly, const fs::path& object) {
  return {{toolchain.compiler.cc.string(), "-c", "-o", object.string(), assembly.string()},
          object.parent_path(),
          {},
          object.parent_path()};
}

Command check_command(const Toolchain& toolchain, const Unit& unit, const std::vector<std::string>& options,
                      const fs::path& scratch) {
  std::vector<std::string> words = base_words(toolchain, unit);
  append(words, options);
  add_source(words, unit);
  return {std::move(words), unit.folder, unit.input, scratch};
}

Command preprocess_command(const Toolchain& toolchain, const Unit& unit, const fs::path& output) {
  std::vector<std::string> words = base_words(toolchain, unit);
  append(words, {"-w", "-E", "-o", output.string()});
  add_source(words, unit);
  return {std::move(words), unit.folder, unit.input, output.parent_path()};
}

Command merge_command(const Toolchain& toolchain, const std::vector<fs::path>& objects,
                      const fs::path& object) {
  std::vector<std::string> words = {
      toolchain.compiler.cc.string(), "-r", "-nostdlib", "-fuse-ld=bfd", "-o", object.string()};
  for (const fs::path& one : objects) words.push_back(one.string());
  return {std::move(words), object.parent_path(), {}, object.parent_path()};
}

Command archive_command(const Toolchain& toolchain, const std::vector<fs::path>& objects,
                        const fs::path& archive) {
  std::vector<std::string> words = {find_tool(toolchain.target, toolchain.target.archiver).string(), "rcsD",
                                    archive.string()};
  for (const fs::path& one : objects) words.push_back(one.string());
  return {std::move(words), archive.parent_path(), {}, archive.parent_path()};
}

Command link_command(const Toolchain& toolchain, const std::vector<fs::path>& objects, const fs::path& image,
                     const Core::Names& places) {
  const fs::path work = image.parent_path();
  for (const auto& [name, text] : toolchain.target.link_files) write_file(work / name, text);
  std::vector<std::string> words = {toolchain.compiler.cc.string()};
  append(words, toolchain.target.link);
  if (toolchain.sanitize) append(words, toolchain.target.sanitizer.link);
  append(words, toolchain.core.machine);
  if (toolchain.target.chip) {
    add_prefix_maps(words, toolchain, places);  // for debug information of link-time optimisation
    // Since gcc 10, file names in this information begin with the relative path from the linker's folder to
    // the compiler's folder.
    std::error_code error;
    for (const auto& [folder, name] : places) {
      const std::string way = fs::canonical(folder, error).lexically_relative(fs::canonical(work)).string();
      words.push_back(fmt::format("{}={}/=", toolchain.target.prefix_map, way));
    }
  } else
    append(words, {"-Wl,--version-script=exports.map", "-Wl,-T,sections.ld"});
  append(words, toolchain.core.link);
  append(words, {"-o", image.string()});
  for (const fs::path& object : objects) words.push_back(object.string());
  words.push_back("-lm");
  if (toolchain.coverage) append(words, toolchain.target.coverage.link);
  return {std::move(words), work, {}, work};
}

Command product_command(const Target& target, const Product& product, const fs::path& image,
                        const fs::path& file) {
  std::vector<std::string> words = {find_tool(target, product.program).string()};
  append(words, product.arguments);
  append(words, {image.string(), file.string()});
  return {std::move(words), file.parent_path(), {}, file.parent_path()};
}

std::vector<fs::path> read_by_all(const Toolchain& toolchain, std::vector<fs::path> read) {
  const Core& core = toolchain.core;
  read.insert(read.end(), {core.root, toolchain.facts.include_folder, data_folder() / "hal",
                           toolchain.compiler.cxx.parent_path(), toolchain.compiler.cc.parent_path()});
  for (const auto* more : {&core.sources, &core.includes, &core.system_includes, &core.linked})
    read.insert(read.end(), more->begin(), more->end());
  return read;
}

std::string recipe(const Toolchain& toolchain) {
  const Target& target = toolchain.target;
  std::string text =
      key_of({"robosim", ROBOSIM_VERSION, toolchain.compiler.identity, toolchain.core.root.string(),
              std::to_string(static_cast<int>(toolchain.warnings))});
  const auto add_text = [&](std::initializer_list<const std::vector<std::string>*> all) {
    for (const auto* words : all) text += key_of({key_of(*words)});
  };
  const std::vector<std::string> defined = definitions(toolchain);
  add_text({&target.code, &target.cxx_code, &target.c_code, &target.own, &target.memory, &target.as_avr,
            &target.link, &defined, &target.core, &toolchain.core.machine, &toolchain.core.link});
  const Sanitizer& checks = target.sanitizer;
  if (toolchain.sanitize)
    add_text({&checks.undefined, &checks.addresses, &checks.definitions, &checks.link, &checks.warnings});
  if (toolchain.sanitize)
    for (const fs::path& folder : toolchain.core.includes_with_checks) text += key_of({folder.string()});
  const Counting& counting = target.coverage;
  if (toolchain.coverage) add_text({&counting.own, &counting.definitions, &counting.link});
  text += fmt::format("assembly 6 {}{}", target.own_level, target.core_level);
  for (const auto& [name, content] : target.link_files) text += content;
  return text;
}

std::vector<fs::path> read_dependencies(const std::string& text, const fs::path& folder) {
  std::vector<fs::path> files;
  std::string name;
  const auto finish = [&] {
    if (!name.empty() && name.back() != ':' && name != "-" && name != "<stdin>") {
      fs::path path = (folder / name).lexically_normal();
      files.push_back(std::move(path));
    }
    name.clear();
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (c == '\\' && next == '\n') {
      finish();
      ++i;
    } else if (c == '\\' && (next == ' ' || next == '#' || next == '\\')) {
      name += next;
      ++i;
    } else if (c == '$' && next == '$') {
      name += '$';
      ++i;
    } else if (c == ' ' || c == '\n') {
      finish();
    } else {
      name += c;
    }
  }
  finish();
  return files;
}

}  // namespace robosim::build
