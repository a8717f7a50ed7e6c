// Running compilers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::build {

class Walls;

struct Command {
  std::vector<std::string> words;  ///< program, by its absolute path, and arguments
  std::filesystem::path folder;    ///< working folder
  std::filesystem::path input;     ///< standard input; empty = none
  const Walls* walls = nullptr;    ///< what it may see; nothing = what we may
};

struct CommandResult {
  int status = 0;      ///< exit status; 128 + signal where a signal ended it
  std::string output;  ///< standard output and standard error, as they came
};

/// Runs all of them, several at a time, and waits for all. Results are in the order of the commands.
/// Messages are in English, environment variables that add include paths are dropped, and __DATE__ is 1
/// January 1970, so that equal input gives equal output.
std::vector<CommandResult> run(const std::vector<Command>& commands);
CommandResult run(const Command& command);

/// The program of that name on $PATH; empty if there is none.
std::filesystem::path find_program(const std::string& name);

}  // namespace robosim::build
