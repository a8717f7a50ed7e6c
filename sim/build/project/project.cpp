#include "sim/build/project/project.h"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <system_error>

#include "sim/base/did_you_mean.h"
#include "sim/base/file.h"
#include "sim/base/file_scope.h"
#include "sim/base/json_limits.h"
#include "sim/build/project/board_names.h"
#include "sim/build/project/files.h"
#include "sim/build/project/yaml.h"

namespace robosim::project {
namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(path, none);
}

/// Returns the build options that arduino-cli has stored in a build folder; null if they are missing.
nlohmann::json build_options(const fs::path& folder) {
  const fs::path file = folder / "build.options.json";
  if (!is_file(file)) return nullptr;
  const std::string text = read_file(file, kMostProjectFile_bytes);
  if (!is_within_json_limits(text)) return nlohmann::json(nlohmann::json::value_t::discarded);
  return nlohmann::json::parse(text, nullptr, false);
}

std::string text_in(const nlohmann::json& object, const char* key) {
  if (!object.is_object()) return {};
  const auto value = object.find(key);
  return value != object.end() && value->is_string() ? value->get<std::string>() : "";
}

/// Returns the PlatformIO project of an image PROJECT/.pio/build/ENVIRONMENT/firmware.elf; otherwise empty.
fs::path platformio_of(const fs::path& image) {
  const fs::path build = image.parent_path().parent_path();
  if (build.filename() != "build" || build.parent_path().filename() != ".pio") return {};
  const fs::path project = build.parent_path().parent_path();
  return is_file(project / "platformio.ini") ? project : fs::path();
}

fs::path full_path(const fs::path& path) { return fs::absolute(path).lexically_normal(); }

}  // namespace

void refuse_environment(const fs::path& file, const std::string& what, const std::string& name,
                        const std::vector<std::string>& all) {
  throw InputError({file.string()}, "--env: " + (all.empty() ? fmt::format("the file has no {}s", what)
                                                             : unknown_name(what, name, all)));
}

Project read_project(const fs::path& folder, const std::string& environment) {
  if (is_file(folder / "platformio.ini")) return read_platformio(folder, environment);
  for (const char* name : {"sketch.yaml", "sketch.yml"})
    if (is_file(folder / name)) return read_sketch_yaml(folder / name, environment);
  if (!environment.empty())
    throw InputError(fmt::format(
        "--env requires a platformio.ini with environments or a sketch.yaml with profiles; {} has neither",
        folder == "." ? "the current folder" : folder.string()));
  return {};
}

Project project_of_image(const fs::path& given) {
  const fs::path image = full_path(given);
  if (const fs::path folder = platformio_of(image); !folder.empty()) {
    Project found = read_platformio(folder, image.parent_path().filename().string());
    Project project;
    project.file = found.file;
    project.environment = found.environment;
    project.board = found.board;
    project.board_name = found.board_name;
    project.board_place = found.board_place;
    return project;
  }
  Project project;
  const fs::path folder = image.parent_path();
  project.board_name = text_in(build_options(folder), "fqbn");
  project.file = folder / "build.options.json";
  if (project.board_name.empty() && folder.parent_path().filename() == "build") {
    // Exported binaries are in SKETCH/build/arduino.avr.uno.
    std::string name = folder.filename().string();
    for (char& c : name) c = c == '.' ? ':' : c;
    if (!board_of_fqbn(name)) return {};
    project.board_name = name;
    project.file = folder;
  }
  if (project.board_name.empty()) return {};
  project.board = board_of_fqbn(project.board_name);
  project.board_place = {project.file.string()};
  return project;
}

fs::path sketch_of_image(const fs::path& given) {
  const fs::path image = full_path(given);
  if (const fs::path folder = platformio_of(image); !folder.empty()) return folder;
  const fs::path folder = image.parent_path();
  fs::path sketch = text_in(build_options(folder), "sketchLocation");
  if (is_file(sketch)) sketch = sketch.parent_path();
  if (sketch.empty() && folder.parent_path().filename() == "build")
    sketch = folder.parent_path().parent_path();
  std::error_code none;
  return fs::is_directory(sketch, none) ? sketch : fs::path();
}

void find_stand_in(Project& project, const std::string& chip) {
  if (project.board || project.board_name.empty()) return;
  project.stand_in = board_with_chip(chip, project.board_name);
  if (!project.stand_in) return;
  project.remarks.push_back(fmt::format(
      "{} names the board {}, which Robosim does not have: the program is for an {} at {} MHz, as "
      "on the {}",
      project.file.filename().string(), project.board_name, project.stand_in->chip->name,
      project.stand_in->clock_hz / 1'000'000, project.stand_in->name));
}

void check_board(const Project& project) {
  if (project.board || project.stand_in || project.board_name.empty()) return;
  throw InputError(
      project.board_place,
      fmt::format(
          "unknown board {}: expected an Arduino board with an AVR chip or the Blue Pill ({}); to run "
          "the sketch on another board, give --robot ROBOT@BOARD, as in --robot uno5@nano",
          project.board_name, project.platformio ? all_platformio_ids() : all_fqbns()));
}

std::vector<fs::path> sketchbooks() {
  std::vector<fs::path> books;
  const auto add = [&](const fs::path& book) {
    if (book.is_absolute()) books.push_back(book);
  };
  if (const char* named = std::getenv("ARDUINO_DIRECTORIES_USER")) add(named);
  const char* const home_text = std::getenv("HOME");
  if (!home_text || *home_text != '/') return books;
  const fs::path home = home_text;
  for (const fs::path& root : {home, home / "snap/arduino/current"}) {
    for (const char* name : {".arduino15", ".arduinoIDE"}) extend_file_scope(root / name);
    const fs::path preferences = root / ".arduino15/preferences.txt";
    if (is_file(preferences)) {
      const std::string text = "\n" + read_file(preferences, kMostProjectFile_bytes);
      constexpr const char* kKey = "\nsketchbook.path=";
      if (const std::size_t at = text.find(kKey); at != text.npos) {
        const std::size_t begin = at + std::char_traits<char>::length(kKey);
        add(text.substr(begin, text.find_first_of("\r\n", begin) - begin));
      }
    }
    for (const char* name : {".arduino15/arduino-cli.yaml", ".arduinoIDE/arduino-cli.yaml"})
      if (is_file(root / name)) {
        const YamlFile file(root / name);
        add(file.root()["directories"]["user"].text());
      }
  }
  return books;
}

}  // namespace robosim::project
