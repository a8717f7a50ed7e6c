// Runs that should be alike: the same world on the host and on the board's chip, or on the chip with its
// clock near a wrap and without. Where they always part in the same place, the sketch depends on what it
// should not: the width of an int, what is in flash, how long the power has been on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/cli/hunt/bench.h"
#include "sim/cli/hunt/symptom.h"
#include "sim/cli/hunt/world.h"

namespace robosim::cli {

/// Where two runs part: the first thing that is not alike.
struct Parting {
  std::string ours, other;                ///< what they do: `says "at 3"`
  std::string form;                       ///< of both, without numbers
  std::vector<double> of_ours, of_other;  ///< the numbers, if it is those that differ
};

/// Lines that come often are looked at by themselves, times are not; `numbers`: whether those count, if one
/// is more than twice the other. Where they do not, one chip is held against itself, and how often a line
/// comes counts, if it is more than five times as often.
std::optional<Parting> parting(const wire::RunResult& ours, const wire::RunResult& other, bool numbers);
/// Whether two pairs of runs part in the same way. Numbers that are another each time are chance.
bool is_same(const Parting& a, const Parting& b);

/// The world that should be alike.
HuntWorld twin_of(const HuntWorld& world, const HuntSpace& space);
/// The same with other noise, everything a little later, and (where one of the two may only be slow) more
/// time: chance would not part them again.
HuntWorld tried_again(const HuntWorld& world, const HuntSpace& space, int time);
inline constexpr int kTriedAgain = 3;

Symptom symptom_of(const Parting& parting, const HuntWorld& world, const HuntSpace& space);

/// Makes the twins of those worlds that have one and went without a fault, and adds to what was found in
/// them. False if it was interrupted.
bool look_at_twins(HuntBench& bench, const std::vector<HuntWorld>& worlds,
                   const std::vector<std::optional<wire::RunResult>>& results,
                   std::vector<std::vector<Symptom>>& found);

}  // namespace robosim::cli
