// The runner for the target avr, and for runs that also have robots on the target host.
#include "sim/runner/avr_target.h"
#include "sim/runner/targets.h"

int main() {
  using namespace robosim::runner;
  return serve(beside(avr_target(), {host_target()}));
}
