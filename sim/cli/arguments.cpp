#include "sim/cli/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "hal/board/board_spec.h"
#include "sim/base/did_you_mean.h"
#include "sim/base/error.h"
#include "sim/base/units.h"
#include "sim/cli/calibrate/calibrate_arguments.h"
#include "sim/cli/check/test_arguments.h"
#include "sim/cli/compare/compare_arguments.h"
#include "sim/cli/completion.h"
#include "sim/cli/files/print_arguments.h"
#include "sim/cli/help.h"
#include "sim/cli/hunt/hunt_arguments.h"
#include "sim/cli/mutate/mutate_arguments.h"
#include "sim/cli/options.h"
#include "sim/cli/report/report_arguments.h"
#include "sim/cli/run/fleet_arguments.h"
#include "sim/cli/run/why_arguments.h"
#include "sim/cli/run_options.h"
#include "sim/cli/serve/serve_arguments.h"
#include "sim/cli/sweep/sweep_arguments.h"
#include "sim/launch/names.h"
#include "sim/map/generator.h"
#include "sim/result/detector_names.h"

namespace robosim::cli {
namespace {

const std::vector<std::string> kWarningLevels{"none", "default", "more", "all"};
const std::vector<std::string> kFamilies{"tree", "cycles", "grid", kTrackFamily};
const std::vector<std::string> kPlanners{"bfs",   "dfs",      "iterative", "pruned",
                                         "climb", "interval", "dijkstra"};
const std::vector<std::string> kShells{"bash", "zsh", "fish"};

std::vector<std::string> command_names();

std::vector<std::string> board_names() {
  std::vector<std::string> names;
  for (int i = 0; const BoardSpec* board = board_at(i); ++i) names.push_back(board->name);
  return names;
}

double view_speed(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= 0.0) || value > 1e6) {
    refuse_value("--speed", text, "a number from 0 (as fast as possible), such as 2 (twice real time)");
  }
  return value;
}

using Words = std::vector<std::string>;

/// Throws InputError for options that a run of several robots does not support.
void refuse_for_fleet(const RunArguments& run) {
  const auto refuse = [](bool given, const char* option, const char* why) {
    if (given) throw InputError(fmt::format("{} {}", option, why));
  };
  refuse(run.request.gdb_port > 0, "--gdb",
         "halts only one robot's chip; debug that robot in a run of its own");
  refuse(!run.coverage.empty(), "--coverage", "counts the lines of only one sketch; run that robot alone");
  refuse(run.serial, "--serial",
         "prints the text of only one sketch; run that robot alone, or read the text in --json");
}

/// Returns the names of all detectors, for the help of `run`.
std::string detector_names() {
  std::string text;
  for (const result::DetectorName& one : result::kDetectorNames)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", one.name);
  return text;
}

Command parse_run(const Words& words) {
  RunArguments run;
  std::string speed, port;
  Options options(
      "run", "run a sketch on a robot on a map and judge the run",
      fmt::format("With --sanitize, a run also reports these findings (docs/howto/sanitizers.md): {}.",
                  detector_names()));
  options.text("--map", run.map, "MAP", kMapHelp, PossibleValues::map());
  FleetOptions robots(options, run);
  RunOptions shared(options, run);
  shared.time();
  shared.seed();
  shared.common();
  options.texts("--record", run.record, "FILE",
                "write a replay page (.html), samples (.csv), pins (.vcd) ...; may be repeated",
                PossibleValues::file());
  options.texts("--plot", run.plot, "FILE", "draw where the robot drove, as .svg or .png; may be repeated",
                PossibleValues::file());
  options.text("--coverage", run.coverage, "DIR",
               "count which lines of the sketch ran, in all runs with this DIR", PossibleValues::folder());
  options.flag("--sanitize", run.sanitize, "stop at the first bad index, overflow, wild pointer ...");
  options.text("--gdb", port, "PORT",
               "wait at this port for gdb, which then halts the sketch and the world (chip targets only)");
  options.flag("--untrusted", run.untrusted, kUntrustedHelp);
  options.flag("--view", run.view, "watch the run in the terminal");
  options.text("--speed", speed, "N",
               "play --view at N times real time (default: 1; 0: as fast as possible)");
  options.flag("--live", run.live,
               "obey JSON lines on standard input: play, pause, step, act (docs/howto/serving.md)");
  options.flag("--serial", run.serial, "print the sketch's serial text; print the result to standard error");
  options.flag("--json", run.json, "print the result as JSON");
  options.flag("--timing", run.timing, "also report the wall time of the run");
  if (const auto help = options.parse(words)) return *help;
  shared.finish();
  if (!port.empty()) run.request.gdb_port = static_cast<int>(whole_number("--gdb", port, 1, 65535));
  if (!speed.empty()) run.speed = view_speed(speed);
  if (run.view + run.json + run.serial + run.live > 1)
    throw InputError(
        "--view, --live, --json and --serial each need the standard output; give only one of them");
  robots.finish();
  if (!run.fleet.members.empty()) refuse_for_fleet(run);
  if (!speed.empty() && !run.view) throw InputError("--speed requires --view");
  return run;
}

