// Runs a test case in two ways that should give equal behaviour, and compares the two runs. Either one run is
// on the host, and the other run on the board's chip. Or both runs are on the chip, and the clock of only one
// run is close to its wrap.
//
// If the two runs always diverge in the same way, the sketch depends on something that should not matter.
// Examples are the width of an int, the content of flash, and the time since power-on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/campaign/hunt/campaign_runner.h"
#include "sim/campaign/hunt/oracle.h"
#include "sim/campaign/hunt/test_case.h"

namespace robosim::campaign {

/// The first difference between two runs.
struct Divergence {
  std::string ours, other;                ///< behaviour of each run: `says "at 3"`
  std::string form;                       ///< form of both lines, without numbers
  std::vector<double> of_ours, of_other;  ///< the numbers, if they differ
};

/// Returns the first difference between two runs. Compares frequent lines separately, and ignores times. With
/// `numbers`, two numbers differ if they are more than 20 apart and one is more than twice the other. Without
/// `numbers`, counts of a frequent line differ if one is more than five times the other. Runs on one chip are
/// compared without `numbers`.
std::optional<Divergence> divergence(const result::RunResult& ours, const result::RunResult& other,
                                     bool numbers);
/// Returns whether two pairs of runs diverge in the same way. Numbers that vary from pair to pair count as
/// chance.
bool is_same(const Divergence& a, const Divergence& b);

/// Returns the test case whose run should resemble the run of `test_case`.
TestCase counterpart_of(const TestCase& test_case, const HuntSpace& space);
/// Returns the test case with other noise and slightly later stimuli, to rule out chance. Gives the test case
/// more time, in case one of the two runs is only slow. `time` is the number of the repetition, from 1.
TestCase tried_again(const TestCase& test_case, const HuntSpace& space, int time);
inline constexpr int kTriedAgain = 3;

Symptom symptom_of(const Divergence& divergence, const TestCase& test_case, const HuntSpace& space);

/// Runs the counterpart of each test case that needs one and has shown no symptom. Adds a symptom for each
/// divergence. Returns false if the user interrupted the runs.
bool run_differential_tests(CampaignRunner& campaign, const std::vector<TestCase>& test_cases,
                            const std::vector<std::optional<result::RunResult>>& results,
                            std::vector<std::vector<Symptom>>& found);

}  // namespace robosim::campaign
