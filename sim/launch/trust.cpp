#include "sim/launch/trust.h"

#include <fmt/format.h>

#include <iterator>

#include "sim/base/config.h"
#include "sim/base/file.h"
#include "sim/base/program_sandbox.h"
#include "sim/base/robot_name.h"
#include "sim/build/project.h"

namespace robosim::launch {
namespace fs = std::filesystem;

namespace {

struct Lack {
  const char* what;
  const char* else_;  ///< the consequence if `what` is not confined
  std::string why;
};

}  // namespace

std::vector<std::string> lacks(const Launch& launch, const Chosen& chosen, const wire::Hello& host_runner) {
  std::vector<Lack> found;
  if (const std::string why = ProgramSandbox::missing(); chosen.sketch.elf_target.empty() && !why.empty())
    found.push_back({"compilers", "a sketch can make them read any file that you can read", why});
  const bool matters = launch.untrusted || host_runner.sandbox == "missing";
  if (chosen.target == "host" && matters && !host_runner.no_sandbox_why.empty())
    found.push_back(
        {"runs on the host", "a sketch can do everything that you can do", host_runner.no_sandbox_why});
  std::vector<std::string> sentences;
  for (const Lack& lack : found) {
    if (launch.untrusted)
      throw ToolMissing(fmt::format("--untrusted: {} cannot be confined here: {}", lack.what, lack.why));
    sentences.push_back(fmt::format("{} are not confined here: {}; {}", lack.what, lack.why, lack.else_));
  }
  return sentences;
}

namespace {

/// Returns whether a build tool could have written the program `image` for a sketch whose folder is `folder`.
/// Build tools write to the sketch's folder, to `build` or `.pio/build` in it, or to a folder in these.
bool is_built_in(const fs::path& image, const fs::path& folder) {
  std::error_code error;
  const fs::path real = fs::canonical(image, error), real_folder = fs::canonical(folder, error);
  if (error || !build::lies_in(image, folder)) return false;
  const fs::path below = real.lexically_relative(real_folder).parent_path();
  const auto count = std::distance(below.begin(), below.end());
  if (below.empty()) return true;
  auto part = below.begin();
  if (*part == ".pio" && count > 1) ++part;
  return *part == "build" && std::distance(part, below.end()) <= 2;
}

}  // namespace

void check_folder(const SketchChoice& sketch) {
  if (!sketch.elf_target.empty() && !is_built_in(sketch.path, sketch.folder))
    throw InputError(
        {sketch.path.string()},
        fmt::format("the files next to the image refer to {} as the sketch's folder, outside of the "
                    "image's folder; --untrusted does not follow it",
                    sketch.folder.string()));
  const project::Project& project = sketch.project;
  std::vector<fs::path> folders = project.libraries;
  folders.insert(folders.end(), project.includes.begin(), project.includes.end());
  if (!project.sources.empty()) folders.push_back(project.sources);
  for (const fs::path& folder : folders)
    if (!build::lies_in(folder, sketch.folder))
      throw InputError({project.file.string()},
                       fmt::format("{} is outside of the sketch's folder; --untrusted does not follow it",
                                   folder.string()));
}

void check_robot(const SketchChoice& sketch, const Choice& robot) {
  constexpr int kMostBases = 8;  // the runner refuses a longer chain of base robots
  fs::path file = parse_robot_name(robot.path.string()).robot;
  if (!is_path(file.string()) || !build::lies_in(file, sketch.folder)) return;
  for (int bases = 0; bases <= kMostBases; ++bases) {
    const ConfigValue table = parse_toml(read_file(file), file.string());
    const ConfigValue* const base = table.find("base");
    if (!base || base->kind != ConfigValue::Kind::string || !is_path(base->string)) return;
    file = file.parent_path() / base->string;
    std::error_code none;
    if (!fs::exists(file, none)) return;
    if (!build::lies_in(file, sketch.folder))
      throw InputError(base->place, fmt::format("base: \"{}\" is outside of the sketch's folder; --untrusted "
                                                "does not follow it",
                                                base->string));
  }
}

std::string chip_target(const Launch& launch, const Describe& describe) {
  const SketchChoice sketch = choose_sketch(launch.sketch, launch.environment, launch.untrusted);
  if (!sketch.elf_target.empty()) return sketch.elf_target;
  const Choice robot = choose_robot(launch.robot, sketch, "host");
  return board_of(describe(robot.path.string())).chip->target;
}

}  // namespace robosim::launch
