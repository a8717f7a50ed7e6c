#include "sim/build/messages.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <regex>
#include <stdexcept>
#include <string_view>

#include "sim/base/elf/avr_addresses.h"
#include "sim/base/file.h"
#include "sim/base/system_error.h"
#include "sim/build/core.h"
#include "sim/build/hints.h"
#include "sim/build/process.h"
#include "sim/build/vector_hints.h"
#include "sim/build/warning_filter.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

// Limits the length of a line and of all lines together, because std::regex needs stack for each character.
constexpr std::size_t kLongestLine = 2000, kMostText = 200'000;

/// Returns whether a line begins like a message of the compiler or linker; other lines may be text from the
/// sketch. Messages begin like "My.ino:3:5: error: …", "My.ino: In function …", "In file included from
/// My.ino:1:", "    3 | int x;" or "My.ino: first defined here".
bool is_begun_by_compiler(std::string_view line) {
  if (line.empty() || line[0] == ' ' || line.starts_with("In file included from ")) return true;
  const std::size_t colon = line.find(':');
  if (colon == line.npos) return false;
  const std::string_view rest = line.substr(colon + 1);
  return rest.starts_with(" In ") || rest.starts_with(" At ") || rest == " first defined here" ||
         rest.starts_with(" multiple definition of `") ||
         (!rest.empty() && std::isdigit(static_cast<unsigned char>(rest[0])));
}

/// Indents lines that do not begin like a compiler's message, because they could be mistaken for Robosim's
/// own messages.
std::string with_texts_indented(const std::string& messages) {
  std::string shown;
  for (std::size_t at = 0; at < messages.size();) {
    const std::size_t end = std::min(messages.find('\n', at), messages.size());
    const std::string_view line = std::string_view(messages).substr(at, end - at);
    if (!is_begun_by_compiler(line)) shown += "  ";
    shown += line;
    if (end < messages.size()) shown += '\n';
    at = end + 1;
  }
  return shown;
}

std::string cut(const std::string& output) {
  std::string text;
  for (std::size_t at = 0; at < output.size() && text.size() < kMostText;) {
    const std::size_t end = std::min(output.find('\n', at), output.size());
    text.append(output, at, std::min(end - at, kLongestLine));
    if (end - at > kLongestLine) text += " …";
    if (end < output.size()) text += '\n';
    at = end + 1;
  }
  return text;
}

/// Converts digits to a number. Returns 0 for a number that is too large: such a number comes from a text of
/// the sketch, not from the compiler.
template <typename Number = int>
Number number_in(const std::string& digits, int base = 10) {
  Number number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number, base);
  return error == std::errc() ? number : 0;
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

// Throws CompileError if the program exceeds the chip's memory. Only the linker detects this error, and it
// names neither a file nor a line.
void check_room(const Toolchain& toolchain, const Sketch& sketch, const std::string& messages) {
  static const std::regex ram(R"(address (0x[0-9a-f]+) of [^\n]* is not within region `data')");
  static const std::regex more_ram(R"(region `data' overflowed by (\d+) bytes)");
  static const std::regex flash(R"(region `text' overflowed by (\d+) bytes)");
  const BoardSpec& board = toolchain.board;
  const auto fail_for_ram = [&](std::uint64_t bytes) {
    throw CompileError(fmt::format("{} does not fit: its variables take {} bytes, but the {} has {} of RAM",
                                   sketch.name, bytes, board.name, board.ram_bytes));
  };
  std::smatch match;
  if (std::regex_search(messages, match, ram))
    fail_for_ram(number_in<std::uint64_t>(match[1].str().substr(2), 16) - kAvrData - board.chip->ram_address);
  if (std::regex_search(messages, match, more_ram))
    fail_for_ram(board.ram_bytes + number_in<std::uint64_t>(match[1]));
  if (std::regex_search(messages, match, flash))
    throw CompileError(
        fmt::format("{} does not fit: it is {} bytes larger than the flash, and the {} has {} bytes for a "
                    "sketch{}",
                    sketch.name, match[1].str(), board.name, board.flash_bytes,
                    board.chip->eeprom_bytes == 0 && board.eeprom_bytes > 0
                        ? "; the last 4096 are free only if the sketch does not use the EEPROM"
                        : ""));
}

}  // namespace

void check_machine(const std::string& tool, const std::string& output) {
  if (const std::string fault = system_error_of(tool, output); !fault.empty()) throw ToolMissing(fault);
}

