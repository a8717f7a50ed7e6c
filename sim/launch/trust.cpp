#include "sim/launch/trust.h"

#include <fmt/format.h>

#include "sim/base/program_sandbox.h"
#include "sim/build/project.h"

namespace robosim::launch {
namespace {

struct Lack {
  const char* what;
  const char* else_;  ///< the consequence
  std::string why;
};

}  // namespace

std::vector<std::string> lacks(const Launch& launch, const Chosen& chosen, const wire::Hello& host_runner) {
  std::vector<Lack> found;
  if (const std::string why = ProgramSandbox::missing(); chosen.sketch.elf_target.empty() && !why.empty())
    found.push_back({"compilers", "a sketch can make them read any file that you may read", why});
  const bool matters = launch.untrusted || host_runner.sandbox == "missing";
  if (chosen.target == "host" && matters && !host_runner.no_sandbox_why.empty())
    found.push_back({"runs on the host", "a sketch can do whatever you may do", host_runner.no_sandbox_why});
  std::vector<std::string> sentences;
  for (const Lack& lack : found) {
    if (launch.untrusted)
      throw ToolMissing(fmt::format("--untrusted: {} cannot be confined here: {}", lack.what, lack.why));
    sentences.push_back(fmt::format("{} are not confined here: {}; {}", lack.what, lack.why, lack.else_));
  }
  return sentences;
}

void check_folder(const SketchChoice& sketch) {
  const project::Project& project = sketch.project;
  std::vector<std::filesystem::path> folders = project.libraries;
  folders.insert(folders.end(), project.includes.begin(), project.includes.end());
  if (!project.sources.empty()) folders.push_back(project.sources);
  for (const std::filesystem::path& folder : folders)
    if (!build::lies_in(folder, sketch.folder))
      throw InputError({project.file.string()},
                       fmt::format("{} is outside of the sketch's folder; --untrusted follows no such folder",
                                   folder.string()));
}

std::string chip_target(const Launch& launch, const Describe& describe) {
  const SketchChoice sketch = choose_sketch(launch.sketch, launch.environment, launch.untrusted);
  if (!sketch.elf_target.empty()) return sketch.elf_target;
  const Choice robot = choose_robot(launch.robot, sketch, "host");
  return board_of(describe(robot.path.string())).chip->target;
}

}  // namespace robosim::launch
