// Explains a verdict in one sentence, suggests the next step, and finds the decisive moment of the run.
#pragma once

#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/core/executor.h"
#include "sim/judge/goal.h"
#include "sim/judge/judge.h"
#include "sim/judge/outcome.h"
#include "sim/judge/script_fault.h"
#include "sim/judge/supply_summary.h"
#include "sim/map/map.h"
#include "sim/robot/robot.h"
#include "sim/world/body.h"

namespace robosim::judge {

/// The facts that an explanation may use.
struct Evidence {
  Verdict verdict = Verdict::timeout;
  SimTime t = 0;
  SimTime limit = 0;
  const map::Map* map = nullptr;
  const Goal* goal = nullptr;
  const Progress* progress = nullptr;
  const Judge* judge = nullptr;
  exec::Activity activity;
  std::optional<exec::Crash> crash;
  std::vector<exec::DivisionByZero> divisions_by_zero;
  int int_bits = 32;                 ///< size of the firmware's int
  std::string exceeded;              ///< description of the exceeded budget
  const BoardSpec* board = nullptr;  ///< provides the names of pins; null = use their numbers
  std::vector<robot::WiredPin> wiring;
  std::vector<bool> went_high;   ///< per pin: the firmware drove it high, or with PWM, at least once
  std::vector<bool> was_output;  ///< per pin: it was an output at least once
  std::vector<bool>
      was_pulled_up;         ///< per pin: its pull-up was on, e.g. by digitalWrite(pin, HIGH) of an input
  bool pin_level = false;    ///< the present level of the pin that the sketch reads
  bool pin_changed = false;  ///< the sketch has read both levels at this pin
  bool on_chip = false;      ///< the firmware is a chip's image, whose calls are known only by their effects
  bool in_contact = false;   ///< the body touches an obstruction
  std::string stopped_by = "a wall, an obstacle or the map's edge";  ///< what the body touches
  double left_command = 0.0, right_command = 0.0;                    ///< motor commands at the end, -1..1
  double strongest_command[2] = {0.0, 0.0};  ///< largest absolute commands, 0..1, by world::Side
  double turning_drive = 0.0;                ///< smallest share of full power that turns a wheel from rest
  SimTime sensors_read = kNever;             ///< last read of a floor sensor by the sketch; kNever = none
  double line_side = 0.0;  ///< distance in m by which the line was last left of the middle; below 0 = right
  double steered = 0.0;    ///< mean command difference while the line is off-centre; above 0 = towards it
  bool moved = false;      ///< a wheel turned
  SimTime off_line = 0;    ///< time in which no sensor saw the line
  int collisions = 0;
  double distance_m = 0.0;  ///< path of the axle's centre
  world::Toppled toppled = world::Toppled::no;
  Vec2 at;                          ///< the robot's position
  std::vector<ScriptFault> faults;  ///< the script's faults so far, by time
  SupplySummary power;
};

/// Returns whether a sensor last saw the line half a second or longer before `t`, and the robot has moved
/// since. The robot must have moved, because a script may remove the line under a robot that stands still.
bool left_line_before(const Evidence& evidence, SimTime t);
/// Returns whether the robot has made two or more turns in one direction at its present place, and still
/// turns.
bool spins(const Evidence& evidence);
/// Returns whether the robot reached a goal of laps, but was off the line for at least a quarter of the time.
bool was_off_line(const Evidence& evidence);
/// Returns one sentence that explains why the run ended.
std::string explain(const Evidence& evidence);
NextStep next_step(const Evidence& evidence);
Decisive decisive_moment(const Evidence& evidence);

}  // namespace robosim::judge
