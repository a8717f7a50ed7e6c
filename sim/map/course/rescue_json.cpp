// Reads RoboCupJunior Rescue Line courses of rcj-rescue-cms.
//
// Source of the format: robocup-junior/rcj-rescue-cms, commit 14ba0ba2, models/lineMap.js and
// helper/pathFinder.js. Source of the rules: RoboCupJunior Rescue Line.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "sim/base/error.h"
#include "sim/base/pluralize.h"
#include "sim/map/course/formats.h"
#include "sim/map/course/polyline.h"
#include "sim/map/course/rescue_tiles.h"

namespace robosim::course {
namespace {

using Json = nlohmann::json;

constexpr double kTile = 0.300, kRescueLine = 0.020, kGreen = 0.025, kStrip = 0.250;  // m
constexpr int kCells = 3;   // cells of 100 mm in a tile
constexpr int kAround = 3;  // cells around the field (one tile), since robots leave the field
constexpr int kMostTiles = 100;

struct Key {
  int x, y, z;
  auto operator<=>(const Key&) const = default;
};

struct Drawn {
  Polyline line;  // in percent of the tile's side, before the tile's rotation
  bool used = false;
};

struct Tile {
  Key at;
  int quarters = 0;
  std::string id;
  std::vector<Drawn> lines;
  std::string arms, turns, greens, used_arms;
  char up = 0, down = 0;  // sides with a higher or a lower neighbour
  int obstacles = 0, bumps = 0;
  bool ramp = false, checkpoint = false;
};

class RescueReader {
 public:
  RescueReader(const Json& json, const std::string& file) : json_(json), file_(file) {
    columns_ = size("width");
    rows_ = size("length");
    const Json& tiles = json["tiles"];
    if (!tiles.is_array() && !tiles.is_object()) refuse("tiles: expected a list or an object");
    for (const auto& item : tiles) add(item);
    if (tiles_.empty()) refuse("tiles: expected at least one tile");
  }

  Imported read() {
    const std::optional<Key> start = key("startTile"), second = key("startTile2");
    if (!start || !tiles_.contains(*start)) refuse("startTile: expected one of the tiles");
    Tile& first = tiles_.at(*start);
    char entry = 0;
    for (const char side : entries_of(first))
      if (tiles_.contains(next(first, side))) entry = side;
    if (!entry)
      refuse(fmt::format("startTile: expected a tile that is joined to another tile, got {},{}", start->x,
                         start->y));
    follow(first, entry);
    if (second && tiles_.contains(*second) && has_evacuation()) after_evacuation(tiles_.at(*second));
    const std::size_t routes = lines_.size();
    for (auto& [at, tile] : tiles_) rest_of(tile);
    return finish(routes);
  }

 private:
  [[noreturn]] void refuse(const std::string& message) const { throw InputError({file_}, message); }

  int size(const char* name) const {
    if (!json_.contains(name) || !json_[name].is_number_integer())
      refuse(fmt::format("{}: expected a whole number of tiles", name));
    const auto value = json_[name].get<std::int64_t>();
    if (value < 1 || value > kMostTiles)
      refuse(fmt::format("{}: expected 1 to {} tiles, got {}", name, kMostTiles, value));
    return static_cast<int>(value);
  }

  std::optional<Key> key(const char* name) const {
    if (!json_.contains(name)) return std::nullopt;
    return key_of(json_[name], name);
  }

  Key key_of(const Json& json, const std::string& what) const {
    const auto number = [&](const char* name) {
      if (!json.is_object() || !json.contains(name) || !json[name].is_number_integer() ||
          std::abs(json[name].get<std::int64_t>()) > kMostTiles)
        refuse(fmt::format("{}: expected whole numbers x, y and z", what));
      return json[name].get<int>();
    };
    return {number("x"), number("y"), number("z")};
  }

  char side_named(const Json& json, const char* name, const Key& at) const {
    if (!json.contains(name) || json[name].is_null()) return 0;
    for (const auto& [word, side] : {std::pair{"left", 'L'}, {"top", 'T'}, {"right", 'R'}, {"bottom", 'B'}})
      if (json[name] == word) return side;
    refuse(fmt::format("tile {},{}: invalid value of the key {}: expected left, top, right or bottom", at.x,
                       at.y, name));
  }

