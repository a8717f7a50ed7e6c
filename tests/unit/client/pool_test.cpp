#include "sim/launch/client/pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cerrno>
#include <stdexcept>

#include "sim/base/error.h"

namespace robosim::client {
namespace pool_test {

using ::testing::ElementsAre;

/// Returns a task for the fake worker (fake_worker.cpp). `image` is a command for the worker, or the verdict
/// that the worker returns.
Task task_of(const std::string& image) {
  Task task{"host", {}};
  task.request.image = image;
  task.request.map = "oval";
  task.request.robot = "uno5";
  return task;
}

class PoolTest : public ::testing::TestWithParam<std::size_t> {
 protected:
  static Runner start(const std::string&) { return Runner::from_program(FAKE_WORKER); }

  Batch batch(std::vector<std::string> images) {
    Batch batch;
    batch.count = images.size();
    batch.task = [images](std::size_t i) {
      Task task = task_of(images[i]);
      task.request.seed = i;
      return task;
    };
    batch.answered = [this](std::size_t i, Answer answer) {
      std::string said;
      if (const auto* result = std::get_if<result::RunResult>(&answer)) {
        EXPECT_EQ(result->seed, i);
        said = result->verdict;
      } else {
        const Failure::Kind kind = std::get<Failure>(answer).kind;
        said = kind == Failure::Kind::input ? "input" : kind == Failure::Kind::tool ? "tool" : "internal";
      }
      answers_.push_back(std::to_string(i) + ":" + said);
    };
    return batch;
  }

  static void expect_no_children() {
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
  }

  std::vector<std::string> answers_;  ///< "run:verdict" or "run:kind of failure"
};

INSTANTIATE_TEST_SUITE_P(Workers, PoolTest, ::testing::Values(1, 2, 5),
                         [](const auto& workers) { return std::to_string(workers.param); });

TEST_P(PoolTest, HandsResultsOverInTheOrderOfTheRequestsHoweverLongEachTakes) {
  {
    Pool pool(GetParam(), start);
    EXPECT_TRUE(pool.run(batch({"slow", "lost", "slow", "reached", "lost", "reached", "stuck"})));
  }
  EXPECT_THAT(answers_,
              ElementsAre("0:slow", "1:lost", "2:slow", "3:reached", "4:lost", "5:reached", "6:stuck"));
  expect_no_children();
}

TEST_P(PoolTest, ARunThatFailsIsAnAnswerAndHarmsNoOther) {
  Pool pool(GetParam(), start);
  EXPECT_TRUE(pool.run(batch({"lost", "die", "reached", "input", "die", "stuck"})));
  EXPECT_THAT(answers_, ElementsAre("0:lost", "1:internal", "2:reached", "3:input", "4:internal", "5:stuck"));
}

TEST_P(PoolTest, AWorkerThatCannotBeStartedIsAnAnswerToo) {
  Pool pool(GetParam(), [](const std::string&) -> Runner { throw ToolMissing("no avr"); });
  EXPECT_TRUE(pool.run(batch({"lost", "lost"})));
  EXPECT_THAT(answers_, ElementsAre("0:tool", "1:tool"));
}

TEST_P(PoolTest, RunsBeyondThePointWhereEnoughIsKnownAreDropped) {
  Pool pool(GetParam(), start);
  Batch work = batch({"slow", "lost", "never", "never", "reached", "stuck"});
  bool enough = false;
  const auto note = work.answered;
  work.answered = [&](std::size_t i, Answer answer) {
    enough = enough || i == 1;
    note(i, std::move(answer));
  };
  work.wanted = [&](std::size_t i) { return i == 5 || !enough; };
  EXPECT_TRUE(pool.run(work));
  EXPECT_THAT(answers_, ElementsAre("0:slow", "1:lost", "5:stuck"));
}

TEST_P(PoolTest, AnInterruptKeepsWhatIsFinishedAndLeavesNoProcessBehind) {
  {
    Pool pool(GetParam(), start);
    Batch work = batch({"reached", "lost", "never", "never", "never", "never", "never"});
    const auto note = work.answered;
    work.answered = [&](std::size_t i, Answer answer) {
      note(i, std::move(answer));
      if (i == 1) pool.interrupt();
    };
    EXPECT_FALSE(pool.run(work));
  }
  EXPECT_THAT(answers_, ElementsAre("0:reached", "1:lost"));
  expect_no_children();
}

TEST_P(PoolTest, WhatTheCallerThrowsEndsTheBatch) {
  {
    Pool pool(GetParam(), start);
    Batch work = batch({"reached", "never", "never"});
    work.answered = [](std::size_t, Answer) { throw std::runtime_error("disk full"); };
    EXPECT_THROW(pool.run(work), std::runtime_error);
  }
  expect_no_children();
}

TEST(Pool, RunsThatFinishedBehindAMissingOneAreKeptWhenItIsInterrupted) {
  Pool pool(2, [](const std::string&) { return Runner::from_program(FAKE_WORKER); });
  std::vector<std::size_t> handed;
  Batch work;
  work.count = 3;
  work.task = [&](std::size_t i) {
    Task task = task_of(i == 0 ? "never" : "reached");
    if (i == 2) pool.interrupt();  // the pool calls task(2) after the answer of run 1
    return task;
  };
  work.answered = [&](std::size_t i, Answer) { handed.push_back(i); };
  EXPECT_FALSE(pool.run(work));
  EXPECT_THAT(handed, ::testing::Contains(1u));
  EXPECT_THAT(handed, ::testing::Not(::testing::Contains(0u)));
}

TEST(Pool, AnEmptyBatchIsDoneAtOnce) {
  Pool pool(2);
  EXPECT_TRUE(pool.run({}));
}

}  // namespace pool_test
}  // namespace robosim::client
