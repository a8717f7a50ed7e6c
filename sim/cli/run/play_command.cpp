#include "sim/cli/run/play_command.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "sim/base/error.h"
#include "sim/launch/names.h"
#include "sim/map/network.h"
#include "sim/view/play/play_cells.h"
#include "sim/view/play/play_robot.h"
#include "sim/view/play/session.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

// Larger map files are listed with their size, without being read.
constexpr std::uintmax_t kLargestListed_bytes = 256'000;

volatile sig_atomic_t the_signal = 0;
extern "C" void on_signal(int number) { the_signal = number; }

/// Records SIGINT, SIGTERM and SIGHUP, so that the terminal is restored before the program ends.
class NotedSignals {
 public:
  NotedSignals() {
    the_signal = 0;
    struct sigaction action {};
    action.sa_handler = on_signal;
    ::sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &action, &before_[i]);
  }
  ~NotedSignals() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &before_[i], nullptr);
  }
  NotedSignals(const NotedSignals&) = delete;
  NotedSignals& operator=(const NotedSignals&) = delete;

 private:
  static constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_;
};

std::string describe(const fs::path& file, const std::string& where) {
  std::error_code error;
  const auto bytes = fs::file_size(file, error);
  if (error) return where;
  if (bytes > kLargestListed_bytes)
    return fmt::format("{:.1f} MB{}", static_cast<double>(bytes) * 1e-6, where);
  try {
    const map::Map map = map::read_map(file);
    const map::Network network = map::trace_network(map, map::default_start(map));
    return fmt::format("{:>3} x {:<3} {:>3} stations {:>3} junctions{}", map.width, map.height,
                       network.stations.size(), network.junctions.size(), where);
  } catch (const InputError& problem) {
    return fmt::format("not a map: {}", problem.message());
  }
}

class Host final : public play::SessionHost {
 public:
  std::vector<play::MapEntry> maps() override {
    std::vector<play::MapEntry> entries;
    std::error_code error;
    // Skips the current folder if it is the folder of the samples. Otherwise the maps would be listed twice.
    if (!fs::equivalent(fs::current_path(), launch::stock_map_folder(), error)) {
      for (const char* ending : {".map", ".dat"}) {
        for (const std::string& name : launch::names_in(".", ending)) {
          const std::string file = "./" + name + ending;
          entries.push_back({file, describe(file, "  in this folder")});
        }
      }
    }
    for (const std::string& name : launch::names_in(launch::stock_map_folder(), ".map"))
      entries.push_back({name, describe(launch::stock_map_folder() / (name + ".map"), "")});
    return entries;
  }
  map::Map open_map(const std::string& name) override {
    const auto quoted_path = launch::is_path(name) ? fs::path(name) : map::find_map(name);
    map::Map map = map::read_map(quoted_path);
    map::require_cells(map, map::default_start(map), "play");  // also throws if the map has no line
    return map;
  }
  std::unique_ptr<play::CellDriver> cells(const map::Map& map, const map::Start& start,
                                          double seconds_per_move) override {
    return play::drive_cells(map, start, seconds_per_move);
  }
  std::string drive_robot(const map::Map& map, const map::Start& start, play::Algorithm algorithm,
                          terminal::Console& console, const play::AskPerson& ask) override {
    return play_robot(map, start, algorithm, console, ask);
  }
};

bool can_address_cursor() {
  const char* kind = std::getenv("TERM");
  return ::isatty(STDIN_FILENO) != 0 && ::isatty(STDOUT_FILENO) != 0 && kind && *kind &&
         std::string_view(kind) != "dumb";
}

}  // namespace

int play_command(const PlayArguments& arguments) {
  Host host;
  const play::Session::Options options{arguments.map, arguments.start};
  if (!can_address_cursor()) {
    terminal::LineConsole console(STDIN_FILENO, STDOUT_FILENO, terminal::look_from_environment(false));
    play::Session(host, console, options).run();
    return static_cast<int>(ExitStatus::ok);
  }
  bool complete = true;
  {
    const NotedSignals signals;
    terminal::ScreenConsole console(terminal::look_from_environment(true), [] { return the_signal != 0; });
    complete = play::Session(host, console, options).run();
  }
  if (the_signal == SIGTERM || the_signal == SIGHUP) ::raise(the_signal);
  return static_cast<int>(complete ? ExitStatus::ok : ExitStatus::interrupted);
}

}  // namespace robosim::cli
