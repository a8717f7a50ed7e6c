// The command line, read into values. `robosim --help` lists the commands (sim/cli/help_text.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/cli/shard.h"
#include "sim/launch/fleet.h"
#include "sim/launch/launch.h"

namespace robosim::cli {

/// `robosim run`. Names are as the user typed them; empty = not given.
struct RunArguments : launch::Launch {
  launch::Fleet fleet;              ///< several robots; without members it is one, as above
  std::string script;               ///< a file
  std::vector<std::string> send;    ///< texts as a scenario writes them, between its double quotes
  std::vector<std::string> record;  ///< files
  std::vector<std::string> plot;    ///< files
  std::string coverage;             ///< a folder; empty = nothing is counted
  bool chip_only = false;           ///< no target named is that of the robot's board, not the host
  bool view = false;
  double speed = 1.0;   ///< of the view: simulated seconds a wall second; 0 = as fast as possible
  bool live = false;    ///< driven by requests on the standard input (run/live.h)
  bool serial = false;  ///< the standard output is the sketch's serial text
  bool json = false;
  bool timing = false;
};

/// `robosim why`
struct WhyArguments {
  RunArguments run;
};

/// `robosim replay`
struct ReplayArguments {
  std::string file;
  double speed = 1.0;               ///< as of RunArguments
  std::string over;                 ///< a file; empty = none
  std::vector<std::string> record;  ///< files
};

/// `robosim sweep`: every sketch on every map with every robot on every target, each with all seeds.
struct SweepArguments {
  std::vector<std::string> sketches;
  std::vector<std::string> maps;  ///< this and the next two: empty = as `run` chooses
  std::vector<std::string> robots;
  std::vector<std::string> targets;
  RunArguments each;  ///< what all runs have in common; its sketch, map, robot, target and seed do not count
  std::uint64_t first_seed = 1;
  std::uint64_t last_seed = 100;
  std::size_t jobs = 1;  ///< runs at a time
  std::string csv;       ///< a file; empty = none
  bool resume = false;
  std::optional<double> min_rate;
  bool sure = false;        ///< the runs must show it, see client::Demand
  bool stop_early = false;  ///< leave out runs that cannot change whether min_rate is met
  bool json = false;
  Shard shard;                     ///< of the runs
  std::vector<std::string> merge;  ///< tables of other shards: their runs are not made again
};

/// `robosim report`
struct ReportArguments {
  std::string file;  ///< of sweep --csv, or JUnit's XML
  std::string out = "report.html";
  std::size_t runs = 40;  ///< that are made again, at most
  RunArguments each;      ///< of a table: as of SweepArguments
};

/// `robosim compare`
struct CompareArguments {
  std::vector<std::string> targets;  ///< the others are held against the first
  std::string moves;                 ///< the one of several robots that is put on them; empty = all
  RunArguments each;                 ///< its target and seed do not count
  std::uint64_t first_seed = 1;
  std::uint64_t last_seed = 1;
  bool json = false;
};

/// `robosim build`
struct BuildArguments {
  std::string sketch;
  std::string environment;
  std::string robot;
  std::string target = "host";
  std::string out;  ///< a folder; empty = the files stay in the cache
  std::vector<std::string> libraries;
  std::string warnings = "default";
  bool sanitize = false;
};

/// `robosim flash`
struct FlashArguments {
  std::string sketch;
  std::string environment;
  std::string robot;
  std::string port;
  std::optional<std::uint64_t> baud;  ///< of the boot loader; without it what the board's has
  std::vector<std::string> libraries;
  bool dry_run = false;
};

/// `robosim map check|show|graph`
struct MapArguments {
  std::string action;
  std::string map;
  std::string start;
  bool json = false;  ///< of check and graph
  bool dot = false;   ///< of graph
};

/// `robosim map generate`
struct GenerateArguments {
  std::string family;
  int stations = 0;
  std::uint64_t count = 1;
  std::uint64_t seed = 1;  ///< of the first map
  std::string out = ".";   ///< a folder
};

/// `robosim map import`
struct ImportArguments {
  std::string file;
  std::string out;       ///< a file; empty = standard output
  double pixel_m = 0.0;  ///< of a picture; 0 = not given
  double walls_m = 0.0;  ///< of a maze with walls, from cell to cell; 0 = lines
};

/// `robosim map print`
struct PrintArguments {
  std::string map;
  std::string out;  ///< a file
  std::string paper = "A4";
  double margin_mm = 5.0;
  bool black_on_white = false;  ///< whatever the map's paint
};

/// `robosim serve`
struct ServeArguments {
  std::string folder;                 ///< "" = the current one
  std::string address = "127.0.0.1";  ///< an IP address
  int port = 0;                       ///< 0 = not given
};

/// `robosim robot list|show|check`
struct RobotArguments {
  std::string action;
  std::string robot;
  bool full = false;  ///< show: with the robots that it is based on
};

/// `robosim wire`
struct WireArguments {
  std::string sketch;
  std::string environment;
  std::string board;         ///< empty = the project's, else the first there is
  std::string map = "oval";  ///< that the draft is tried on
  std::string target;        ///< empty = host
  std::vector<std::string> libraries;
  std::string out;  ///< a file; empty = standard output
};

/// `robosim calibrate`
struct CalibrateArguments {
  std::string robot;              ///< a file or name
  std::vector<std::string> logs;  ///< files
  std::string stopwatch;          ///< a file; empty = none
  double tape_m = 0.0;            ///< 0 = not given
  double supply_volts = 0.0;      ///< 0 = not given
  std::string out;                ///< a file; empty = none
  bool in_place = false;
  std::string plot;  ///< a file; empty = none
};

/// `robosim classic`
struct ClassicArguments {
  std::string map;
  std::string start;
  std::string algorithm;        ///< "left", "right", "ai", or a C++ file
  double speed = 1.0;           ///< seconds a move takes
  std::uint64_t steps = 0;      ///< moves allowed; 0 = see classic_command.cpp
  std::vector<std::string> to;  ///< stations by number or name, or "all"
  std::string planner;          ///< empty = as AiNavigator chooses
  double miss = 0.0;            ///< chances, 0..1
  double slip = 0.0;
  std::uint64_t seed = 1;
  bool trace = false;
  bool json = false;
};

/// `robosim play`
struct PlayArguments {
  std::string map;
  std::string start;
};

/// `robosim test`
struct TestArguments {
  std::vector<std::string> sketches;
  std::string checks;    ///< a file for all sketches; empty = the checks.toml beside each
  std::string junit;     ///< a file; empty = none
  std::size_t jobs = 1;  ///< runs at a time
  bool untrusted = false;
};

/// `robosim mutate`
struct MutateArguments {
  std::string sketch;
  std::string checks;              ///< a file; empty = the checks.toml beside the sketch
  std::vector<std::string> tests;  ///< programs of GoogleTest tests, in place of checks
  std::uint64_t seed = 1;
  std::size_t count = 20;  ///< bugs
  std::size_t jobs = 1;    ///< runs at a time
  double min_score = 0.0;
  bool json = false;
};

/// `robosim hunt`
struct HuntArguments {
  std::string sketch;
  std::vector<std::string> maps;  ///< empty = as `run` chooses, or one that suits
  bool only_maps = false;         ///< no maps are drawn
  std::string robot;
  std::vector<std::string> targets;  ///< empty = the chip's, and the host
  RunArguments each;                 ///< as of SweepArguments
  std::uint64_t seed = 1;            ///< of what is drawn
  std::uint64_t runs = 400;
  double minutes = 0.0;  ///< wall time after which no further run begins; 0 = as many as there are runs
  std::size_t jobs = 1;  ///< runs at a time
  std::string out;       ///< a folder; empty = hunt-SKETCH
  bool resume = false;
  bool stop_early = false;
  Shard shard;                     ///< of the runs
  std::vector<std::string> merge;  ///< folders of other shards; no runs are made
};

/// `robosim new`
struct NewArguments {
  std::string name;
};

/// Nothing to do but to print: --help, --version, or the examples of a bare `robosim`.
struct PrintText {
  std::string text;
};

using Command = std::variant<RunArguments, WhyArguments, ReplayArguments, SweepArguments, ReportArguments,
                             CompareArguments, PlayArguments, ClassicArguments, BuildArguments,
                             FlashArguments, WireArguments, MapArguments, GenerateArguments, ImportArguments,
                             PrintArguments, RobotArguments, CalibrateArguments, ServeArguments,
                             TestArguments, MutateArguments, HuntArguments, NewArguments, PrintText>;

/// `words` without the program's name. Throws InputError.
Command parse_arguments(const std::vector<std::string>& words);

}  // namespace robosim::cli
