#include "sim/cli/program.h"

#include <fmt/format.h>

#include <csignal>
#include <exception>

#include "sim/base/error.h"
#include "sim/base/system_error.h"
#include "sim/build/sketch.h"
#include "sim/cli/output.h"
#include "sim/launch/client/interrupts.h"

namespace robosim::cli {
namespace {

int fail(ExitStatus status, const char* prefix, const char* message) {
  complain(fmt::format("{}{}\n", prefix, message));
  return static_cast<int>(status);
}

}  // namespace

int run_program(int count, char** words, const std::function<int(const Command&)>& perform) {
  open_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding a file size limit becomes a write error
  try {
    return perform(parse_arguments({words + 1, words + count}));
  } catch (const build::CompileError& error) {
    return fail(ExitStatus::bad_input, "", error.what());  // begins with the file and line, as editors expect
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

}  // namespace robosim::cli
