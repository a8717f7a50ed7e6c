#include "sim/detect/avr/torn_access.h"

namespace robosim::detect::avr {
TornAccess::TornAccess(const RunningProgram& program)
    : machine_(program.machine),
      debug_(program.debug),
      race_analysis_(program.firmware, program.debug, machine_.chip().chip(),
                     [this](std::uint32_t pc) { machine_.chip().show(*this, pc); }) {
  machine_.chip().show_handlers(*this);
}

void TornAccess::visited(std::uint32_t pc, Cycle) { race_analysis_.visited(pc); }

void TornAccess::entered(int vector, Cycle) { race_analysis_.entered(vector); }

void TornAccess::left() {
  race_analysis_.left();
  found_at_.resize(race_analysis_.found().size(), machine_.now());
}

std::vector<Detected> TornAccess::found(SimTime) const {
  std::vector<Detected> all;
  for (const exec::avr::RaceAnalysis::Found& found : race_analysis_.found()) {
    std::string mend = fix_of(found.kind) + ".";
    mend[0] = static_cast<char>(mend[0] - 'a' + 'A');
    all.push_back({check_of(found.kind), torn_text(found, debug_, machine_.chip().clock_hz()), mend,
                   debug_.place(found.pc), 1e-9 * static_cast<double>(found_at_[all.size()]), 1});
  }
  return all;
}

}  // namespace robosim::detect::avr
