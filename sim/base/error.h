// Bad input, reported in one sentence: where, what was found, what is allowed.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace robosim {

/// A place in something the user wrote. Line and column count from 1; 0 = not known.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// "robot.toml:12:3", as compilers write it; the known parts only.
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

/// Something the user gave is wrong. what() reads "PLACE: MESSAGE".
class InputError : public std::runtime_error {
 public:
  InputError(Place place, const std::string& message);
  explicit InputError(const std::string& message) : InputError(Place{}, message) {}
  const Place& place() const { return place_; }
  /// The sentence without its place.
  const std::string& message() const { return message_; }

 private:
  Place place_;
  std::string message_;
};

/// A program that Robosim needs is not there: the message names the Debian package that brings it. Or the
/// machine lacks something else, such as room on a disk.
class ToolMissing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "one, two or three": how messages list what is allowed.
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
