#include "sim/cli/files/map_generate.h"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <system_error>

#include "sim/base/file.h"
#include "sim/map/generator.h"
#include "sim/map/map_writer.h"

namespace robosim::cli {
namespace fs = std::filesystem;

ExitStatus generate_maps(const GenerateArguments& arguments, std::ostream& out) {
  const map::Family family = *map::family_of(arguments.family);
  const fs::path folder = arguments.out;
  const auto path_of = [&](std::uint64_t n) {
    return folder / (map::generated_name(family, arguments.stations, arguments.seed + n) + ".map");
  };
  std::error_code error;
  for (std::uint64_t n = 0; n < arguments.count; ++n)
    if (fs::exists(fs::symlink_status(path_of(n), error)))
      throw InputError({path_of(n).string()},
                       "exists already; nothing was written; remove it, or name another --out or --seed");
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
    throw InputError({folder.string()}, "this folder cannot be created; name another with --out");
  for (std::uint64_t n = 0; n < arguments.count; ++n) {
    const map::Map map = map::generate(family, arguments.stations, arguments.seed + n);
    write_file(path_of(n), map::write_map(map));
  }
  const std::uint64_t last = arguments.count - 1;
  out << (last == 0 ? fmt::format("wrote {}\n", path_of(0).string())
                    : fmt::format("wrote {} maps, {} to {}\n", arguments.count, path_of(0).string(),
                                  path_of(last).filename().string()));
  return ExitStatus::ok;
}

}  // namespace robosim::cli
