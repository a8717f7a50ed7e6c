// The output of `robosim` and `robosim --help`.
#pragma once

namespace robosim::cli {

inline constexpr const char* kExamples =
    R"(Robosim runs your Arduino line follower on a simulated robot, and judges it.

  robosim run PidFollower --map oval        a sketch of ours on a map of ours
  robosim run PidFollower --view            watch it drive
  robosim serve                             choose, run, press buttons and look, in the browser
  robosim run my/Sketch --map my.map        your own sketch, on your own map
  robosim wire my/Sketch --out my/Sketch/robot.toml    drafts your robot's file from what the sketch does
  robosim play                              choose a map, watch it scanned, send the robot to stations
  robosim run LeftPath --map d --robot uno3 --json     results for a program to read

robosim --help lists the commands, robosim run --help the options.
)";

inline constexpr const char* kHelp = R"(robosim COMMAND …

  run [SKETCH]                run a sketch on a robot on a map, and judge it
  why [SKETCH]                the same, and back from the verdict to the lines of the sketch that caused it
  replay FILE                 play what run --record has written, in the terminal; hold it against another
  serve [FOLDER]              the same in the browser, for all sketches, robots and maps of a folder
  sweep SKETCH…               many runs, by seed, map, robot and target: how often do they succeed?
  report FILE                 a page of a sweep's table, or of the checks of a class: who passed, where the line was left
  compare [SKETCH]            the first thing that host, AVR and STM32 do differently
  play [MAP]                  watch and steer the robot on a map, step by step, in the terminal
  classic MAP                 the robot on cells: walk, scan and find the way
  build [SKETCH]              compile a sketch as Arduino would, and say its size
  flash [SKETCH] --port PORT  write a sketch to the board, as tested on --target avr
  wire [SKETCH]               draft a robot file: which part is on which pin, from what the sketch does
  map check|show|graph MAP    check a map file; draw it with stations and coordinates; its graph
  map generate                make random maps: trees, cycles, streets
  map import FILE             make a map of another tool's course
  map print MAP --out F.pdf   a floor in true size, on sheets of paper to lay on the floor
  robot list|show|check       the robots; the text of one; check a robot file
  calibrate ROBOT LOG…        fit a robot file to logs of the real robot
  test [SKETCH…]              what the checks.toml beside a sketch asks for (in a checkout: Robosim's own tests)
  mutate [SKETCH]             small bugs, drawn at random: which of them do these checks not find?
  hunt [SKETCH]               what goes wrong without anybody having written a test: drawn worlds, buttons, faults
  new NAME                    a project to begin with: sketch, robot, track, checks

  robosim COMMAND --help      the options of a command
  robosim --version           the version

SKETCH is a folder, an .ino file or the name of a sketch of ours; without it, the current folder. A name with / or . in
it is a path.

Exit status: 0 the goal was reached, or the check holds · 1 lost, stuck, toppled, hung, ended, crashed, or a difference · 2 usage, a bad file, or
a sketch that does not compile · 3 a fault of Robosim's own · 4 time was up · 5 a tool is missing · 130 Ctrl-C
)";

}  // namespace robosim::cli
