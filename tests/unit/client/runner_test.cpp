#include "sim/launch/client/runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace robosim::client {
namespace runner_test {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kHello = R"({"hello": "fake", "protocol": 1, "version": "0.1.0", "target": "host"})"
                               "\n";

std::string result(int id, const char* verdict) {
  return R"({"id": )" + std::to_string(id) + R"(, "result": {"verdict": ")" + verdict +
         R"(", "why": "w", "next": "", "status": 0, "time_s": 1, "goal": "tour", "for_s": 600, "seed": 1,
"profile": "ideal", "metrics": {"distance_m": 1, "laps_s": [], "cross_track_rms_mm": 0, "cross_track_max_mm": 0,
"off_line_s": 0, "collisions": 0, "energy_j": 0, "stations": [], "junctions": 0}, "events": [], "serial": "",
"trace_hash": "1:0", "map_sha256": "", "robot_sha256": "", "image_sha256": ""}})";
}

/// Starts the fake runner (fake_runner.cpp), which plays back the text `play`.
class RunnerTest : public ::testing::Test {
 protected:
  std::string program(std::string play) {
    // Joins the lines of each message, because a message is one line, but is wrapped in this source file.
    std::string::size_type at = 0;
    while ((at = play.find(",\n", at)) != std::string::npos) play.replace(at, 2, ", ");
    const fs::path path = folder_ / "fake";
    std::ofstream(path.string() + ".play") << play;
    fs::remove(path);
    fs::create_symlink(FAKE_RUNNER, path);
    return path.string();
  }
  Runner runner(const std::string& play) { return Runner::from_program(program(play)); }

  std::string failure_of_run(const std::string& play) {
    Runner r = runner(play);
    try {
      r.run({});
    } catch (const wire::RunnerError& error) {
      return error.what();
    }
    return "no RunnerError";
  }

  /// Expects that the test has no child process left, dead or alive.
  static void expect_no_children() {
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
  }

