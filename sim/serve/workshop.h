// Runs what a page asks for: each run is a `robosim run` of its own, whose page is kept for the browser to
// fetch. One that is watched while it runs is a `robosim run --live`.
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

/// A run, as the page wants it.
struct Wanted {
  std::string sketch, robot, map;  ///< of Choices; "" for robot and map: as `robosim run` chooses
  std::string target = "host";     ///< host, avr or stm32
  std::uint64_t seed = 1;
  double for_s = 60.0;                         ///< simulated, 0.001 to 3600
  std::string goal;                            ///< "" = the map's
  std::string script;                          ///< of several robots, of those that have none
  std::map<std::string, std::string> scripts;  ///< of several robots, by their names
};

/// Reads the JSON of a request. Throws InputError for what is none, has other keys, or names nothing that can
/// be chosen.
Wanted read_wanted(const std::string& json, const Choices& choices);

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

class Workshop {
 public:
  static constexpr int kAtOnce = 2;            ///< runs
  static constexpr std::size_t kKept = 8;      ///< pages of runs
  static constexpr double kLongest_s = 600.0;  ///< of wall time, compiling included
  static constexpr double kLongestLive_s = 3600.0;

  /// `robosim`: the program. Pages are kept in a temporary folder until this ends.
  Workshop(std::filesystem::path robosim, std::filesystem::path folder);

  /// How a run ended.
  struct Done {
    int status = 0;        ///< of `robosim run`
    int recording = 0;     ///< its number, for page_of; 0 = there is none
    std::string sentence;  ///< why it was stopped; "" = it was not
  };
  /// Runs it now. `say` gets what it prints, piece by piece, and may be called without text; where it gives
  /// false, nobody is listening any more, and the run is stopped. Nothing: there are kAtOnce already.
  std::optional<Done> run(const Wanted& wanted, const std::function<bool(const std::string&)>& say);

  /// Notes what is to be watched, and gives its number. Of those that nobody has come to watch kKept are
  /// known.
  int prepare(const Wanted& wanted);
  enum class Said { lines, text };  ///< whole lines of JSON of the run's; what it prints for people
  using Tell = std::function<bool(Said, const std::string&)>;
  /// As run(), but goes along with the clock and takes requests. Nothing where nobody has prepared it, or it
  /// was watched already.
  std::optional<Done> watch(int number, const Tell& tell);
  /// A request to a run that is watched (sim/wire/live.h), a line of JSON; false: it does not listen.
  bool ask(int number, const std::string& line);

  /// Stops all runs, for ever: the server ends.
  void end() { ending_ = true; }
  bool ending() const { return ending_; }

  /// The page of a run; "" if it is not kept any more.
  std::string page_of(int recording) const;

  const HeldFolder& folder() const { return folder_; }

 private:
  class Place;
  class Listening;
  /// Where a run's process says something, and who takes it: false where nobody is listening any more.
  struct Source {
    const Descriptor* pipe;
    std::function<bool(const std::string&)> take;
  };
  int next_number();
  ChildStart start_of(const Wanted& wanted, int number) const;
  /// Until it ends; each source is also called without text now and then.
  Done follow(Child& child, const std::vector<Source>& sources, double longest_s) const;
  void put_away(int number, Done& done) const;

  const std::filesystem::path robosim_;
  const HeldFolder folder_;
  const PageFolder pages_;
  mutable std::mutex mutex_;
  std::atomic<bool> ending_{false};
  int running_ = 0;
  int last_ = 0;
  std::map<int, Wanted> prepared_;
  std::map<int, int> inputs_;  ///< of runs that are watched
};

}  // namespace robosim::serve
