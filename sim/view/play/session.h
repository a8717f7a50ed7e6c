// Reproduces the interactive session of Robosim v1. The user chooses a map, places the robot, and lets it
// walk or scan the map. Then the user inspects the scanned graph, and sends the robot from station to
// station. The SessionHost moves the robot and finds maps. docs/howto/play.md describes the session for
// users.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/map/map.h"
#include "sim/map/true_graph.h"
#include "sim/view/terminal/cell_picture.h"
#include "sim/view/terminal/console.h"
#include "sim/view/terminal/page.h"

namespace robosim::play {

enum class Algorithm { left, right, ai };

/// The state of a robot that moves from cell to cell, before one of its moves.
struct CellStep {
  map::Start pose;
  const char* sense = "";  ///< "straight"
  const char* move = "";   ///< "step_forward"; "" after the last move
  double time_s = 0.0;     ///< simulated time before this move
};
/// Receives each step of a walk. May throw an exception to end the walk.
using OnStep = std::function<void(const CellStep&)>;

/// The result of a walk, a scan or a drive.
struct WalkReport {
  bool complete = false;  ///< the scan covered everything, or the robot arrived or returned to the start
  std::string note;       ///< an additional message for the user; "" = none
  std::uint64_t moves = 0;
  double time_s = 0.0;  ///< simulated time of this walk alone
  map::Start end;
};

struct RouteReport {
  bool possible = false;
  std::string why_not;
  std::vector<int> junctions;  ///< numbers of the junctions on the route
  std::string turns;           ///< a letter for each junction: R, S, L
  double time_s = 0.0;
};

/// Moves a robot from cell to cell, on one map, from one start and at one speed.
class CellDriver {
 public:
  virtual ~CellDriver() = default;
  /// Walks by the algorithm `left` or `right`.
  virtual WalkReport walk(Algorithm algorithm, const OnStep& on_step) = 0;
  virtual WalkReport scan(const OnStep& on_step) = 0;
  /// Returns the scanned graph.
  virtual const map::TrueGraph& graph() const = 0;
  virtual map::Start pose() const = 0;
  /// Returns the number of the robot's station; 0 = none.
  virtual int here() const = 0;
  virtual RouteReport route(int to) = 0;
  virtual WalkReport drive(int to, const OnStep& on_step) = 0;
  /// Places the robot at a station, for example after an interrupted drive.
  virtual void put_back(int station) = 0;
};

struct MapEntry {
  std::string name;
  std::string note;  ///< "24 x 15 cells, 7 stations"
};

/// Asks the user on a separate page, which shows `told` above the question. Returns the typed line.
using AskPerson =
    std::function<std::string(const std::vector<std::string>& told, const std::string& question)>;

class SessionHost {
 public:
  virtual ~SessionHost() = default;
  virtual std::vector<MapEntry> maps() = 0;
  /// Opens the map that the user has chosen: a name from the list, or a file. Throws InputError.
  virtual map::Map open_map(const std::string& name) = 0;
  virtual std::unique_ptr<CellDriver> cells(const map::Map& map, const map::Start& start,
                                            double seconds_per_move) = 0;
  /// Runs the simulated Arduino robot on the terminal, from compiling its sketch to the end of the run.
  /// Returns a sentence about the end. Throws the errors of `robosim run` for invalid input.
  virtual std::string drive_robot(const map::Map& map, const map::Start& start, Algorithm algorithm,
                                  terminal::Console& console, const AskPerson& ask) = 0;
};

/// Thrown to end the session.
struct SessionQuit {
  bool interrupted = false;  ///< by Ctrl-C or another signal
};

class Session {
 public:
  struct Options {
    std::string map;               ///< "" = ask the user
    std::string start;             ///< X,Y,DIR; "" = the map's start
    double moves_per_second = 10;  ///< initial speed of the display of walks
  };

  Session(SessionHost& host, terminal::Console& console, Options options);

  /// Runs the session. Returns false if it was interrupted. Throws InputError for an invalid map or start in
  /// the options.
  bool run();

 private:
  using Body = std::function<void(terminal::Page&)>;

  // Questions (session_ask.cpp).
  terminal::Press read(const Body& body, const std::vector<terminal::Page::Line>& footer);
  /// Returns a typed line. Calls `arrow` for the keys up (-1) and down (+1).
  std::string ask(const Body& body, const std::string& question, const std::function<void(int)>& arrow = {});
  void refuse(const std::string& sentence) { error_ = sentence; }

  // The steps of the session (session.cpp).
  void choose_map();
  void place();
  bool try_accept();
  void choose_engine();
  void choose_speed();
  void choose_algorithm();
  enum class Next { place, algorithm, map };
  Next choose_next(const std::string& result, terminal::Ink ink);
  Next on_robot();

  // Shows how the robot walks, scans and drives from cell to cell (session_drive.cpp).
  Next on_cells();
  Next scan_and_drive();
  void show_graph(const std::string& result);
  int choose_destination();
  /// Returns a sentence about the result.
  std::string drive_to(int station);
  bool ask_whether_to_continue(const std::string& result);

  // The display (session_watch.cpp).
  struct Stopped {};
  /// Runs a walk and shows each move. Returns nullopt if the user interrupted it.
  std::optional<WalkReport> watch(const std::string& title, const std::vector<terminal::CellLabel>& labels,
                                  const std::function<WalkReport(const OnStep&)>& walk);
  void show_step(const std::string& title, const std::vector<terminal::CellLabel>& labels,
                 const CellStep& step, std::uint64_t moves);
  void obey(const terminal::Press& press);
  std::string pace_text() const;

  void draw_map(terminal::Page& page, int rows, const std::vector<terminal::CellLabel>& labels = {});
  /// Draws the part of the map around the cell `around`. draw_map() draws the part around the robot.
  void draw_map_around(terminal::Page& page, int rows, map::CellAt around,
                       const std::vector<terminal::CellLabel>& labels);
  std::string map_title() const;

  SessionHost& host_;
  terminal::Console& console_;
  Options options_;
  std::string error_;  // shown with the next question

  std::optional<map::Map> map_;
  std::optional<terminal::CellPicture> picture_;
  std::string line_cells_;
  map::Start start_;  // pose at the beginning
  map::Start pose_;   // current pose
  bool driven_ = false;
  double speed_s_ = 1.0;
  Algorithm algorithm_ = Algorithm::ai;
  std::unique_ptr<CellDriver> driver_;

  // State of the displayed walk.
  double pace_;  // moves per second; 0 = as fast as possible
  bool paused_ = false, single_ = false, to_the_end_ = false;
  std::int64_t due_us_ = 0, drawn_us_ = 0;
};

}  // namespace robosim::play
