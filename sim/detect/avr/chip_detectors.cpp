#include "sim/detect/avr/chip_detectors.h"

#include "sim/detect/avr/busy_handlers.h"
#include "sim/detect/avr/firmware_actions.h"
#include "sim/detect/avr/float_equality.h"
#include "sim/detect/avr/heap.h"
#include "sim/detect/avr/missed_interrupts.h"
#include "sim/detect/avr/nested_loop.h"
#include "sim/detect/avr/reference_change.h"
#include "sim/detect/avr/stack_margin.h"
#include "sim/detect/avr/torn_access.h"
#include "sim/detect/avr/watchdog_margin.h"

namespace robosim::detect::avr {

std::vector<std::unique_ptr<exec::Detector>> chip_detectors(const RunningProgram& program,
                                                            const std::vector<Pin>& counted) {
  std::vector<std::unique_ptr<exec::Detector>> all;
  all.push_back(std::make_unique<MissedInterrupts>(program, counted));
  all.push_back(std::make_unique<Heap>(program));
  all.push_back(std::make_unique<WatchdogMargin>(program));
  all.push_back(std::make_unique<FloatEquality>(program));
  all.push_back(std::make_unique<FirmwareActions>(program));
  all.push_back(std::make_unique<ReferenceChange>(program));
  all.push_back(std::make_unique<StackMargin>(program));
  all.push_back(std::make_unique<NestedLoop>(program));
  all.push_back(std::make_unique<TornAccess>(program));
  all.push_back(std::make_unique<BusyHandlers>(program));
  return all;
}

}  // namespace robosim::detect::avr
