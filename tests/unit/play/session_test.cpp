#include "sim/view/play/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "sim/base/error.h"

namespace robosim::play {
namespace session_test {

using ::testing::HasSubstr;
using ::testing::Not;
using Kind = terminal::Press::Kind;

constexpr const char* kMap =
    "########\n"
    "#____._#\n"
    "#S...._#\n"
    "#_._.__#\n"
    "#_...__#\n"
    "########\n";

/// A console whose user presses the given keys, followed by the end of input. If `live` is true, it shows
/// every frame.
class FakeConsole final : public terminal::Console {
 public:
  explicit FakeConsole(const std::string& keys, bool live = false) : live_(live) {
    std::string bytes = keys;
    for (terminal::Press press = terminal::take_press(bytes); press.kind != Kind::nothing;
         press = terminal::take_press(bytes))
      keys_.push_back(press);
  }
  terminal::TerminalSize size() override { return size_; }
  terminal::Look look() const override { return {false, false}; }
  bool is_live() const override { return live_; }
  void show(const terminal::Frame& frame) override {
    last = to_text(frame, look());
    last.erase(last.find_last_not_of('\n') + 1);
    last += '\n';
    all += last + "=====\n";
    ++frames;
  }
  terminal::Press wait(int timeout_ms) override {
    now_us_ += 1000LL * std::max(timeout_ms, 0);
    // While a walk is displayed, the keys come from `during_walk`.
    if (timeout_ms >= 0) return during_walk ? during_walk(*this) : terminal::Press{};
    if (keys_.empty()) return at_end;
    const terminal::Press press = keys_.front();
    keys_.pop_front();
    return press;
  }
  std::int64_t now_us() override { return now_us_ += 10; }
  void lend(const std::function<void()>& use) override { use(); }

  std::string last, all;
  int frames = 0;
  terminal::Press at_end{Kind::end};
  std::function<terminal::Press(FakeConsole&)> during_walk;
  terminal::TerminalSize size_{80, 60};

 private:
  bool live_;
  std::deque<terminal::Press> keys_;
  std::int64_t now_us_ = 1;
};

/// A robot that makes five moves on every trip, and knows the map's true graph.
class FakeDriver final : public CellDriver {
 public:
  FakeDriver(const map::Map& map, const map::Start& start, double speed)
      : start_(start), graph_(map::true_graph(map, start)), speed_(speed) {}
  WalkReport walk(Algorithm, const OnStep& on_step) override { return go(on_step, "Round."); }
  WalkReport scan(const OnStep& on_step) override { return go(on_step, ""); }
  const map::TrueGraph& graph() const override { return graph_; }
  map::Start pose() const override { return start_; }
  int here() const override { return here_; }
  RouteReport route(int) override {
    if (!way_) return {false, "An obstacle blocks the way to this station.", {}, "", 0.0};
    return {true, "", std::vector<int>(way_junctions_, 1), std::string(way_junctions_, 'R'), 5.0};
  }
  WalkReport drive(int to, const OnStep& on_step) override {
    const WalkReport report = go(on_step, "");
    here_ = to;
    return report;
  }
  void put_back(int station) override { here_ = station; }

  bool way_ = true;
  std::size_t way_junctions_ = 1;

 private:
  WalkReport go(const OnStep& on_step, const std::string& note) {
    for (int i = 0; i < 5; ++i) on_step({start_, "straight", "step_forward", i * speed_});
    return {true, note, 5, 5 * speed_, start_};
  }
  map::Start start_;
  map::TrueGraph graph_;
  double speed_;
  int here_ = 1;
};

class FakeHost final : public SessionHost {
 public:
  std::vector<MapEntry> maps() override { return {{"one", "first"}, {"two", "second"}}; }
  map::Map open_map(const std::string& name) override {
    opened.push_back(name);
    if (name != "one" && name != "two") throw InputError("there is no map “" + name + "”");
    return map::parse_map(kMap, name);
  }
  std::unique_ptr<CellDriver> cells(const map::Map& map, const map::Start& start, double speed) override {
    starts.push_back(start);
    auto driver = std::make_unique<FakeDriver>(map, start, speed);
    driver->way_ = way;
    driver->way_junctions_ = way_junctions;
    return driver;
  }
  std::string drive_robot(const map::Map&, const map::Start&, Algorithm algorithm, terminal::Console&,
                          const AskPerson& ask) override {
    if (algorithm == Algorithm::ai) return "sent to " + ask({"scan complete", "at 1"}, "Where to:");
    if (algorithm == Algorithm::right) throw InputError("it does not compile");
    return "reached: all stations.";
  }

