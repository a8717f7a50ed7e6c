#include "sim/sketch/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <regex>
#include <string_view>

#include "sim/base/file.h"

namespace robosim::sketch {
namespace fs = std::filesystem;

namespace {

// A sketch's time is counted in blocks of its code, so its level is fixed for ever. The core costs what its
// table says.
constexpr const char* kSketchLevel = "-O1";
constexpr const char* kCoreLevel = "-O2";
// Fixed: the same code on the same compiler must give the same trace.
const std::vector<std::string> kCode = {
    "-gdwarf-4", "-fPIC", "-fvisibility=hidden", "-fwrapv", "-fno-strict-aliasing", "-fsigned-char",
    "-ffp-contract=off",
    // As avr-gcc, to which address 0 is a place like any other: a write through a null pointer stays, and is
    // met.
    "-fno-delete-null-pointer-checks",
    // As Arduino's AVR core compiles:
    "-ffunction-sections", "-fdata-sections",
    // What a private copy of an image needs: no symbol shared between copies, nothing from the C++ library,
    // no names of this machine inside, no defaults that distributions differ in.
    "-fno-gnu-unique", "-fno-stack-protector", "-gno-record-gcc-switches", "-fno-canonical-system-headers",
    "-fdiagnostics-color=never", "-pipe", "-nostdinc"};
const std::vector<std::string> kCxx = {"-std=gnu++14",
                                       "-fpermissive",
                                       "-fno-exceptions",
                                       "-fno-rtti",
                                       "-fno-threadsafe-statics",
                                       "-nostdinc++",
                                       "-Wno-error=narrowing",
                                       "-Wno-builtin-declaration-mismatch"};
const std::vector<std::string> kC = {"-std=gnu11", "-Wno-builtin-declaration-mismatch"};
const std::vector<std::string> kInstrumented = {"-fsanitize-coverage=trace-pc",
                                                "-fsanitize=integer-divide-by-zero"};
// The loader shall find nothing to run: start files bring constructors of their own.
const std::vector<std::string> kLink = {
    "-shared", "-nostartfiles", "-static-libgcc", "-fuse-ld=bfd", "-Wl,-Bsymbolic", "-Wl,--no-undefined",
    "-Wl,--gc-sections", "-Wl,--build-id=none", "-Wl,-z,now",
    // Handlers that a sketch does not define are null, whatever the process has.
    "-Wl,-z,nodynamic-undefined-weak", "-Wl,-z,noexecstack"};

constexpr const char* kExports = "{ global: robosim_image; local: *; };\n";
// Ahead of the default script, so that constructors are taken out of .init_array, in the order of their
// priority. Destructors are kept apart and never run: a microcontroller has no end.
constexpr const char* kSections = R"(SECTIONS
{
  robosim_init_array : ALIGN(8)
  {
    PROVIDE_HIDDEN(__start_robosim_init_array = .);
    KEEP(*(SORT_BY_INIT_PRIORITY(.init_array.*) SORT_BY_INIT_PRIORITY(.ctors.*)))
    KEEP(*(.init_array .ctors))
    PROVIDE_HIDDEN(__stop_robosim_init_array = .);
  }
  robosim_fini_array : { *(.fini_array.* .dtors.* .fini_array .dtors) }
}
INSERT BEFORE .data;
)";

void add(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

bool is_c(const Unit& unit) { return fs::path(unit.source).extension() == ".c"; }

std::vector<std::string> warning_flags(const Toolchain& toolchain, const Unit& unit) {
  if (unit.kind == Unit::Kind::core) return {"-w"};
  switch (toolchain.warnings) {
    case Warnings::none:
      return {"-w"};
    case Warnings::standard:
      return {};
    case Warnings::more:
      return {"-Wall"};
    case Warnings::all:
      return {"-Wall", "-Wextra"};
  }
  return {};
}

std::vector<std::string> definitions(const Toolchain& toolchain) {
  return {fmt::format("-DF_CPU={}L", toolchain.board.clock_hz),
          "-DARDUINO=10819",
          fmt::format("-D{}", toolchain.board.macro),
          "-DARDUINO_ARCH_HOST",
          "-D__AVR_ATmega328P__",
          "-DROBOSIM"};
}

std::vector<std::string> base_words(const Toolchain& toolchain, const Unit& unit) {
  const bool c = is_c(unit);
  std::vector<std::string> words = {(c ? toolchain.compiler.cc : toolchain.compiler.cxx).string()};
  words.push_back(unit.kind == Unit::Kind::core ? kCoreLevel : kSketchLevel);
  add(words, kCode);
  add(words, c ? kC : kCxx);
  if (unit.kind != Unit::Kind::core) add(words, kInstrumented);
  add(words, warning_flags(toolchain, unit));
  add(words, definitions(toolchain));
  const std::string stage = toolchain.stage.string();
  add(words, {"-I" + stage + "/hal/arduino", "-I" + stage + "/core", "-I" + stage});
  for (const fs::path& folder : unit.includes) words.push_back("-I" + folder.string());
  add(words, {"-isystem", stage + "/hal/arduino/libc", "-isystem", toolchain.facts.include_folder.string()});

  // The last map that fits wins.
  const auto map = [&](const std::string& from, const std::string& to) {
    words.push_back("-ffile-prefix-map=" + from + "=" + to);
  };
  map(toolchain.facts.include_folder.string(), "robosim/gcc");
  map(stage, "robosim");
  map(stage + "/hal", "robosim");
  for (const fs::path& folder : unit.includes)
    if (unit.kind == Unit::Kind::sketch && folder != unit.folder)
      map(folder.string(), "libraries/" + folder.filename().string());
  map(unit.folder.string(), unit.place);
  if (unit.kind == Unit::Kind::sketch) map(unit.folder.string() + "/", "");
  return words;
}

void add_source(std::vector<std::string>& words, const Unit& unit) {
  if (unit.input.empty())
    words.push_back(unit.source);
  else
    add(words, {"-x", "c++", "-"});
}

bool replace_all(std::string& text, const std::string& from, const std::string& to) {
  bool found = false;
  for (std::size_t at = 0; !from.empty() && (at = text.find(from, at)) != std::string::npos;
       at += to.size()) {
    text.replace(at, from.size(), to);
    found = true;
  }
  return found;
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

Command compile_command(const Toolchain& toolchain, const Unit& unit, const fs::path& object) {
  std::vector<std::string> words = base_words(toolchain, unit);
  add(words, {"-MD", "-MF", object.string() + ".d"});
  if (unit.kind == Unit::Kind::core)
    add(words, {"-c", "-o", object.string()});
  else
    add(words, {"-S", "-o", object.string() + ".s"});
  add_source(words, unit);
  return {std::move(words), unit.folder, unit.input};
}

Command assemble_command(const Toolchain& toolchain, const fs::path& object) {
  return {{toolchain.compiler.cc.string(), "-c", "-o", object.string(), object.string() + ".s"},
          object.parent_path(),
          {}};
}

Command preprocess_command(const Toolchain& toolchain, const Unit& unit, const fs::path& output) {
  std::vector<std::string> words = base_words(toolchain, unit);
  add(words, {"-w", "-E", "-o", output.string()});
  add_source(words, unit);
  return {std::move(words), unit.folder, unit.input};
}

Command merge_command(const Toolchain& toolchain, const std::vector<fs::path>& objects,
                      const fs::path& object) {
  std::vector<std::string> words = {
      toolchain.compiler.cc.string(), "-r", "-nostdlib", "-fuse-ld=bfd", "-o", object.string()};
  for (const fs::path& one : objects) words.push_back(one.string());
  return {std::move(words), object.parent_path(), {}};
}

Command link_command(const Toolchain& toolchain, const std::vector<fs::path>& objects, const fs::path& image,
                     const fs::path& work) {
  write_file(work / "exports.map", kExports);
  write_file(work / "sections.ld", kSections);
  std::vector<std::string> words = {toolchain.compiler.cc.string()};
  add(words, kLink);
  add(words, {"-Wl,--version-script=exports.map", "-Wl,-T,sections.ld", "-o", image.string()});
  for (const fs::path& object : objects) words.push_back(object.string());
  words.push_back("-lm");
  return {std::move(words), work, {}};
}

std::string recipe(const Toolchain& toolchain) {
  std::string text = fmt::format("robosim {} {} {} {}\n", ROBOSIM_VERSION, toolchain.compiler.identity,
                                 toolchain.stage.string(), static_cast<int>(toolchain.warnings));
  for (const auto& words : {kCode, kCxx, kC, kInstrumented, kLink, definitions(toolchain)})
    text += fmt::format("{}\n", fmt::join(words, " "));
  return text + "assembly 1 " + kSketchLevel + kCoreLevel + kExports + kSections;
}

std::vector<fs::path> read_dependencies(const fs::path& list, const fs::path& folder) {
  const std::string text = read_file(list);
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

std::string missing_header(const std::string& output, Place* place) {
  static const std::regex pattern(
      R"(([^\n]*):(\d+):(\d+): fatal error: ([^\n]*): No such file or directory)");
  std::smatch match;
  if (!std::regex_search(output, match, pattern)) return {};
  *place = {match[1], std::stoi(match[2]), std::stoi(match[3])};
  return match[4];
}

std::string readable(const Toolchain& toolchain, const fs::path& sketch, std::string output) {
  replace_all(output, sketch.string() + "/", "");
  replace_all(output, toolchain.stage.string() + "/hal/arduino/", "");
  replace_all(output, toolchain.stage.string() + "/hal/", "hal/");
  replace_all(output, toolchain.stage.string() + "/core/", "");
  replace_all(output, toolchain.stage.string() + "/", "");
  // The linker's lines: only those that name a place in a source are of use.
  static const std::regex linker(R"((^|\n)[^\n ]*/ld(\.bfd)?: )");
  output = std::regex_replace(output, linker, "$1");
  static const std::regex noise(
      R"((^|\n)(collect2: error:|[^\n]*\.o: in function |compilation terminated)[^\n]*(?=\n|$))");
  output = std::regex_replace(output, noise, "");
  static const std::regex object(R"((^|[\n ])[^\n ]*\.o:(?=[^\n]))");
  output = std::regex_replace(output, object, "$1");
  static const std::regex here(R"((^|[\n ])(\./)+)");
  output = std::regex_replace(output, here, "$1");
  while (!output.empty() && (output.back() == '\n' || output.back() == ' ')) output.pop_back();
  while (!output.empty() && output.front() == '\n') output.erase(0, 1);
  return output;
}

void fail(const std::string& messages) {
  static const std::regex error(
      R"((^|\n)([^\n: ][^\n:]*):(\d+):((\d+):)? (fatal error|error|undefined reference|multiple definition))");
  std::smatch match;
  if (!std::regex_search(messages, match, error)) {
    static const std::regex assembler(R"(([^\n:]+):(\d+): Error: ([^\n]*))");
    if (std::regex_search(messages, match, assembler))
      throw CompileError({match[1], std::stoi(match[2])}, "asm() holds assembler of the chip (" +
                                                              match[3].str() + "): it is for --target avr");
    throw CompileError(messages);
  }
  const Place place{match[2], std::stoi(match[3]), match[5].matched ? std::stoi(match[5]) : 0};
  throw CompileError(place, messages.substr(static_cast<std::size_t>(match.position(6))));
}

}  // namespace robosim::sketch
