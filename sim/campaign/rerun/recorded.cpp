#include "sim/campaign/rerun/recorded.h"

namespace robosim::campaign {

record::RecordedRun recorded(const launch::Prepared& run, const std::string& version) {
  return {version,    launch::title_of(run.sketch), run.map.name, run.robot.name, run.target, run.robot_info,
          run.request};
}

record::RecordedRun recorded(const launch::Fleet& fleet, const launch::PreparedFleet& run,
                             const std::string& version) {
  record::RecordedRun all = recorded(run.members.front(), version);
  all.request = run.request;
  for (std::size_t i = 0; i < run.members.size(); ++i) {
    const launch::Prepared& one = run.members[i];
    all.robots.push_back(
        {fleet.members[i].name, launch::title_of(one.sketch), one.robot.name, one.target, one.robot_info});
  }
  return all;
}

}  // namespace robosim::campaign
