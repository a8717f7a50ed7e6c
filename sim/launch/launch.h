// Makes a request for a runner from the names that the user typed. All code that starts a run uses this code.
// Therefore equal names mean the same run in a command, a check, a session and a test.
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

/// The user's names. If a name is empty, the choice is automatic: see choose_sketch, choose_map, choose_robot
/// and choose_target in names.h.
struct Launch {
  std::string sketch;
  std::string map;
  std::string robot;
  std::string target;
  std::string environment;             ///< environment of platformio.ini, or profile of sketch.yaml
  std::vector<std::string> libraries;  ///< folders of libraries
  bool sanitize = false;               ///< run-time checks in the sketch
  bool count_lines = false;            ///< counts which of the sketch's lines run
  bool untrusted = false;              ///< sketch by a stranger: not run if this machine cannot confine it
  wire::RunRequest request;            ///< goal, seed …; Launcher adds image, map and robot
};

/// The files that the names refer to.
struct Chosen {
  SketchChoice sketch;
  Choice map;
  Choice robot;
  std::string target;
};

/// Finds the files. Throws InputError for an unknown name, and for a target that cannot run the sketch.
Chosen choose(const Launch& launch);

struct Prepared {
  SketchChoice sketch;
  Choice map;
  Choice robot;  ///< with the board for this target
  std::string target;
  wire::RobotInfo robot_info;
  build::Request wanted;  ///< settings for building the image; unused if the sketch is an .elf or .hex
  build::Image image;
  wire::RunRequest request;
  std::string remark;  ///< a sentence on data that the result will lack; empty = none
};

/// Receives reports during preparation; any function may be empty.
struct Listener {
  std::function<void(const std::string& sentence)> chosen;  ///< sentences on automatic choices
  std::function<void(const std::string& sentence)>
      lacking;  ///< sentences on doubtful choices and on missing confinement
  std::function<void(const std::string& sketch)> compiling;
  /// Called after `compiling` if the Arduino core for the board and target must be compiled, too.
  std::function<void(const std::string& board, const std::string& target)> compiling_core;
  std::function<void(const build::Image&)> compiled;
};

/// Returns a finished .elf unchanged, and otherwise compiles the sketch. Throws InputError and ToolMissing.
build::Image image_of(const SketchChoice& sketch, const build::Request& request, const Listener& listener);

/// Reads a script file. Throws InputError.
std::string script_text(const std::string& file);

/// Prepares runs. Work that several runs share is done and reported once.
class Launcher {
 public:
  explicit Launcher(Listener listener = {}) : listener_(std::move(listener)) {}

  /// Prepares a run. `runner` is the first message of the runner that will execute the run, or of the host's
  /// runner. Throws InputError, ToolMissing, and the exceptions of `describe`.
  Prepared prepare(const Launch& launch, Chosen chosen, const Describe& describe, const wire::Hello& runner);

 private:
  void tell(const std::function<void(const std::string&)>& to, const std::string& sentence);
  const build::Image& image(const SketchChoice& sketch, const build::Request& request);

  Listener listener_;
  std::set<std::string> told_;
  std::map<std::string, build::Image> images_;
};

}  // namespace robosim::launch