Command parse_replay(const Words& words) {
  ReplayArguments replay;
  std::string speed;
  Options options("replay", "play a recorded run in the terminal, or compare it with another");
  options.positional("FILE", replay.file, "play this file, which run --record wrote: .html or .rec",
                     PossibleValues::file());
  options.text("--speed", speed, "N", "play at N times real time (default: 1; 0: as fast as possible)");
  options.text("--over", replay.over, "OTHER",
               "measure the distance to another run: a recording, or a .csv log with time, x and y",
               PossibleValues::file());
  options.texts("--record", replay.record, "FILE",
                "write the run again as .html (with --over, a page of both runs), .rec or .perfetto.json; "
                "may be repeated",
                PossibleValues::file());
  if (const auto help = options.parse(words)) return *help;
  if (replay.file.empty())
    throw InputError("robosim replay requires a recording, as in robosim replay run.html");
  if (!speed.empty()) replay.speed = view_speed(speed);
  return replay;
}

Command parse_build(const Words& words) {
  BuildArguments build;
  Options options("build", "compile a sketch as the Arduino IDE would and print its size");
  options.positional("[SKETCH]", build.sketch, kSketchHelp, PossibleValues::sketch());
  options.text("--robot", build.robot, "ROBOT", "compile for the board of this robot: a file or a name",
               PossibleValues::robot());
  options.text("--target", build.target, "TARGET", "compile for host, avr or stm32 (default: host)",
               targets());
  options.text("--out", build.out, "DIR", "put the compiled files, named after the sketch, into this folder",
               PossibleValues::folder());
  options.text("--env", build.environment, "NAME", kEnvironmentHelp);
  options.texts("--libraries", build.libraries, "DIR", kLibrariesHelp, PossibleValues::folder());
  options.text("--warnings", build.warnings, "LEVEL",
               "print the compiler's warnings: none, default, more or all",
               PossibleValues::of(kWarningLevels));
  options.flag("--sanitize", build.sanitize, "compile with the checks of run --sanitize");
  if (const auto help = options.parse(words)) return *help;
  check_choice("--warnings", build.warnings, kWarningLevels);
  return build;
}

Command parse_flash(const Words& words) {
  FlashArguments flash;
  std::string baud;
  Options options("flash", "build a sketch and write it to the board with avrdude");
  options.positional("[SKETCH]", flash.sketch, kSketchHelp, PossibleValues::sketch());
  options.text("--port", flash.port, "PORT",
               "write to the board at this port (required), such as /dev/ttyACM0 or /dev/ttyUSB0",
               PossibleValues::file());
  options.text("--robot", flash.robot, "ROBOT", "compile for the board of this robot: a file or a name",
               PossibleValues::robot());
  options.text("--baud", baud, "N",
               "talk to the boot loader at this rate (default: the board's; old Nanos need 57600)");
  options.text("--env", flash.environment, "NAME", kEnvironmentHelp);
  options.texts("--libraries", flash.libraries, "DIR", kLibrariesHelp, PossibleValues::folder());
  options.flag("--dry-run", flash.dry_run,
               "print the command and the image's SHA-256 without writing anything");
  if (const auto help = options.parse(words)) return *help;
  if (!baud.empty()) flash.baud = whole_number("--baud", baud, 300, 2'000'000);
  if (flash.port.empty())
    throw InputError(
        "robosim flash requires the board's port, as in --port /dev/ttyACM0 (most Unos) or /dev/ttyUSB0 "
        "(most "
        "Nanos); compare “ls /dev/ttyACM* /dev/ttyUSB*” with and without the board plugged in");
  return flash;
}

