// Draws the stimuli of a hunt: buttons, messages, manual moves, obstacles.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/hunt/test_case.h"
#include "sim/campaign/random_worlds/random_source.h"

namespace robosim::campaign {

inline bool chance(const random_worlds::RandomSource& rng, int of_100) { return rng(100) < of_100; }

template <typename T>
const T& pick(const random_worlds::RandomSource& rng, const std::vector<T>& from) {
  return from[static_cast<std::size_t>(rng(static_cast<int>(from.size())))];
}

/// Returns the openings, which are stimuli that may start a sketch: none, a button, the same button twice.
std::vector<std::vector<Stimulus>> openings(const HuntSpace& space);
/// Returns the beginnings of the lines that the sketch printed, each up to the line's first number. The
/// beginning of the last line comes last.
std::vector<std::string> beginnings_of(const std::string& serial);

/// Sets the opening, and draws up to four more stimuli at random times.
void draw_stimuli(TestCase& test_case, const HuntSpace& space, const random_worlds::RandomSource& rng);
/// Returns whether the sketch can receive messages.
bool hears(const HuntSpace& space);
/// Sets the opening, and draws a sequence of many messages. The sequence often starts after an output of the
/// sketch, because the sketch may then wait for messages. Usually, this is the last output.
void draw_talk(TestCase& test_case, const HuntSpace& space, const random_worlds::RandomSource& rng);
/// Blocks the line by an obstacle, which appears when the run begins and stays longer than most runs last.
void block(TestCase& test_case, const HuntSpace& space, const random_worlds::RandomSource& rng);
/// Repeats one input just before and twice after millis() exceeds 65,535, to expose 16-bit timestamps and
/// durations. Such code fails only on a chip.
void draw_late_stimuli(TestCase& test_case, const HuntSpace& space, const random_worlds::RandomSource& rng);
/// Adds a stimulus within two seconds after the moment.
void add_stimulus_after(TestCase& test_case, const Moment& moment, const HuntSpace& space,
                        const random_worlds::RandomSource& rng);
/// Adds a stimulus after `test_case.branch_point`, as the last stimulus.
void branch(TestCase& test_case, const HuntSpace& space, const random_worlds::RandomSource& rng);
/// Adds a stimulus.
void add_stimulus(TestCase& test_case, const HuntSpace& space, const random_worlds::RandomSource& rng);

/// Returns a stimulus as a line of a script.
std::string script_line(const Stimulus& stimulus);

}  // namespace robosim::campaign
