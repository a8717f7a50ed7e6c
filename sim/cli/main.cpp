#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>

#include "sim/base/error.h"
#include "sim/base/system_error.h"
#include "sim/build/sketch.h"
#include "sim/cli/arguments.h"
#include "sim/cli/calibrate/calibrate_command.h"
#include "sim/cli/check/test_command.h"
#include "sim/cli/compare/compare_command.h"
#include "sim/cli/files/build_command.h"
#include "sim/cli/files/flash_command.h"
#include "sim/cli/files/man_command.h"
#include "sim/cli/files/map_command.h"
#include "sim/cli/files/map_import.h"
#include "sim/cli/files/map_print.h"
#include "sim/cli/files/new_command.h"
#include "sim/cli/files/robot_command.h"
#include "sim/cli/hunt/hunt_command.h"
#include "sim/cli/mutate/mutate_command.h"
#include "sim/cli/output.h"
#include "sim/cli/report/report_command.h"
#include "sim/cli/run/classic_command.h"
#include "sim/cli/run/play_command.h"
#include "sim/cli/run/replay_command.h"
#include "sim/cli/run/run_command.h"
#include "sim/cli/run/why_command.h"
#include "sim/cli/serve/serve_command.h"
#include "sim/cli/sweep/sweep_command.h"
#include "sim/cli/wire/wire_command.h"
#include "sim/launch/client/interrupts.h"

namespace robosim::cli {
namespace {

struct Perform {
  int operator()(const RunArguments& arguments) const { return run_command(arguments); }
  int operator()(const WhyArguments& arguments) const { return why_command(arguments); }
  int operator()(const ReplayArguments& arguments) const { return replay_command(arguments); }
  int operator()(const SweepArguments& arguments) const { return sweep_command(arguments); }
  int operator()(const ReportArguments& arguments) const { return report_command(arguments); }
  int operator()(const CompareArguments& arguments) const { return compare_command(arguments); }
  int operator()(const ClassicArguments& arguments) const { return classic_command(arguments); }
  int operator()(const BuildArguments& arguments) const { return build_command(arguments); }
  int operator()(const FlashArguments& arguments) const { return flash_command(arguments); }
  int operator()(const WireArguments& arguments) const { return wire_command(arguments); }
  int operator()(const MapArguments& arguments) const { return map_command(arguments); }
  int operator()(const GenerateArguments& arguments) const { return generate_command(arguments); }
  int operator()(const ImportArguments& arguments) const { return import_command(arguments); }
  int operator()(const PrintArguments& arguments) const { return print_command(arguments); }
  int operator()(const RobotArguments& arguments) const { return robot_command(arguments); }
  int operator()(const CalibrateArguments& arguments) const { return calibrate_command(arguments); }
  int operator()(const PlayArguments& arguments) const { return play_command(arguments); }
  int operator()(const ServeArguments& arguments) const { return serve_command(arguments); }
  int operator()(const TestArguments& arguments) const { return test_command(arguments); }
  int operator()(const MutateArguments& arguments) const { return mutate_command(arguments); }
  int operator()(const HuntArguments& arguments) const { return hunt_command(arguments); }
  int operator()(const NewArguments& arguments) const { return new_command(arguments); }
  int operator()(const ManArguments& arguments) const { return man_command(arguments); }
  int operator()(const PrintText& text) const {
    print(text.text);
    return 0;
  }
};

int fail(ExitStatus status, const char* prefix, const char* message) {
  complain(fmt::format("{}{}\n", prefix, message));
  return static_cast<int>(status);
}

int perform(int count, char** words) {
  try {
    return std::visit(Perform{}, parse_arguments({words + 1, words + count}));
  } catch (const build::CompileError& error) {
    return fail(ExitStatus::bad_input, "", error.what());  // begins with the place, as editors expect
  } catch (const InputError& error) {
    return fail(ExitStatus::bad_input, "robosim: ", error.what());
  } catch (const ToolMissing& error) {
    return fail(ExitStatus::tool_missing, "robosim: ", error.what());
  } catch (const wire::Unstoppable& error) {
    return fail(ExitStatus::interrupted, "robosim: ", error.what());
  } catch (const std::exception& error) {
    if (const std::string fault = system_error_of(error); !fault.empty())
      return fail(ExitStatus::tool_missing, "robosim: ", fault.c_str());
    if (client::Interrupts::count() > 0) return fail(ExitStatus::interrupted, "robosim: ", "interrupted");
    return fail(ExitStatus::internal, "robosim: internal error: ", error.what());
  }
}

}  // namespace
}  // namespace robosim::cli

int main(int count, char** words) {
  robosim::cli::open_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding a file size limit becomes a write error
  return robosim::cli::perform(count, words);
}