  void add(const Json& item) {
    Tile tile;
    tile.at = key_of(item, fmt::format("tile {}", tiles_.size() + 1));
    const Key& at = tile.at;
    const std::string where = fmt::format("tile {},{}", at.x, at.y);
    if (at.x < 0 || at.y < 0 || at.x >= columns_ || at.y >= rows_)
      refuse(fmt::format("{}: expected a tile inside the field of {} x {} tiles", where, columns_, rows_));
    const int rot = item.contains("rot") && item["rot"].is_number_integer() ? item["rot"].get<int>() : 0;
    if (rot != 0 && rot != 90 && rot != 180 && rot != 270)
      refuse(fmt::format("{}: rot: expected 0, 90, 180 or 270, got {}", where, rot));
    tile.quarters = rot / 90;
    const Json none;
    const Json& type = item.contains("tileType") ? item["tileType"] : none;
    if (type.is_string()) tile.id = type.get<std::string>();
    if (type.is_object() && type.contains("_id") && type["_id"].is_string())
      tile.id = type["_id"].get<std::string>();
    if (tile.id.empty()) refuse(where + ": tileType is missing");
    draw(tile, type, where);
    tile.up = side_named(item, "levelUp", at);
    tile.down = side_named(item, "levelDown", at);
    tile.checkpoint = item.contains("checkPoint") && item["checkPoint"] == true;
    if (item.contains("items") && item["items"].is_object()) {
      const Json& items = item["items"];
      const auto count = [&](const char* name) {
        return items.contains(name) && items[name].is_number_integer()
                   ? static_cast<int>(std::clamp<std::int64_t>(items[name].get<std::int64_t>(), 0, 100))
                   : 0;
      };
      tile.obstacles = count("obstacles");
      tile.bumps = count("speedbumps");
      tile.ramp = items.contains("rampPoints") && items["rampPoints"] == true;
    }
    if (!tiles_.emplace(at, std::move(tile)).second) refuse(where + " is given twice");
  }

  // Adds the lines of a tile, from rescue_tiles() or from the file.
  void draw(Tile& tile, const Json& type, const std::string& where) {
    if (is_evacuation(tile.id)) return;
    for (const TileKind& kind : rescue_tiles()) {
      if (kind.id != tile.id) continue;
      for (const TileLine& line : kind.lines)
        if (!line.points.empty()) tile.lines.push_back({polyline_of(line)});
      tile.arms = kind.arms;
      tile.turns = kind.turns;
      tile.greens = kind.greens;
      simplified_ += kind.simplified;
      return;
    }
    // For an unknown tile, uses the paths in the file. Each path leads from one side to another.
    if (!type.is_object() || !type.contains("paths") || !type["paths"].is_object() || type["paths"].empty())
      refuse(fmt::format("{}: unknown type of tile: expected a known tileType or one with paths, got “{}”",
                         where, tile.id.substr(0, 40)));
    for (const auto& [from, to] : type["paths"].items()) {
      const char a = side_named({{from, from}}, from.c_str(), tile.at);
      const char b = side_named(type["paths"], from.c_str(), tile.at);
      tile.turns += fmt::format("{}{} ", a, b);
      for (const char side : {a, b})
        if (tile.arms.find(side) == std::string::npos) tile.arms += side;
    }
    ++simplified_;
  }

  // Returns the sides through which the route may enter the rotated tile.
  static std::string entries_of(const Tile& tile) {
    std::string sides;
    for (const Drawn& drawn : tile.lines)
      for (const Vec2 end : {drawn.line.front().at, drawn.line.back().at})
        if (side_of(end)) sides += side_of(end);
    for (std::size_t i = 0; i < tile.turns.size(); i += 3) sides += tile.turns[i];
    for (char& side : sides) side = turned(side, tile.quarters);
    return sides;
  }

  // Returns the exit of the route for this entry; 0 = none.
  static char exit_of(const Tile& tile, char entry) {
    const char own = turned(entry, -tile.quarters);
    for (const Drawn& drawn : tile.lines) {
      const char a = side_of(drawn.line.front().at), b = side_of(drawn.line.back().at);
      if (own == a || own == b) return turned(own == a ? b : a, tile.quarters);
    }
    for (std::size_t i = 0; i < tile.turns.size(); i += 3)
      if (tile.turns[i] == own) return turned(tile.turns[i + 1], tile.quarters);
    return 0;
  }

  static Key beside(const Key& at, char side) {
    return {at.x + (side == 'R') - (side == 'L'), at.y + (side == 'B') - (side == 'T'), at.z};
  }

