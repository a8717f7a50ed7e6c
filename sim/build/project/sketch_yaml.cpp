// Reads Arduino's sketch.yaml: the board and the libraries of a profile.
#include <fmt/format.h>

#include <cstdlib>
#include <system_error>

#include "sim/build/project/board_names.h"
#include "sim/build/project/files.h"
#include "sim/build/project/yaml.h"

namespace robosim::project {
namespace fs = std::filesystem;

namespace {

/// Parses "Servo (1.2.1)", or a name without a version.
WantedLibrary wanted_library(const std::string& text) {
  const std::size_t open = text.find('(');
  WantedLibrary wanted{text.substr(0, open), ""};
  while (!wanted.name.empty() && wanted.name.back() == ' ') wanted.name.pop_back();
  if (open == std::string::npos) return wanted;
  const std::size_t close = text.find(')', open);
  wanted.version = text.substr(open + 1, close == std::string::npos ? close : close - open - 1);
  return wanted;
}

void take_libraries(Project& project, const YamlValue& list) {
  for (const YamlValue& item : list.items()) {
    const std::string folder = item["dir"].text();
    const std::string other = item["dependency"].text();
    if (!folder.empty())
      project.libraries.push_back((fs::absolute(project.file).parent_path() / folder).lexically_normal());
    else if (!(item.text() + other).empty())
      project.wanted.push_back(wanted_library(item.text() + other));
  }
}

/// Adds the wanted libraries that arduino-cli has downloaded. arduino-cli stores the libraries of all
/// profiles in folders NAME_VERSION_HASH/NAME.
void add_fetched(Project& project) {
  const char* const home = std::getenv("HOME");
  if (!home) return;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(fs::path(home) / ".arduino15/internal", none)) {
    const std::string folder = entry.path().filename().string();
    for (const WantedLibrary& wanted : project.wanted) {
      std::string begin = wanted.name + "_" + wanted.version + "_";
      for (char& c : begin) c = c == ' ' ? '_' : c;
      if (!wanted.version.empty() && folder.rfind(begin, 0) == 0) project.libraries.push_back(entry.path());
    }
  }
}

void set_board(Project& project, const YamlValue& fqbn) {
  project.board_name = fqbn.text();
  project.board = board_of_fqbn(project.board_name);
  project.board_place = {project.file.string(), fqbn.line()};
}

}  // namespace

Project read_sketch_yaml(const fs::path& path, const std::string& wanted) {
  const YamlFile file(path);
  const YamlValue root = file.root();
  Project project;
  project.file = path;
  std::vector<std::string> names;
  std::string first_known;
  for (const auto& [name, profile] : root["profiles"].members()) {
    names.push_back(name);
    if (first_known.empty() && board_of_fqbn(profile["fqbn"].text())) first_known = name;
  }
  project.environment = wanted.empty() ? root["default_profile"].text() : wanted;
  const YamlValue default_fqbn = root["default_fqbn"];
  if (project.environment.empty() && !default_fqbn.is_there() && !names.empty()) {
    project.environment = first_known.empty() ? names[0] : first_known;
    if (names.size() > 1)
      project.remarks.push_back(
          fmt::format("{2}, one of {0} profiles in {1}, is used; choose another with --env", names.size(),
                      path.filename().string(), project.environment));
  }
  if (project.environment.empty()) {
    if (default_fqbn.is_there()) set_board(project, default_fqbn);
    return project;
  }
  const YamlValue profile = root["profiles"][project.environment];
  if (!profile.is_there()) {
    if (!wanted.empty()) refuse_environment(path, "profile", wanted, names);
    throw InputError({path.string(), root["default_profile"].line()},
                     fmt::format("default_profile: no such profile {}", project.environment));
  }
  set_board(project, profile["fqbn"].is_there() ? profile["fqbn"] : default_fqbn);
  take_libraries(project, profile["libraries"]);
  add_fetched(project);
  return project;
}

}  // namespace robosim::project
