#include "sim/map/cells/custom.h"

#include <dlfcn.h>

#include "sim/base/error.h"
#include "sim/map/cells/include/robosim/cells.h"

namespace robosim::cells {
namespace {

static_assert(static_cast<int>(robosim::Sense::junction) == static_cast<int>(cells::Sense::junction));

class Adapter final : public Cells {
 public:
  Adapter(CellRobot& robot, DeadEnds& visited) : robot_(robot), visited_(visited) { visited_.look(robot_); }

  robosim::Sense sense() override { return static_cast<robosim::Sense>(robot_.sense()); }
  void step_forward() override { did(&CellRobot::step_forward); }
  void turn_right() override { did(&CellRobot::turn_right); }
  void turn_left() override { did(&CellRobot::turn_left); }
  void turn_around() override { did(&CellRobot::turn_around); }
  void choose_right() override { did(&CellRobot::choose_right); }
  void choose_left() override { did(&CellRobot::choose_left); }
  unsigned long long moves() const override { return robot_.moves(); }
  int x() const override { return robot_.pose().cell.x; }
  int y() const override { return robot_.pose().cell.y; }
  char facing() const override { return letter(robot_.facing()); }
  int dead_ends() const override { return static_cast<int>(visited_.cells().size()); }

 private:
  void did(void (CellRobot::*move)()) {
    (robot_.*move)();
    visited_.look(robot_);
  }

  CellRobot& robot_;
  DeadEnds& visited_;
};

}  // namespace

Walk run_custom(CellRobot& robot, const std::filesystem::path& shared_object) {
  void* const library = ::dlopen(shared_object.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw InputError(std::string("the algorithm cannot be loaded: ") + ::dlerror());
  const auto navigate = reinterpret_cast<void (*)(Cells&)>(::dlsym(library, "navigate"));
  if (!navigate) throw InputError("missing function: expected void navigate(robosim::Cells& robot)");
  DeadEnds visited;
  Adapter adapter(robot, visited);
  Walk walk;
  walk.ending = Walk::Ending::returned;
  try {
    navigate(adapter);
  } catch (const OutOfMoves&) {
    walk.ending = Walk::Ending::out_of_moves;
  }
  walk.moves = robot.moves();
  walk.time = robot.clock();
  walk.end = robot.pose();
  walk.dead_ends = visited.cells();
  return walk;
}

}  // namespace robosim::cells
