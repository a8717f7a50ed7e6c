#include "robosim/testing/power_cuts.h"

#include <gtest/gtest.h>

#include "sim/launch/client/power_cuts.h"
#include "sim/testing/silent_run.h"

namespace robosim::testing {

constexpr const char* kWithoutCut = "in a run without a power cut";

void AtEveryPowerCut(const Trial& trial, const std::function<void(Simulation&)>& body, const char* file,
                     int line) {
  std::uint64_t writes = 0;
  const auto counted = [&](Simulation& robot) {
    body(robot);
    writes = robot.eeprom_writes();
  };
  if (fails_in(trial, counted)) {
    rerun_and_report(trial, body, kWithoutCut, file, line);
    return;
  }
  if (writes == 0) {
    const auto complain = [&](Simulation& robot) {
      body(robot);
      ADD_FAILURE_AT(file, line)
          << "the sketch wrote nothing to its EEPROM, so that there is no moment for a power cut";
    };
    rerun_and_report(trial, complain, kWithoutCut, file, line);
    return;
  }
  for (const client::PowerCut& cut : client::all_power_cuts(writes)) {
    Trial with_cut = trial;
    if (!with_cut.script.empty() && with_cut.script.back() != '\n') with_cut.script += '\n';
    with_cut.script += cut.script();
    if (!fails_in(with_cut, body)) continue;
    rerun_and_report(with_cut, body, "in a run with a " + cut.text(), file, line);
    return;
  }
}

}  // namespace robosim::testing