std::string missing_header(const std::string& whole, Place* place) {
  // Searches only the relevant line, because a search of all lines would take quadratic time.
  const std::size_t says = whole.find(": fatal error: ");
  if (says == std::string::npos) return {};
  const std::size_t begin = whole.rfind('\n', says) + 1;
  const std::string line = cut(whole.substr(begin, whole.find('\n', says) - begin));
  static const std::regex pattern(R"((.*):(\d+):(\d+): fatal error: (.*): No such file or directory.*)");
  std::smatch match;
  if (!std::regex_match(line, match, pattern)) return {};
  *place = {match[1], number_in(match[2]), number_in(match[3])};
  return match[4];
}

/// Returns the name of a file below `folders` that differs from `header` only in capital letters. Returns an
/// empty text if there is no such file.
static std::string other_spelling(const std::vector<fs::path>& folders, const std::string& header) {
  const fs::path parent = fs::path(header).parent_path();
  const std::string wanted = fs::path(header).filename().string();
  const auto is_like = [&](const std::string& name) {
    return std::equal(name.begin(), name.end(), wanted.begin(), wanted.end(), [](char a, char b) {
      return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    });
  };
  for (const fs::path& folder : folders) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder / parent, none))
      if (is_like(entry.path().filename().string())) return (parent / entry.path().filename()).string();
  }
  return {};
}

void fail_without_library(const Toolchain& toolchain, const GenuineCore& core, const LibraryFinder& finder,
                          const fs::path& sketch, const Place& place, const std::string& header) {
  if (const std::string foreign = foreign_header(header); !foreign.empty())
    throw CompileError(place, foreign);
  std::vector<fs::path> known = finder.includes();
  known.insert(known.begin(), toolchain.core.includes.begin(), toolchain.core.includes.end());
  known.insert(known.begin(), sketch);
  if (const std::string name = other_spelling(known, header); !name.empty())
    throw CompileError(place, fmt::format("no such header {}: write {}, because Linux distinguishes capital "
                                          "letters in file names",
                                          header, name));
  const bool chip = toolchain.target.chip;
  if (!chip && fs::exists(core.sources / header))
    throw CompileError(place, fmt::format("{} is a private part of Arduino's core for AVR chips, which the "
                                          "target host does not have; build for the target avr",
                                          header));
  if (!chip && fs::exists(core.avr_libc.parent_path() / header))
    throw CompileError(place, fmt::format("{} belongs to avr-libc, which the target host does not "
                                          "have; build for the target avr",
                                          header));
  if (header.find('.') == std::string::npos)
    throw CompileError(
        place,
        toolchain.board.chip->target == std::string_view("stm32")
            ? fmt::format("no such header {}: for the STM32, Robosim has only headers of the C++ standard "
                          "library that "
                          "come from C, such as cstdint and cmath",
                          header)
            : fmt::format("no such header {}: Arduino boards with an AVR chip have no C++ standard library",
                          header));
  if (const std::string purpose = purpose_of_core_library(header); !purpose.empty()) {
    if (std::string_view(toolchain.target.name) == "stm32")
      throw CompileError(
          place, fmt::format("{} is for {}, which sketches can use on the targets host and avr, but not "
                             "yet on the target stm32",
                             header, purpose));
    throw CompileError(place,
                       fmt::format("no such header {}: it belongs to the AVR core, which is incomplete on "
                                   "this machine: sudo apt install --reinstall arduino-core-avr",
                                   header));
  }
  std::vector<std::string> folders;
  for (const fs::path& folder : finder.folders()) folders.push_back(folder.string());
  const std::string library = library_of_header(header);
  throw MissingLibrary(
      place, fmt::format("no such header {} in the sketch, nor in a library below {}{}", header,
                         fmt::join(folders, ", "),
                         library.empty() ? ""
                                         : fmt::format("; Arduino's library manager has it: arduino-cli lib "
                                                       "install \"{}\"",
                                                       library)));
}

std::string without_folders(const Toolchain& toolchain, const fs::path& sketch, std::string text) {
  replace_all(text, sketch.string() + "/", "");
  for (const auto& [folder, name] : toolchain.core.readable) replace_all(text, folder.string() + "/", name);
  return text;
}

