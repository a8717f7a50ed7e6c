// Receives the progress of a long task.
#pragma once

#include <string>

namespace robosim {

/// Receives sentences about the progress of a task, for a person who waits. This base class ignores the
/// sentences.
class Progress {
 public:
  virtual ~Progress() = default;
  /// Called when a new part of the task begins.
  virtual void say(const std::string& /*text*/) {}
  /// Called often, with a text that changes only slightly.
  virtual void update(const std::string& /*text*/) {}
  /// Called before something else is shown, and at the end of the task.
  virtual void clear() {}
};

}  // namespace robosim
