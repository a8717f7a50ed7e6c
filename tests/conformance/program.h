// Reads, compiles and runs programs for a chip. Their reports (avr/report.h) decide whether the core conforms
// to the data sheet.
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
  std::string sentence;                               ///< what must hold
  std::string source;                                 ///< "DS40002061B, 15.7.2"
  std::vector<std::optional<std::uint8_t>> expected;  ///< none: any
  std::uint64_t cycles = 100000;                      ///< after which it is stopped
  std::vector<std::string> chips{"atmega328p"};       ///< the chips for which it holds, as avr-gcc calls them
  int loop = -1;                                      ///< the USART whose TX is wired to its RX; -1 = none
};

/// The chip that avr-gcc calls so. Throws std::runtime_error where no board has it.
const ChipSpec& chip_named(const std::string& name);

/// Returns all programs of a folder, by name. Throws std::runtime_error if one lacks its sentence, source or
/// expectation.
std::vector<Program> programs_in(const std::filesystem::path& folder);

/// Returns the program's flash, compiled by avr-gcc for a chip ("atmega328p"). Throws std::runtime_error with
/// the compiler's message.
std::vector<std::uint8_t> compile(const Program& program, const std::string& chip);

/// Formats bytes as "05 .. ff".
std::string text_of(const std::vector<std::optional<std::uint8_t>>& bytes);
std::string text_of(const std::vector<std::uint8_t>& bytes);
/// Prints a program for gtest.
inline void PrintTo(const Program& program, std::ostream* out) { *out << program.name; }

bool matches(const std::vector<std::optional<std::uint8_t>>& expected,
             const std::vector<std::uint8_t>& reported);

}  // namespace robosim::conformance
