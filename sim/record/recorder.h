// What listens to a run and leaves a file behind: a table, a wave, a page, a picture. The file's ending says
// which.
//
//   Recorders recorders({"run.csv", "run.html"});
//   recorders.ask(request);            // what they want to hear of
//   recorders.begin(run);
//   … recorders.add(event) for each event …
//   recorders.finish(result);          // now the files are there
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/wire/messages.h"

namespace robosim::record {

/// How often a recording takes a sample, simulated time.
constexpr std::int64_t kRecordEvery_ns = 10'000'000;

/// One of several robots.
struct RecordedRobot {
  std::string name, sketch, robot, target;
  wire::RobotInfo info;
};

/// The run that is recorded, as it is known before it begins. Names are as the user typed them.
struct RecordedRun {
  std::string robosim;  ///< version
  std::string sketch;
  std::string map;
  std::string robot;
  std::string target;
  wire::RobotInfo robot_info;
  wire::RunRequest request;
  std::vector<RecordedRobot> robots = {};  ///< where there are several: all, the first one too
};

class Recorder {
 public:
  virtual ~Recorder() = default;
  Recorder() = default;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Adds to a request what it wants to hear of. No result depends on that.
  virtual void ask(wire::RunRequest& request) const;
  /// Before the first event. Throws InputError.
  virtual void begin(const RecordedRun&) {}
  virtual void add(const wire::Event& event) = 0;
  /// Writes the file, whole or not at all. Throws InputError.
  virtual void finish(const wire::RunResult& result) = 0;
};

/// The endings of files that there is a recorder for: ".csv", ".html" …
const std::vector<std::string>& record_endings();
/// Throws InputError naming the endings of pictures if the file has another.
void check_is_picture(const std::filesystem::path& file);

/// Throws InputError naming the endings that exist if the file has another.
std::unique_ptr<Recorder> make_recorder(const std::filesystem::path& file);

/// Several of them, each with its file.
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
  std::vector<std::unique_ptr<Recorder>> recorders_;  ///< of each
};

}  // namespace robosim::record
