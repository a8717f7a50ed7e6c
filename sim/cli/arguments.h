// Parses the command line into values. `robosim --help` lists the commands (sim/cli/help.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/campaign/compare/compare_options.h"
#include "sim/campaign/hunt/hunt_options.h"
#include "sim/campaign/mutate/mutate_options.h"
#include "sim/campaign/report/report_options.h"
#include "sim/campaign/sweep/sweep_options.h"
#include "sim/cli/help.h"
#include "sim/launch/run_settings.h"

namespace robosim::cli {

/// `robosim run`
struct RunArguments : launch::RunSettings {
  std::vector<std::string> record;  ///< files that receive the recording
  std::vector<std::string> plot;    ///< files that receive a drawing of the robot's path
  std::string coverage;             ///< folder of the coverage report; empty = lines are not counted
  bool view = false;
  double speed = 1.0;   ///< speed of the view, simulated s per s of wall time; 0 = as fast as possible
  bool live = false;    ///< requests on the standard input control the run (run/live.h)
  bool serial = false;  ///< the standard output contains only the text that the sketch sends
  bool json = false;
  bool timing = false;
};

/// `robosim why`
struct WhyArguments {
  RunArguments run;
  bool all = false;  ///< print all lines of the chain, not only the ten most direct ones
};

/// `robosim replay`
struct ReplayArguments {
  std::string file;
  double speed = 1.0;               ///< see RunArguments
  std::string over;                 ///< file of another run, with which this run is compared; empty = none
  std::vector<std::string> record;  ///< files to write the recording to, in other formats
};

/// `robosim sweep`
struct SweepArguments : campaign::SweepOptions {
  bool json = false;
};

/// `robosim report`
struct ReportArguments : campaign::ReportOptions {
  std::string file;  ///< a table of sweep --csv, or a JUnit XML file
};

/// `robosim compare`
struct CompareArguments : campaign::CompareOptions {
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
  std::optional<std::uint64_t> baud;  ///< baud rate of the boot loader; nothing = the board's default
  std::vector<std::string> libraries;
  bool dry_run = false;
};

/// `robosim map check|show|graph`
struct MapArguments {
  std::string action;
  std::string map;
  std::string start;
  bool json = false;  ///< for check and graph
  bool dot = false;   ///< for graph
};

/// The family of closed tracks (sim/campaign/random_worlds/track.h).
inline constexpr const char* kTrackFamily = "track";

/// `robosim map generate`
struct GenerateArguments {
  std::string family;  ///< map::Family, or kTrackFamily
  int size = 0;        ///< number of stations, or of a track's squares
  std::uint64_t count = 1;
  std::uint64_t seed = 1;  ///< seed of the first map; each further map adds 1
  std::string out = ".";   ///< folder that receives the maps
};

/// `robosim map import`
struct ImportArguments {
  std::string file;
  std::string out;       ///< a file; empty = standard output
  double pixel_m = 0.0;  ///< side of a picture's pixel; 0 = not given
  double walls_m = 0.0;  ///< cell pitch of a maze with walls; 0 = the course has lines
};

/// `robosim map print`
struct PrintArguments {
  std::string map;
  std::string out;  ///< a file
  std::string paper = "A4";
  double margin_mm = 5.0;
  bool black_on_white = false;  ///< instead of the colours of the map
};

/// `robosim serve`
struct ServeArguments {
  std::string folder;                 ///< "" = the current folder
  std::string address = "127.0.0.1";  ///< an IP address
  int port = 0;                       ///< 0 = not given
};

/// `robosim robot list|show|check`
struct RobotArguments {
  std::string action;
  std::string robot;
  bool full = false;  ///< for show: includes the robots that this robot is based on
};

/// `robosim wire`
struct WireArguments {
  std::string sketch;
  std::string environment;
  std::string board;         ///< empty = the project's board, or else a board that suits the sketch
  std::string map = "oval";  ///< map on which the draft is tried
  std::string target;        ///< empty = host, or avr if the sketch compiles only there
  std::vector<std::string> libraries;
  std::string out;  ///< a file; empty = standard output
};

/// `robosim calibrate`
struct CalibrateArguments {
  std::string robot;              ///< robot file or name of a stock robot
  std::vector<std::string> logs;  ///< log files of the real robot
  std::string stopwatch;          ///< file of drives measured by stopwatch; empty = none
  double tape_m = 0.0;            ///< width of the tape that the sensors crossed; 0 = not given
  double supply_volts = 0.0;      ///< battery voltage during the log; 0 = not given
  std::string out;                ///< file that receives the fitted robot; empty = none
  bool in_place = false;
  std::string plot;  ///< file that receives a plot of the fit; empty = none
};

/// `robosim classic`
struct ClassicArguments {
  std::string map;
  std::string start;
  std::string algorithm;        ///< "left", "right", "ai", or a C++ file
  double speed = 1.0;           ///< seconds per move
  std::uint64_t steps = 0;      ///< maximum number of moves; 0 = the default in classic_command.cpp
  std::vector<std::string> to;  ///< destinations: stations by number or name, or "all"
  std::string planner;          ///< name of a route planner; empty = the firmware's default (AiNavigator)
  double miss = 0.0;            ///< probability from 0 to 1 that a cell is not seen
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
  std::string checks;  ///< file of checks for all sketches; empty = each sketch's checks.toml
  std::string junit;   ///< JUnit XML file to write; empty = none
  std::vector<std::string> libraries;
  std::size_t jobs = 1;  ///< number of simultaneous runs
  bool untrusted = false;
};

/// `robosim mutate`
struct MutateArguments : mutate::MutateOptions {
  double min_score = 0.0;
  bool json = false;
};

/// `robosim hunt`
struct HuntArguments : campaign::HuntOptions {
  std::string out;  ///< folder that receives the findings; empty = hunt-SKETCH
  bool resume = false;
};

/// `robosim new`
struct NewArguments {
  std::string name;
};

/// `robosim man`
struct ManArguments {
  std::string command;  ///< empty = the page of Robosim itself
  std::string out;      ///< a folder for all pages; empty = standard output
};

using Command =
    std::variant<RunArguments, WhyArguments, ReplayArguments, SweepArguments, ReportArguments,
                 CompareArguments, PlayArguments, ClassicArguments, BuildArguments, FlashArguments,
                 WireArguments, MapArguments, GenerateArguments, ImportArguments, PrintArguments,
                 RobotArguments, CalibrateArguments, ServeArguments, TestArguments, MutateArguments,
                 HuntArguments, NewArguments, ManArguments, PrintText>;

/// Describes all commands, grouped by task.
std::vector<CommandGroup> command_groups();

/// Parses the words after the program's name. Throws InputError.
Command parse_arguments(const std::vector<std::string>& words);

}  // namespace robosim::cli
