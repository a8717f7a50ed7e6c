#include "sim/view/play/play_cells.h"

#include <fmt/format.h>

#include "sim/map/cells/survey.h"
#include "sim/map/cells/walk.h"

namespace robosim::play {
namespace {

using cells::Ending;

// Returns a limit for the moves of a walk or a scan, which enters each line cell at most a few times.
std::uint64_t enough_moves(const map::Map& map) { return 100 * map.cells.size() + 100'000; }

map::Start start_of(const cells::CellPose& pose) { return {pose.cell, pose.facing}; }

std::string note_of(Ending ending) {
  switch (ending) {
    case Ending::lost:
      return "The robot lost its way.";
    case Ending::out_of_moves:
      return "It ended because the robot had made more moves than any scan needs.";
    case Ending::no_way:
      return "An obstacle blocks the way to this station.";
    case Ending::complete:
    case Ending::refused:
      break;
  }
  return "";
}

/// Reports each move to the session until this object is destroyed.
class Watching final : public cells::MoveWatcher {
 public:
  Watching(cells::CellRobot& robot, const OnStep& on_step)
      : robot_(robot), on_step_(on_step), moves_before_(robot.moves()), clock_before_(robot.clock()) {
    robot_.watch(this);
  }
  ~Watching() { robot_.watch(nullptr); }
  Watching(const Watching&) = delete;
  Watching& operator=(const Watching&) = delete;

  void moved(const cells::CellPose& pose, cells::Sense sense, cells::Move move, double) override {
    on_step_({start_of(pose), name_of(sense), name_of(move), time_});
    time_ = robot_.clock() - clock_before_;
  }
  WalkReport report(bool complete, std::string note) const {
    return {complete, std::move(note), robot_.moves() - moves_before_, robot_.clock() - clock_before_,
            start_of(robot_.pose())};
  }

 private:
  cells::CellRobot& robot_;
  const OnStep& on_step_;
  std::uint64_t moves_before_;
  double clock_before_, time_ = 0.0;
};

class Cells final : public CellDriver {
 public:
  Cells(const map::Map& map, const map::Start& start, double speed)
      : floor_(map), robot_(floor_, {start.cell, start.facing}, speed), survey_(robot_) {}

  WalkReport walk(Algorithm algorithm, const OnStep& on_step) override {
    robot_.limit_moves(robot_.moves() + enough_moves(floor_.map()));
    const Watching watching(robot_, on_step);
    const cells::Walk walk =
        cells::walk(robot_, algorithm == Algorithm::left ? cells::Side::left : cells::Side::right);
    const bool closed = walk.ending == cells::Walk::Ending::closed;
    const std::string where = !closed ? "It has not come back to where it was."
                              : start_of(robot_.pose()).cell == start_.cell
                                  ? "The robot is back at its start."
                                  : "From here on it would go the same round again.";
    return watching.report(closed, fmt::format("{} It met {} end{} of a line.", where, walk.dead_ends.size(),
                                               walk.dead_ends.size() == 1 ? "" : "s"));
  }
  WalkReport scan(const OnStep& on_step) override {
    robot_.limit_moves(robot_.moves() + enough_moves(floor_.map()));
    const Watching watching(robot_, on_step);
    scan_ = &survey_.scan();
    return watching.report(scan_->ending == Ending::complete, note_of(scan_->ending));
  }
  const map::TrueGraph& graph() const override { return scan_->graph; }
  int here() const override { return survey_.here(); }
  map::Start pose() const override { return start_of(robot_.pose()); }

  // Drives to the station without showing the moves, then puts the robot back. drive() takes the same route.
  RouteReport route(int to) override {
    const int from = survey_.here();
    const cells::Route route = drive(to);
    survey_.place_at(from);
    RouteReport report{route.ending == Ending::complete, {}, route.junctions, route.turns, route.time};
    if (!report.possible) report.why_not = route.why.empty() ? note_of(route.ending) : route.why;
    return report;
  }
  WalkReport drive(int to, const OnStep& on_step) override {
    const Watching watching(robot_, on_step);
    const cells::Route route = drive(to);
    return watching.report(route.ending == Ending::complete, note_of(route.ending));
  }
  void put_back(int station) override { survey_.place_at(station); }

 private:
  cells::Route drive(int to) {
    robot_.limit_moves(robot_.moves() + enough_moves(floor_.map()));
    return survey_.drive(to, survey_.default_planner());
  }

  cells::CellFloor floor_;
  cells::CellRobot robot_;
  map::Start start_ = start_of(robot_.pose());
  cells::Survey survey_;
  const cells::Scan* scan_ = nullptr;
};

}  // namespace

std::unique_ptr<CellDriver> drive_cells(const map::Map& map, const map::Start& start,
                                        double seconds_per_move) {
  return std::make_unique<Cells>(map, start, seconds_per_move);
}

}  // namespace robosim::play
