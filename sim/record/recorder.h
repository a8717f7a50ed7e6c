// Listens to a run and writes a file: a table, a waveform, a page or a picture. The file name extension
// selects the format.
//
//   Recorders recorders({"run.csv", "run.html"});
//   recorders.ask(request);            // subscribes to the events that the recorders need
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

/// The sample period of recordings, in simulated time.
constexpr std::int64_t kRecordEvery_ns = 10'000'000;

/// One of several robots.
struct RecordedRobot {
  std::string name, sketch, robot, target;
  wire::RobotInfo info;
};

/// The recorded run, as known before it begins. Names are as the user typed them.
struct RecordedRun {
  std::string robosim;  ///< version of Robosim
  std::string sketch;
  std::string map;
  std::string robot;
  std::string target;
  wire::RobotInfo robot_info;
  wire::RunRequest request;
  std::vector<RecordedRobot> robots = {};  ///< empty if there is only one robot; otherwise all robots
};

class Recorder {
 public:
  virtual ~Recorder() = default;
  Recorder() = default;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Subscribes to the events that this recorder needs. The subscription does not affect the run's result.
  virtual void ask(wire::RunRequest& request) const;
  /// Receives the description of the run, before the first event. Throws InputError.
  virtual void begin(const RecordedRun&) {}
  virtual void add(const wire::Event& event) = 0;
  /// Writes the whole file, or nothing. Throws InputError.
  virtual void finish(const result::RunResult& result) = 0;
};

/// Returns the supported file name extensions: ".csv", ".html" …
const std::vector<std::string>& record_endings();
/// Throws InputError if the file name does not have the extension of a picture. The message lists the valid
/// extensions.
void check_is_picture(const std::filesystem::path& file);

/// Returns the recorder for a file. Throws InputError if the extension is unknown. The message lists the
/// supported extensions.
std::unique_ptr<Recorder> make_recorder(const std::filesystem::path& file);

/// Several recorders, one for each file.
class Recorders {
 public:
  Recorders() = default;
  /// Throws the same errors as make_recorder().
  explicit Recorders(const std::vector<std::string>& files);

  bool empty() const { return recorders_.empty(); }
  void ask(wire::RunRequest& request) const;
  void begin(const RecordedRun& run);
  void add(const wire::Event& event);
  void finish(const result::RunResult& result);

 private:
  std::vector<std::string> files_;
  std::vector<std::unique_ptr<Recorder>> recorders_;  ///< one per file
};

}  // namespace robosim::record
