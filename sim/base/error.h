// Reports invalid input in one sentence: the place, the value found, and the values allowed.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace robosim {

/// A place in a file that the user wrote. Line and column count from 1; 0 = unknown.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// Returns a place in the format of compilers, "robot.toml:12:3", without unknown parts.
std::string to_string(const Place& place);

/// The exit statuses of all commands.
enum class ExitStatus : int {
  ok = 0,            ///< goal reached, or check passed
  failed = 1,        ///< lost, stuck, toppled, hung, ended, crashed, over_budget, or a difference found
  bad_input = 2,     ///< usage, bad file, sketch does not compile
  internal = 3,      ///< internal error in Robosim
  timeout = 4,       ///< simulated time limit reached
  tool_missing = 5,  ///< missing tool (with an installation hint), or another fault of the machine
  interrupted = 130,
};

/// Reports invalid user input. what() returns "PLACE: MESSAGE".
class InputError : public std::runtime_error {
 public:
  InputError(Place place, const std::string& message);
  explicit InputError(const std::string& message) : InputError(Place{}, message) {}
  const Place& place() const { return place_; }
  /// Returns the message without the place.
  const std::string& message() const { return message_; }

 private:
  Place place_;
  std::string message_;
};

/// Reports a missing program; the message names its Debian package. Also reports other faults of the machine,
/// such as missing disk space.
class ToolMissing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Lists allowed names for messages: "one, two or three".
template <typename Names>
std::string one_of(const Names& names) {
  std::string text;
  std::size_t left = std::size(names);
  for (const auto& name : names) {
    text += name;
    --left;
    if (left) text += left == 1 ? " or " : ", ";
  }
  return text;
}

}  // namespace robosim