  std::vector<std::string> opened;
  std::vector<map::Start> starts;
  bool way = true;
  std::size_t way_junctions = 1;
};

class SessionTest : public ::testing::Test {
 protected:
  bool play(FakeConsole& console, Session::Options options = {}) {
    return Session(host_, console, std::move(options)).run();
  }
  std::string shown(const std::string& keys) {
    FakeConsole console(keys);
    EXPECT_TRUE(play(console));
    return console.all;
  }
  FakeHost host_;
};

TEST_F(SessionTest, OpensWithTheListOfMapsAndEndsWithItsInput) {
  const std::string text = shown("");
  EXPECT_THAT(text, HasSubstr("R O B O S I M"));
  EXPECT_THAT(text, HasSubstr("1  one  first"));
}

TEST_F(SessionTest, AMapIsChosenByNumberByNameByArrowOrByEnter) {
  shown("2\n");
  shown("one\n");
  shown("\033[B\n");
  shown("\n");
  EXPECT_THAT(host_.opened, ::testing::ElementsAre("two", "one", "two", "one"));
}

TEST_F(SessionTest, AnUnknownMapIsRefusedAndAskedForAgain) {
  const std::string text = shown("three\n1\n");
  EXPECT_THAT(text, HasSubstr("Not possible: there is no map"));
  EXPECT_THAT(text, HasSubstr("Map one: 8 columns x 6 rows, 11 line cells"));
}

TEST_F(SessionTest, AMapGivenBeforehandThatCannotBeReadEndsTheSession) {
  FakeConsole console("");
  EXPECT_THROW(play(console, {"three", ""}), InputError);
}

TEST_F(SessionTest, TheRobotIsMovedAndTurnedByTheLastKey) {
  const std::string text = shown("1\ndd");
  EXPECT_THAT(text, HasSubstr("it is at 1,2,E"));
  EXPECT_THAT(text, HasSubstr("it is at 3,2,E"));
  EXPECT_THAT(shown("1\nt"), HasSubstr("it is at 1,2,S"));
  EXPECT_THAT(shown("1\nw"), HasSubstr("it is at 1,1,N"));
  EXPECT_THAT(shown("1\n\033[C"), HasSubstr("it is at 2,2,E"));
}

TEST_F(SessionTest, ItCannotBePlacedOffTheLineAndTheSentenceSaysWhatIsThere) {
  EXPECT_THAT(shown("1\nw\n"), HasSubstr("The robot cannot stand at 1,1: plain floor is there."));
  EXPECT_THAT(shown("1\na\n"), HasSubstr("The robot cannot stand at 0,2: a wall is there."));
  EXPECT_TRUE(host_.starts.empty());
}

TEST_F(SessionTest, ItStaysOnTheMapAtTheEdgeButTurns) {
  EXPECT_THAT(shown("1\naaaa"), HasSubstr("it is at 0,2,W"));
}

TEST_F(SessionTest, StartsWhereItWasPutAndWithTheStartGiven) {
  FakeConsole console("\n\n\n\n");
  play(console, {"one", "5,1,S"});
  shown("1\nd\n\n\n\n");
  ASSERT_EQ(host_.starts.size(), 2u);
  EXPECT_EQ(host_.starts[0].cell, (map::CellAt{5, 1}));
  EXPECT_EQ(host_.starts[0].facing, map::Direction::south);
  EXPECT_EQ(host_.starts[1].cell, (map::CellAt{2, 2}));
}

TEST_F(SessionTest, BadAnswersGetASentenceAndTheQuestionAgain) {
  const std::string text = shown("1\n\n7\n1\nfast\n-1\n0.5\n9\n3\n");
  EXPECT_THAT(text, HasSubstr("\"7\" is not a choice"));
  EXPECT_THAT(text, HasSubstr("\"fast\" is not a speed"));
  EXPECT_THAT(text, HasSubstr("\"-1\" is not a speed"));
  EXPECT_THAT(text, HasSubstr("\"9\" is not an algorithm"));
  EXPECT_THAT(text, HasSubstr("Time consumed: 2.5 s, 5 moves."));
}

TEST_F(SessionTest, TheGraphIsShownOnTheMapAndAsATree) {
  const std::string text = shown("1\n\n\n\n\n");
  EXPECT_THAT(text, HasSubstr("2 stations, 2 junctions, 4 links; 1 cycle"));
  EXPECT_THAT(text, HasSubstr("##S1>---J1------J2--+ "));
  EXPECT_THAT(text, HasSubstr("S1 at 1,2\n`- east 1: J1 at 2,2\n"));
  EXPECT_THAT(text, HasSubstr("see above"));
}

TEST_F(SessionTest, AnUnknownDestinationIsRefusedWithTheStations) {
  const std::string text = shown("1\n\n\n\n\n\n8\n1\n");
  EXPECT_THAT(text, HasSubstr("There is no station \"8\" that can be reached; there are S1 and S2."));
  EXPECT_THAT(text, HasSubstr("The robot is at S1 already"));
}

TEST_F(SessionTest, DrivesListJunctionsAndTurnsAndMayGoOn) {
  const std::string text = shown("1\n\n\n\n\n\n2\n\ny\n1\n\nn\nq\n");
  EXPECT_THAT(text, HasSubstr("S1 to S2\nJunctions: J1\nTurns: R"));
  EXPECT_THAT(text, HasSubstr("Arrived at S2. Time consumed: 5 s, 5 moves."));
  EXPECT_THAT(text, HasSubstr("S2 to S1"));
  EXPECT_THAT(text, HasSubstr("And now"));
}

TEST_F(SessionTest, AVeryLongRouteIsCutSoThatTheMapStillShows) {
  host_.way_junctions = 5000;
  const std::string text = shown("1\n\n\n\n\n\n2\n\n");
  EXPECT_THAT(text, HasSubstr("... (5000 in"));
  EXPECT_THAT(text, HasSubstr("Arrived at S2."));
}

TEST_F(SessionTest, NoWayIsToldAndTheSessionGoesOn) {
  host_.way = false;
  EXPECT_THAT(shown("1\n\n\n\n\n\n2\n"),
              HasSubstr("S1 to S2: An obstacle blocks the way to this station.\n"));
}

TEST_F(SessionTest, TheDrivenRobotsResultOrTroubleIsTold) {
  EXPECT_THAT(shown("1\n\n2\n1\n"), HasSubstr("reached: all stations."));
  EXPECT_THAT(shown("1\n\n2\n2\n"), HasSubstr("The robot did not drive: it does not compile"));
}

TEST_F(SessionTest, TheDrivenRobotMayAskThePerson) {
  const std::string text = shown("1\n\n2\n3\n5\n");
  EXPECT_THAT(text, HasSubstr("scan complete\nat 1\n\nWhere to:"));
  EXPECT_THAT(text, HasSubstr("sent to 5"));
}

TEST_F(SessionTest, CtrlCEndsItAsInterrupted) {
  FakeConsole console("1\n");
  console.at_end = {Kind::interrupt};
  EXPECT_FALSE(play(console));
}

TEST_F(SessionTest, AWatchedWalkIsDrawnAtEveryMove) {
  FakeConsole console("1\n\n\n\n1\n", true);
  console.during_walk = [](FakeConsole&) { return terminal::Press{}; };
  EXPECT_TRUE(play(console));
  for (const char* moves : {"0 moves", "1 moves", "2 moves", "3 moves", "4 moves"})
    EXPECT_THAT(console.all, HasSubstr(moves));
  EXPECT_THAT(console.all, HasSubstr("senses straight, then step_forward"));
}

TEST_F(SessionTest, APausedWalkGoesOnByOneMoveAtAStep) {
  FakeConsole console("1\n\n\n\n1\n", true);
  int asked = 0;
  console.during_walk = [&](FakeConsole& c) {
    ++asked;
    if (asked == 1) return terminal::Press{Kind::character, ' '};
    if (asked < 50) {
      EXPECT_THAT(c.last, HasSubstr("paused"));
      EXPECT_THAT(c.last, HasSubstr(" 0 moves"));
      return terminal::Press{};
    }
    if (asked == 50) return terminal::Press{Kind::character, 's'};
    if (asked < 60) {
      EXPECT_THAT(c.last, HasSubstr(" 1 moves"));
      return terminal::Press{};
    }
    return terminal::Press{Kind::character, 'e'};
  };
  EXPECT_TRUE(play(console));
  EXPECT_GE(asked, 60);
  EXPECT_THAT(console.all, HasSubstr("Time consumed: 5 s"));
}

TEST_F(SessionTest, AWalkGetsFasterAndSlowerAndCanBeBrokenOff) {
  FakeConsole console("1\n\n\n\n3\n", true);
  int asked = 0;
  console.during_walk = [&](FakeConsole& c) {
    switch (++asked) {
      case 1:
        return terminal::Press{Kind::character, '+'};
      case 2:
        EXPECT_THAT(c.last, HasSubstr("20 moves a second"));
        return terminal::Press{Kind::character, '-'};
      case 3:
        EXPECT_THAT(c.last, HasSubstr("10 moves a second"));
        return terminal::Press{Kind::character, 'q'};
      default:
        return terminal::Press{};
    }
  };
  EXPECT_TRUE(play(console));
  EXPECT_THAT(console.all, HasSubstr("The scan was broken off"));
}

TEST_F(SessionTest, EveryScreenFitsASmallWindow) {
  FakeConsole console("1\n\n\n\n\ng\n2\n\nn\n", true);
  console.size_ = {40, 14};
  console.during_walk = [](FakeConsole&) { return terminal::Press{Kind::character, 'e'}; };
  EXPECT_TRUE(play(console));
  EXPECT_THAT(console.all, Not(HasSubstr("\n\n\n")));
  for (const char* part :
       {"Map (a number", "goes to the next end", "Speed", "Algorithm", "Destination", "And now"})
    EXPECT_THAT(console.all, HasSubstr(part));
}

}  // namespace session_test
}  // namespace robosim::play
