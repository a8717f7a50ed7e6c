#include "sim/cli/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "sim/base/error.h"
#include "sim/base/spelling.h"
#include "sim/base/units.h"
#include "sim/cli/calibrate/calibrate_command.h"
#include "sim/cli/check/test_arguments.h"
#include "sim/cli/compare/compare_arguments.h"
#include "sim/cli/files/print_arguments.h"
#include "sim/cli/help_text.h"
#include "sim/cli/hunt/hunt_arguments.h"
#include "sim/cli/mutate/mutate_arguments.h"
#include "sim/cli/options.h"
#include "sim/cli/report/report_arguments.h"
#include "sim/cli/run/fleet_arguments.h"
#include "sim/cli/run/why_arguments.h"
#include "sim/cli/run_options.h"
#include "sim/cli/serve/serve_arguments.h"
#include "sim/cli/sweep/sweep_arguments.h"
#include "sim/grid/generator.h"
#include "sim/launch/names.h"

namespace robosim::cli {
namespace {

const std::vector<std::string> kCommands{
    "run",  "why", "replay", "sweep", "report",    "compare", "play",   "classic", "build", "flash",
    "wire", "map", "robot",  "serve", "calibrate", "test",    "mutate", "hunt",    "new"};

double view_speed(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= 0.0) || value > 1e6) {
    refuse_value("--speed", text, "a number such as 2 (twice real time); 0 is as fast as possible");
  }
  return value;
}

using Words = std::vector<std::string>;

Command parse_run(const Words& words) {
  RunArguments run;
  std::string speed, port;
  Options options("run", "Runs a sketch on a robot on a map, and judges it.");
  options.text("--map", run.map, "MAP", "file, or name of a sample map");
  FleetOptions robots(options, run);
  RunOptions shared(options, run);
  shared.time();
  shared.seed();
  shared.common();
  options.texts("--record", run.record, "FILE",
                "a page to replay the run (.html), samples (.csv), pins (.vcd) …; may be repeated");
  options.texts("--plot", run.plot, "FILE", "a picture of where the robot drove, as .svg or .png");
  options.text("--coverage", run.coverage, "DIR",
               "which lines of the sketch ran, over all runs with this DIR");
  options.flag("--sanitize", run.sanitize, "stop at the first bad index, overflow, wild pointer …");
  options.text("--gdb", port, "PORT", "wait at this port for gdb, which then halts sketch and world (chip)");
  options.flag("--untrusted", run.untrusted, kUntrusted);
  options.flag("--view", run.view, "watch the run in the terminal");
  options.text("--speed", speed, "N", "of the view; default: 1, real time; 0: as fast as possible");
  options.flag("--live", run.live,
               "for programs: play, pause, step, act, by JSON lines (docs/howto/serving.md)");
  options.flag("--serial", run.serial, "print what the sketch sends, and the result to standard error");
  options.flag("--json", run.json, "print the result as JSON");
  options.flag("--timing", run.timing, "also say how much wall time the run took");
  if (const auto help = options.parse(words)) return PrintText{*help};
  shared.finish();
  if (!port.empty()) run.request.gdb_port = static_cast<int>(whole_number("--gdb", port, 1, 65535));
  if (!speed.empty()) run.speed = view_speed(speed);
  if (run.view + run.json + run.serial + run.live > 1)
    throw InputError("--view, --live, --json and --serial want the standard output; give one of them");
  robots.finish();
  if (!speed.empty() && !run.view) throw InputError("--speed is the speed of the view; give --view too");
  return run;
}

Command parse_replay(const Words& words) {
  ReplayArguments replay;
  std::string speed;
  Options options("replay", "Plays a recorded run in the terminal.");
  options.positional("FILE", replay.file, "what run --record has written: .html or .rec");
  options.text("--speed", speed, "N", "default: 1, real time; 0: as fast as possible");
  options.text("--over", replay.over, "OTHER",
               "how far apart it is from another run: a recording, or a .csv log with time, x and y");
  options.texts(
      "--record", replay.record, "FILE",
      "writes it anew: a page (.html; with --over it shows both), .rec, .perfetto.json; may be repeated");
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (replay.file.empty())
    throw InputError("robosim replay needs a recording, as in robosim replay run.html");
  if (!speed.empty()) replay.speed = view_speed(speed);
  return replay;
}

