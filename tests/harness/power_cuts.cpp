#include "robosim/testing/power_cuts.h"

#include <gtest/gtest.h>

#include "sim/client/power_cuts.h"

namespace robosim::testing {
namespace {

/// The writes to the EEPROM of one run.
std::uint64_t run(const Trial& trial, const std::string& what, const std::function<void(Simulation&)>& body) {
  Simulation robot(trial);
  body(robot);
  if (::testing::Test::HasFailure()) ADD_FAILURE() << what << "\n  replay: " << robot.replay_command();
  return robot.eeprom_writes();
}

}  // namespace

void AtEveryPowerCut(const Trial& trial, const std::function<void(Simulation&)>& body) {
  const std::uint64_t writes = run(trial, "this was without any power cut", body);
  if (::testing::Test::HasFailure()) return;
  if (writes == 0) {
    ADD_FAILURE() << "the sketch wrote nothing to its EEPROM: there is no place for a power cut";
    return;
  }
  for (const client::PowerCut& cut : client::all_power_cuts(writes)) {
    Trial with_cut = trial;
    if (!with_cut.script.empty() && with_cut.script.back() != '\n') with_cut.script += '\n';
    with_cut.script += cut.script();
    run(with_cut, "this was with a " + cut.text(), body);
    if (::testing::Test::HasFailure()) return;
  }
}

}  // namespace robosim::testing
