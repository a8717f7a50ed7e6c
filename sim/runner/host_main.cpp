// The runner for the target host.
#include "sim/runner/targets.h"

int main() { return robosim::runner::serve(robosim::runner::host_target()); }