  static Key next(const Tile& tile, char entry) {
    const char exit = exit_of(tile, entry);
    Key key = beside(tile.at, exit);
    if (exit && exit == tile.up) ++key.z;
    if (exit && exit == tile.down) --key.z;
    return exit ? key : Key{-1, -1, -1};
  }

  Vec2 world(const Tile& tile, Vec2 percent) const {
    const Vec2 p = turned(percent, tile.quarters);
    return {rounded(kAround * 0.1 + (tile.at.x + p.x * 0.01) * kTile),
            rounded(kAround * 0.1 + (rows_ - tile.at.y - p.y * 0.01) * kTile)};
  }

  void append(Polyline& line, const Tile& tile, const Polyline& part) const {
    for (Polyline::value_type point : part) {
      point.at = world(tile, point.at);
      line.push_back(point);
    }
  }

  // Follows the route tile by tile to its end.
  void follow(Tile& from, char entry) {
    Polyline route;
    Tile* tile = &from;
    for (std::size_t steps = 0; steps <= 4 * tiles_.size(); ++steps) {
      const char own = turned(entry, -tile->quarters);
      const char exit = exit_of(*tile, entry);
      if (!exit) break;
      ++tiles_on_route_;
      if (lines_.empty()) checkpoints_.push_back(tile->checkpoint);
      bool is_line = false;
      for (Drawn& drawn : tile->lines) {
        Polyline part = drawn.line;
        if (side_of(part.front().at) != own && side_of(part.back().at) != own) continue;
        if (side_of(part.front().at) != own) reverse(part);
        if (tile->id == kRescueExit) part.pop_back();  // the line ends at the red bar
        append(route, *tile, part);
        drawn.used = is_line = true;
        break;
      }
      if (!is_line) {
        const char out = turned(exit, -tile->quarters);
        append(route, *tile, {{middle_of(own)}, {{50.0, 50.0}}, {middle_of(out)}});
        tile->used_arms += {own, out};
      }
      if (tile->id == kRescueExit) {
        strip(world(*tile, {50, 50}), turned('B', tile->quarters), map::Hue::red, kTile);
        break;
      }
      const auto beyond = tiles_.find(next(*tile, entry));
      if (beyond == tiles_.end()) break;
      if (is_evacuation(beyond->second.id)) {
        const Vec2 inward = middle_of(turned(exit, -tile->quarters));
        strip(world(*tile, inward), exit, map::Hue::silver, kStrip);
        to_zone_ = true;
        break;
      }
      entry = turned(exit, 2);
      tile = &beyond->second;
    }
    if (route.size() > 1) lines_.push_back(std::move(route));
  }

  bool has_evacuation() const {
    return std::any_of(tiles_.begin(), tiles_.end(),
                       [](const auto& t) { return is_evacuation(t.second.id); });
  }

  void after_evacuation(Tile& tile) {
    for (const char side : entries_of(tile)) {
      const auto from = tiles_.find(beside(tile.at, side));
      if (from == tiles_.end() || !is_evacuation(from->second.id)) continue;
      strip(world(tile, middle_of(turned(side, -tile.quarters))), side, map::Hue::black, kStrip);
      return follow(tile, side);
    }
    remarks_.push_back(
        "no tile of the evacuation zone is next to startTile2, so the path after the zone is missing");
  }

  // Adds a strip across the path. The strip's edge towards `side` goes through `at`.
  void strip(Vec2 at, char side, map::Hue hue, double across) {
    const Vec2 out{(side == 'R') - 1.0 * (side == 'L'), (side == 'T') - 1.0 * (side == 'B')};
    areas_.push_back({{{at - out * (0.5 * kGreen), out}, 0.5 * kGreen, 0.5 * across}, {hue}});
  }

  // Adds lines outside the route, and green squares.
  void rest_of(Tile& tile) {
    for (Drawn& drawn : tile.lines) {
      if (drawn.used) continue;
      Polyline& line = lines_.emplace_back();
      append(line, tile, drawn.line);
    }
    for (const char arm : tile.arms) {
      if (tile.used_arms.find(arm) != std::string::npos) continue;
      Polyline& line = lines_.emplace_back();
      append(line, tile, {{{50.0, 50.0}}, {middle_of(arm)}});
    }
    const double away = 100.0 * (0.5 * kRescueLine + 0.5 * kGreen) / kTile;
    for (const char green : tile.greens) {
      const double x = green == 'b' || green == 'd' ? 1.0 : -1.0,
                   y = green == 'c' || green == 'd' ? 1.0 : -1.0;
      const Pose middle{world(tile, {50.0 + x * away, 50.0 + y * away}), {1.0, 0.0}};
      areas_.push_back({{middle, 0.5 * kGreen, 0.5 * kGreen}, {map::Hue::green}});
    }
  }

