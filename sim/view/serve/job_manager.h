// Runs the simulations that the web page of `robosim serve` requests. Each simulation is a separate process
// `robosim run`, or `robosim run --live` if it is watched live. Its replay page is stored for the browser.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/child.h"
#include "sim/base/file_scope.h"
#include "sim/view/serve/folder.h"

namespace robosim::serve {

/// A run, as requested by the page.
struct RunForm {
  std::string sketch, robot, map;  ///< from Choices; "" for robot and map: the defaults of `robosim run`
  std::string target = "host";     ///< host, avr or stm32
  std::uint64_t seed = 1;
  double for_s = 60.0;  ///< simulated time, 0.001 to 3600
  std::string goal;     ///< "" = the map's goal
  std::string script;   ///< script of the robot, or of each robot that is not in `scripts`
  std::map<std::string, std::string> scripts;  ///< if there are several robots: scripts by robots' names
};

/// Parses the JSON of a request. Throws InputError if it is invalid, has other keys, or names anything
/// outside of the choices.
RunForm read_run_form(const std::string& json, const Choices& choices);

/// A temporary folder for the pages of runs. If this server is killed, the user's next server removes the
/// folder.
class PageFolder {
 public:
  PageFolder();
  ~PageFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Descriptor held_;
};

class JobManager {
 public:
  static constexpr int kAtOnce = 2;            ///< maximum number of simultaneous runs
  static constexpr std::size_t kKept = 8;      ///< maximum number of stored pages of runs
  static constexpr double kLongest_s = 600.0;  ///< wall time, including compilation
  static constexpr double kLongestLive_s = 3600.0;

  /// `robosim` is the path of the program. Stores pages in a temporary folder as long as this object exists.
  JobManager(std::filesystem::path robosim, std::filesystem::path folder);

  /// The result of a run.
  struct Done {
    int status = 0;        ///< exit status of `robosim run`
    int recording = 0;     ///< number of the recording, for page_of; 0 = none
    std::string sentence;  ///< why the run was stopped; "" = it ended by itself
  };
  /// Returns the result of a run that cannot start because kAtOnce others are running.
  static Done busy() { return {5, 0, "too many runs at once: try again later"}; }
  /// Runs a request immediately. Passes the output to `say`, piece by piece. Also calls `say` with an empty
  /// text at intervals. If `say` returns false, the listener has left, and the run is stopped. Returns
  /// nullopt if kAtOnce runs are active.
  std::optional<Done> run(const RunForm& form, const std::function<bool(const std::string&)>& say);

  /// Prepares a run for watching, and returns its number. Stores at most kKept unwatched runs.
  int prepare(const RunForm& form);
  enum class Said { lines, text };  ///< lines: whole lines of JSON from the run; text: output for the user
  using Tell = std::function<bool(Said, const std::string&)>;
  /// Starts a prepared run and follows it. Unlike run(), keeps pace with the wall clock, and obeys the
  /// requests of ask(). Returns nullopt if the run was not prepared, or was already watched.
  std::optional<Done> watch(int number, const Tell& tell);
  /// Sends a request, a line of JSON (sim/wire/live.h), to a watched run. Returns false if the run does not
  /// accept the request.
  bool ask(int number, const std::string& line);

  /// Stops all present and later runs, because the server is shutting down.
  void end() { ending_ = true; }
  bool ending() const { return ending_; }

  /// Returns the page of a run; "" if it is no longer stored.
  std::string page_of(int recording) const;

  const HeldFolder& folder() const { return folder_; }

 private:
  class Place;
  class Listening;
  /// An output of a run's process, and a function that receives it. The function returns false if the
  /// listener has left.
  struct Source {
    const Descriptor* pipe;
    std::function<bool(const std::string&)> take;
  };
  int next_number();
  ChildStart start_of(const RunForm& form, int number) const;
  /// Waits until a process ends. Passes its output to the functions of the sources. Also calls these
  /// functions with an empty text at intervals.
  Done follow(Child& child, const std::vector<Source>& sources, double longest_s) const;
  void put_away(int number, Done& done) const;

  const std::filesystem::path robosim_;
  const HeldFolder folder_;
  const PageFolder pages_;
  mutable std::mutex mutex_;
  std::atomic<bool> ending_{false};
  int running_ = 0;
  int last_ = 0;
  std::map<int, RunForm> prepared_;
  std::map<int, int> inputs_;  ///< by number of a watched run: descriptor of the pipe for its requests
};

}  // namespace robosim::serve