Command parse_build(const Words& words) {
  BuildArguments build;
  Options options("build", "Compiles a sketch as Arduino would, and says its size.");
  options.positional("SKETCH", build.sketch, "folder, .ino file or name; default: the current folder");
  options.text("--robot", build.robot, "ROBOT", "file or name: its board is compiled for");
  options.text("--target", build.target, "TARGET", "host, avr or stm32");
  options.text("--out", build.out, "DIR", "put the compiled files there, under the sketch's name");
  options.text("--env", build.environment, "NAME", kEnvironment);
  options.texts("--libraries", build.libraries, "DIR", "a folder of Arduino libraries; may be repeated");
  options.text("--warnings", build.warnings, "LEVEL", "none, default, more or all");
  options.flag("--sanitize", build.sanitize, "with the checks of run --sanitize");
  if (const auto help = options.parse(words)) return PrintText{*help};
  check_choice("--warnings", build.warnings, {"none", "default", "more", "all"});
  return build;
}

Command parse_flash(const Words& words) {
  FlashArguments flash;
  std::string baud;
  Options options("flash", "Builds a sketch for the robot's chip, and writes it to the board by avrdude.");
  options.positional("SKETCH", flash.sketch, "folder, .ino file or name; default: the current folder");
  options.text("--port", flash.port, "PORT", "where the board is, as /dev/ttyACM0 or /dev/ttyUSB0");
  options.text("--robot", flash.robot, "ROBOT", "file or name: its board is compiled for");
  options.text("--baud", baud, "N", "of the boot loader; default: the board's; an old Nano's has 57600");
  options.text("--env", flash.environment, "NAME", kEnvironment);
  options.texts("--libraries", flash.libraries, "DIR", "a folder of Arduino libraries; may be repeated");
  options.flag("--dry-run", flash.dry_run, "print the command and the image's SHA-256, write nothing");
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (!baud.empty()) flash.baud = whole_number("--baud", baud, 300, 2'000'000);
  if (flash.port.empty())
    throw InputError(
        "robosim flash needs the board's port, as in --port /dev/ttyACM0 (most Unos) or /dev/ttyUSB0 (most "
        "Nanos); “ls /dev/ttyACM* /dev/ttyUSB*” with and without the board plugged in shows which one it is");
  return flash;
}

/// Returns the action that must come first; `usage` if help is requested instead.
std::optional<std::string> take_action(const std::string& command, Words& words,
                                       const std::vector<std::string>& actions) {
  if (words.empty()) throw InputError("robosim " + command + " needs to know what to do: " + one_of(actions));
  const std::string action = words[0];
  if (action == "--help" || action == "-h") return std::nullopt;
  if (std::find(actions.begin(), actions.end(), action) == actions.end()) {
    throw InputError(
        fmt::format("robosim {} cannot “{}”; {}", command, action, guess_and_list(action, actions)));
  }
  words.erase(words.begin());
  return action;
}

Command parse_generate(const Words& words) {
  GenerateArguments generate;
  std::string stations, count = "1", first_seed = "1";
  Options options("map generate",
                  "Generates random maps. The same family, number and seed give the same map.");
  options.text("--family", generate.family, "tree|cycles|grid",
               "junctions of three ways; with cycles; streets");
  options.text("--stations", stations, "N", "how many dead ends, up to a million");
  options.text("--count", count, "K", "how many maps, with seeds S, S+1, … (default 1)");
  options.text("--seed", first_seed, "S", "of the first map (default 1)");
  options.text("--out", generate.out, "DIR", "folder for FAMILY-N-SEED.map (default: the current one)");
  if (const auto help = options.parse(words)) return PrintText{*help};
  for (const auto& [option, value] : {std::pair{"--family", &generate.family}, {"--stations", &stations}})
    if (value->empty()) throw InputError(fmt::format("robosim map generate needs {}", option));
  check_choice("--family", generate.family, {"tree", "cycles", "grid"});
  generate.stations =
      static_cast<int>(whole_number("--stations", stations, grid::kMinStations, grid::kMaxStations));
  generate.seed = seed_number(first_seed);
  generate.count = whole_number("--count", count, 1, 1'000'000);
  if (generate.count - 1 > kMostSeed - generate.seed) refuse_value("--count", count, "less: the seeds end");
  return generate;
}

