#include "sim/cli/run/end_screen.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "sim/base/error.h"
#include "sim/base/profile.h"
#include "sim/view/terminal/terminal.h"

namespace robosim::cli {
namespace {

constexpr int kWidest_columns = 78;
// Largest map file that is drawn. Drawing a larger map would take longer than the run.
constexpr std::uintmax_t kLargestPicturedMap_bytes = 4'000'000;

}  // namespace

ScreenSize screen_size() {
  const auto size = terminal::terminal_size(STDOUT_FILENO);
  return {std::min(size ? size->columns - 1 : kWidest_columns, kWidest_columns),
          terminal::look_from_environment(size.has_value())};
}

void check_view(const RunArguments& arguments) {
  if (arguments.view && ::isatty(STDOUT_FILENO) == 0) {
    throw InputError(
        "--view requires a terminal as standard output; omit --view, or do not redirect the output");
  }
}

map::Map map_of(const wire::RunRequest& request) {
  return map::read_map(request.map, {request.seed, profile_of(request.profile)});
}

std::unique_ptr<map::Map> map_to_draw(const wire::RunRequest& request) {
  std::error_code error;
  const auto bytes = std::filesystem::file_size(request.map, error);
  if (error || bytes > kLargestPicturedMap_bytes) return nullptr;
  return std::make_unique<map::Map>(map_of(request));
}

}  // namespace robosim::cli
