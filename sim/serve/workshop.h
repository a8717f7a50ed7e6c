// Runs what a page asks for: each run is a `robosim run` of its own, whose page is kept for the browser to
// fetch.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "sim/serve/folder.h"

namespace robosim::serve {

/// A run, as the page wants it.
struct Wanted {
  std::string sketch, robot, map;  ///< of Choices; "" for robot and map: as `robosim run` chooses
  std::string target = "host";     ///< host, avr or stm32
  std::uint64_t seed = 1;
  double for_s = 60.0;  ///< simulated, 0.001 to 3600
  std::string goal;     ///< "" = the map's
  std::string script;
};

/// Reads the JSON of a request. Throws InputError for what is none, has other keys, or names nothing that can
/// be chosen.
Wanted read_wanted(const std::string& json, const Choices& choices);

class Workshop {
 public:
  static constexpr int kAtOnce = 2;            ///< runs
  static constexpr std::size_t kKept = 8;      ///< pages of runs
  static constexpr double kLongest_s = 600.0;  ///< of wall time, compiling included

  /// `robosim`: the program. Pages are kept in a temporary folder until this ends.
  Workshop(std::filesystem::path robosim, std::filesystem::path folder);
  ~Workshop();

  /// How a run ended.
  struct Done {
    int status = 0;        ///< of `robosim run`
    int recording = 0;     ///< its number, for page_of; 0 = there is none
    std::string sentence;  ///< why it was stopped; "" = it was not
  };
  /// Runs it now. `say` gets what it prints, piece by piece, and may be called without text; where it gives
  /// false, nobody is listening any more, and the run is stopped. Nothing: there are kAtOnce already.
  std::optional<Done> run(const Wanted& wanted, const std::function<bool(const std::string&)>& say);

  /// The page of a run; "" if it is not kept any more.
  std::string page_of(int recording) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  class Place;

  const std::filesystem::path robosim_, folder_, kept_;
  mutable std::mutex mutex_;
  int running_ = 0;
  int last_ = 0;
};

}  // namespace robosim::serve