/// Removes the action, which must be the first word, and returns it. Returns nullopt if the user requested
/// help.
std::optional<std::string> take_action(const std::string& command, Words& words,
                                       const std::vector<std::string>& actions) {
  if (words.empty())
    throw InputError(fmt::format("robosim {} requires an action: {}", command, one_of(actions)));
  const std::string action = words[0];
  if (action == "--help" || action == "-h") return std::nullopt;
  if (std::find(actions.begin(), actions.end(), action) == actions.end())
    throw InputError(fmt::format("{}: unknown action: {}", command, expected_one_of(action, actions)));
  words.erase(words.begin());
  return action;
}

/// Returns the help of a command that requires an action.
PrintText help_of_actions(const std::string& command, const std::string& summary, Command (*parse)(Words),
                          const std::vector<std::string>& actions) {
  CommandHelp help{command, summary, "", {}, {}, {}};
  for (const std::string& action : actions)
    help.actions.push_back(std::get<PrintText>(parse({action, "--help"})).help);
  return {help_text(help), help};
}

Command parse_generate(const Words& words) {
  GenerateArguments generate;
  std::string stations, squares, count = "1", first_seed = "1";
  Options options("map generate", "generate random maps",
                  "The same family, size and seed always give the same map.");
  options.text(
      "--family", generate.family, "FAMILY",
      "generate a tree (junctions of three ways), cycles (a tree with cycles), a grid (streets) or a "
      "track (one loop)",
      PossibleValues::of(kFamilies));
  options.text("--stations", stations, "N", "give each map this many dead ends, 2 to a million");
  options.text("--squares", squares, "N", "make each track the outline of this many squares, 1 to 100");
  options.text("--count", count, "K", "generate K maps, with seeds S, S+1, ... (default: 1)");
  options.text("--seed", first_seed, "S", "generate the first map from this seed (default: 1)");
  options.text("--out", generate.out, "DIR",
               "write FAMILY-N-SEED.map into this folder (default: the current folder)",
               PossibleValues::folder());
  if (const auto help = options.parse(words)) return *help;
  if (generate.family.empty()) throw InputError("robosim map generate requires --family");
  check_choice("--family", generate.family, kFamilies);
  const bool is_track = generate.family == kTrackFamily;
  const auto& [option, value] =
      is_track ? std::pair("--squares", squares) : std::pair("--stations", stations);
  if (value.empty())
    throw InputError(fmt::format("robosim map generate --family {} requires {}", generate.family, option));
  if (!stations.empty() && !squares.empty())
    throw InputError("--squares is for tracks, and --stations for all other families: expected one of them");
  generate.size =
      static_cast<int>(is_track ? whole_number(option, value, 1, 100)
                                : whole_number(option, value, map::kMinStations, map::kMaxStations));
  generate.seed = seed_number(first_seed);
  generate.count = whole_number("--count", count, 1, 1'000'000);
  if (generate.count - 1 > kMostSeed - generate.seed)
    refuse_value("--count", count, fmt::format("fewer maps, because the last seed is {}", kMostSeed));
  return generate;
}

Command parse_import(const Words& words) {
  ImportArguments import;
  std::string pixel, pitch;
  bool walls = false;
  Options options("map import", "make a map from another tool's course",
                  "Reads the JSON of robotrace_course_cad and rcj-rescue-cms, lengths with curvatures, "
                  "points, micromouse mazes, and pictures (docs/reference/courses.md).");
  options.positional("FILE", import.file, "import this course", PossibleValues::file());
  options.text("--out", import.out, "MAP", "write the map to this file (default: standard output)",
               PossibleValues::file());
  options.text("--pixel", pixel, "LENGTH", "set the side of a picture's pixels, such as 0.5mm");
  options.flag("--walls", walls, "import a maze with its walls, instead of lines through its passages");
  options.text("--pitch", pitch, "LENGTH",
               "set the distance between the cells of a maze with --walls (default: 180mm)");
  if (const auto help = options.parse(words)) return *help;
  if (!pitch.empty() && !walls) throw InputError("--pitch requires --walls");
  if (walls) {
    const auto length = parse_quantity(pitch.empty() ? "180mm" : pitch, Dimension::length);
    if (!length || !(*length >= 0.05 && *length <= 2.0))
      refuse_value("--pitch", pitch, "a length from 50 mm to 2 m, such as 180mm");
    import.walls_m = *length;
  }
  if (!pixel.empty()) {
    const auto length = parse_quantity(pixel, Dimension::length);
    if (!length || !(*length >= 1e-5 && *length <= 0.1))
      refuse_value("--pixel", pixel, "a length from 0.01 to 100 mm, such as 0.5mm");
    import.pixel_m = *length;
  }
  if (import.file.empty()) throw InputError("robosim map import requires the course's file");
  return import;
}

