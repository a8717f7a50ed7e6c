// What a request's run reads, read before its process begins: that finds it in the runner's memory, and so do
// those of the next requests, as long as the files hold the same.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/exec/host/image_file.h"
#include "sim/runner/requested_run.h"
#include "sim/runner/stamp.h"

namespace robosim::runner {

struct ImageAhead {
  std::shared_ptr<const exec::ImageContent> content;
  Stamp stamp{};  ///< of the file, where that alone says that it holds the same
};

struct MapAhead {
  std::string name;  ///< as the request has it
  grid::Draw draw;   ///< whose it is
  Stamp stamp{};     ///< of the file, where that alone says that it holds the same
  Stamp picture{};   ///< the same of the floor's picture, if it has one
  std::shared_ptr<ReadMap> read;
};

struct ReadAhead {
  Robots robots;
  std::map<std::string, ImageAhead> images;
  std::vector<MapAhead> maps;  ///< the request's, then those of the requests before
  /// The request's; null if it was not read.
  std::shared_ptr<ReadMap> map;
};

long long wall_ns();

/// The robot of that name: the one that `last` has, if its files still hold the same, else read now. Throws
/// InputError.
std::shared_ptr<const robot::Description> known_robot(const std::string& name, const Robots& last);

/// Reads all robots, the map with the simulation's initial state, and the images whose numbers are in
/// `confined`. Reuses from `last` whatever is unchanged in the files. Skips a robot or map that cannot be
/// read, since the run reports it, and a map whose file exceeds 1 MiB. Throws InputError where an image
/// cannot be read. `now`: ns since 1970.
ReadAhead read_ahead(const wire::RunRequest& request, const std::vector<std::size_t>& confined,
                     ReadAhead last, long long now = wall_ns());

/// Of its images, in ascending order: ImageContent::sealed().
std::vector<int> sealed_images(const ReadAhead& ahead);

}  // namespace robosim::runner