Command parse_import(const Words& words) {
  ImportArguments import;
  std::string pixel, pitch;
  bool walls = false;
  Options options("map import",
                  "Makes a map of another tool's course: robotrace_course_cad's and rcj-rescue-cms' JSON, "
                  "lengths with curvatures, "
                  "points, mazes of micromouse, a picture (docs/reference/courses.md).");
  options.positional("FILE", import.file, "the course");
  options.text("--out", import.out, "MAP", "the map's file (default: standard output)");
  options.text("--pixel", pixel, "LENGTH", "of a picture: the side of a pixel, such as 0.5mm");
  options.flag("--walls", walls, "a maze with its walls, in place of lines through its passages");
  options.text("--pitch", pitch, "LENGTH", "of such a maze's cells (default: 180mm)");
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (!pitch.empty() && !walls) throw InputError("--pitch is of a maze with walls: --walls");
  if (walls) {
    const auto length = parse_quantity(pitch.empty() ? "180mm" : pitch, Dimension::length);
    if (!length || !(*length >= 0.05 && *length <= 2.0))
      refuse_value("--pitch", pitch, "50 mm to 2 m, such as 180mm");
    import.walls_m = *length;
  }
  if (!pixel.empty()) {
    const auto length = parse_quantity(pixel, Dimension::length);
    if (!length || !(*length >= 1e-5 && *length <= 0.1))
      refuse_value("--pixel", pixel, "0.01 to 100 mm, such as 0.5mm");
    import.pixel_m = *length;
  }
  if (import.file.empty()) throw InputError("robosim map import needs the course's file");
  return import;
}

Command parse_map(Words words) {
  MapArguments map;
  const auto action = take_action("map", words, {"check", "show", "graph", "generate", "import", "print"});
  if (action == "generate") return parse_generate(words);
  if (action == "import") return parse_import(words);
  if (action == "print") return parse_print(words);
  Options options(
      "map " + action.value_or("check|show|graph|generate|import|print"),
      "Checks a map file, draws it with its stations, tells its graph, makes, imports or prints maps.");
  options.positional("MAP", map.map, "file, or name of a sample map");
  options.text("--start", map.start, "X,Y,DIR", "start: stations are numbered from there");
  const bool is_graph = action.value_or("graph") == "graph";
  if (is_graph || action == "check")
    options.flag("--json", map.json, is_graph ? "the graph for programs" : "what was found, for programs");
  if (is_graph) {
    options.flag("--dot", map.dot, "the graph for Graphviz");
  }
  if (const auto help = options.parse(words)) return PrintText{*help};
  map.action = *action;
  if (map.json && map.dot) throw InputError("robosim map graph prints either --json or --dot");
  if (map.map.empty()) {
    throw InputError("robosim map " + map.action + " needs a map: a file, or one of " +
                     one_of(launch::names_in(launch::stock_map_folder(), ".map")));
  }
  return map;
}

double seconds_a_move(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= 0.0) || value > 1e6)
    refuse_value("--speed", text, "the seconds that a move takes, a number from 0 to 1000000");
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
      refuse_value("--noise", text, "miss=P, slip=P or both with a comma between them, P from 0 to 1");
    (name == "miss" ? classic.miss : classic.slip) = value;
  }
}

Command parse_classic(const Words& words) {
  ClassicArguments classic;
  std::string speed, steps, noise, seed_text;
  Options options("classic", "The robot on cells: it walks, scans a floor into a graph, and finds its way.");
  options.positional("MAP", classic.map, "file, or name of a sample map");
  options.text("--start", classic.start, "X,Y,DIR", "start; default: the map's");
  options.text("--algorithm", classic.algorithm, "WHICH",
               "left, right, ai (default), or a C++ file of your own");
  options.text("--speed", speed, "S", "seconds a move takes (default 1)");
  options.text("--steps", steps, "N", "moves allowed");
  options.texts("--to", classic.to, "STATION",
                "after the scan: drive there; all = every ordered pair; may be repeated");
  options.text(
      "--planner", classic.planner, "WHICH",
      "bfs, dfs, iterative, pruned, climb, interval or dijkstra (default: climb on trees, else dijkstra)");
  options.text("--noise", noise, "miss=P,slip=P", "chances that a cell is not seen, that a move fails");
  options.text("--seed", seed_text, "N", "of the noise (default 1)");
  options.flag("--trace", classic.trace, "every move");
  options.flag("--json", classic.json, "for programs");
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (classic.map.empty()) {
    throw InputError("robosim classic needs a map: a file, or one of " +
                     one_of(launch::names_in(launch::stock_map_folder(), ".map")));
  }
  if (classic.algorithm.empty()) classic.algorithm = "ai";
  if (!launch::is_path(classic.algorithm))
    check_choice("--algorithm", classic.algorithm, {"left", "right", "ai", "a C++ file"});
  if (!speed.empty()) classic.speed = seconds_a_move(speed);
  if (!steps.empty()) classic.steps = whole_number("--steps", steps, 1, kMostSeed);
  if (!noise.empty()) read_noise(noise, classic);
  if (!seed_text.empty()) classic.seed = seed_number(seed_text);
  if (!classic.planner.empty())
    check_choice("--planner", classic.planner,
                 {"bfs", "dfs", "iterative", "pruned", "climb", "interval", "dijkstra"});
  if (classic.algorithm != "ai" && (!classic.to.empty() || !classic.planner.empty()))
    throw InputError("--to and --planner go with --algorithm ai: the others know no stations");
  return classic;
}

