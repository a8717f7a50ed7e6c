// The program `robosim-campaign`, which `robosim` starts. Its commands do many runs, or handle files of other
// programs.
#include <stdexcept>
#include <variant>

#include "sim/cli/calibrate/calibrate_command.h"
#include "sim/cli/check/test_command.h"
#include "sim/cli/compare/compare_command.h"
#include "sim/cli/files/map_import.h"
#include "sim/cli/files/map_print.h"
#include "sim/cli/hunt/hunt_command.h"
#include "sim/cli/mutate/mutate_command.h"
#include "sim/cli/program.h"
#include "sim/cli/report/report_command.h"
#include "sim/cli/sweep/sweep_command.h"
#include "sim/cli/wire/wire_command.h"

namespace robosim::cli {
namespace {

struct Perform {
  int operator()(const SweepArguments& arguments) const { return sweep_command(arguments); }
  int operator()(const ReportArguments& arguments) const { return report_command(arguments); }
  int operator()(const CompareArguments& arguments) const { return compare_command(arguments); }
  int operator()(const WireArguments& arguments) const { return wire_command(arguments); }
  int operator()(const ImportArguments& arguments) const { return import_command(arguments); }
  int operator()(const PrintArguments& arguments) const { return print_command(arguments); }
  int operator()(const CalibrateArguments& arguments) const { return calibrate_command(arguments); }
  int operator()(const TestArguments& arguments) const { return test_command(arguments); }
  int operator()(const MutateArguments& arguments) const { return mutate_command(arguments); }
  int operator()(const HuntArguments& arguments) const { return hunt_command(arguments); }
  template <typename Arguments>
  int operator()(const Arguments&) const {
    throw std::logic_error("robosim itself performs this command");
  }
};

}  // namespace
}  // namespace robosim::cli

int main(int count, char** words) {
  namespace cli = robosim::cli;
  return cli::run_program(count, words,
                          [](const cli::Command& command) { return std::visit(cli::Perform{}, command); });
}
