// Reads Robotrace courses of robotrace_course_cad.
//
// Source of the format: kyamashita5/robotrace_course_cad, commit 8daa8226, its doc/ and its solver. Source of
// the rules: NTF, Robotrace 1-1 to 2-8.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "sim/base/deterministic_trig.h"
#include "sim/base/error.h"
#include "sim/base/json_limits.h"
#include "sim/map/course/formats.h"

namespace robosim::course {
namespace {

using Json = nlohmann::json;

constexpr double kCm = 0.01;
constexpr double kTouching = 1e-5;       // in m: circles with a shorter tangent touch each other
constexpr double kMostCoordinate = 1e5;  // cm
constexpr std::size_t kMostCircles = 1000;
constexpr double kMarkLength = 0.040, kMarkAway = 0.070;
constexpr double kClose = 0.0005;  // in m: closer changes of curvature share one mark

struct Circle {
  Vec2 centre;
  double radius;
  double sign;
};

struct Tangent {
  Vec2 from, to, along;
  double length;
};

class Reader {
 public:
  Reader(const Json& json, const std::string& file) : json_(json), file_(file) {
    if (!json.is_object() || !json.contains("circles") || !json["circles"].is_array())
      refuse(
          "unknown kind of course: expected JSON of robotrace_course_cad (a list “circles”) or of "
          "rcj-rescue-cms (“tiles”)");
    const Json& circles = json["circles"];
    if (circles.size() < 2 || circles.size() > kMostCircles)
      refuse(fmt::format("circles: expected 2 to {} circles, got {}", kMostCircles, circles.size()));
    for (std::size_t i = 0; i < circles.size(); ++i) circles_.push_back(circle(circles[i], i + 1));
  }

  Imported read() const {
    const std::size_t count = circles_.size();
    std::vector<Tangent> out;
    for (std::size_t i = 0; i < count; ++i) out.push_back(tangent(i, (i + 1) % count));
    // The last tangent contains start and goal. The course begins at its start line.
    const Tangent& home = out.back();
    const double start_to_goal = number(json_, "length", "start_goal_hint", 100.0) * kCm;
    const double hint = std::clamp(dot(hint_at() - home.from, home.along), 0.0, home.length);
    const bool fits = hint >= start_to_goal / 2.0 && hint + start_to_goal / 2.0 <= home.length;
    const double start = fits ? hint + start_to_goal / 2.0 : home.length / 2.0;
    map::Path path({home.from + home.along * start, home.along});
    std::vector<double> corners;
    const auto straight = [&](double length) {
      if (length > kTouching) path.add_straight(length);
    };
    straight(home.length - start);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 in = out[(i + count - 1) % count].along, next = out[i].along;
      double turn = circles_[i].sign * (angle_of(next) - angle_of(in));
      turn -= std::floor(turn / (2.0 * std::numbers::pi)) * 2.0 * std::numbers::pi;
      if (turn * circles_[i].radius > kTouching) {
        corners.push_back(path.length());
        path.add_arc(circles_[i].radius, turn * circles_[i].sign);
        corners.push_back(path.length());
      }
      if (i + 1 < count) straight(out[i].length);
    }
    straight(start);
    return finish(path, corners, fits ? start_to_goal : 0.0);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw InputError({file_}, what); }

  double number(const Json& object, const char* key, const char* in, double otherwise) const {
    const Json* of = &object;
    if (in) {
      const auto found = object.find(in);
      if (found == object.end() || !found->is_object()) return otherwise;
      of = &*found;
    }
    const auto found = of->find(key);
    if (found == of->end()) return otherwise;
    if (!found->is_number() || !(std::fabs(found->get<double>()) <= kMostCoordinate))
      refuse(fmt::format("{}: expected a number of centimetres up to {:.0f}", key, kMostCoordinate));
    return found->get<double>();
  }