  const test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

TEST_F(RunnerTest, OneRunnerServesManyRuns) {
  {
    Runner r = runner(kHello + std::string("!wait\n") + result(1, "reached") + "\n!wait\n" +
                      result(2, "lost") + "\n");
    EXPECT_EQ(r.hello().version, "0.1.0");
    EXPECT_EQ(r.run({}).verdict, "reached");
    EXPECT_EQ(r.run({}).verdict, "lost");
  }
  expect_no_children();
}

TEST_F(RunnerTest, EventsArriveInOrderAndTheRequestIsSent) {
  Runner r = runner(kHello + std::string("!wait\n!echo\n!flood 3\n") + result(1, "reached") + "\n");
  wire::RunRequest request;
  request.image = "x.so";
  std::vector<std::int64_t> times;
  std::string note;
  r.run(request, [&](const wire::Event& event) {
    if (const auto* sample = std::get_if<wire::Sample>(&event)) times.push_back(sample->t_us);
    if (const auto* text = std::get_if<wire::Note>(&event)) note = text->text;
  });
  EXPECT_THAT(times, ::testing::ElementsAre(0, 10000, 20000));
  EXPECT_THAT(note, HasSubstr("'image':'x.so'"));
}

TEST_F(RunnerTest, MoreThanAPipeHoldsGoesThrough) {
  Runner r = runner(kHello + std::string("!wait\n!flood 20000\n") + result(1, "reached") + "\n");
  int samples = 0;
  r.run({}, [&](const wire::Event&) { ++samples; });
  EXPECT_EQ(samples, 20000);
}

TEST_F(RunnerTest, ADyingRunnerIsToldInOneSentenceAndLeavesNoZombie) {
  EXPECT_EQ(
      failure_of_run(kHello + std::string("!wait\n!signal 11\n")),
      "the runner fake was ended by signal 11 (Segmentation fault) before it answered; this is a fault of "
      "Robosim, not of your sketch");
  EXPECT_THAT(failure_of_run(kHello + std::string("!wait\n!exit 7\n")), HasSubstr("ended with status 7"));
  expect_no_children();
}

TEST_F(RunnerTest, ARunnerThatIsGoneBeforeTheRequestRaisesNoSignal) {
  EXPECT_THAT(failure_of_run(kHello + std::string("!exit 0\n")), HasSubstr("ended with status 0"));
}

TEST_F(RunnerTest, GarbageIsQuoted) {
  EXPECT_THAT(failure_of_run(kHello + std::string("!wait\nterminate called\n")),
              HasSubstr("“terminate called”"));
  EXPECT_THAT(failure_of_run(kHello + std::string("!wait\n") + result(9, "lost") + "\n"),
              HasSubstr("answered request 9 instead of 1"));
}

TEST_F(RunnerTest, AProgramThatSaysNoHelloIsRefused) {
  EXPECT_THROW(runner("!exit 3\n"), wire::RunnerError);
  const auto refusal = [&](const std::string& line) {
    try {
      runner(line + "\n");
    } catch (const wire::RunnerError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal("hi"), "fake is not a Robosim runner: expected a hello message, got “hi”");
  EXPECT_EQ(refusal(R"({"hello": "fake", "protocol": 2, "greeting": [1]})"),
            "the runner fake has another Robosim version: expected protocol 1, got 2");
  EXPECT_THROW(Runner::from_program("/nonexistent/robosim-host"), wire::RunnerError);
  expect_no_children();
}

TEST_F(RunnerTest, ErrorAnswersKeepTheirKindAndTheRunnerGoesOn) {
  Runner r = runner(kHello + std::string("!wait\n") +
                    R"({"id": 1, "error": {"kind": "input", "message": "m:1: bad"}})" + "\n!wait\n" +
                    R"({"id": 2, "error": {"kind": "tool", "message": "no gcc"}})" + "\n!wait\n" +
                    R"({"id": 3, "error": {"kind": "internal", "message": "oops"}})" + "\n!wait\n" +
                    result(4, "reached") + "\n");
  EXPECT_THROW(
      {
        try {
          r.describe_robot("u");
        } catch (const InputError& error) {
          EXPECT_STREQ(error.what(), "m:1: bad");
          throw;
        }
      },
      InputError);
  EXPECT_THROW(r.run({}), ToolMissing);
  EXPECT_THROW(r.run({}), wire::RunnerError);
  EXPECT_EQ(r.run({}).verdict, "reached");
}

TEST_F(RunnerTest, AnInterruptReachesTheRunAndTheAnswerStillComes) {
  Runner r = runner(kHello + std::string("!wait\n!flood 1\n!interrupt\n") + result(1, "interrupted") + "\n");
  EXPECT_EQ(r.run({}, [&](const wire::Event&) { r.interrupt(); }).verdict, "interrupted");
}

TEST_F(RunnerTest, ARunThatDoesNotHeedAnInterruptIsKilled) {
  {
    Runner r = runner(kHello + std::string("!wait\n!flood 1\n!interrupt\n!interrupt\n"));
    EXPECT_THROW(r.run({}, [&](const wire::Event&) { r.interrupt(); }), wire::Unstoppable);
  }
  expect_no_children();
}

TEST_F(RunnerTest, AKilledRunnerEndsTheRun) {
  Runner r = runner(kHello + std::string("!wait\n!flood 1\n!interrupt\n"));
  EXPECT_THROW(r.run({}, [&](const wire::Event&) { r.kill(); }), wire::RunnerError);
}

TEST_F(RunnerTest, WhatTheCallbackThrowsPassesThroughAndEndsTheRunner) {
  {
    Runner r = runner(kHello + std::string("!wait\n!flood 1\n!interrupt\n"));
    EXPECT_THROW(r.run({}, [](const wire::Event&) { throw InputError("mine"); }), InputError);
    EXPECT_THROW(r.run({}), wire::RunnerError);
  }
  expect_no_children();
}

TEST_F(RunnerTest, ARunnerThatStopsListeningDoesNotHoldUpItsEnd) {
  { Runner r = runner(kHello + std::string("!interrupt\n")); }  // does not read its input, so it is killed
  expect_no_children();
}

TEST_F(RunnerTest, NoDescriptorOfOursIsLeftOpenOrInherited) {
  const auto open_files = [] {
    return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
  };
  const auto before = open_files();
  { Runner r = runner(kHello); }
  EXPECT_EQ(open_files(), before);
}

}  // namespace runner_test
}  // namespace robosim::client
