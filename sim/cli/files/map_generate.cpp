#include "sim/cli/files/map_generate.h"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <system_error>

#include "sim/base/file.h"
#include "sim/base/noise.h"
#include "sim/campaign/random_worlds/track.h"
#include "sim/map/generator.h"
#include "sim/map/map_writer.h"

namespace robosim::cli {
namespace fs = std::filesystem;
namespace {

/// Returns a track as the text of a map file. Its bends are wide enough for the stock robots.
std::string track_text(int squares, std::uint64_t seed) {
  const NoiseStream noise(seed, 0, "map generate", kTrackFamily);
  const auto draw = [&noise, n = std::uint64_t{0}](int below) mutable {
    return static_cast<int>(noise.bits(n++) % static_cast<std::uint64_t>(below));
  };
  random_worlds::TrackLimits limits;
  limits.squares = squares;
  limits.apart = 10;  // so that the sensors are on a straight at the start, in the middle of a side
  return "+++\ncell = \"40 mm\"\ncorner = \"80 mm\"\ngoal = \"laps:1\"\n+++\n" +
         random_worlds::lay_out(limits, draw).grid();
}

}  // namespace

ExitStatus generate_maps(const GenerateArguments& arguments, std::ostream& out) {
  const auto family = map::family_of(arguments.family);  // nullopt for a track
  const fs::path folder = arguments.out;
  const auto path_of = [&](std::uint64_t n) {
    return folder / fmt::format("{}-{}-{}.map", arguments.family, arguments.size, arguments.seed + n);
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
    const std::uint64_t seed = arguments.seed + n;
    write_file(path_of(n), family ? map::write_map(map::generate(*family, arguments.size, seed))
                                  : track_text(arguments.size, seed));
  }
  const std::uint64_t last = arguments.count - 1;
  out << (last == 0 ? fmt::format("wrote {}\n", path_of(0).string())
                    : fmt::format("wrote {} maps, {} to {}\n", arguments.count, path_of(0).string(),
                                  path_of(last).filename().string()));
  return ExitStatus::ok;
}

}  // namespace robosim::cli
