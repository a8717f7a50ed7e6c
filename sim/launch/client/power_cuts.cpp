#include "sim/launch/client/power_cuts.h"

#include <utility>

namespace robosim::client {

std::string PowerCut::script() const {
  return "after eeprom " + std::to_string(write) + " power off for 20ms byte " + byte + "\n";
}

std::string PowerCut::text() const {
  return "power cut during write " + std::to_string(write) + " to the EEPROM, its byte left " + byte;
}

std::vector<PowerCut> all_power_cuts(std::uint64_t writes) {
  std::vector<PowerCut> cuts;
  for (std::uint64_t write = 1; write <= writes; ++write)
    for (const char* byte : {"old", "erased", "new"}) cuts.push_back({write, byte});
  return cuts;
}

Answer run_with_power_cuts(Pool& pool, const Task& task, const OnPowerCut& cut) {
  Answer whole = Failure{Failure::Kind::internal, "the run was interrupted"};
  pool.run({1,
            [&](std::size_t) { return task; },
            [&](std::size_t, Answer answer) { whole = std::move(answer); },
            {}});
  const auto* const result = std::get_if<result::RunResult>(&whole);
  if (!result) return whole;
  const std::vector<PowerCut> cuts = all_power_cuts(result->eeprom_writes);
  const auto task_of = [&](std::size_t i) {
    Task run = task;
    std::string& script = run.request.script;
    if (!script.empty() && script.back() != '\n') script += '\n';
    script += cuts[i].script();
    return run;
  };
  pool.run(
      {cuts.size(), task_of, [&](std::size_t i, Answer answer) { cut(cuts[i], std::move(answer)); }, {}});
  return whole;
}

}  // namespace robosim::client
