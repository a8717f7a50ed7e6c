// Runs the requests of a page: each is a separate `robosim run`, whose page is stored for the browser. A run
// that is watched live is a `robosim run --live`.
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
#include "sim/serve/folder.h"

namespace robosim::serve {

/// A run, as requested by the page.
struct RunForm {
  std::string sketch, robot, map;  ///< of Choices; "" for robot and map: the defaults of `robosim run`
  std::string target = "host";     ///< host, avr or stm32
  std::uint64_t seed = 1;
  double for_s = 60.0;                         ///< simulated, 0.001 to 3600
  std::string goal;                            ///< "" = the map's
  std::string script;                          ///< of several robots, for those without their own
  std::map<std::string, std::string> scripts;  ///< of several robots, by name
};

/// Reads the JSON of a request. Throws InputError if it is invalid, has other keys, or names anything outside
/// the choices.
RunForm read_run_form(const std::string& json, const Choices& choices);

/// A temporary folder for the pages of runs. The next server of this user removes it if this one is killed.
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
  static constexpr int kAtOnce = 2;            ///< simultaneous runs
  static constexpr std::size_t kKept = 8;      ///< stored pages of runs
  static constexpr double kLongest_s = 600.0;  ///< of wall time, including compilation
  static constexpr double kLongestLive_s = 3600.0;

  /// `robosim`: the program. Pages are stored in a temporary folder until this ends.
  JobManager(std::filesystem::path robosim, std::filesystem::path folder);

  /// How a run ended.
  struct Done {
    int status = 0;        ///< of `robosim run`
    int recording = 0;     ///< its number, for page_of; 0 = none
    std::string sentence;  ///< why it was stopped; "" = it ended by itself
  };
  /// Returns how a run ends that cannot begin because kAtOnce others are running.
  static Done busy() { return {5, 0, "too many runs at once: try again later"}; }
  /// Runs it now. `say` gets its output, piece by piece, and may be called without text. If it returns false,
  /// the listener has gone, and the run is stopped. Returns nothing if kAtOnce runs exist already.
  std::optional<Done> run(const RunForm& form, const std::function<bool(const std::string&)>& say);

  /// Prepares a run for watching, and returns its number. At most kKept unwatched ones are stored.
  int prepare(const RunForm& form);
  enum class Said { lines, text };  ///< whole lines of JSON from the run; its output for people
  using Tell = std::function<bool(Said, const std::string&)>;
  /// Like run(), but in step with the clock and with requests. Returns nothing if it was not prepared, or was
  /// watched already.
  std::optional<Done> watch(int number, const Tell& tell);
  /// Sends a request to a watched run (sim/wire/live.h), a line of JSON; returns false if it does not listen.
  bool ask(int number, const std::string& line);

  /// Stops all runs, for ever: the server ends.
  void end() { ending_ = true; }
  bool ending() const { return ending_; }

  /// Returns the page of a run; "" if it is not stored any more.
  std::string page_of(int recording) const;

  const HeldFolder& folder() const { return folder_; }

 private:
  class Place;
  class Listening;
  /// An output of a run's process, and its receiver, which returns false if the listener has gone.
  struct Source {
    const Descriptor* pipe;
    std::function<bool(const std::string&)> take;
  };
  int next_number();
  ChildStart start_of(const RunForm& form, int number) const;
  /// Runs until it ends; each source is also called without text at intervals.
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
  std::map<int, int> inputs_;  ///< of watched runs
};

}  // namespace robosim::serve
