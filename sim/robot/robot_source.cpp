#include "sim/robot/robot_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/did_you_mean.h"
#include "sim/base/file.h"
#include "sim/base/file_scope.h"
#include "sim/robot/description.h"

namespace robosim::robot {
namespace fs = std::filesystem;

std::string text_of(const ConfigValue& table, const char* key) {
  const ConfigValue* value = table.find(key);
  return value && value->kind == ConfigValue::Kind::string ? value->string : "";
}

namespace {

constexpr int kMostBases = 8;

ConfigValue* member(ConfigValue& table, std::string_view key) {
  for (auto& [name, value] : table.members)
    if (name == key) return &value;
  return nullptr;
}

void set(ConfigValue& table, const std::string& key, const ConfigValue& value) {
  if (ConfigValue* old = member(table, key))
    *old = value;
  else
    table.members.emplace_back(key, value);
}

void override_members(ConfigValue& table, const ConfigValue& with) {
  for (const auto& [key, value] : with.members) set(table, key, value);
  table.place = with.place;
}

std::vector<ConfigValue>& parts_of(ConfigValue& tree) {
  ConfigValue* parts = member(tree, "part");
  if (!parts) {
    tree.members.emplace_back("part", ConfigValue{.kind = ConfigValue::Kind::array});
    parts = &tree.members.back().second;
  }
  if (parts->kind != ConfigValue::Kind::array)
    throw InputError(parts->place, "part: expected a table [[part]] for each part");
  return parts->items;
}

// Returns the part named `name`, or end().
std::vector<ConfigValue>::iterator find_part(std::vector<ConfigValue>& parts, const std::string& name) {
  return std::find_if(parts.begin(), parts.end(),
                      [&](const ConfigValue& p) { return text_of(p, "name") == name; });
}

std::vector<std::string> part_names(const std::vector<ConfigValue>& parts) {
  std::vector<std::string> names;
  for (const ConfigValue& part : parts) names.push_back(text_of(part, "name"));
  return names;
}

void remove_parts(std::vector<ConfigValue>& parts, const ConfigValue& list) {
  if (list.kind == ConfigValue::Kind::string && list.string == "all") {
    parts.clear();
    return;
  }
  if (list.kind != ConfigValue::Kind::array)
    throw InputError(list.place, "remove: expected a list of part names, such as [\"buzzer\"], or \"all\"");
  for (const ConfigValue& item : list.items) {
    const auto part = find_part(parts, as_string(item, "remove"));
    if (part == parts.end())
      throw InputError(item.place, fmt::format("remove: unknown part of the base: {}",
                                               expected_one_of(item.string, part_names(parts))));
    parts.erase(part);
  }
}

void override_parts(std::vector<ConfigValue>& parts, std::vector<ConfigValue>& own) {
  const std::size_t inherited = parts.size();
  for (ConfigValue& part : own) {
    const auto base_end = parts.begin() + static_cast<std::ptrdiff_t>(inherited);
    const auto old = std::find_if(parts.begin(), base_end, [&](const ConfigValue& p) {
      return text_of(p, "name") == text_of(part, "name");
    });
    if (old == base_end || part.kind != ConfigValue::Kind::table) {
      parts.push_back(part);
    } else if (const std::string type = text_of(part, "type");
               !type.empty() && type != text_of(*old, "type")) {
      *old = part;
    } else {
      override_members(*old, part);
    }
  }
}

// Returns whether `key` is a table whose keys a derived robot file may override one by one.
bool merged(const std::string& key) {
  return key == "chassis" || key == "motors" || key == "driver" || key == "budget" || key == "electronics";
}

// Overrides `base` with `own`: tables key by key, parts by name.
ConfigValue derive(ConfigValue base, ConfigValue own) {
  std::vector<ConfigValue> own_parts = parts_of(own);
  if (const ConfigValue* list = own.find("remove")) {
    remove_parts(parts_of(base), *list);
    ConfigValue* driver = member(base, "driver");
    if (driver && list->kind == ConfigValue::Kind::string)  // "all": also removes the standby wire
      driver->members.remove_if([](const auto& item) { return item.first == "standby"; });
  }
  override_parts(parts_of(base), own_parts);
  for (auto& [key, value] : own.members) {
    ConfigValue* old = member(base, key);
    const bool both_tables =
        old && old->kind == ConfigValue::Kind::table && value.kind == ConfigValue::Kind::table;
    if (key == "part" || key == "remove" || key == "base") continue;
    if (both_tables && merged(key))
      override_members(*old, value);
    else
      set(base, key, value);
  }
  base.place = own.place;
  return base;
}

// Returns the path of a stock robot by name, or of a file relative to the file that names it.
fs::path find_base(const ConfigValue& base, const fs::path& from) {
  const std::string& name = as_string(base, "base");
  if (name.find_first_of("/.") != std::string::npos) {
    const fs::path path = from.parent_path() / name;
    check_in_scope(path, base.place);
    std::error_code error;
    if (!fs::is_regular_file(path, error))
      throw InputError(base.place, fmt::format("base: no such file {}, got \"{}\"", path.string(), name));
    return path;
  }
  try {
    return find_robot(name);
  } catch (const InputError& error) {
    throw InputError(base.place, error.message());
  }
}

RobotSource read_with_bases(std::string_view text, const fs::path& file, int depth) {
  RobotSource source{parse_toml(text, file.string()), {{file, std::string(text)}}, {}};
  const ConfigValue* base = source.tree.find("base");
  if (!base) {
    if (const ConfigValue* list = source.tree.find("remove"))
      throw InputError(list->place, "remove requires the key base, the robot that has these parts");
    return source;
  }
  if (depth == kMostBases)
    throw InputError(
        base->place,
        fmt::format("too many robots based on each other: expected at most {}; is one its own base?",
                    kMostBases));
  const fs::path path = find_base(*base, file);
  std::string base_text;
  try {
    base_text = read_file(path);
  } catch (const InputError& error) {
    throw InputError(base->place, fmt::format("base \"{}\": {}", base->string, error.what()));
  }
  RobotSource below = read_with_bases(base_text, path, depth + 1);
  source.based_on = std::move(below.based_on);
  source.based_on.emplace(path.string(), base->place);
  source.tree = derive(std::move(below.tree), std::move(source.tree));
  std::move(below.texts.begin(), below.texts.end(), std::back_inserter(source.texts));
  return source;
}

}  // namespace

std::string bytes_of(const RobotSource& source) {
  std::string bytes;
  for (const SourceText& one : source.texts) bytes += one.text;
  return bytes;
}

std::string place_text(const RobotSource& source, const Place& place) {
  const auto base = source.based_on.find(place.file);
  const std::string text = fmt::format("{}:{}", place.file, place.line);
  if (base == source.based_on.end()) return text;
  return fmt::format("{}, which {}:{} extends", text, base->second.file, base->second.line);
}

RobotSource read_source(std::string_view text, const fs::path& file) {
  return read_with_bases(text, file, 0);
}

}  // namespace robosim::robot
