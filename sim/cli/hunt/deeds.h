// What people do to a robot in a hunt: buttons, messages, hands, what they put in its way.
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

/// What may make a sketch go: nothing, a button, the same again.
std::vector<std::vector<Deed>> openings(const HuntSpace& space);
/// How the lines that a sketch has sent begin, up to their first number; the last line last.
std::vector<std::string> beginnings_of(const std::string& serial);

/// The opening, and at most four more at any time.
void draw_deeds(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);
/// Whether anybody can talk to the sketch.
bool hears(const HuntSpace& space);
/// The opening, and many messages one after the other; often from where the sketch has sent something, most
/// of all the last thing, behind which it may wait for them.
void draw_talk(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);
/// Something stands on the line from the beginning, for longer than most runs.
void block(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);
/// The same is pressed, or sent, a little before 16 bits do not hold the milliseconds since power-on any
/// more, and twice behind that: what an `int` takes the time of, or the time from one to the next, goes
/// wrong, on a chip only.
void draw_late_deeds(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);
/// One more, within two seconds of the moment.
void add_deed_behind(HuntWorld& world, const Moment& moment, const HuntSpace& space, const worlds::Die& die);
/// The same of `world.parting`, as its last deed.
void branch(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);
/// One more.
void add_deed(HuntWorld& world, const HuntSpace& space, const worlds::Die& die);

/// Of a script.
std::string script_line(const Deed& deed);

}  // namespace robosim::cli
