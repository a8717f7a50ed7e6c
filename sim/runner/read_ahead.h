// Reads the files of a request's run before its process begins. The process finds them in the runner's
// memory. So do those of the next requests, while the files stay the same.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/exec/host/image_file.h"
#include "sim/runner/file_identity.h"
#include "sim/runner/requested_run.h"

namespace robosim::runner {

struct ImageAhead {
  std::shared_ptr<const exec::ImageContent> content;
  FileIdentity identity{};  ///< of the file, if that alone proves that it is unchanged
};

struct MapAhead {
  std::string name;         ///< as in the request
  grid::Draw draw;          ///< its random choices
  FileIdentity identity{};  ///< of the file, if that alone proves that it is unchanged
  FileIdentity picture{};   ///< of the floor's picture, if that alone proves that it is unchanged
  std::shared_ptr<ReadMap> read;
};

struct ReadAhead {
  Robots robots;
  std::map<std::string, ImageAhead> images;
  std::vector<MapAhead> maps;  ///< the request's, then those of earlier requests
  /// The request's; null if it was not read.
  std::shared_ptr<ReadMap> map;
};

long long wall_ns();

/// Returns the robot of that name: the one in `last`, if its files are unchanged, else read now. Throws
/// InputError.
std::shared_ptr<const robot::Description> known_robot(const std::string& name, const Robots& last);

/// Reads all robots, the map with the simulation's initial state, and the images whose numbers are in
/// `confined`. Reuses from `last` whatever is unchanged in the files. Skips a robot or map that cannot be
/// read, since the run reports it. Also skips a map whose file exceeds 1 MiB. Throws InputError if an image
/// cannot be read. `now`: ns since 1970.
ReadAhead read_ahead(const wire::RunRequest& request, const std::vector<std::size_t>& confined,
                     ReadAhead last, long long now = wall_ns());

/// Returns ImageContent::sealed() of its images, in ascending order.
std::vector<int> sealed_images(const ReadAhead& ahead);

}  // namespace robosim::runner