  Circle circle(const Json& json, std::size_t n) const {
    if (!json.is_object() || !json.contains("x") || !json.contains("y") || !json.contains("r"))
      refuse(fmt::format("circle {}: expected x, y and r", n));
    const double radius = number(json, "r", nullptr, 0.0) * kCm;
    if (!(radius > 0.0)) refuse(fmt::format("circle {}: r: expected a radius above 0", n));
    const bool clockwise = json.contains("turn") && json["turn"] == "cw";
    if (json.contains("turn") && !clockwise && json["turn"] != "ccw")
      refuse(fmt::format("circle {}: turn: expected “cw” or “ccw”", n));
    return {{number(json, "x", nullptr, 0.0) * kCm, number(json, "y", nullptr, 0.0) * kCm},
            radius,
            clockwise ? -1.0 : 1.0};
  }

  Vec2 hint_at() const {
    const Tangent home = tangent(circles_.size() - 1, 0);
    const Vec2 middle = (home.from + home.to) * 0.5;
    return {number(json_, "x", "start_goal_hint", middle.x / kCm) * kCm,
            number(json_, "y", "start_goal_hint", middle.y / kCm) * kCm};
  }

  Tangent tangent(std::size_t i, std::size_t j) const {
    const Circle &a = circles_[i], &b = circles_[j];
    const Vec2 d = b.centre - a.centre;
    const double delta = b.sign * b.radius - a.sign * a.radius;
    const double square = dot(d, d);
    if (square <= 0.0 || delta * delta > square + kTouching * kTouching)
      refuse(fmt::format(
          "circles {} and {} have no tangent in the directions of their turns: one lies inside the other, or "
          "they overlap",
          i + 1, j + 1));
    const double length = std::sqrt(std::max(square - delta * delta, 0.0));
    const Vec2 u = Vec2{d.x * length + d.y * delta, d.y * length - d.x * delta} * (1.0 / square);
    const Vec2 aside{u.y, -u.x};
    return {a.centre + aside * (a.sign * a.radius), b.centre + aside * (b.sign * b.radius), u, length};
  }

  Imported finish(const map::Path& path, const std::vector<double>& corners, double start_to_goal) const {
    const double line = number(json_, "line_width_cm", nullptr, kRobotraceLine / kCm) * kCm;
    if (!(line >= 0.001 && line <= 0.1)) refuse("line_width_cm: expected a number from 0.1 to 10");
    map::Map map = map_around({path}, line, kBoardMargin);
    map.light_line = true;
    map.goal = "laps:1";
    const auto mark = [&](double along, double away) {
      map.course.marks.push_back(
          map::mark_beside(map.course.paths, 0, rounded(along), away, kMarkLength, line));
    };
    double last = -1.0;
    for (const double along : corners) {
      if (along - last > kClose) mark(along, kMarkAway);
      last = along;
    }
    if (start_to_goal == 0.0)
      return {std::move(map),
              {"start and goal do not fit on the straight between the last circle and the first, so they "
               "have no marks; a robot starts in the middle of this straight"}};
    const double goal = path.length() - start_to_goal;
    mark(0.0, -kMarkAway);
    mark(goal, -kMarkAway);
    map.course.race = map::RaceLines{0, 0.0, rounded(goal)};
    map.goal = "robotrace";
    // Starts the robot between the goal line and the start line. Its sensors have not reached the start line.
    map.start = map::start_on(map, {0, rounded(goal + start_to_goal / 2.0), false});
    return {std::move(map), {}};
  }

  const Json& json_;
  const std::string& file_;
  std::vector<Circle> circles_;
};

}  // namespace

Imported read_robotrace(const nlohmann::json& json, const std::string& file) {
  return Reader(json, file).read();
}

nlohmann::json json_of(std::string_view text, const std::string& file) {
  if (!is_within_json_limits(text))
    throw InputError({file},
                     fmt::format("the JSON is too deep or too long: expected at most {} nested brackets and "
                                 "{} values",
                                 kDeepestJson, kMostJsonValues));
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const std::string_view before = text.substr(0, std::min(error.byte, text.size()));
    throw InputError({file, 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'))},
                     "not valid JSON from here on");
  }
}

}  // namespace robosim::course