const Words kMapActions{"check", "show", "graph", "generate", "import", "print"};

const char* summary_of_map(const std::string& action) {
  if (action == "check") return "check a map file and report its line, stations and goal";
  if (action == "show") return "draw a map with its stations and coordinates";
  return "print a map's graph of stations and junctions";
}

Command parse_map(Words words) {
  MapArguments map;
  const auto action = take_action("map", words, kMapActions);
  if (!action)
    return help_of_actions("map", "check, draw, generate, import or print maps", parse_map, kMapActions);
  if (action == "generate") return parse_generate(words);
  if (action == "import") return parse_import(words);
  if (action == "print") return parse_print(words);
  map.action = *action;
  Options options("map " + map.action, summary_of_map(map.action));
  options.positional("MAP", map.map, kMapHelp, PossibleValues::map());
  options.text("--start", map.start, "X,Y,DIR", "number the stations from this cell and heading");
  if (map.action == "graph") {
    options.flag("--json", map.json, "print the graph as JSON");
    options.flag("--dot", map.dot, "print the graph for Graphviz");
  }
  if (map.action == "check") options.flag("--json", map.json, "print the findings as JSON");
  if (const auto help = options.parse(words)) return *help;
  if (map.json && map.dot)
    throw InputError("robosim map graph prints either --json or --dot; give only one of them");
  if (map.map.empty()) {
    throw InputError(fmt::format("robosim map {} requires a map: a file, or one of {}", map.action,
                                 one_of(launch::names_in(launch::stock_map_folder(), ".map"))));
  }
  return map;
}

double seconds_a_move(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= 0.0) || value > 1e6)
    refuse_value("--speed", text, "the seconds of a move, a number from 0 to 1000000");
  return value;
}

