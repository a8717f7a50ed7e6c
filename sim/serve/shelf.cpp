#include "sim/serve/shelf.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "sim/base/base64.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/elf/elf_target.h"
#include "sim/grid/map.h"
#include "sim/launch/names.h"
#include "sim/record/floor_shapes.h"
#include "sim/wire/json_writer.h"

namespace robosim::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

bool has_ending(const std::string& name, std::string_view ending) { return name.ends_with(ending); }

// Where it goes; below `folder`.
fs::path place_of(const fs::path& folder, const std::string& name) {
  if (name.starts_with("./")) {  // one that is there, and no link leads out to it
    const Choices choices = choices_in(folder);
    if (has_ending(name, ".map") &&
        std::find(choices.maps.begin(), choices.maps.end(), name) != choices.maps.end())
      return folder / name.substr(2);
  }
  static const std::regex plain("[A-Za-z0-9][A-Za-z0-9_-]{0,62}\\.(ino|hex|elf|toml|map)");
  if (!std::regex_match(name, plain) || name == "checks.toml")
    throw InputError(
        "the name of a file must end with .ino, .hex, .elf, .toml or .map, and before that have 1 to 63 "
        "letters, digits, - and _; checks.toml is not written");
  return has_ending(name, ".ino") ? folder / fs::path(name).stem() / name : folder / name;
}

}  // namespace

Offered read_offered(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw InputError("what is sent is no JSON object");
  Offered offered;
  for (const auto& item : json.items()) {
    if (item.key() == "name" && item.value().is_string())
      offered.name = item.value();
    else if (item.key() == "text" && item.value().is_string())
      offered.text = item.value();
    else if (item.key() == "base64" && item.value().is_string())
      offered.text = from_base64(item.value().get_ref<const std::string&>());
    else if (item.key() == "replace" && item.value().is_boolean())
      offered.replace = item.value();
    else
      throw InputError(
          "what is sent may have the texts name, text and base64 (of an image), and replace, true or false");
  }
  if (!is_image(offered.name) && offered.text.find('\0') != std::string::npos)
    throw InputError("what is sent is no text");
  if (json.contains("base64") != is_image(offered.name))
    throw InputError("a .hex or .elf is sent as base64, and what else there is as text");
  return offered;
}

std::string keep(const fs::path& folder, const Offered& offered) {
  const fs::path root = fs::canonical(folder), place = place_of(root, offered.name);
  if (has_ending(offered.name, ".map")) grid::parse_map(offered.text, offered.name);
  if (has_ending(offered.name, ".elf")) target_of_elf(offered.text, offered.name);
  if (has_ending(offered.name, ".hex") && !offered.text.starts_with(":"))
    throw InputError(offered.name + ":1: is no line of an Intel HEX file");
  std::error_code error;
  const fs::path parent = place.parent_path();
  if (fs::is_symlink(fs::symlink_status(parent, error)) || fs::is_symlink(fs::symlink_status(place, error)) ||
      (fs::exists(place, error) && !fs::is_regular_file(place, error)))
    throw InputError(offered.name + " is there, and is no file of the folder's own");
  if (fs::exists(place, error) && !offered.replace) throw IsThere{offered.name + " is there already"};
  fs::create_directory(parent, error);
  write_file(place, offered.text);
  return "./" + fs::relative(place, root).string();
}

std::string map_text(const fs::path& folder, const std::string& name) {
  const Choices choices = choices_in(folder);
  if (std::find(choices.maps.begin(), choices.maps.end(), name) == choices.maps.end())
    throw InputError("there is no map of that name in the folder that is served, nor of ours");
  constexpr std::size_t kLongest = 256 * 1024;
  return read_file(name.starts_with("./") ? folder / name : launch::stock_map_folder() / (name + ".map"),
                   kLongest);
}

std::string floor_of(const Offered& offered) {
  const grid::Map map = grid::parse_map(offered.text, offered.name.empty() ? "the map" : offered.name);
  wire::Started started;
  if (std::any_of(map.cells.begin(), map.cells.end(), grid::is_line)) {
    const grid::Start start = grid::default_start(map);
    started.x = start.cell.x;
    started.y = start.cell.y;
    started.facing = grid::letter(start.facing);
  }
  return wire::text_of(wire::to_json(record::floor_shapes(map, started)));
}

}  // namespace robosim::serve
