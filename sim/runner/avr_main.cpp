// The runner for the target avr, and for runs that also have robots on the target host.
#include "sim/exec/avr/avr_executor.h"
#include "sim/runner/targets.h"

int main() {
  using namespace robosim::runner;
  return serve(beside(chip_target<robosim::exec::AvrExecutor>("avr"), {host_target()}));
}
