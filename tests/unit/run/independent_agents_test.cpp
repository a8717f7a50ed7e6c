// Tests an optimisation: robots that are far apart are simulated independently of each other. Their motion,
// readings, output and events must not change, and neither must the order of all events.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "sim/exec/core/board_state.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "tests/support/fake_firmware.h"
#include "tests/support/temporary_folder.h"

namespace robosim::run::independent_agents_test {

/// Firmware for an Uno that drives randomly, reads sensors, prints and occasionally crashes.
class Roaming final : public test::FakeFirmware {
 public:
  explicit Roaming(unsigned seed) : random_(seed) {}

  void power_on(SimTime t) override {
    board_.reset(t);
    on_ = true;
  }
  void power_off(SimTime t) override {
    board_.reset(t);
    on_ = false;
  }
  void run_until(SimTime t) override {
    now_ = t;
    for (; on_ && !crash_ && next_ < t; next_ += (1 + random_() % 40) * 700 * kMicrosecond) act(next_);
  }

  std::string seen;

 private:
  void act(SimTime t) {
    seen += board_.read_level(12, t) ? '1' : '0';  // the bumper or the infra-red switch
    const auto drive = [&](Pin enable, Pin one, Pin other, bool back) {
      board_.set_drive(enable, {PinMode::output, true, true, 0.25 * static_cast<double>(random_() % 5), 0},
                       t);
      board_.set_drive(one, {PinMode::output, !back, false, back ? 0.0 : 1.0, 0}, t);
      board_.set_drive(other, {PinMode::output, back, false, back ? 1.0 : 0.0, 0}, t);
    };
    switch (random_() % 6) {
      case 0:
        return drive(5, 7, 8, random_() % 4 == 0);
      case 1:
        return drive(6, 9, 10, random_() % 4 == 0);
      case 2:
        return board_.send_byte(static_cast<std::uint8_t>('a' + random_() % 4), t);
      case 3:
        if (random_() % 400 == 0) crash_ = exec::Crash{"it has crashed", {}};
        return;
      default:
        seen += fmt::format(
            "{:.6f} ", board_.read_volts(static_cast<Pin>(board_.spec().analog_pin_0 + random_() % 5), t));
    }
  }

  std::mt19937 random_;
  SimTime next_ = 0;
  bool on_ = false;
};

/// Records one robot's samples and events. All robots append to one text.
struct NotingTurns final : Listener {
  explicit NotingTurns(std::string& text) : all(text) {}
  void sampled(const Sample& s) override {
    all += fmt::format("{} {} {} {} {}\n", s.t, s.pose.position.x, s.pose.heading.y, s.cross_track, s.left);
  }
  void happened(const result::RunEvent& event) override {
    all += fmt::format("{} {} {}\n", event.t_ns, event.agent, result::text_of(event));
  }
  bool minds_turns() const override { return false; }
  std::string& all;
};

// Returns an uno5 whose bumper is replaced by an infra-red switch that looks ahead.
robot::Description seeing_robot() {
  const test::TemporaryFolder folder;
  const std::string file = folder.path() / "seeing.toml";
  std::ofstream(file)
      << "base = \"uno5\"\nremove = [\"bumper\"]\n[[part]]\nname = \"eye\"\ntype = \"ir-switch\"\n"
         "pin = 12\nat = [\"85 mm\", \"0 mm\"]\nrange = \"400 mm\"\n";
  return robot::load_description(file);
}

class Turns : public testing::TestWithParam<unsigned> {};

// Runs six robots on the map city: two robots start in each of three streets, and may leave their streets.
// Returns the text of all samples, events and results.
std::string turning_run_of(unsigned seed, bool takes_turns) {
  std::mt19937 random(seed);
  const map::Map map = map::read_map(map::find_map("city"));
  const robot::Description plain = robot::load_description("uno5");
  const robot::Description seeing = seeing_robot();
  std::vector<std::string> scripts(6);
  if (random() % 2) scripts[1] = fmt::format("at {}ms lift for 300ms\n", random() % 3000);
  if (random() % 2) scripts[4] = fmt::format("at {}ms obstacle 14,11 for 1s\n", random() % 3000);
  if (random() % 4 == 0) scripts[5] = "after serial \"abc\" place 20,15,E\n";
  std::string told;
  std::vector<std::unique_ptr<Roaming>> firmware;
  std::vector<std::unique_ptr<NotingTurns>> listeners;
  Setup setup;
  setup.map = &map;
  setup.seed = seed;
  setup.limit = 3 * kSecond + random() % 140 * kMillisecond;
  setup.samples_every = static_cast<SimTime>(random() % 3) * 23 * kMillisecond;
  setup.takes_turns = takes_turns;
  const bool some_see = random() % 2;
  for (unsigned i = 0; i < 6; ++i) {
    firmware.push_back(std::make_unique<Roaming>(static_cast<unsigned>(random())));
    listeners.push_back(std::make_unique<NotingTurns>(told));
    const std::string start = fmt::format("{},{},E", 8 + random() % 4 + i % 2 * 6, 7 + i / 2 * 4);
    setup.agents.push_back({.robot = some_see && i % 3 == 0 ? &seeing : &plain,
                            .executor = firmware.back().get(),
                            .start = map::parse_start(map, start),
                            .goal = judge::parse_goal("none"),
                            .scenario = scenario::parse_scenario(scripts[i], "s.txt"),
                            .listener = listeners.back().get()});
  }
  Simulation simulation(setup);
  simulation.run_until(1111 * kMillisecond);
  simulation.run_until(setup.limit);
  told += fmt::format("{}\n", simulation.now());
  for (const judge::Outcome& o : simulation.end())
    told += fmt::format("{} {} {} {} {} {}\n", o.why, o.time, o.trace_hash, o.serial, o.metrics.distance_m,
                        o.metrics.collisions);
  for (const auto& one : firmware) told += one->seen + '\n';
  return told;
}

TEST_P(Turns, LeaveNoTrace) {
  for (unsigned seed = 10 * GetParam(); seed < 10 * GetParam() + 10; ++seed)
    ASSERT_EQ(turning_run_of(seed, true), turning_run_of(seed, false)) << "seed " << seed;
}

INSTANTIATE_TEST_SUITE_P(Seeds, Turns, testing::Range(0u, 4u));

/// Firmware that counts how often it ran directly after the firmware of another robot.
class Counting final : public test::FakeFirmware {
 public:
  explicit Counting(const void*& last) : last_(last) {}
  void run_until(SimTime t) override {
    now_ = t;
    changes += last_ != this;
    last_ = this;
  }

  int changes = 0;

 private:
  const void*& last_;
};

int changes_of(const std::string& other_start) {
  const map::Map map = map::read_map(map::find_map("city"));
  const robot::Description robot = robot::load_description("uno5");
  const void* last = nullptr;
  Counting a(last), b(last);
  Setup setup;
  setup.map = &map;
  setup.limit = kSecond;
  setup.leaves_rest_out = false;
  const judge::Goal goal = judge::parse_goal("none");
  setup.agents = {
      {.robot = &robot, .executor = &a, .start = map::parse_start(map, "10,7,E"), .goal = goal},
      {.robot = &robot, .executor = &b, .start = map::parse_start(map, other_start), .goal = goal}};
  simulate(setup);
  return a.changes;
}

TEST(RobotsThatAreApart, GoATenthOfASecondAtAStretch) {
  EXPECT_EQ(changes_of("10,24,E"), 10);
  EXPECT_EQ(changes_of("12,7,E"), 1000) << "the robots are near enough to meet";
}

}  // namespace robosim::run::independent_agents_test