// Parses "miss=0.01,slip=0.005"
void read_noise(const std::string& text, ClassicArguments& classic) {
  std::size_t at = 0;
  while (at <= text.size()) {
    const std::string part = text.substr(at, text.find(',', at) - at);
    at += part.size() + 1;
    const std::size_t equals = part.find('=');
    const std::string name = part.substr(0, equals),
                      number = equals == part.npos ? "" : part.substr(equals + 1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    const bool is_chance =
        error == std::errc() && end == number.data() + number.size() && value >= 0.0 && value <= 1.0;
    if (!is_chance || (name != "miss" && name != "slip"))
      refuse_value("--noise", text, "miss=P, slip=P or both separated by a comma, with P from 0 to 1");
    (name == "miss" ? classic.miss : classic.slip) = value;
  }
}

Command parse_classic(const Words& words) {
  ClassicArguments classic;
  std::string speed, steps, noise, seed_text;
  Options options("classic", "walk a robot over cells, scan a map into a graph and plan ways");
  options.positional("MAP", classic.map, kMapHelp, PossibleValues::map());
  options.text("--start", classic.start, "X,Y,DIR", "start in this cell and heading (default: the map's)");
  options.text("--algorithm", classic.algorithm, "WHICH",
               "walk by the algorithm left, right or ai (default), or by a C++ file of your own",
               PossibleValues::of({"left", "right", "ai"}));
  options.text("--speed", speed, "S", "let a move take this many seconds (default: 1)");
  options.text("--steps", steps, "N", "allow this many moves");
  options.texts("--to", classic.to, "STATION",
                "drive to this station after the scan, or with the word all from each station to each other; "
                "may be repeated");
  options.text("--planner", classic.planner, "WHICH",
               "plan ways by bfs, dfs, iterative, pruned, climb, interval or dijkstra (default: climb on "
               "trees, else dijkstra)",
               PossibleValues::of(kPlanners));
  options.text("--noise", noise, "miss=P,slip=P",
               "set the probabilities that a cell is not seen and that a move fails");
  options.text("--seed", seed_text, "N", "seed the noise (default: 1)");
  options.flag("--trace", classic.trace, "print every move");
  options.flag("--json", classic.json, "print the result as JSON");
  if (const auto help = options.parse(words)) return *help;
  if (classic.map.empty()) {
    throw InputError(fmt::format("robosim classic requires a map: a file, or one of {}",
                                 one_of(launch::names_in(launch::stock_map_folder(), ".map"))));
  }
  if (classic.algorithm.empty()) classic.algorithm = "ai";
  if (!launch::is_path(classic.algorithm))
    check_choice("--algorithm", classic.algorithm, {"left", "right", "ai", "a C++ file"});
  if (!speed.empty()) classic.speed = seconds_a_move(speed);
  if (!steps.empty()) classic.steps = whole_number("--steps", steps, 1, kMostSeed);
  if (!noise.empty()) read_noise(noise, classic);
  if (!seed_text.empty()) classic.seed = seed_number(seed_text);
  if (!classic.planner.empty()) check_choice("--planner", classic.planner, kPlanners);
  if (classic.algorithm != "ai" && (!classic.to.empty() || !classic.planner.empty()))
    throw InputError("--to and --planner require --algorithm ai; the other algorithms know no stations");
  return classic;
}

const Words kRobotActions{"list", "show", "check"};

const char* summary_of_robot(const std::string& action) {
  if (action == "list") return "list the stock robots";
  return action == "show" ? "print the file of a robot" : "check a robot file";
}

Command parse_robot(Words words) {
  RobotArguments robot;
  const auto action = take_action("robot", words, kRobotActions);
  if (!action) return help_of_actions("robot", "list, print or check robots", parse_robot, kRobotActions);
  robot.action = *action;
  Options options("robot " + robot.action, summary_of_robot(robot.action));
  if (robot.action != "list")
    options.positional("ROBOT", robot.robot, "use this robot: a file, or the name of a stock robot",
                       PossibleValues::robot());
  if (robot.action == "show")
    options.flag("--full", robot.full, "print one file that also contains everything from its base robots");
  if (const auto help = options.parse(words)) return *help;
  if (robot.action != "list" && robot.robot.empty()) {
    throw InputError(fmt::format("robosim robot {} requires a robot: a file, or one of {}", robot.action,
                                 one_of(launch::names_in(launch::stock_robot_folder(), ".toml"))));
  }
  return robot;
}

Command parse_wire(const Words& words) {
  WireArguments wire;
  Options options("wire", "draft a robot file from a sketch's names and its use of the pins");
  options.positional("[SKETCH]", wire.sketch, kSketchHelp, PossibleValues::sketch());
  options.text("--board", wire.board, "BOARD", "draft a robot with this board (default: uno)",
               PossibleValues::of(board_names()));
  options.text("--map", wire.map, "MAP", "try the draft on this map: a file or a name (default: oval)",
               PossibleValues::map());
  options.text("--target", wire.target, "TARGET", "run the sketch on host, avr or stm32 (default: host)",
               targets());
  options.text("--env", wire.environment, "NAME", kEnvironmentHelp);
  options.texts("--libraries", wire.libraries, "DIR", kLibrariesHelp, PossibleValues::folder());
  options.text("--out", wire.out, "FILE", "write the draft to this file (default: standard output)",
               PossibleValues::file());
  if (const auto help = options.parse(words)) return *help;
  return wire;
}

Command parse_play(const Words& words) {
  PlayArguments play;
  Options options("play", "place a robot on a map, watch it scan, and send it to stations");
  options.positional("[MAP]", play.map,
                     "use this map: a file, or the name of a sample map (default: choose from a list)",
                     PossibleValues::map());
  options.text("--start", play.start, "X,Y,DIR",
               "offer this cell and heading as the robot's place (default: the map's start)");
  if (const auto help = options.parse(words)) return *help;
  if (play.map.empty() && !play.start.empty())
    throw InputError("--start requires a map, as in robosim play d --start 2,10,E");
  return play;
}

Command parse_help(const Words& words) {
  std::vector<std::string> command;
  Options options("help", "explain Robosim or one of its commands");
  options.positionals("[COMMAND]", command, "explain this command, such as run or map check",
                      PossibleValues::of(command_names()));
  if (const auto help = options.parse(words)) return *help;
  if (command.empty()) return PrintText{full_help(command_groups())};
  command.push_back("--help");
  return parse_arguments(command);
}

Command parse_completion(const Words& words) {
  std::string shell;
  Options options("completion", "print the code that completes robosim's commands in a shell",
                  "For bash: source <(robosim completion bash). For zsh: robosim completion zsh > "
                  "DIR/_robosim, with DIR in $fpath. For fish: robosim completion fish | source. The Debian "
                  "packages install all three.");
  options.positional("SHELL", shell, "print the code for bash, zsh or fish", PossibleValues::of(kShells));
  if (const auto help = options.parse(words)) return *help;
  if (shell.empty()) throw InputError("robosim completion requires a shell: bash, zsh or fish");
  check_choice("robosim completion", shell, kShells);
  return PrintText{completion(shell, command_groups())};
}

Command parse_man(const Words& words) {
  ManArguments man;
  Options options("man", "print the manual page of Robosim or of one of its commands",
                  "To read a page: robosim man run | man -l -");
  options.positional("[COMMAND]", man.command, "print the page of this command",
                     PossibleValues::of(command_names()));
  options.text("--out", man.out, "DIR", "write all pages into this folder instead", PossibleValues::folder());
  if (const auto help = options.parse(words)) return *help;
  if (!man.command.empty() && !man.out.empty())
    throw InputError("--out writes the pages of all commands; omit the name of a command");
  if (!man.command.empty()) parse_arguments({man.command, "--help"});  // rejects unknown commands
  return man;
}

/// A command and its group in the overview.
struct Entry {
  const char* group;
  const char* name;
  Command (*parse)(const Words&);
};

template <Command (*parse)(Words)>
Command with_copy(const Words& words) {
  return parse(words);
}

constexpr const char *kDrive = "Drive", *kLook = "Look", *kTest = "Test", *kFiles = "Robots and maps",
                     *kStations = "Stations", *kTool = "This program";

constexpr Entry kCommands[] = {{kDrive, "new", parse_new},
                               {kDrive, "run", parse_run},
                               {kDrive, "build", parse_build},
                               {kDrive, "flash", parse_flash},
                               {kLook, "serve", parse_serve},
                               {kLook, "why", parse_why},
                               {kLook, "replay", parse_replay},
                               {kLook, "compare", parse_compare},
                               {kTest, "test", parse_test},
                               {kTest, "sweep", parse_sweep},
                               {kTest, "hunt", parse_hunt},
                               {kTest, "mutate", parse_mutate},
                               {kTest, "report", parse_report},
                               {kFiles, "robot", with_copy<parse_robot>},
                               {kFiles, "wire", parse_wire},
                               {kFiles, "calibrate", parse_calibrate},
                               {kFiles, "map", with_copy<parse_map>},
                               {kStations, "play", parse_play},
                               {kStations, "classic", parse_classic},
                               {kTool, "help", parse_help},
                               {kTool, "completion", parse_completion},
                               {kTool, "man", parse_man}};

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const Entry& entry : kCommands) names.push_back(entry.name);
  return names;
}

}  // namespace

std::vector<CommandGroup> command_groups() {
  std::vector<CommandGroup> groups;
  for (const Entry& entry : kCommands) {
    if (groups.empty() || groups.back().title != entry.group) groups.push_back({entry.group, {}});
    groups.back().commands.push_back(std::get<PrintText>(entry.parse({"--help"})).help);
  }
  return groups;
}

Command parse_arguments(const std::vector<std::string>& words) {
  if (words.empty()) return PrintText{overview(command_groups())};
  const std::string& first = words[0];
  if (first == "--help" || first == "-h") return PrintText{full_help(command_groups())};
  if (first == "--version" || first == "-V") return PrintText{"robosim " ROBOSIM_VERSION "\n"};
  const Words rest(words.begin() + 1, words.end());
  for (const Entry& entry : kCommands)
    if (first == entry.name) return entry.parse(rest);
  if (first.starts_with('-'))
    throw InputError(fmt::format("unknown option: {}", expected_one_of(first, {"--help", "--version"})));
  throw InputError(unknown_name("command", first, command_names()));
}

}  // namespace robosim::cli