std::string readable(const Toolchain& toolchain, const fs::path& sketch, const std::string& messages) {
  std::string output = without_folders(toolchain, sketch, cut(messages));
  // Removes the linker's name. Also removes lines that name no place in a source, because these are not
  // useful.
  static const std::regex linker(R"((^|\n)[^\n ]*/ld(\.bfd)?: )");
  output = std::regex_replace(output, linker, "$1");
  static const std::regex noise(
      R"((^|\n)(collect2: error:|[^\n]*\.o: [Ii]n function |compilation terminated)[^\n]*(?=\n|$))");
  output = std::regex_replace(output, noise, "");
  static const std::regex object(R"((^|[\n ])[^\n ]*\.o:(?=[^\n]))");
  output = std::regex_replace(output, object, "$1");
  static const std::regex here(R"((^|[\n ])(\./)+)");
  output = std::regex_replace(output, here, "$1");
  while (!output.empty() && (output.back() == '\n' || output.back() == ' ')) output.pop_back();
  while (!output.empty() && output.front() == '\n') output.erase(0, 1);
  return with_texts_indented(toolchain.warnings == Warnings::standard ? without_style_warnings(output)
                                                                      : output);
}

constexpr const char* kNotSeen =
    " is not a readable file of the sketch, its project, its libraries or the core: compilers see no other "
    "files of this machine. --libraries DIR names a folder of code that sketches share";

void check_seen(const fs::path& sketch, const Place& place, const std::string& header) {
  const fs::path named = header, from = (sketch / place.file).parent_path();
  std::error_code none;
  for (const fs::path& file : {from / named, sketch / named}) {
    const bool outside =
        named.is_absolute() || header.find("..") != header.npos || fs::is_symlink(file, none);
    if (outside) throw CompileError(place, header + kNotSeen);
  }
}

/// Returns whether the user has set a lower limit than Robosim's limit.
static bool has_lower_limit(int what, rlim_t ours) {
  rlimit limit{};
  ::getrlimit(static_cast<__rlimit_resource_t>(what), &limit);
  return limit.rlim_cur < ours;
}

// Throws CompileError for failures that the sandbox of a compiler has caused.
void fail_at_walls(const std::string& messages) {
  const auto says = [&](const char* text) { return messages.find(text) != std::string::npos; };
  if (says(kWaits))
    throw CompileError(
        fmt::format("the compiler was stopped because it only waited for {} s: expected files, got a "
                    "pipe or another special file",
                    kWaitSeconds));
  if (says(kTooMuchTime))
    throw CompileError(fmt::format(
        "the compilers were stopped: together they took more than {} s of processor time", kStepSeconds));
  if (says(kTimeExceeded))
    throw CompileError(fmt::format(
        "the compiler was stopped after {} s of processor time: the sketch keeps it busy for ever",
        kCompileSeconds));
  if (lacks_memory({1, messages}))
    throw CompileError(
        fmt::format("the compiler was stopped: it took more than {} MB of memory", kCompileBytes >> 20));
  if (says("File size limit exceeded") || says("File too large"))
    if (!has_lower_limit(RLIMIT_FSIZE, kMadeBytes))
      throw CompileError(
          fmt::format("the compiler was stopped: it wrote a file of more than {} MB", kMadeBytes >> 20));
  std::smatch match;
  static const std::regex by_assembler(
      R"(Error: (?:file not found: |can't open )([^\n:]*?)(?: for reading)?(?:\n|:|$))");
  if (std::regex_search(messages, match, by_assembler))
    throw CompileError("asm() names a file: " + match[1].str() + kNotSeen);
  static const std::regex by_compiler(
      R"((?:^|\n)([^\n: ][^\n:]*):(\d+):(\d+): (?:fatal error|error): ([^\n]*): Permission denied)");
  if (std::regex_search(messages, match, by_compiler))
    throw CompileError({match[1], number_in(match[2]), number_in(match[3])}, match[4].str() + kNotSeen);
}

namespace {

/// Finds the first error. Groups 2, 3 and 5 are file, line and column; the message begins at group 6.
bool find_error(const std::string& messages, std::smatch& match) {
  static const std::regex error(
      R"((^|\n)([^\n: ][^\n:]*):(\d+):((\d+):)? (fatal error|error|undefined reference|multiple definition))");
  return std::regex_search(messages, match, error);
}

Place place_of(const std::smatch& match) {
  return {match[2], number_in(match[3]), match[5].matched ? number_in(match[5]) : 0};
}

}  // namespace

Place first_error(const std::string& messages) {
  std::smatch match;
  return find_error(messages, match) ? place_of(match) : Place();
}

bool is_about_library(const std::string& messages, const std::vector<Library>& libraries) {
  const std::string file = first_error(messages).file;
  return std::any_of(libraries.begin(), libraries.end(), [&](const Library& library) {
    return file.rfind(library.folder.string() + "/", 0) == 0;
  });
}

