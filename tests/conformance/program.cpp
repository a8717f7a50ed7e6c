#include "tests/conformance/program.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "hal/board/board_spec.h"
#include "sim/base/elf/elf_file.h"
#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace robosim::conformance {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error(file.filename().string() + ": " + what);
}

std::vector<std::optional<std::uint8_t>> bytes_of(const std::filesystem::path& file,
                                                  const std::string& text) {
  std::vector<std::optional<std::uint8_t>> bytes;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word == "..") {
      bytes.push_back(std::nullopt);
      continue;
    }
    std::size_t used = 0;
    const unsigned long value = std::stoul(word, &used, 16);
    if (used != word.size() || value > 0xFF) refuse(file, "'" + word + "' is not a hexadecimal byte");
    bytes.push_back(static_cast<std::uint8_t>(value));
  }
  return bytes;
}

/// The reasons why a program fails on the host. A name of the feature may follow after ": ".
constexpr const char* kHostReasons[] = {"assembler",   "cycles",        "memory",
                                        "boot loader", "not simulated", "differs"};

std::string reason_of(const std::filesystem::path& file, const std::string& text) {
  const std::string reason = text.substr(0, text.find(": "));
  if (std::find(std::begin(kHostReasons), std::end(kHostReasons), reason) == std::end(kHostReasons))
    refuse(file, "Host: '" + reason + "' is no reason of program.cpp");
  return text;
}

Program read(const std::filesystem::path& file) {
  Program program;
  program.file = file;
  program.name = file.stem().string();
  std::ifstream in(file);
  bool has_expectation = false;
  for (std::string line; std::getline(in, line) && line.rfind("//", 0) == 0;) {
    const std::string text = line.size() > 3 ? line.substr(3) : "";
    const auto field = [&](const char* name) -> std::optional<std::string> {
      const std::string start = std::string(name) + ": ";
      if (text.rfind(start, 0) != 0) return std::nullopt;
      return text.substr(start.size());
    };
    if (const auto source = field("Source")) {
      program.source = *source;
    } else if (const auto expected = field("Expect")) {
      program.expected = bytes_of(file, *expected);
      has_expectation = true;
    } else if (const auto chips = field("Chips")) {
      std::istringstream names(*chips);
      program.chips.assign(std::istream_iterator<std::string>(names), {});
    } else if (const auto ends = field("Ends")) {
      program.cycles = std::stoull(*ends);
    } else if (const auto loop = field("Loop")) {
      program.loop = std::stoi(*loop);
    } else if (const auto host = field("Host")) {
      program.host = reason_of(file, *host);
    } else if (program.source.empty()) {
      program.sentence += (program.sentence.empty() ? "" : " ") + text;
    }
  }
  if (program.sentence.empty()) refuse(file, "the required behaviour is missing");
  if (program.source.empty()) refuse(file, "Source: is missing");
  if (!has_expectation) refuse(file, "Expect: is missing");
  return program;
}

template <typename Bytes, typename Text>
std::string joined(const Bytes& bytes, Text text) {
  std::string all;
  for (const auto& byte : bytes) all += (all.empty() ? "" : " ") + text(byte);
  return all;
}

std::string hex(std::uint8_t byte) {
  constexpr char kDigits[] = "0123456789abcdef";
  return {kDigits[byte >> 4], kDigits[byte & 15]};
}

}  // namespace

const ChipSpec& chip_named(const std::string& name) {
  for (int i = 0; const BoardSpec* board = board_at(i); ++i)
    if (name == board->chip->compiler_name) return *board->chip;
  throw std::runtime_error("no board has a chip " + name);
}

std::vector<Program> programs_in(const std::filesystem::path& folder) {
  std::vector<Program> programs;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".c") programs.push_back(read(entry.path()));
  std::sort(programs.begin(), programs.end(),
            [](const Program& a, const Program& b) { return a.name < b.name; });
  return programs;
}

std::vector<std::uint8_t> compile(const Program& program, const std::string& chip) {
  const test::TemporaryFolder folder;
  const auto image = folder.path() / "program.elf", errors = folder.path() / "errors";
  const std::string command = "avr-gcc -mmcu=" + chip + " -Os -std=gnu11 -Wall -Werror -o '" +
                              image.string() + "' '" + program.file.string() + "' 2>'" + errors.string() +
                              "'";
  if (std::system(command.c_str()) != 0) refuse(program.file, "does not compile: " + read_file(errors));
  const ElfFile elf(read_file(image), image.string());
  std::vector<std::uint8_t> flash;
  for (const ElfSegment& segment : elf.segments()) {
    if (segment.address >= 0x800000) continue;
    flash.resize(std::max<std::size_t>(flash.size(), segment.address + segment.bytes.size()), 0xFF);
    std::copy(segment.bytes.begin(), segment.bytes.end(),
              flash.begin() + static_cast<std::ptrdiff_t>(segment.address));
  }
  return flash;
}

std::string text_of(const std::vector<std::optional<std::uint8_t>>& bytes) {
  return joined(bytes, [](const auto& byte) { return byte ? hex(*byte) : std::string(".."); });
}

std::string text_of(const std::vector<std::uint8_t>& bytes) { return joined(bytes, hex); }

bool is_right(const Program& program, const Report& report) {
  return report.ended && std::equal(program.expected.begin(), program.expected.end(), report.bytes.begin(),
                                    report.bytes.end(), [](const auto& want, std::uint8_t have) {
                                      return !want || *want == have;
                                    });
}

bool is_for(const Program& program, const std::string& chip) {
  return std::find(program.chips.begin(), program.chips.end(), chip) != program.chips.end();
}

}  // namespace robosim::conformance
