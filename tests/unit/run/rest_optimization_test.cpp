// Tests that skipping ticks of resting robots and sleeping firmware does not change a run. Firmware, scripts,
// goals and neighbouring robots are random.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "sim/exec/core/board_state.h"
#include "tests/support/fake_firmware.h"
#include "tests/support/one_robot.h"

namespace robosim::run::rest_optimization_test {

/// An executor that acts as the firmware, so that no sketch needs to be compiled.
class OnBoard : public test::FakeFirmware {
 public:
  using FakeFirmware::FakeFirmware;

  void power_on(SimTime t) override {
    board_.reset(t);
    next_ = t;
    on_ = true;
  }
  void power_off(SimTime t) override {
    board_.reset(t);
    on_ = false;
  }
  SimTime last_call() const override { return on_ ? std::min(next_, now_) : now_; }

 protected:
  void drive_pins(std::initializer_list<Pin> pins, double duty, SimTime t) {
    for (const Pin pin : pins) board_.set_drive(pin, {PinMode::output, duty > 0.0, true, duty, 0}, t);
  }

  SimTime next_ = 0;
  bool on_ = false;
};

/// Firmware that usually waits, and occasionally drives, prints, reads a sensor or crashes.
class Dozing final : public OnBoard {
 public:
  Dozing(unsigned seed, const BoardSpec& board, bool tells_sleep)
      : OnBoard(board), random_(seed), tells_sleep_(tells_sleep) {}

  void run_until(SimTime t) override {
    now_ = t;
    for (; on_ && !crash_ && next_ < t; next_ += one_of({3 * kMicrosecond, kMillisecond, 7300 * kMicrosecond,
                                                         40 * kMillisecond, 900 * kMillisecond, 2 * kSecond}))
      act(next_);
  }

  SimTime sleeps_until() const override { return tells_sleep_ && on_ && !crash_ ? next_ : 0; }

  std::string seen;

 private:
  template <class T>
  T one_of(std::initializer_list<T> things) {
    return things.begin()[random_() % things.size()];
  }
  void act(SimTime t) {
    const Pin pin = static_cast<Pin>(random_() % board_.spec().pin_count);
    switch (random_() % 8) {
      case 0:
      case 1:
        return drive_pins({5, 6, 7, 9}, one_of({0.3, 0.6, 1.0}), t);
      case 2:
      case 3:
        return drive_pins({5, 6, 7, 8, 9, 10}, 0.0, t);
      case 4:
        return board_.set_drive(pin, {one_of({PinMode::input, PinMode::output}), true, false, 1.0, 0}, t);
      case 5:
        return board_.send_byte(static_cast<std::uint8_t>(random_()), t);
      case 6:
        if (random_() % 40 == 0) crash_ = exec::Crash{"it has crashed", {}};
        return;
      default:
        seen += fmt::format("{} {} ", board_.read_volts(pin, t), board_.read_level(pin, t));
    }
  }

  std::mt19937 random_;
  const bool tells_sleep_;
};

/// Firmware that starts to drive at time `begin`.
class Late final : public OnBoard {
 public:
  explicit Late(SimTime begin) : begin_(begin) {}
  void run_until(SimTime t) override {
    if (now_ < begin_ && begin_ <= t) drive_pins({5, 6, 7, 9}, 1.0, begin_);
    next_ = now_ = t;
  }

 private:
  const SimTime begin_;
};

struct Noting final : Listener {
  void sampled(const Sample& s) override {
    text += fmt::format("{} {} {} {} {} {}\n", s.t, s.pose.position.x, s.pose.heading.y, s.cross_track,
                        s.left, fmt::join(s.readings, " "));
  }
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override {
    text += fmt::format("{} {} {}\n", t, pin, drive.duty);
  }
  void happened(const result::RunEvent& event) override {
    text += fmt::format("{} {}\n", event.t_ns, result::text_of(event));
  }
  std::string text;
};

std::string text_of(const judge::Outcome& o) {
  const judge::Metrics& m = o.metrics;
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {}", o.why, o.time, o.trace_hash, o.serial, m.distance_m,
                     m.cross_track_rms_mm, m.cross_track_max_mm, m.off_line_s, m.collisions, m.energy_j,
                     fmt::join(m.laps_s, " "));
}