Command parse_robot(Words words) {
  RobotArguments robot;
  const auto action = take_action("robot", words, {"list", "show", "check"});
  Options options("robot " + action.value_or("list|show|check"),
                  "The robots there are, the text of one, a file checked.");
  if (action != "list") options.positional("ROBOT", robot.robot, "file, or name of a stock robot");
  if (action == "show")
    options.flag("--full", robot.full, "with what it has from the robots that it is based on, as one file");
  if (const auto help = options.parse(words)) return PrintText{*help};
  robot.action = *action;
  if (robot.action != "list" && robot.robot.empty()) {
    throw InputError("robosim robot " + robot.action + " needs a robot: a file, or one of " +
                     one_of(launch::names_in(launch::stock_robot_folder(), ".toml")));
  }
  return robot;
}

Command parse_wire(const Words& words) {
  WireArguments wire;
  Options options("wire",
                  "Drafts a robot file for a sketch, from its names and from what it does to its pins.");
  options.positional("SKETCH", wire.sketch,
                     "a folder, its .ino, or one of ours; without it, the current folder");
  options.text("--board", wire.board, "BOARD", "that the robot carries; default: uno");
  options.text("--map", wire.map, "MAP", "file or name: the draft is tried on it; default: oval");
  options.text("--target", wire.target, "TARGET", "host, or the chip's: avr or stm32");
  options.text("--env", wire.environment, "NAME", kEnvironment);
  options.texts("--libraries", wire.libraries, "DIR", "a folder of Arduino libraries; may be repeated");
  options.text("--out", wire.out, "FILE", "is written; default: standard output");
  if (const auto help = options.parse(words)) return PrintText{*help};
  return wire;
}

Command parse_play(const Words& words) {
  PlayArguments play;
  Options options("play", "A session in the terminal: place the robot, watch it scan, send it to stations.");
  options.positional("MAP", play.map, "file, or name of a sample map; without it, a list to choose from");
  options.text("--start", play.start, "X,Y,DIR", "where placing the robot begins; default: the map's start");
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (play.map.empty() && !play.start.empty())
    throw InputError("--start is a place on a map; name the map too, as in robosim play d --start 2,10,E");
  return play;
}

}  // namespace

Command parse_arguments(const std::vector<std::string>& words) {
  if (words.empty()) return PrintText{kExamples};
  const std::string& first = words[0];
  if (first == "--help" || first == "-h" || first == "help") return PrintText{kHelp};
  if (first == "--version") return PrintText{"robosim " ROBOSIM_VERSION "\n"};
  const Words rest(words.begin() + 1, words.end());
  if (first == "run") return parse_run(rest);
  if (first == "why") return parse_why(rest);
  if (first == "replay") return parse_replay(rest);
  if (first == "sweep") return parse_sweep(rest);
  if (first == "report") return parse_report(rest);
  if (first == "compare") return parse_compare(rest);
  if (first == "play") return parse_play(rest);
  if (first == "classic") return parse_classic(rest);
  if (first == "build") return parse_build(rest);
  if (first == "flash") return parse_flash(rest);
  if (first == "map") return parse_map(rest);
  if (first == "wire") return parse_wire(rest);
  if (first == "robot") return parse_robot(rest);
  if (first == "calibrate") return parse_calibrate(rest);
  if (first == "serve") return parse_serve(rest);
  if (first == "test") return parse_test(rest);
  if (first == "mutate") return parse_mutate(rest);
  if (first == "hunt") return parse_hunt(rest);
  if (first == "new") return parse_new(rest);
  if (first.starts_with('-')) throw InputError(unknown_name("option", first, {"--help", "--version"}));
  throw InputError(unknown_name("command", first, kCommands));
}

}  // namespace robosim::cli
