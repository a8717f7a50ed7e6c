// Reads the files for a requested run before the runner forks the run's process, which inherits them in
// memory. Later requests use the same memory as long as the files are unchanged.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/exec/host/image_file.h"
#include "sim/runner/file_identity.h"
#include "sim/runner/requested_run.h"

namespace robosim::runner {

/// Outputs of addr2line for one image. Many runs of a sweep ask about the same addresses.
class KnownLines {
 public:
  /// Returns the output for these offsets. Calls `ask` if the output is not known, and stores an output that
  /// is not empty.
  std::string find(const std::vector<std::uintptr_t>& offsets, const std::function<std::string()>& ask);

 private:
  std::map<std::vector<std::uintptr_t>, std::string> outputs_;
  std::size_t bytes_ = 0;  ///< size of all outputs and their offsets
};

struct ImageAhead {
  std::shared_ptr<const exec::ImageContent> content;
  FileIdentity identity{};  ///< identity of the file; all zero if it was not settled (is_settled())
  std::shared_ptr<KnownLines> lines;
};

struct MapAhead {
  std::string name;         ///< name in the request
  map::Draw draw;           ///< seed and profile for which the map was read
  FileIdentity identity{};  ///< identity of the file; all zero if it was not settled (is_settled())
  FileIdentity picture{};   ///< identity of the floor's picture; all zero if missing or not settled
  std::shared_ptr<ReadMap> read;
};

struct ReadAhead {
  Robots robots;
  std::map<std::string, ImageAhead> images;
  std::vector<MapAhead> maps;  ///< the request's map, then maps of earlier requests
  /// The request's map; null if it was not read.
  std::shared_ptr<ReadMap> map;
};

long long wall_ns();

/// Returns the robot of that name: from `last` if the robot's files are unchanged, otherwise from these
/// files. Throws InputError.
std::shared_ptr<const robot::Description> known_robot(const std::string& name, const Robots& last);

/// Reads all robots and the map, and prepares the map for a simulation. Reads the images of the robots whose
/// numbers are in `confined`. Reuses everything in `last` whose files are unchanged. Skips a robot or map
/// that cannot be read, because the run reports that error. Skips a map whose file exceeds 1 MiB. Throws
/// InputError if an image cannot be read. `now` is in ns since 1970.
ReadAhead read_ahead(const wire::RunRequest& request, const std::vector<std::size_t>& confined,
                     ReadAhead last, long long now = wall_ns());

/// Returns ImageContent::sealed() of all images, in ascending order.
std::vector<int> sealed_images(const ReadAhead& ahead);

}  // namespace robosim::runner
