// The runner for the target avr, and for robots on the target host in the same run.
#include "sim/exec/avr/avr_executor.h"
#include "sim/runner/targets.h"

int main() {
  using namespace robosim::runner;
  return serve(beside(chip_target<robosim::exec::AvrExecutor>("avr"), {host_target()}));
}
