#include "sim/map/course_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "sim/base/deterministic_trig.h"
#include "sim/map/front_tables.h"

namespace robosim::map {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kLeastPiece = 1e-4;   // m
constexpr double kLeastTurn = 1.7e-8;  // in rad (1e-6 deg); course_text() alters angles by at most 2e-11 rad
constexpr double kMostRadius = 1000.0;
constexpr double kLeastWidth = 1e-3, kMostWidth = 0.1;  // m, for lines
constexpr double kLatestSignal = 600.0;                 // s
constexpr double kLongestRescue = 100.0;                // m
// Robotrace (NTF), rules 2-5 and 2-6: a marker is 40 mm long, and its middle is 70 mm from the line's middle.
constexpr double kMarkLength = 0.040;
constexpr double kMarkAway = 0.070;

double read_turn(const ConfigValue& value, double most) {
  const double turn = as_quantity(value, "angle", Dimension::angle, -most, most);
  if (std::fabs(turn) < kLeastTurn)
    throw InputError(value.place,
                     "angle: expected at least 0.000001 deg to the left or right; a straight has a length "
                     "instead");
  return turn;
}

// Returns a paint's index in paints_of(). Adds the paint to the course if it is new.
int number_of(const Paint& paint, const Paint& usual, Course& course, const Place& place) {
  if (paint == usual) return 0;
  std::size_t i = 0;
  while (i < course.paints.size() && course.paints[i] != paint) ++i;
  if (i == Paint::kMost)
    throw InputError(place, fmt::format("too many kinds of line: expected at most {} that differ from the "
                                        "map's usual line in the keys width, colour, worn or gloss",
                                        Paint::kMost));
  if (i == course.paints.size()) course.paints.push_back(paint);
  return static_cast<int>(i) + 1;
}

// Reads the keys of a paint; `paint` has the defaults. For a mark, skips `width`, the mark's size.
Paint read_paint(TableReader& table, bool of_line, Paint paint) {
  if (of_line) paint.width = table.quantity("width", Dimension::length, paint.width, kLeastWidth, kMostWidth);
  if (const ConfigValue* const colour = table.find("colour")) paint.colour = read_colour(*colour);
  paint.worn = read_share(table, "worn", paint.worn);
  paint.gloss = read_share(table, "gloss", paint.gloss);
  return paint;
}

void read_piece(const ConfigValue& value, const Paint& usual, const Paint& of_path, Course& course,
                Path& path) {
  TableReader table(value, "a segment");
  const bool is_gap = table.boolean("gap", false);
  const Paint paint = read_paint(table, true, of_path);
  const ConfigValue* const length = table.find("length");
  const ConfigValue* const radius = table.find("radius");
  const ConfigValue* const angle = table.find("angle");
  table.finish();
  if (length && !radius && !angle) {
    path.add_straight(as_quantity(*length, "length", Dimension::length, kLeastPiece, Path::kMost), is_gap);
  } else if (radius && angle && !length) {
    const double r = as_quantity(*radius, "radius", Dimension::length, kLeastPiece, kMostRadius);
    path.add_arc(r, read_turn(*angle, kTurn), is_gap);
  } else if (angle && !radius && !length && !is_gap) {
    path.add_corner(read_turn(*angle, kTurn / 2.0));
  } else {
    throw InputError(
        value.place,
        "invalid segment: expected a straight, { length = \"300 mm\" }, an arc, { radius = \"200 mm\", angle "
        "= \"90 deg\" }, or a corner, { angle = \"90 deg\" }; an angle below 0 turns to the right");
  }
  const bool is_corner = path.pieces().back().length == 0.0;
  if (paint != of_path && (is_gap || is_corner))
    throw InputError(value.place,
                     fmt::format("{} is not painted: the keys width, colour, worn and gloss are not allowed",
                                 is_gap ? "a gap" : "a corner"));
  path.paint_last(number_of(paint, usual, course, value.place));
  if (path.length() > Path::kMost)
    throw InputError(value.place,
                     fmt::format("the path is too long: expected at most {:.0f} km", Path::kMost / 1e3));
}

}  // namespace

void read_paths(const ConfigValue& value, const Paint& usual, Course& course) {
  for (const ConfigValue& item : tables_of(value, "path")) {
    TableReader table(item, "[[path]]");
    const Vec2 from = read_point(table.require("from"), "from");
    const double heading = table.quantity("heading", Dimension::angle, 0.0, -kTurn, kTurn);
    const ConfigValue& segments = table.require("segments");
    const Paint paint = read_paint(table, true, usual);
    table.finish();
    if (segments.kind != ConfigValue::Kind::array || segments.items.empty())
      throw InputError(segments.place,
                       "segments: expected a list of straights and arcs, such as [{ length = \"1 m\" }]");
    Path path({from, unit_vector(heading)});
    path.place = item.place;
    for (const ConfigValue& segment : segments.items) read_piece(segment, usual, paint, course, path);
    course.paths.push_back(std::move(path));
  }
}

