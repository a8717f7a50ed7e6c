// Draws the stimuli of a hunt: buttons, messages, manual moves, obstacles.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/hunt/world.h"
#include "sim/worlds/die.h"

namespace robosim::cli {

inline bool chance(const worlds::Die& die, int of_100) { return die(100) < of_100; }

template <typename T>
const T& pick(const worlds::Die& die, const std::vector<T>& from) {
  return from[static_cast<std::size_t>(die(static_cast<int>(from.size())))];
}

/// Returns what may start a sketch: nothing, a button, the same button twice.
std::vector<std::vector<Deed>> openings(const HuntSpace& space);
/// Returns the beginnings of the sketch's lines, up to their first number; the last line last.
std::vector<std::string> beginnings_of(const std::string& serial);

/// Draws the opening, and at most four more stimuli at any time.
void draw_deeds(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);
/// Returns whether the sketch can receive messages.
bool hears(const HuntSpace& space);
/// Draws the opening, and many messages in sequence. They often start where the sketch has sent something,
/// most often the last thing, after which it may wait for them.
void draw_talk(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);
/// Puts an obstacle on the line from the beginning, for longer than most runs.
void block(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);
/// Repeats one input just before and twice after millis() exceeds 65,535, to expose 16-bit timestamps and
/// durations. They fail on a chip only.
void draw_late_deeds(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);
/// Adds a stimulus within two seconds after the moment.
void add_deed_behind(HuntWorld& world, const Moment& moment, const HuntSpace& space, const worlds::Die& die);
/// Adds one after `world.parting`, as its last stimulus.
void branch(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);
/// Adds a stimulus.
void add_deed(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);

/// Returns the line of a script.
std::string script_line(const Deed& deed);

}  // namespace robosim::cli
