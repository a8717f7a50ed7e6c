#include "sim/cli/classic_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "sim/base/error.h"
#include "sim/classic/custom.h"
#include "sim/classic/survey.h"
#include "sim/classic/walk.h"
#include "sim/cli/classic_text.h"
#include "sim/cli/graph_text.h"
#include "sim/cli/names.h"
#include "sim/cli/output.h"
#include "sim/cli/supervise.h"
#include "sim/grid/map.h"
#include "sim/sketch/algorithm.h"

namespace robosim::cli {
namespace {

using classic::Ending;

// A scan takes two moves for each of the line's cells and some for its ends; with noise it may wander.
std::uint64_t enough_moves(const grid::Map& map) { return 100 * map.cells.size() + 100'000; }

// Notes moves, if they are to be printed, and passes them on.
class Tape final : public classic::MoveWatcher {
 public:
  explicit Tape(classic::MoveWatcher* next, bool wanted) : next_(next), wanted_(wanted) {}
  void moved(const classic::CellPose& pose, classic::Sense sense, classic::Move move, double clock) override {
    if (wanted_) moves_.push_back({pose, sense, move, clock});
    if (next_) next_->moved(pose, sense, move, clock);
  }
  const std::vector<TapedMove>& moves() const { return moves_; }

 private:
  classic::MoveWatcher* next_;
  bool wanted_;
  std::vector<TapedMove> moves_;
};

ExitStatus status_of(Ending ending) {
  return ending == Ending::complete ? ExitStatus::ok : ExitStatus::failed;
}

// The station that a user means by a number or a name.
int station_of(const grid::TrueGraph& graph, const std::string& wanted) {
  std::vector<std::string> known;
  for (int id = 0; const grid::GraphStation& station : graph.stations) {
    known.push_back(std::to_string(++id));
    if (wanted == known.back() || (!station.name.empty() && wanted == station.name)) return id;
    if (!station.name.empty()) known.back() += " (" + station.name + ")";
  }
  constexpr std::size_t kListed = 20;
  std::string there = "there are none";
  if (known.size() > kListed) {
    there = fmt::format("there are 1 to {}", known.size());
  } else if (!known.empty()) {
    there = fmt::format("there {} {}", known.size() == 1 ? "is" : "are", fmt::join(known, ", "));
  }
  throw InputError(fmt::format("--to: there is no station “{}” that can be reached; {}", wanted, there));
}

std::vector<classic::Route> drive(classic::Survey& survey, const grid::TrueGraph& graph,
                                  const ClassicArguments& arguments) {
  const std::string planner = arguments.planner.empty() ? survey.default_planner() : arguments.planner;
  std::vector<classic::Route> routes;
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

/// Everything from the start to the report. `library`: the user's own algorithm, if it is one; `progressed`
/// is told of its moves.
int run_on(const grid::Map& map, const grid::Start& start, const ClassicArguments& arguments,
           const std::filesystem::path& library, classic::MoveWatcher* progressed) {
  const classic::CellFloor floor(map);
  classic::CellRobot robot(floor, {start.cell, start.facing}, arguments.speed);
  robot.limit_moves(arguments.steps > 0 ? arguments.steps : enough_moves(map));
  robot.set_noise({arguments.miss, arguments.slip, arguments.seed});
  Tape tape(progressed, arguments.trace);
  if (arguments.trace || progressed) robot.watch(&tape);

  ClassicReport report{map, start, arguments, {}, {}, {}, tape.moves()};
  ExitStatus status = ExitStatus::ok;
  if (!library.empty()) {
    report.walk = classic::run_custom(robot, library);
    if (report.walk->ending == classic::Walk::Ending::out_of_moves) status = ExitStatus::timeout;
  } else if (arguments.algorithm == "ai") {
    classic::Survey survey(robot);
    report.scan = survey.scan();
    status = status_of(report.scan->ending);
    if (status == ExitStatus::ok) report.routes = drive(survey, report.scan->graph, arguments);
    for (const classic::Route& route : report.routes)
      if (status == ExitStatus::ok) status = status_of(route.ending);
  } else {
    report.walk =
        classic::walk(robot, arguments.algorithm == "left" ? classic::Side::left : classic::Side::right);
  }
  print(arguments.json ? classic_json(report) : classic_text(report));
  return static_cast<int>(status);
}

}  // namespace

int classic_command(const ClassicArguments& arguments) {
  const grid::Map map = grid::read_map(grid::find_map(arguments.map));
  const grid::Start start =
      arguments.start.empty() ? grid::default_start(map) : grid::parse_start(map, arguments.start);
  if (map.at(start.cell) == grid::Cell::obstacle)
    throw InputError(
        fmt::format("{}: an obstacle stands on the start, {},{}", map.file, start.cell.x, start.cell.y));
  if (!is_path(arguments.algorithm)) return run_on(map, start, arguments, {}, nullptr);
  const sketch::Algorithm algorithm(arguments.algorithm);
  return supervise(arguments.algorithm, [&](Progressed& progressed) {
    return run_on(map, start, arguments, algorithm.shared_object(), &progressed);
  });
}

}  // namespace robosim::cli
