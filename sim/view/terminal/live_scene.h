// Draws the content of the live view. The content depends only on the events, not on the terminal or a clock.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/map/map.h"
#include "sim/view/terminal/floor_picture.h"
#include "sim/view/terminal/frame.h"
#include "sim/view/terminal/report.h"
#include "sim/wire/messages.h"

namespace robosim::terminal {

class LiveScene {
 public:
  /// `title` names sketch, robot and map. `names` are the robots' names if there are several robots; only the
  /// parts of the first robot are shown. The map must outlive the scene.
  LiveScene(std::string title, const map::Map& map, const wire::RobotInfo& robot,
            std::vector<std::string> names = {});

  void add(const wire::Event& event);
  void finish(const result::RunResult& result);
  const wire::Started& started() const { return started_; }

  /// Moves the window by tenths of its size. The window stops following the robot.
  void scroll(int right, int down);
  /// Makes the window follow the robot again, if the map is too large to be shown whole.
  void follow();

  /// Draws the view. `speed` is a text such as "x1" or "paused".
  Frame draw(int columns, int rows, const std::string& speed, Look look);

 private:
  /// A robot other than the first.
  struct Other {
    Trail trail;
    Vec2 drawn_to;
  };
  void add_other(const wire::Event& event, int agent);
  void draw_trails();
  void choose_window(int columns, int rows);
  void keep_robot_in_sight();
  void move_window(Vec2 top_left);
  Vec2 to_world(double forward_m, double left_m) const;
  std::vector<Mark> marks() const;
  /// Returns whether a reading is a line sensor's level. Other readings are numbers, or on/off states.
  bool is_level(const std::string& reading) const;
  /// Returns the unit of a numeric reading, or null for other readings.
  const std::string* unit_of(const std::string& reading) const;
  /// Draws the texts of displays. Returns the row below them.
  int draw_told(Frame& frame, int row) const;
  /// Draws the readings. Returns the row below them.
  int draw_readings(Frame& frame, int row, Look look) const;

  std::string title_;
  std::vector<std::string> names_;
  std::map<int, Other> others_;  ///< by robot number
  const map::Map& map_;
  wire::RobotInfo robot_;
  FloorPicture floor_;
  wire::Started started_;
  std::optional<wire::Sample> sample_;
  Trail trail_;
  Vec2 drawn_to_;  // end of the trail as drawn in floor_
  std::vector<std::string> visited_;
  std::string serial_;                       // last part of the serial output
  std::map<std::string, std::string> told_;  // texts of displays, by part
  std::string note_;
  std::optional<result::RunResult> result_;
  bool follows_ = true;
};

}  // namespace robosim::terminal
