#include "sim/cli/run/classic_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "sim/base/error.h"
#include "sim/build/algorithm.h"
#include "sim/cli/files/graph_text.h"
#include "sim/cli/output.h"
#include "sim/cli/run/classic_text.h"
#include "sim/cli/run/supervise.h"
#include "sim/launch/names.h"
#include "sim/map/cells/custom.h"
#include "sim/map/cells/survey.h"
#include "sim/map/cells/walk.h"
#include "sim/map/map.h"

namespace robosim::cli {
namespace {

using cells::Ending;

// Returns the default limit of moves, which stops a robot that gets lost because of noise. A scan needs far
// fewer moves: two for each line cell, and a few at the ends of lines.
std::uint64_t enough_moves(const map::Map& map) { return 100 * map.cells.size() + 100'000; }

// Forwards all moves. Also records the moves if they must be printed.
class Tape final : public cells::MoveWatcher {
 public:
  explicit Tape(cells::MoveWatcher* next, bool wanted) : next_(next), wanted_(wanted) {}
  void moved(const cells::CellPose& pose, cells::Sense sense, cells::Move move, double clock) override {
    if (wanted_) moves_.push_back({pose, sense, move, clock});
    if (next_) next_->moved(pose, sense, move, clock);
  }
  const std::vector<TapedMove>& moves() const { return moves_; }

 private:
  cells::MoveWatcher* next_;
  bool wanted_;
  std::vector<TapedMove> moves_;
};

ExitStatus status_of(Ending ending) {
  return ending == Ending::complete ? ExitStatus::ok : ExitStatus::failed;
}

// Returns the station for a number or a name.
int station_of(const map::TrueGraph& graph, const std::string& wanted) {
  std::vector<std::string> known;
  for (int id = 0; const map::GraphStation& station : graph.stations) {
    known.push_back(std::to_string(++id));
    if (wanted == known.back() || (!station.name.empty() && wanted == station.name)) return id;
    if (!station.name.empty()) known.back() += " (" + station.name + ")";
  }
  constexpr std::size_t kListed = 20;
  std::string there = "there are no stations";
  if (known.size() > kListed) {
    there = fmt::format("there are 1 to {}", known.size());
  } else if (!known.empty()) {
    there = fmt::format("there {} {}", known.size() == 1 ? "is" : "are", fmt::join(known, ", "));
  }
  throw InputError(fmt::format("--to: unknown or unreachable station “{}”; {}", wanted, there));
}

std::vector<cells::Route> drive(cells::Survey& survey, const map::TrueGraph& graph,
                                const ClassicArguments& arguments) {
  const std::string planner = arguments.planner.empty() ? survey.default_planner() : arguments.planner;
  std::vector<cells::Route> routes;
  for (const std::string& to : arguments.to) {
    if (to != "all") {
      if (survey.here() == 0) break;
      routes.push_back(survey.drive(station_of(graph, to), planner));
      continue;
    }
    for (int from = 1; from <= survey.stations(); ++from) {
      for (int there = 1; there <= survey.stations(); ++there) {
        if (there == from) continue;
        survey.place_at(from);
        routes.push_back(survey.drive(there, planner));
      }
    }
    if (survey.stations() > 0) survey.place_at(1);
  }
  return routes;
}

/// Runs the algorithm and prints the report. `library` is the user's compiled algorithm; empty = none.
/// `progressed` receives the robot's moves.
int run_on(const map::Map& map, const map::Start& start, const ClassicArguments& arguments,
           const std::filesystem::path& library, cells::MoveWatcher* progressed) {
  const cells::CellFloor floor(map);
  cells::CellRobot robot(floor, {start.cell, start.facing}, arguments.speed);
  robot.limit_moves(arguments.steps > 0 ? arguments.steps : enough_moves(map));
  robot.set_noise({arguments.miss, arguments.slip, arguments.seed});
  Tape tape(progressed, arguments.trace);
  if (arguments.trace || progressed) robot.watch(&tape);

  ClassicReport report{map, start, arguments, {}, {}, {}, tape.moves()};
  ExitStatus status = ExitStatus::ok;
  if (!library.empty()) {
    report.walk = cells::run_custom(robot, library);
    if (report.walk->ending == cells::Walk::Ending::out_of_moves) status = ExitStatus::timeout;
  } else if (arguments.algorithm == "ai") {
    cells::Survey survey(robot);
    report.scan = survey.scan();
    status = status_of(report.scan->ending);
    if (status == ExitStatus::ok) report.routes = drive(survey, report.scan->graph, arguments);
    for (const cells::Route& route : report.routes)
      if (status == ExitStatus::ok) status = status_of(route.ending);
  } else {
    report.walk = cells::walk(robot, arguments.algorithm == "left" ? cells::Side::left : cells::Side::right);
  }
  print(arguments.json ? classic_json(report) : classic_text(report));
  return static_cast<int>(status);
}

}  // namespace

int classic_command(const ClassicArguments& arguments) {
  const map::Map map = map::read_map(map::find_map(arguments.map));
  const map::Start start =
      arguments.start.empty() ? map::default_start(map) : map::parse_start(map, arguments.start);
  map::require_cells(map, start, "classic");
  if (map.at(start.cell) == map::Cell::obstacle)
    throw InputError(
        fmt::format("{}: there is an obstacle on the start, {},{}", map.file, start.cell.x, start.cell.y));
  if (!launch::is_path(arguments.algorithm)) return run_on(map, start, arguments, {}, nullptr);
  const build::Algorithm algorithm(arguments.algorithm);
  return supervise(arguments.algorithm, [&](Progressed& progressed) {
    return run_on(map, start, arguments, algorithm.shared_object(), &progressed);
  });
}

}  // namespace robosim::cli
