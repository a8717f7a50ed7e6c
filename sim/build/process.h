// Runs compilers.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/base/program_sandbox.h"

namespace robosim::build {

struct Command {
  std::vector<std::string> words;                   ///< program, by its absolute path, and arguments
  std::filesystem::path folder;                     ///< working folder
  std::filesystem::path input;                      ///< standard input; empty = none
  std::filesystem::path scratch;                    ///< the folder of its output
  const ProgramSandbox* walls = nullptr;            ///< what it may see; nothing = what we may
  std::size_t most_output = std::size_t{16} << 20;  ///< bytes; a program with more output is killed
  int most_wait_s = kWaitSeconds;                   ///< of wall time in which it hardly works, within walls
  std::size_t most_memory = 0;                      ///< bytes, within walls; 0 = kCompileBytes
};

/// The first line of the output of a program that was killed because of too much output.
constexpr const char* kTooMuchOutput = "robosim: too much output";
/// And of the last that was started, where all together took more than kStepSeconds.
constexpr const char* kTooMuchTime = "robosim: too much processor time of all programs together";
/// And of one that was killed because it hardly worked for kWaitSeconds.
constexpr const char* kWaits = "robosim: the program waits for input that never comes";
/// gcc's message about a program that took more than kCompileSeconds.
constexpr const char* kTimeExceeded = "CPU time limit exceeded";

struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

struct CommandResult {
  int status = 0;      ///< exit status; 128 + signal if a signal ended it
  std::string output;  ///< standard output and standard error, interleaved
};

/// Returns whether the program failed with a message that it got no memory.
bool lacks_memory(const CommandResult& result);

/// Runs all of them, several at a time, and waits for all. Results are in the order of the commands. Messages
/// are in English and __DATE__ is 1 January 1970, so that equal input gives equal output. The environment of
/// a confined program has only $PATH, and the scratch folder as $HOME and $TMPDIR. Others lose the variables
/// that add include paths. Throws InputError for an argument that begins with '@': compilers read a file of
/// that name as more arguments.
/// Throws Interrupted if SIGINT or SIGTERM has ended one.
std::vector<CommandResult> run(const std::vector<Command>& commands);
CommandResult run(const Command& command);
/// Runs each within walls of its own: it sees `read`, and no other command writes its scratch folder.
/// Programs that run at the same time share kCompileBytes. One that needs more than its part runs again,
/// alone. After a program that has exceeded its processor time no other is started.
std::vector<CommandResult> run_within(const std::vector<std::filesystem::path>& read,
                                      std::vector<Command> commands);

using robosim::find_program;

}  // namespace robosim::build
