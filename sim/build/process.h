// Runs compilers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::build {

class Walls;

struct Command {
  std::vector<std::string> words;                   ///< program, by its absolute path, and arguments
  std::filesystem::path folder;                     ///< working folder
  std::filesystem::path input;                      ///< standard input; empty = none
  std::filesystem::path scratch;                    ///< the folder of its output
  const Walls* walls = nullptr;                     ///< what it may see; null = all that we may
  std::size_t most_output = std::size_t{16} << 20;  ///< bytes; a program with more output is killed
};

/// The first line of the output of a program that was killed because of too much output.
constexpr const char* kTooMuchOutput = "robosim: more output than is read";

struct CommandResult {
  int status = 0;      ///< exit status; 128 + signal if a signal ended it
  std::string output;  ///< standard output and standard error, interleaved
};

/// Runs all of them, several at a time, and waits for all. Results are in the order of the commands. Messages
/// are in English and __DATE__ is 1 January 1970, so that equal input gives equal output. The environment of
/// a confined program has only $PATH, and the scratch folder as $HOME and $TMPDIR. Others lose the variables
/// that add include paths. Throws InputError for an argument that begins with '@': compilers read a file of
/// that name as more arguments.
std::vector<CommandResult> run(const std::vector<Command>& commands);
CommandResult run(const Command& command);
/// Confines each separately: it sees `read`, and no other command writes its scratch folder.
std::vector<CommandResult> run_within(const std::vector<std::filesystem::path>& read,
                                      std::vector<Command> commands);

/// Returns the program of that name on $PATH; empty if there is none.
std::filesystem::path find_program(const std::string& name);

}  // namespace robosim::build
