// Reads and compiles programs for a chip. Their reports (avr/report.h) decide whether an emulator conforms to
// the chip's data sheet.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "hal/board/chip_spec.h"

namespace robosim::conformance {

struct Program {
  std::filesystem::path file;
  std::string name;                                   ///< name of the file, without its ending
  std::string sentence;                               ///< the required behaviour
  std::string source;                                 ///< "DS40002061B, 15.7.2"
  std::vector<std::optional<std::uint8_t>> expected;  ///< nullopt matches any byte
  std::uint64_t cycles = 100000;                      ///< the program is stopped after this number
  std::vector<std::string> chips{"atmega328p"};       ///< the chips with this behaviour, by avr-gcc name
  int loop = -1;                                      ///< the USART whose TX is connected to its RX, or -1
  std::string host;  ///< why the program fails on the host; empty = it passes
};

/// A program's report, and whether the program reached its end.
struct Report {
  std::vector<std::uint8_t> bytes;
  bool ended = false;
};

/// Returns whether the program ended, and reported what it must.
bool is_right(const Program& program, const Report& report);

/// Returns the chip with this avr-gcc name. Throws std::runtime_error if no board has this chip.
const ChipSpec& chip_named(const std::string& name);

/// Returns all programs of a folder, sorted by name. Throws std::runtime_error if a program has no sentence,
/// source or expectation, or an unknown reason to fail on the host.
std::vector<Program> programs_in(const std::filesystem::path& folder);

/// Returns whether the chip with the avr-gcc name `chip` has the behaviour that the program requires.
bool is_for(const Program& program, const std::string& chip);

/// Compiles the program by avr-gcc for a chip ("atmega328p"), and returns the content of its flash. Throws
/// std::runtime_error with the compiler's message.
std::vector<std::uint8_t> compile(const Program& program, const std::string& chip);

/// Formats bytes in hexadecimal, such as "05 .. ff"; ".." is a byte that may have any value.
std::string text_of(const std::vector<std::optional<std::uint8_t>>& bytes);
std::string text_of(const std::vector<std::uint8_t>& bytes);
/// Prints a program for gtest.
inline void PrintTo(const Program& program, std::ostream* out) { *out << program.name; }

}  // namespace robosim::conformance
