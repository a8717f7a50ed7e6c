// The original program's session: choose a map, place the robot, let it walk or scan, see the graph, and send
// it from station to station. Moving the robot and finding maps are left to the SessionHost.
// docs/howto/play.md describes what a person sees.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/grid/map.h"
#include "sim/grid/true_graph.h"
#include "sim/tui/cell_picture.h"
#include "sim/tui/console.h"
#include "sim/tui/page.h"

namespace robosim::play {

enum class Algorithm { left, right, ai };

/// The robot on cells before one of its moves.
struct CellStep {
  grid::Start pose;
  const char* sense = "";  ///< "straight"
  const char* move = "";   ///< "step_forward"; "" after the last one
  double time_s = 0.0;     ///< of the clock, before this move
};
/// May throw to end the walk.
using OnStep = std::function<void(const CellStep&)>;

/// How a walk, a scan or a drive ended.
struct WalkReport {
  bool complete = false;  ///< scanned all, arrived, came back to the start
  std::string note;       ///< what else a person should know; "" = nothing
  std::uint64_t moves = 0;
  double time_s = 0.0;  ///< of this walk alone
  grid::Start end;
};

struct RouteReport {
  bool possible = false;
  std::string why_not;
  std::vector<int> junctions;  ///< by number
  std::string turns;           ///< a letter for each: R, S, L
  double time_s = 0.0;
};

/// The robot on cells, on one map from one start at one speed.
class CellDriver {
 public:
  virtual ~CellDriver() = default;
  /// Left or right.
  virtual WalkReport walk(Algorithm algorithm, const OnStep& on_step) = 0;
  virtual WalkReport scan(const OnStep& on_step) = 0;
  /// As scanned.
  virtual const grid::TrueGraph& graph() const = 0;
  virtual grid::Start pose() const = 0;
  /// The station at which the robot stands, 0 = none.
  virtual int here() const = 0;
  virtual RouteReport route(int to) = 0;
  virtual WalkReport drive(int to, const OnStep& on_step) = 0;
  /// After a drive that was broken off: back to the station.
  virtual void put_back(int station) = 0;
};

struct MapEntry {
  std::string name;
  std::string note;  ///< "24 x 15 cells, 7 stations"
};

/// Asks the person on a page of its own: what is told first, then the question. Gives the line typed.
using AskPerson =
    std::function<std::string(const std::vector<std::string>& told, const std::string& question)>;

class SessionHost {
 public:
  virtual ~SessionHost() = default;
  virtual std::vector<MapEntry> maps() = 0;
  /// What the person typed: a name of the list, or a file. Throws InputError.
  virtual grid::Map open_map(const std::string& name) = 0;
  virtual std::unique_ptr<CellDriver> cells(const grid::Map& map, const grid::Start& start,
                                            double seconds_per_move) = 0;
  /// The simulated Arduino robot, from compiling its sketch to the end of the run, on the terminal itself.
  /// Gives a sentence about how it ended. Throws what `robosim run` would throw for bad input.
  virtual std::string drive_robot(const grid::Map& map, const grid::Start& start, Algorithm algorithm,
                                  tui::Console& console, const AskPerson& ask) = 0;
};

/// Ends the session from within.
struct SessionQuit {
  bool interrupted = false;  ///< by Ctrl-C or the like
};

class Session {
 public:
  struct Options {
    std::string map;               ///< "" = ask
    std::string start;             ///< X,Y,DIR; "" = the map's
    double moves_per_second = 10;  ///< at which walks are shown, at first
  };

  Session(SessionHost& host, tui::Console& console, Options options);

  /// To its end. False if it was interrupted. Throws InputError for a map or start in the options.
  bool run();

 private:
  using Body = std::function<void(tui::Page&)>;

  // Asking (session_ask.cpp).
  tui::Press read(const Body& body, const std::vector<tui::Page::Line>& footer);
  /// A line typed. `arrow` is told of up (-1) and down (+1).
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
  Next choose_next(const std::string& result, tui::Ink ink);
  Next on_robot();

  // On cells (session_drive.cpp).
  Next on_cells();
  Next scan_and_drive();
  void show_graph(const std::string& result);
  int choose_destination();
  /// Gives a sentence about how it went.
  std::string drive_to(int station);
  bool ask_whether_to_continue(const std::string& result);

  // Watching (session_watch.cpp).
  struct Stopped {};
  /// Runs a walk, shown move by move; nothing if the person broke it off.
  std::optional<WalkReport> watch(const std::string& title, const std::vector<tui::CellLabel>& labels,
                                  const std::function<WalkReport(const OnStep&)>& walk);
  void show_step(const std::string& title, const std::vector<tui::CellLabel>& labels, const CellStep& step,
                 std::uint64_t moves);
  void obey(const tui::Press& press);
  std::string pace_text() const;

  void draw_map(tui::Page& page, int rows, const std::vector<tui::CellLabel>& labels = {});
  /// The same with another cell in sight than the robot's.
  void draw_map_around(tui::Page& page, int rows, grid::CellAt around,
                       const std::vector<tui::CellLabel>& labels);
  std::string map_title() const;

  SessionHost& host_;
  tui::Console& console_;
  Options options_;
  std::string error_;  // told with the next question

  std::optional<grid::Map> map_;
  std::optional<tui::CellPicture> picture_;
  std::string line_cells_;
  grid::Start start_;  // as placed
  grid::Start pose_;   // now
  bool driven_ = false;
  double speed_s_ = 1.0;
  Algorithm algorithm_ = Algorithm::ai;
  std::unique_ptr<CellDriver> driver_;

  // Of the walk that is being watched.
  double pace_;  // moves a second; 0 = as fast as possible
  bool paused_ = false, single_ = false, to_the_end_ = false;
  std::int64_t due_us_ = 0, drawn_us_ = 0;
};

}  // namespace robosim::play