void read_marks(const ConfigValue& value, double line_m, const Paint& usual, Course& course) {
  for (const ConfigValue& item : tables_of(value, "mark")) {
    TableReader table(item, "[[mark]]");
    const auto paths = static_cast<std::int64_t>(course.paths.size());
    if (paths == 0) throw InputError(item.place, "[[mark]] requires a [[path]] to lie next to");
    const auto path = static_cast<int>(table.integer("path", 1, 1, paths) - 1);
    const double most = course.paths[static_cast<std::size_t>(path)].length();
    const double along = as_quantity(table.require("along"), "along", Dimension::length, 0.0, most);
    const double away = table.quantity("away", Dimension::length, kMarkAway, 0.0, 1.0);
    const double length = table.quantity("length", Dimension::length, kMarkLength, kLeastPiece, 1.0);
    const double width = table.quantity("width", Dimension::length, line_m, kLeastPiece, 1.0);
    const bool left = table.choice("side", "left", {"left", "right"}) == "left";
    const Paint paint = read_paint(table, false, usual);
    table.finish();
    course.marks.push_back(mark_beside(course.paths, path, along, left ? away : -away, length, width));
    course.marks.back().paint = number_of(paint, usual, course, item.place);
  }
}

void read_race(const ConfigValue& value, double line_m, Course& course) {
  TableReader table(value, "[race]");
  const auto paths = static_cast<std::int64_t>(course.paths.size());
  if (paths == 0) throw InputError(value.place, "[race] requires a [[path]]");
  RaceLines race;
  race.path = static_cast<int>(table.integer("path", 1, 1, paths) - 1);
  const Path& path = course.paths[static_cast<std::size_t>(race.path)];
  const bool is_drag_race = table.find("braking") != nullptr;
  if (!is_drag_race && !path.is_closed(line_m))
    throw InputError(value.place,
                     "[race] requires a closed path, whose end meets its beginning; a drag race requires "
                     "braking = \"1 m\", the distance after its goal line");
  race.start = table.quantity("start", Dimension::length, 0.0, 0.0, path.length());
  const ConfigValue& goal = table.require("goal");
  race.goal = as_quantity(goal, "goal", Dimension::length, 0.0, path.length());
  race.braking = table.quantity("braking", Dimension::length, 0.0, kLeastPiece, path.length());
  const ConfigValue* const signal = table.find("signal");
  race.signal = table.quantity("signal", Dimension::time, 0.0, 1e-3, kLatestSignal);
  table.finish();
  if (signal && !is_drag_race)
    throw InputError(signal->place, "the key signal requires the key braking, for a drag race");
  if (race.goal == race.start)
    throw InputError(goal.place, "the goal line is the start line: expected two different places");
  if (is_drag_race && (race.goal < race.start || race.goal + race.braking > path.length()))
    throw InputError(goal.place,
                     fmt::format("the path is too short for a drag race: expected room for start, goal line "
                                 "and braking distance in this order, got {:.10g} mm",
                                 1e3 * path.length()));
  course.race = race;
}

void read_rescue(const ConfigValue& value, Course& course) {
  TableReader table(value, "[rescue]");
  if (course.paths.empty())
    throw InputError(value.place, "[rescue] requires a [[path]], along which the course goes");
  const double length = course.paths.front().length();
  if (length > kLongestRescue)
    throw InputError(value.place,
                     fmt::format("the first path is too long for [rescue]: expected at most {:.10g} m, got "
                                 "{:.10g} m",
                                 kLongestRescue, length));
  RescueCourse rescue;
  rescue.tile = table.quantity("tile", Dimension::length, rescue.tile, 0.1, 1.0);
  rescue.is_entry = table.choice("league", "line", {"line", "entry"}) == "entry";
  if (const ConfigValue* const origin = table.find("origin")) rescue.origin = read_point(*origin, "origin");
  rescue.to_zone = table.choice("end", "tile", {"tile", "zone"}) == "zone";
  if (const ConfigValue* const list = table.find("checkpoints")) {
    if (list->kind != ConfigValue::Kind::array)
      throw InputError(list->place,
                       "checkpoints: expected a list of lengths along the first path, such as [\"1.35 m\"]");
    for (const ConfigValue& item : list->items) {
      const double along = as_quantity(item, "a checkpoint", Dimension::length, 0.0, length);
      if (!rescue.checkpoints.empty() && along <= rescue.checkpoints.back())
        throw InputError(item.place,
                         "checkpoints: expected increasing lengths, the order in which the robot meets them");
      rescue.checkpoints.push_back(along);
    }
  }
  table.finish();
  course.rescue = rescue;
}

}  // namespace robosim::map
