// Runs compilers and other programs of a build, several at a time.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/base/program_sandbox.h"

namespace robosim::build {

struct Command {
  std::vector<std::string> words;         ///< program, as an absolute path, and its arguments
  std::filesystem::path folder;           ///< working folder
  std::filesystem::path input;            ///< standard input; empty = none
  std::filesystem::path scratch;          ///< folder for the files that the program writes
  const ProgramSandbox* walls = nullptr;  ///< accessible files; null = all that Robosim can access
  /// Limit, in bytes, of the output of all programs of one run() together. A program that exceeds the limit
  /// is killed.
  std::size_t most_output = std::size_t{16} << 20;
  int most_wait_s = kWaitSeconds;  ///< wall time after which an idle sandboxed program is killed
  std::size_t most_memory = 0;     ///< in bytes, for a sandboxed program; 0 = kCompileBytes
  std::vector<std::filesystem::path> read = {};  ///< for run_within(): files that only this program can read
};

/// First line of the output of a program that was killed because of too much output.
constexpr const char* kTooMuchOutput = "robosim: too much output";
/// First line of the output of a program that ended after all programs together had exceeded kStepSeconds.
constexpr const char* kTooMuchTime = "robosim: too much processor time of all programs together";
/// First line of the output of a program that was killed because it hardly used a processor for most_wait_s.
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

/// Returns whether the program failed with a message about missing memory.
bool lacks_memory(const CommandResult& result);

/// Runs all commands, several at a time, and waits for all. Results are in the order of the commands.
/// Messages are in English and __DATE__ is 1 January 1970, so that equal input gives equal output.
///
/// A sandboxed program gets only $PATH from the user's environment; $HOME and $TMPDIR are the scratch folder.
/// Other programs get the user's environment without the variables that affect compilers, such as $CPATH.
///
/// Throws InputError for an argument that begins with '@', because compilers would read more arguments from
/// the file that it names. Throws Interrupted if SIGINT or SIGTERM has ended a program.
std::vector<CommandResult> run(const std::vector<Command>& commands);
CommandResult run(const Command& command);
/// Runs each command in its own sandbox. The command can read the files in `read`, and no other command can
/// write to its scratch folder. Programs that run at the same time share kCompileBytes of memory. A program
/// that needs more than its share runs again, alone. After a program has exceeded the limit of processor
/// time or of output, no other program is started.
std::vector<CommandResult> run_within(const std::vector<std::filesystem::path>& read,
                                      std::vector<Command> commands);

using robosim::find_program;

}  // namespace robosim::build
