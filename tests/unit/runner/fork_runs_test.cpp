// Tests that each branch of a forked run equals a separate run. An executor acts as the firmware, so that no
// sketch needs to be compiled.
#include "sim/runner/fork_runs.h"

#include <gmock/gmock.h>

#include "sim/base/archive.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/wire/protocol.h"
#include "tests/support/built_in_driver.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace robosim::runner::fork_runs_test {

using ::testing::HasSubstr;

/// The built-in driver, which also prints "hello" at 1.5 s. Its counters() returns the number of ticks,
/// instead of the line counters of real firmware.
class Talker final : public test::BuiltInDriver {
 public:
  SimTime sleeps_until() const override { return 0; }
  void run_until(SimTime t) override {
    BuiltInDriver::run_until(t);
    ++ticks_;
    if (t == 1500 * kMillisecond)
      for (const char c : std::string("hello")) board_.send_byte(static_cast<std::uint8_t>(c), t);
  }
  std::vector<ArchivedFile> counters() override { return {{"ticks", std::to_string(ticks_)}}; }
  void count_lines() override {}

 private:
  int ticks_ = 0;
};

class WaysTest : public ::testing::Test {
 protected:
  WaysTest() {
    write_file(folder_.path() / "image", "any");
    request_.image = (folder_.path() / "image").string();
    request_.map = map::find_map("oval").string();
    request_.robot = "uno5";
    request_.goal = "none";
    request_.for_ns = 4 * kSecond;
    request_.script = "at 1s lift for 100ms\n";
  }

  static std::unique_ptr<exec::Executor> make(const std::string&, const BoardSpec&,
                                              const std::filesystem::path&) {
    return std::make_unique<Talker>();
  }
  static void nothing(wire::Event) {}

  result::RunResult go() const {
    RequestedRun run(make, request_, nothing);
    return run_all_branches(run, request_, [] {});
  }
  std::string refusal() const {
    return test::refusal([&] { go(); }, "");
  }
  /// Returns the result of a separate run from power-on, with the complete script of one branch.
  std::string whole(const std::string& way) const {
    wire::RunRequest request = request_;
    request.ways.reset();
    request.script += way;
    RequestedRun run(make, request, nothing);
    return line_of(run.go());
  }
  static std::string line_of(result::RunResult result) {
    result.ways.clear();
    return wire::to_line({}, wire::Answer(std::move(result)));
  }
  void expect_all_as_whole() const {
    const result::RunResult result = go();
    ASSERT_EQ(result.ways.size() + 1, request_.ways->scripts.size());
    for (std::size_t way = 0; way < request_.ways->scripts.size(); ++way)
      EXPECT_EQ(line_of(way == 0 ? result : result.ways[way - 1]), whole(request_.ways->scripts[way])) << way;
    EXPECT_NE(result.trace_hash, result.ways.front().trace_hash) << "the branches make no difference";
  }

  test::TemporaryFolder folder_;
  wire::RunRequest request_;
};

TEST_F(WaysTest, AreAsRunsOfTheirOwn) {
  request_.ways = wire::Ways{2 * kSecond,
                             {},
                             {"at 2s fault left reversed for 300ms\n", "", "at 2010ms lift for 700ms\n",
                              "at 2500ms power off for 50ms\n"}};
  expect_all_as_whole();
}

TEST_F(WaysTest, PartBehindWhatTheSketchSends) {
  request_.ways = wire::Ways{0,
                             "llo",
                             {"after serial \"llo\" wait 210ms fault left reversed for 300ms\n", "",
                              "after serial \"llo\" lift for 300ms\n", "at 2s lift for 200ms\n"}};
  expect_all_as_whole();
}

TEST_F(WaysTest, AreOneIfItEndsBefore) {
  request_.ways = wire::Ways{5 * kSecond, {}, {"at 6s lift for 100ms\n", ""}};
  const result::RunResult result = go();
  ASSERT_EQ(result.ways.size(), 1U);
  EXPECT_EQ(line_of(result), whole(""));
  EXPECT_EQ(line_of(result.ways.front()), whole(""));
}

TEST_F(WaysTest, CountLinesEachForItself) {
  request_.counters = (folder_.path() / "lines").string();
  request_.ways = wire::Ways{2 * kSecond, {}, {"", "", ""}};
  go();
  const std::string all = pack({{"ticks", "4000"}});
  for (const char* const name : {"lines", "lines.2", "lines.3"})
    EXPECT_EQ(read_file(folder_.path() / name), all) << name;
}

TEST_F(WaysTest, OfARunThatCannotPartAreRefused) {
  request_.ways = wire::Ways{2 * kSecond, {}, {}};
  EXPECT_THAT(refusal(), HasSubstr("the branches of a run: expected 1 to 64, got 0"));
  request_.ways->scripts = {"", "at 1s lift\n"};
  EXPECT_THAT(refusal(), HasSubstr("script:1: this line is due before the run is split"));
  request_.ways->scripts = {"after boot 2 lift\n"};
  EXPECT_THAT(refusal(),
              HasSubstr("script:1: expected a line that begins with “at”, or with the way's `after`"));
  request_.ways->scripts = {"", "at 3s press nothing\n"};
  EXPECT_THAT(refusal(), HasSubstr("nothing"));
  request_.ways->scripts = {""};
  request_.pins = true;
  EXPECT_THAT(refusal(), HasSubstr("cannot stream events"));
  request_.pins = false;
  RequestedRun run(make, request_, nothing);
  EXPECT_THROW(run_all_branches(run, request_, {}), InputError);
}

}  // namespace robosim::runner::fork_runs_test
