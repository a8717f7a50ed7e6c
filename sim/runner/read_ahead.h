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

struct ReadAhead {
  Robots robots;
  std::map<std::string, ImageAhead> images;
};

/// The robot of that name: the one that `last` has, if its files still hold the same, else read now. Throws
/// InputError.
std::shared_ptr<const robot::Description> known_robot(const std::string& name, const Robots& last);

/// All robots, and the images of those whose numbers are `confined`. What `last` has and the files still hold
/// is not read again. A robot that cannot be read is left out: the run will say why. Throws InputError where
/// an image cannot be read.
ReadAhead read_ahead(const wire::RunRequest& request, const std::vector<std::size_t>& confined,
                     ReadAhead last);

/// Of its images, in ascending order: ImageContent::sealed().
std::vector<int> sealed_images(const ReadAhead& ahead);

}  // namespace robosim::runner