  // Sets the goal along the first path. Sets no goal if the path and the route pass different tiles. Possible
  // causes are several levels, and lines on a tile's edge.
  void set_goal(map::Map& map) {
    const std::vector<double> middles = tile_middles(map.course.paths.front(), kTile);
    map.goal = "none";
    if (middles.size() != checkpoints_.size() || middles.size() < 2)
      return remarks_.push_back("the path cannot be followed tile by tile, so the map has no goal");
    map.goal = "rescue-line";
    map::RescueCourse& rescue = map.course.rescue.emplace();
    rescue.tile = kTile;
    rescue.to_zone = to_zone_;
    for (std::size_t i = 1; i + 1 < middles.size(); ++i)
      if (checkpoints_[i]) rescue.checkpoints.push_back(rounded(middles[i]));
  }

  Imported finish(std::size_t routes) {
    Imported imported;
    map::Map& map = imported.map;
    map.line_m = kRescueLine;
    map.width = kCells * columns_ + 2 * kAround;
    map.height = kCells * rows_ + 2 * kAround;
    map.cells.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height),
                     map::Cell::floor);
    for (const Polyline& line : lines_) map.course.paths.push_back(path_of(line));
    if (routes == 0) refuse("no route begins at the start tile");
    map.course.areas = areas_;
    set_goal(map);
    map.start = map::start_on(map, {0, 0.5 * kTile, false});
    int obstacles = 0, bumps = 0, ramps = 0, seesaws = 0, evacuation = 0, levels = 0;
    for (const auto& [at, tile] : tiles_) {
      if (tile.obstacles > 0)
        map.cells[map.index_of({kAround + kCells * at.x + 1, kAround + kCells * at.y + 1})] = map::Cell::wall;
      obstacles += tile.obstacles > 0;
      bumps += tile.bumps;
      ramps += tile.ramp || tile.up || tile.down;
      seesaws += tile.id == kRescueSeesaw;
      evacuation += is_evacuation(tile.id);
      levels += at.z != tiles_.begin()->first.z;
    }
    const auto say = [&](int count, const char* what, const char* how) {
      if (count > 0)
        imported.remarks.push_back(
            fmt::format("{} {}", pluralize(static_cast<std::size_t>(count), what), how));
    };
    imported.remarks = remarks_;
    say(obstacles, "tile",
        "with obstacles: each gets a wall of 100 mm in its middle, because the file gives no position");
    say(bumps, "speed bump", "skipped: floors are flat");
    say(ramps, "tile", "with ramps: floors are flat, so their lines are level");
    say(seesaws, "seesaw", "skipped: floors are flat");
    say(levels, "tile", "on another level: all levels lie in one plane");
    say(evacuation, "tile",
        "of the evacuation zone: only its floor is imported, without walls and victims; the goal ends before "
        "it");
    say(simplified_, "tile", "with roundabouts or of an unknown type: only the path through it is drawn");
    if (json_.contains("indexCount") && json_["indexCount"].is_number_integer() &&
        json_["indexCount"].get<std::int64_t>() != static_cast<std::int64_t>(tiles_on_route_))
      imported.remarks.push_back(fmt::format("the path leads over {}, but the file states {}",
                                             pluralize(tiles_on_route_, "tile"), json_["indexCount"].dump()));
    return imported;
  }

  const Json& json_;
  const std::string& file_;
  int columns_ = 0, rows_ = 0;
  std::map<Key, Tile> tiles_;
  std::vector<Polyline> lines_;
  std::vector<map::Area> areas_;
  std::vector<bool> checkpoints_;  // whether each tile of the first route is a checkpoint
  std::vector<std::string> remarks_;
  int simplified_ = 0;
  bool to_zone_ = false;  // the first path ends at the evacuation zone
  std::size_t tiles_on_route_ = 0;
};

}  // namespace

Imported read_rescue(const nlohmann::json& json, const std::string& file) {
  return RescueReader(json, file).read();
}

}  // namespace robosim::course
