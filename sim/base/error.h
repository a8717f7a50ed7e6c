// Reports invalid input in one sentence: where, what was found, what is allowed.
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

/// Returns "robot.toml:12:3", as compilers write it, without unknown parts.
std::string to_string(const Place& place);

/// The process's exit statuses, the same for every command.
enum class ExitStatus : int {
  ok = 0,            ///< goal reached, or the check holds
  failed = 1,        ///< lost, stuck, toppled, hung, ended, crashed, over_budget, or a difference found
  bad_input = 2,     ///< usage, bad file, sketch does not compile
  internal = 3,      ///< an internal error of Robosim
  timeout = 4,       ///< simulated time is up
  tool_missing = 5,  ///< a tool is missing; how to install it is printed. Or the machine lacks something else
  interrupted = 130,
};

/// Reports invalid input of the user. what() reads "PLACE: MESSAGE".
class InputError : public std::runtime_error {
 public:
  InputError(Place place, const std::string& message);
  explicit InputError(const std::string& message) : InputError(Place{}, message) {}
  const Place& place() const { return place_; }
  /// Returns the sentence without its place.
  const std::string& message() const { return message_; }

 private:
  Place place_;
  std::string message_;
};

/// Reports a missing program; the message names its Debian package. Also thrown if the machine lacks
/// something else, such as disk space.
class ToolMissing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Lists what is allowed, for messages: "one, two or three".
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