class Resting : public testing::TestWithParam<unsigned> {};

std::string run_of(unsigned seed, bool leaves_rest_out) {
  std::mt19937 random(seed);
  const auto one_of = [&random](std::initializer_list<const char*> words) {
    return words.begin()[random() % words.size()];
  };
  const bool two = random() % 2;
  const map::Map map = map::read_map(map::find_map(two ? "oval" : one_of({"oval", "d", "warehouse"})));
  const robot::Description robot =
      robot::load_description(one_of({"uno5", "uno3", "pony", "nano8rc", "rover5"}));
  std::string script;
  for (unsigned lines = random() % 5; lines > 0; --lines)
    script += fmt::format(
        "at {}ms {}\n", random() % 9000,
        two ? one_of({"place 10,2,E", "erase 4,2 22,2 for 1s", "obstacle 14,2 for 300ms", "lift for 50ms"})
            : one_of({"lift for 400ms", "sweep 20mm for 1s", "power off for 700ms", "tilt 20deg left for 2s",
                      "fault power sag 5V for 1s", "fault serial lost 0.5"}));
  if (random() % 4 == 0) script += "after boot 2 lift for 100ms\n";
  std::vector<std::unique_ptr<Dozing>> firmware;
  std::vector<Noting> listeners(two ? 2 : 1);
  Setup setup;
  setup.map = &map;
  setup.seed = seed;
  setup.limit = 10 * kSecond + random() % 40 * kMillisecond;
  setup.samples_every = static_cast<SimTime>(random() % 3) * 13 * kMillisecond;
  setup.leaves_rest_out = leaves_rest_out;
  const judge::Goal goal = judge::parse_goal(one_of({"none", "none", "tour", "still"}));
  for (Noting& listener : listeners) {
    firmware.push_back(
        std::make_unique<Dozing>(static_cast<unsigned>(random()), *robot.board, leaves_rest_out));
    setup.agents.push_back(
        {.robot = &robot, .executor = firmware.back().get(), .goal = goal, .listener = &listener});
  }
  setup.agents.front().scenario = scenario::parse_scenario(script, "s.txt");
  if (two) setup.agents.back().start = map::parse_start(map, "20,2,E");
  std::string all;
  Simulation simulation(setup);
  simulation.run_until(5 * kSecond);
  simulation.run_until(setup.limit);
  for (const judge::Outcome& outcome : simulation.end()) all += text_of(outcome) + '\n';
  for (const auto& one : firmware) all += one->seen + '\n';
  for (const Noting& listener : listeners) all += listener.text + '\n';
  return all;
}

TEST_P(Resting, IsLeftOutWithoutATrace) {
  for (unsigned seed = 10 * GetParam(); seed < 10 * GetParam() + 10; ++seed)
    ASSERT_EQ(run_of(seed, true), run_of(seed, false)) << "seed " << seed;
}

TEST(RestingRobot, IsStuckThreeSecondsAfterItsLastMomentWithoutAWish) {
  Late firmware(1006 * kMillisecond + kMicrosecond);
  test::OneRobot one(firmware, "none", "at 0s fault left stuck\nat 0s fault right stuck\n");
  const judge::Outcome outcome = one.run(kDefaultLimit);
  EXPECT_EQ(outcome.verdict, judge::Verdict::stuck) << outcome.why;
  EXPECT_EQ(outcome.time, 4006 * kMillisecond);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Resting, testing::Range(0u, 6u));

}  // namespace robosim::run::rest_optimization_test