std::string folded(const std::string& output) {
  constexpr std::ptrdiff_t kShownLines = 20;
  const std::string text = output.ends_with('\n') ? output : output + '\n';
  const std::ptrdiff_t lines = std::count(text.begin(), text.end(), '\n');
  if (lines <= kShownLines + 1) return output;
  std::string shown;
  std::ptrdiff_t messages = 0, count = 0;
  for (std::size_t at = 0, end; at < text.size() && count < kShownLines; at = end + 1) {
    end = text.find('\n', at);
    const std::string_view line = std::string_view(text).substr(at, end - at);
    const bool is_message = line.find(": warning: ") != line.npos || line.find("error: ") != line.npos;
    messages += is_message;
    if (messages > 1 && !is_message) continue;
    shown.append(line).append(1, '\n');
    ++count;
  }
  return shown + fmt::format("… {} more lines; robosim build prints all of them", lines - count);
}

void fail(const Toolchain& toolchain, const std::string& messages, std::string hint) {
  fail_at_walls(messages);
  check_machine("the compiler", messages);
  std::smatch match;
  if (!find_error(messages, match)) {
    if (messages.find(kTooMuchOutput) != std::string::npos)
      throw CompileError("the compiler was stopped: expected at most 16 MB of messages, got more");
    static const std::regex assembler(R"(([^\n:]+):(\d+): Error: ([^\n]*))");
    if (!toolchain.target.chip && std::regex_search(messages, match, assembler)) {
      // gcc records no source location for an asm() outside functions. The assembler's message then names the
      // file of the compiler's assembly.
      const std::string file = match[1];
      const Place place = file.ends_with(".s") ? Place() : Place{file, number_in(match[2])};
      throw CompileError(
          place, "asm() contains assembler of the chip (" + match[3].str() + "); build for the target avr");
    }
    static const std::regex unplaced(R"([^\n:]+\.s:\d+: Error: ([^\n]*))");
    if (std::regex_search(messages, match, unplaced))
      throw CompileError("asm() contains text that the chip's assembler rejects: " + match[1].str());
    throw CompileError((toolchain.all_messages ? messages : folded(messages)) +
                       (hint.empty() ? "" : "\nhint: " + hint));
  }
  if (hint.empty()) hint = hint_for(messages);
  const std::string text = messages.substr(static_cast<std::size_t>(match.position(6)));
  throw CompileError(place_of(match), (toolchain.all_messages ? text : folded(text)) +
                                          (hint.empty() ? "" : "\nhint: " + hint));
}

void fail_link(const Toolchain& toolchain, const GenuineCore& core, const Sketch& sketch,
               const std::vector<Object>& objects, const std::string& own_lines, std::string output) {
  fail_at_walls(output);
  check_machine("the linker", output);
  output = cut(output);
  if (toolchain.target.chip) check_room(toolchain, sketch, output);
  for (const Object& object : objects)
    replace_all(output, object.path.string() + " (symbol from plugin)", object.name);
  // If the linker knows no line number, it names the function instead. Removes that name.
  static const std::regex in_function(R"((: [Ii]n function [^\n]*\n\(|:\()[.]text[^)]*\): )");
  output = std::regex_replace(output, in_function, ": ");
  // Puts the first definition on its own line, as GNU ld before 2.35 does.
  static const std::regex first_definition(R"((multiple definition of [^\n]*'); ([^\n]*first defined here))");
  output = std::regex_replace(output, first_definition, "$1\n$2");
  const std::string messages = with_names_of_core(toolchain, readable(toolchain, sketch.folder, output));
  for (const char* function : {"setup", "loop"})
    if (messages.find(fmt::format("undefined reference to `{}'", function)) != std::string::npos)
      throw CompileError(
          {sketch.inos.empty() ? sketch.name : sketch.inos[0]},
          fmt::format("the sketch has no function {}(); every sketch needs setup() and loop()", function));
  const BoardSpec& board = toolchain.board;
  const ChipSpec& chip = *(toolchain.target.chip ? board : host_model(board)).chip;
  fail(toolchain, messages, vector_hint(messages, own_lines, board, {chip, core.avr_libc}));
}

void fail_for_changes(const Toolchain& toolchain, const fs::path& saved, const std::string& assembly,
                      const std::string& messages) {
  write_file(saved, assembly);
  const std::size_t error = messages.find("Error: ");
  throw std::runtime_error(fmt::format(
      "{} rejects the assembly that Robosim has generated: {}; please report this with the file {}",
      assembler_name(toolchain.compiler),
      error == messages.npos ? messages : messages.substr(error, messages.find('\n', error) - error),
      saved.string()));
}

}  // namespace robosim::build
