#include <fmt/format.h>

#include "sim/build/libraries.h"
#include "sim/launch/names.h"

namespace robosim::launch {

std::vector<std::string> remarks_on_project(const SketchChoice& sketch,
                                            const std::vector<std::string>& libraries) {
  const project::Project& project = sketch.project;
  std::vector<std::string> remarks = project.remarks;
  if (!is_path(sketch.name) && sketch.path == sketch.name && build::is_stock_sketch(sketch.name))
    remarks.push_back(
        fmt::format("running the folder {} here, not the sample sketch of that name", sketch.name));
  if (project.sources.empty())
    if (std::string remark = build::remark_on_main_file(sketch.path); !remark.empty())
      remarks.push_back(std::move(remark));
  if (project.wanted.empty()) return remarks;
  std::vector<std::filesystem::path> chosen(libraries.begin(), libraries.end());
  chosen.insert(chosen.end(), project.libraries.begin(), project.libraries.end());
  const auto folders = build::library_folders(std::filesystem::absolute(sketch.folder), chosen, {});
  for (const project::WantedLibrary& wanted : project.wanted) {
    const std::string name =
        wanted.version.empty() ? wanted.name : fmt::format("{} {}", wanted.name, wanted.version);
    const auto found = build::libraries_called(wanted.name, folders);
    const std::string says = fmt::format("{} requires {}", project.file.filename().string(), name);
    if (found.empty())
      remarks.push_back(fmt::format(
          "{}, which is in no folder of libraries; install it with arduino-cli lib install \"{}{}{}\"", says,
          wanted.name, wanted.version.empty() ? "" : "@", wanted.version));
    else if (!wanted.version.empty() && found[0].version != wanted.version)
      remarks.push_back(fmt::format("{}; version {} in {} is used instead", says, found[0].version,
                                    found[0].folder.string()));
  }
  return remarks;
}

}  // namespace robosim::launch
