// Compares runs of the same test case that should be alike. One is on the host and one on the board's chip.
// Or both are on the chip, one with its clock near a wrap. If they always part at the same place, the sketch
// depends on something that it should not. Examples are the width of an int, the content of flash, the time
// since power-on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/cli/hunt/campaign_runner.h"
#include "sim/cli/hunt/oracle.h"
#include "sim/cli/hunt/test_case.h"

namespace robosim::cli {

/// Where two runs part: the first difference.
struct Divergence {
  std::string ours, other;                ///< their actions: `says "at 3"`
  std::string form;                       ///< of both, without numbers
  std::vector<double> of_ours, of_other;  ///< the numbers, if those differ
};

/// Returns where two runs part. Frequent lines are compared separately, times are not compared. `numbers`:
/// whether a number counts that is more than twice the other. Otherwise one chip is compared to itself, and a
/// line's frequency counts if it is more than five times the other.
std::optional<Divergence> divergence(const wire::RunResult& ours, const wire::RunResult& other, bool numbers);
/// Returns whether two pairs of runs part in the same way. Numbers that vary each time are chance.
bool is_same(const Divergence& a, const Divergence& b);

/// Returns the test case that should be alike.
TestCase counterpart_of(const TestCase& test_case, const HuntSpace& space);
/// Returns the test case with other noise, a little later. It has more time if one of the two may only be
/// slow. A difference by chance would not repeat there.
TestCase tried_again(const TestCase& test_case, const HuntSpace& space, int time);
inline constexpr int kTriedAgain = 3;

Symptom symptom_of(const Divergence& divergence, const TestCase& test_case, const HuntSpace& space);

/// Runs the counterparts of those test cases that have one and ran without a fault, and adds their symptoms.
/// Returns false if it was interrupted.
bool run_differential_tests(CampaignRunner& campaign, const std::vector<TestCase>& test_cases,
                            const std::vector<std::optional<wire::RunResult>>& results,
                            std::vector<std::vector<Symptom>>& found);

}  // namespace robosim::cli
