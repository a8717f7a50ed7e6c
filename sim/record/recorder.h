// Listens to a run and writes a file: a table, a wave, a page, a picture. The file's ending selects the
// format.
//
//   Recorders recorders({"run.csv", "run.html"});
//   recorders.ask(request);            // subscribes to the events that they need
//   recorders.begin(run);
//   … recorders.add(event) for each event …
//   recorders.finish(result);          // writes the files
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/wire/messages.h"

namespace robosim::record {

/// The sample period of recordings, simulated time.
constexpr std::int64_t kRecordEvery_ns = 10'000'000;

/// A robot of several.
struct RecordedRobot {
  std::string name, sketch, robot, target;
  wire::RobotInfo info;
};

/// The recorded run, as known before it begins. Names are as the user typed them.
struct RecordedRun {
  std::string robosim;  ///< version
  std::string sketch;
  std::string map;
  std::string robot;
  std::string target;
  wire::RobotInfo robot_info;
  wire::RunRequest request;
  std::vector<RecordedRobot> robots = {};  ///< if there are several: all, including the first one
};

class Recorder {
 public:
  virtual ~Recorder() = default;
  Recorder() = default;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Subscribes to the events that it needs. No result depends on that.
  virtual void ask(wire::RunRequest& request) const;
  /// Called before the first event. Throws InputError.
  virtual void begin(const RecordedRun&) {}
  virtual void add(const wire::Event& event) = 0;
  /// Writes the file, completely or not at all. Throws InputError.
  virtual void finish(const wire::RunResult& result) = 0;
};

/// Returns the supported endings of files: ".csv", ".html" …
const std::vector<std::string>& record_endings();
/// Throws InputError, with the endings of pictures, for a file with another one.
void check_is_picture(const std::filesystem::path& file);

/// Returns the recorder for a file. Throws InputError, with the supported endings, for another one.
std::unique_ptr<Recorder> make_recorder(const std::filesystem::path& file);

/// Several recorders, each with its file.
class Recorders {
 public:
  Recorders() = default;
  /// Throws as make_recorder() does.
  explicit Recorders(const std::vector<std::string>& files);

  bool empty() const { return recorders_.empty(); }
  void ask(wire::RunRequest& request) const;
  void begin(const RecordedRun& run);
  void add(const wire::Event& event);
  void finish(const wire::RunResult& result);

 private:
  std::vector<std::string> files_;
  std::vector<std::unique_ptr<Recorder>> recorders_;  ///< per file
};

}  // namespace robosim::record
