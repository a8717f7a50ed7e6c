// From what a user names to what a runner is asked. Everything that starts a run goes this way, so that the
// same names mean the same run in a command, a check, a session and a test.
//
//   Launch launch;
//   launch.sketch = "PidFollower"; launch.target = "avr"; launch.request.goal = "laps:3";
//   Launcher launcher;
//   const Prepared run = launcher.prepare(launch, choose(launch), describe, runner.hello());
//   runner.run(run.request);
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "sim/build/sketch.h"
#include "sim/launch/fit_robot.h"
#include "sim/launch/names.h"
#include "sim/wire/messages.h"

namespace robosim::launch {

/// What a user names. Empty names are chosen for the user: see choose_sketch, choose_map, choose_robot and
/// choose_target in names.h.
struct Launch {
  std::string sketch;
  std::string map;
  std::string robot;
  std::string target;
  std::string environment;             ///< of platformio.ini, or a profile of sketch.yaml
  std::vector<std::string> libraries;  ///< folders
  bool sanitize = false;               ///< the sketch checks itself
  bool count_lines = false;            ///< which of the sketch's lines run
  bool untrusted = false;              ///< somebody else's: what this machine cannot confine is not run
  wire::RunRequest request;            ///< goal, seed …; image, map and robot are put in by Launcher
};

/// The files that the names stand for.
struct Chosen {
  SketchChoice sketch;
  Choice map;
  Choice robot;
  std::string target;
};

/// Throws InputError for a name of nothing, and for a target that the sketch cannot be run on.
Chosen choose(const Launch& launch);

struct Prepared {
  SketchChoice sketch;
  Choice map;
  Choice robot;  ///< with the board that it carries for this target
  std::string target;
  wire::RobotInfo robot_info;
  build::Request wanted;  ///< what the image was built from; of a finished image, what it would have been
  build::Image image;
  wire::RunRequest request;
  std::string remark;  ///< what its result will lack, once there is one; empty = nothing
};

/// Who is told what happens meanwhile; any may be empty.
struct Listener {
  std::function<void(const std::string& sentence)> chosen;   ///< for the user, who has named nothing
  std::function<void(const std::string& sentence)> lacking;  ///< what this machine cannot confine (trust.h)
  std::function<void(const std::string& sketch)> compiling;
  /// While `compiling`: that of a board, for a target, is not there yet.
  std::function<void(const std::string& board, const std::string& target)> compiling_core;
  std::function<void(const build::Image&)> compiled;
};

/// A finished .elf as it is; anything else compiled. Throws InputError and ToolMissing.
build::Image image_of(const SketchChoice& sketch, const build::Request& request, const Listener& listener);

/// Prepares runs. What several of them share is compiled and told once.
class Launcher {
 public:
  explicit Launcher(Listener listener = {}) : listener_(std::move(listener)) {}

  /// `runner`: who will run it, or the host's. Throws InputError, ToolMissing, and what `describe` throws.
  Prepared prepare(const Launch& launch, Chosen chosen, const Describe& describe, const wire::Hello& runner);

 private:
  void tell(const std::function<void(const std::string&)>& to, const std::string& sentence);
  const build::Image& image(const SketchChoice& sketch, const build::Request& request);

  Listener listener_;
  std::set<std::string> told_;
  std::map<std::string, build::Image> images_;
};

}  // namespace robosim::launch
