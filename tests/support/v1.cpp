#include "tests/support/v1.h"

#include <cstring>

namespace robosim::cells::v1 {
namespace {

char right_of(char d) { return d == 'N' ? 'E' : d == 'E' ? 'S' : d == 'S' ? 'W' : 'N'; }
char left_of(char d) { return d == 'N' ? 'W' : d == 'W' ? 'S' : d == 'S' ? 'E' : 'N'; }
char back_of(char d) { return right_of(right_of(d)); }

bool is(const char* sense, const char* what) { return std::strcmp(sense, what) == 0; }

// Follows the line to a junction (returns 1) or to a place without a path (returns 0).
int move_on_line(Robot& robot) {
  for (;;) {
    const char* sense = robot.sense();
    if (is(sense, "straight")) robot.step_forward();
    if (is(sense, "right_turn")) robot.turn_right();
    if (is(sense, "left_turn")) robot.turn_left();
    if (is(sense, "junction")) return 1;
    if (is(sense, "no_path")) return 0;
  }
}

}  // namespace

char Robot::at(int cx, int cy) const {
  if (!map->contains({cx, cy})) return '?';
  const map::Cell cell = map->at({cx, cy});
  return cell == map::Cell::line ? '1' : cell == map::Cell::wall ? '2' : '0';
}

void Robot::side(char to, int& dx, int& dy) const {
  dx = to == 'E' ? 1 : to == 'W' ? -1 : 0;
  dy = to == 'S' ? 1 : to == 'N' ? -1 : 0;
}

const char* Robot::sense() const {
  const auto seen = [&](char to) {
    int dx = 0, dy = 0;
    side(to, dx, dy);
    return at(x + dx, y + dy);
  };
  const char front = seen(facing), right = seen(right_of(facing)), left = seen(left_of(facing)),
             own = at(x, y);
  const int lines = (front == '1') + (right == '1') + (left == '1') + (own == '1');
  if (lines == 0) return "no_path";
  if (lines == 1) return front == '0' ? "no_path" : "straight";
  if (lines >= 3) return "junction";
  if (right == '1' && left == '1') return facing == 'N' || facing == 'W' ? "right_turn" : "left_turn";
  if (right == '1') return "right_turn";
  if (left == '1') return "left_turn";
  return "straight";
}

void Robot::note(const char* move) {
  if (!moves) return;
  moves->push_back(std::to_string(x) + "," + std::to_string(y) + "," + facing + "," + sense() + "," + move +
                   "," + std::to_string(clock + 1));
}

void Robot::step_forward() {
  note("step_forward");
  int dx = 0, dy = 0;
  side(facing, dx, dy);
  if (map->contains({x + dx, y + dy})) x += dx, y += dy;
  ++clock;
}

void Robot::turn_right() {
  note("turn_right");
  int dx = 0, dy = 0;
  facing = right_of(facing);
  side(facing, dx, dy);
  if (map->contains({x + dx, y + dy})) x += dx, y += dy;
  ++clock;
}

void Robot::turn_left() {
  note("turn_left");
  int dx = 0, dy = 0;
  facing = left_of(facing);
  side(facing, dx, dy);
  if (map->contains({x + dx, y + dy})) x += dx, y += dy;
  ++clock;
}

void Robot::turn_around() {
  note("turn_around");
  facing = back_of(facing);
  ++clock;
}

void Robot::choose_right() {
  note("choose_right");
  int dx = 0, dy = 0;
  side(right_of(facing), dx, dy);
  if (at(x + dx, y + dy) == '1') {
    facing = right_of(facing);
  } else {
    side(facing, dx, dy);
  }
  x += dx, y += dy;
  ++clock;
}

void Robot::choose_left() {
  note("choose_left");
  int dx = 0, dy = 0;
  side(left_of(facing), dx, dy);
  if (at(x + dx, y + dy) == '1') {
    facing = left_of(facing);
  } else {
    side(facing, dx, dy);
  }
  x += dx, y += dy;
  ++clock;
}

Scan scan(Robot& robot) {
  Scan result;
  result.nodes.resize(1);  // nodes are numbered from 1
  std::vector<int> stack;
  bool back = false;
  do {
    const int met = move_on_line(robot);
    if (back) {
      back = false;
      if (result.nodes[static_cast<std::size_t>(stack.back())].visit == 3) {
        back = true;
        stack.pop_back();
      }
      robot.choose_right();
    } else if (met == 1) {
      Node node;
      node.no = static_cast<int>(result.nodes.size());
      if (stack.empty()) {
        node.station[0] = 1;
      } else {
        Node& top = result.nodes[static_cast<std::size_t>(stack.back())];
        node.junction[node.visit] = top.no;
        top.junction[top.visit++] = node.no;
      }
      node.visit = 1;
      result.nodes.push_back(node);
      stack.push_back(node.no);
      robot.choose_right();
    } else {
      Node& top = result.nodes[static_cast<std::size_t>(stack.back())];
      top.station[top.visit++] = ++result.stations;
      robot.turn_around();
      back = true;
    }
  } while (!stack.empty());
  move_on_line(robot);
  robot.turn_around();
  return result;
}

}  // namespace robosim::cells::v1
