#include "sim/view/serve/file_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "sim/base/base64.h"
#include "sim/base/elf/elf_target.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/launch/names.h"
#include "sim/map/map.h"
#include "sim/record/floor_shapes.h"
#include "sim/wire/json_parse.h"
#include "sim/wire/json_writer.h"

namespace robosim::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t kLongestMap = 256 * 1024;

bool has_ending(const std::string& name, std::string_view ending) { return name.ends_with(ending); }

// Returns the file's path, relative to `folder`.
fs::path place_of(const HeldFolder& folder, const std::string& name) {
  if (name.starts_with("./")) {  // an existing map; choices_in() omits links out of the folder
    const Choices choices = choices_in(folder);
    if (has_ending(name, ".map") &&
        std::find(choices.maps.begin(), choices.maps.end(), name) != choices.maps.end())
      return name.substr(2);
  }
  static const std::regex plain("[A-Za-z0-9][A-Za-z0-9_-]{0,62}\\.(ino|hex|elf|toml|map)");
  if (!std::regex_match(name, plain) || name == "checks.toml")
    throw InputError(
        "invalid name of a file: expected 1 to 63 letters, digits, - and _ with the ending .ino, .hex, .elf, "
        ".toml or .map; checks.toml is never written");
  return has_ending(name, ".ino") ? fs::path(name).stem() / name : fs::path(name);
}

// Writes through descriptors of open folders. So no symbolic link can lead out of the served folder, even if
// the link appears during the write.
void write_below(const HeldFolder& folder, const fs::path& place, const Offered& offered) {
  const auto foreign = [&] {
    return InputError(offered.name + " exists, but is not a regular file of this folder");
  };
  const auto parent = [&] {
    const fs::path above = place.has_parent_path() ? place.parent_path() : fs::path(".");
    return folder.open(above, O_PATH | O_DIRECTORY, HeldFolder::Links::refused);
  };
  Descriptor into = parent();
  if (!into.is_open() && errno == ENOENT) {
    ::mkdirat(folder.handle(), place.parent_path().c_str(), 0777);
    into = parent();
  }
  if (!into.is_open()) throw foreign();
  const std::string name = place.filename().string(), fresh = fmt::format("{}.tmp{}", name, ::getpid());
  struct stat info {};
  if (::fstatat(into.get(), name.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0) {
    if (!S_ISREG(info.st_mode)) throw foreign();
    if (!offered.replace) throw IsThere{offered.name + " exists already"};
  }
  ::unlinkat(into.get(), fresh.c_str(), 0);
  const int how = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  const Descriptor file(::openat(into.get(), fresh.c_str(), how, 0666));
  int problem = file.is_open() ? write_all(file.get(), offered.text) : errno;
  if (problem == 0 && ::renameat(into.get(), fresh.c_str(), into.get(), name.c_str()) != 0) problem = errno;
  if (problem == 0) return;
  ::unlinkat(into.get(), fresh.c_str(), 0);
  throw InputError({offered.name}, std::string("cannot write the file: ") + std::strerror(problem));
}

}  // namespace

Offered read_offered(const std::string& text) {
  const Json json = wire::parsed_json(text);
  if (!json.is_object()) throw InputError("the request: expected a JSON object");
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
          "unknown key: expected the texts name, text and base64 (of an image), or replace, which is true or "
          "false");
  }
  if (!is_image(offered.name) && offered.text.find('\0') != std::string::npos)
    throw InputError("text: expected text, got zero bytes");
  if (json.contains("base64") != is_image(offered.name))
    throw InputError("the content: expected base64 for a .hex or .elf and text for other files");
  return offered;
}

std::string keep(const HeldFolder& folder, const Offered& offered) {
  const fs::path place = place_of(folder, offered.name);
  if (has_ending(offered.name, ".map")) map::parse_map(offered.text, offered.name);
  if (has_ending(offered.name, ".elf")) target_of_elf(offered.text, offered.name);
  if (has_ending(offered.name, ".hex") && !offered.text.starts_with(":"))
    throw InputError(offered.name + ":1: expected a line of an Intel HEX file");
  write_below(folder, place, offered);
  return "./" + place.string();
}

std::string map_text(const HeldFolder& folder, const std::string& name) {
  const Choices choices = choices_in(folder);
  if (std::find(choices.maps.begin(), choices.maps.end(), name) == choices.maps.end())
    throw InputError("name: expected a map of the served folder or a sample map");
  if (name.starts_with("./")) return folder.read(name, kLongestMap);
  return read_file(launch::stock_map_folder() / (name + ".map"), kLongestMap);
}

std::string floor_of(const Offered& offered) {
  const map::Map map = map::parse_map(offered.text, offered.name.empty() ? "the map" : offered.name);
  wire::Started started;
  if (std::any_of(map.cells.begin(), map.cells.end(), map::is_line)) {
    const map::Start start = map::default_start(map);
    started.x = start.cell.x;
    started.y = start.cell.y;
    started.facing = map::letter(start.facing);
  }
  return wire::text_of(wire::to_json(record::floor_shapes(map, started)));
}

}  // namespace robosim::serve
