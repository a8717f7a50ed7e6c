// Tests a runner's session with its client. An executor acts as the firmware, so that no sketch needs to be
// compiled. A fork of this test serves the session, because a session uses standard input and output.
#include "sim/runner/session.h"

#include <gmock/gmock.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "hal/board/board_spec.h"
#include "sim/base/child.h"
#include "sim/base/file.h"
#include "sim/exec/host/asan_build.h"
#include "sim/wire/batch.h"
#include "sim/wire/protocol.h"
#include "tests/support/built_in_driver.h"
#include "tests/support/one_robot.h"
#include "tests/support/temporary_folder.h"

namespace robosim::runner::session_test {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class Session {
 public:
  explicit Session(const ExecutorFactory& factory) : Session([] {}, factory) {}
  /// Starts the runner's process, which calls `first` and then serves. The process uses only the descriptors
  /// 0, 1 and 2.
  Session(const std::function<void()>& first, const ExecutorFactory& factory)
      : runner_([&] {
          ::dup2(input_.read.get(), STDIN_FILENO);
          ::dup2(output_.write.get(), STDOUT_FILENO);
          for (Descriptor* end : {&input_.read, &input_.write, &output_.read, &output_.write}) end->close();
          first();
          return serve(factory);
        }) {
    input_.read.close();
    output_.write.close();
  }
  void send(const std::string& text) const {
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t n = ::write(input_.write.get(), text.data() + done, text.size() - done);
      if (n < 0) throw std::runtime_error("the runner does not listen");
      done += static_cast<std::size_t>(n);
    }
  }

  /// Returns the next line, or "" at the end of the runner's output.
  std::string line() {
    std::size_t end = 0;
    char some[4096];
    while ((end = unread_.find('\n')) == std::string::npos) {
      const ssize_t n = ::read(output_.read.get(), some, sizeof some);
      if (n <= 0) return std::exchange(unread_, "");
      unread_.append(some, static_cast<std::size_t>(n));
    }
    const std::string text = unread_.substr(0, end);
    unread_.erase(0, end + 1);
    return text;
  }

  /// Returns the `count` bytes of the runner's output that follow the last line read.
  std::string bytes(std::size_t count) {
    char some[4096];
    while (unread_.size() < count) {
      const ssize_t n = ::read(output_.read.get(), some, sizeof some);
      if (n <= 0) return std::exchange(unread_, "");
      unread_.append(some, static_cast<std::size_t>(n));
    }
    const std::string text = unread_.substr(0, count);
    unread_.erase(0, count);
    return text;
  }

  /// Sends a line. Returns the runner's answer. Stores the events before the answer in `events`.
  wire::Line ask(const std::string& text) {
    send(text.ends_with('\n') ? text : text + "\n");
    return answer();
  }
  /// Returns the runner's next answer. Stores the events before the answer in `events`.
  wire::Line answer() {
    events.clear();
    for (;;) {
      wire::Line said = wire::parse_line(line());
      const auto* event = std::get_if<wire::Event>(&said.content);
      if (!event) return said;
      events.push_back(*event);
      if (auto* batch = std::get_if<wire::Batch>(&events.back()))
        batch->bytes = bytes(static_cast<std::size_t>(batch->size));
    }
  }
  template <class Answer>
  Answer ask_for(const std::string& text) {
    const wire::Line said = ask(text);
    const auto* answer = std::get_if<Answer>(&said.content);
    if (!answer)
      throw std::runtime_error("another answer to " + text + ": " + wire::to_line({}, said.content));
    return *answer;
  }
  template <class Answer, class Request>
  Answer ask_for(const Request& request) {
    return ask_for<Answer>(wire::to_line(1, request));
  }

  void interrupt() const { runner_.send(SIGINT); }
  /// Waits until the runner's process and the run's process are both blocked. Returns false if one of them
  /// ends first.
  bool comes_to_wait() const {
    const std::string runner = "/proc/" + std::to_string(runner_.pid());
    // Both processes must be blocked at kOften checks in a row, because they may briefly wait for each other.
    constexpr int kOften = 2000;
    for (int times = 0; times < kOften; ++times, ::sched_yield()) {
      pid_t run = 0;
      std::ifstream children(runner + "/task/" + std::to_string(runner_.pid()) + "/children");
      if (!children.is_open()) throw std::runtime_error("/proc does not list the runner's children");
      children >> run;
      const char state = run > 0 ? state_of("/proc/" + std::to_string(run)) : '?';
      if (state == 'Z' || state_of(runner) == 'Z') return false;
      if (state != 'S' || state_of(runner) != 'S') times = -1;
    }
    return true;
  }
  /// Closes the runner's input, and waits until the runner has ended.
  Ending end() {
    input_.write.close();
    return runner_.wait();
  }

  std::vector<wire::Event> events;  ///< the events before the last answer

 private:
  /// Reads the state of a process from /proc: 'R' is running, 'S' is waiting, and 'Z' has ended.
  static char state_of(const std::string& process) {
    std::ifstream file(process + "/stat");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const std::size_t name = text.rfind(") ");
    return name == text.npos ? '?' : text[name + 2];
  }

  Pipe input_, output_;
  Child runner_;
  std::string unread_;
};

/// The built-in driver, which also calls a function at 100 ms.
class Driver final : public test::BuiltInDriver {
 public:
  explicit Driver(void (*at_100_ms)()) : at_100_ms_(at_100_ms) {}
  SimTime sleeps_until() const override { return 0; }
  void run_until(SimTime t) override {
    BuiltInDriver::run_until(t);
    if (t == 100 * kMillisecond && at_100_ms_) at_100_ms_();
  }

 private:
  void (*at_100_ms_)();
};

ExecutorFactory drivers(void (*at_100_ms)() = nullptr) {
  return {"built-in", [at_100_ms](const BoardSpec&, const std::filesystem::path&) {
            return std::make_unique<Driver>(at_100_ms);
          }};
}

/// Returns a factory whose drivers are treated as native code. The run's process is confined, and reports to
/// the runner instead of the client.
ExecutorFactory confined_drivers() {
  ExecutorFactory factory = drivers();
  factory.prepare_for_confinement = [](auto&&...) {};
  return factory;
}

class SessionTest : public ::testing::Test {
 protected:
  SessionTest() {
    write_file(folder_.path() / "image", "any");
    request_.image = (folder_.path() / "image").string();
    request_.map = map::find_map("oval").string();
    request_.robot = "uno5";
    request_.goal = "laps:1";
    request_.for_ns = 20 * kSecond;
  }

  /// Sends a request that the runner cannot execute. Returns the runner's error.
  static wire::ErrorAnswer refusal(const wire::RunRequest& request) {
    Session session(drivers());
    session.line();
    return session.ask_for<wire::ErrorAnswer>(wire::Request(request));
  }

  test::TemporaryFolder folder_;
  wire::RunRequest request_;
};

const std::string kDescribe = R"({"id": 7, "do": "describe_robot", "robot": "uno5"})";

TEST_F(SessionTest, BeginsWithHelloAndEndsWithItsInput) {
  Session session(drivers());
  const wire::Hello hello = wire::parse_hello(session.line(), "robosim-built-in");
  EXPECT_EQ(hello.program, "robosim-built-in");
  EXPECT_EQ(hello.target, "built-in");
  EXPECT_FALSE(hello.version.empty());
  EXPECT_TRUE(session.end().ok());
  EXPECT_EQ(session.line(), "") << "the output ends";
}

TEST_F(SessionTest, RefusesWhatIsNoRequestAndServesTheNext) {
  Session session(drivers());
  session.line();
  for (const std::string& odd :
       {std::string("GET / HTTP/1.1"), std::string("[]"), std::string("{"), std::string("\0\xff\x01", 3),
        std::string(200'000, '['), std::string(200'000, 'x'), std::string(R"({"id": 3, "do": "walk"})"),
        std::string(R"({"id": 3, "do": "run"})"), std::string(R"({"id": 3, "protocol": 2, "do": "run"})"),
        std::string(R"({"id": 3, "do": "continue"})")}) {
    const wire::Line said = session.ask(odd);
    const auto* error = std::get_if<wire::ErrorAnswer>(&said.content);
    ASSERT_TRUE(error) << odd.substr(0, 40);
    EXPECT_EQ(error->kind, "input");
    EXPECT_EQ(said.id, odd.starts_with("{\"id\"") ? 3 : -1) << odd.substr(0, 40);
    EXPECT_LT(error->message.size(), 400u) << "the message does not quote a long line";
  }
  const wire::Line said = session.ask("\n\n" + kDescribe);
  EXPECT_EQ(said.id, 7) << "empty lines are ignored";
  EXPECT_EQ(std::get<wire::RobotInfo>(said.content).name, "uno5");
  EXPECT_TRUE(session.end().ok());
}

TEST_F(SessionTest, AnswersNoLineThatIsCutOffByTheEndOfItsInput) {
  Session session(drivers());
  session.line();
  session.send(kDescribe);
  EXPECT_TRUE(session.end().ok());
  EXPECT_EQ(session.line(), "");
}

TEST_F(SessionTest, AnswersWhatIsWrongWithARequestsFilesAndTexts) {
  const auto message_with = [&](std::string wire::RunRequest::*member, const std::string& value) {
    wire::RunRequest request = request_;
    request.*member = value;
    const wire::ErrorAnswer error = refusal(request);
    EXPECT_EQ(error.kind, "input") << error.message;
    return error.message;
  };
  EXPECT_THAT(message_with(&wire::RunRequest::image, "/none.so"), HasSubstr("/none.so"));
  EXPECT_THAT(message_with(&wire::RunRequest::map, "/none.map"), HasSubstr("/none.map"));
  EXPECT_THAT(message_with(&wire::RunRequest::robot, "uno9"), HasSubstr("there is no robot “uno9”"));
  EXPECT_THAT(message_with(&wire::RunRequest::start, "0,0,E"), HasSubstr("0,0"));
  EXPECT_THAT(message_with(&wire::RunRequest::goal, "win"), HasSubstr("win"));
  EXPECT_THAT(message_with(&wire::RunRequest::script, "at 1s pres start"), StartsWith("script:1:"));
}

TEST_F(SessionTest, HasAChipsQuestionsRefusedWhereTheFirmwareRunsOnNone) {
  wire::RunRequest clock = request_, debugger = request_;
  clock.clock_ns = kSecond;
  debugger.gdb_port = 65535;
  EXPECT_EQ(refusal(clock).kind, "input");
  EXPECT_EQ(refusal(debugger).kind, "input");
}

TEST_F(SessionTest, GivesTheFactoryTheRobotsBoardAndTheImage) {
  request_.robot = "uno5@nano";
  Session session({"x", [](const BoardSpec& board, const std::filesystem::path& image) {
                     throw InputError(board.name + std::string(" ") + image.string());
                     return std::unique_ptr<exec::Executor>();
                   }});
  session.line();
  EXPECT_EQ(session.ask_for<wire::ErrorAnswer>(wire::Request(request_)).message, "nano " + request_.image);
}

TEST_F(SessionTest, TellsInputMissingToolsAndItsOwnErrorsApartAndGoesOn) {
  Session session({"x", [](const BoardSpec& board, const std::filesystem::path&) {
                     if (std::string(board.name) == "nano") throw ToolMissing("install it");
                     throw std::logic_error("a mistake");
                     return std::unique_ptr<exec::Executor>();
                   }});
  session.line();
  const auto own = session.ask_for<wire::ErrorAnswer>(wire::Request(request_));
  EXPECT_EQ(own.kind, "internal");
  EXPECT_EQ(own.message, "a mistake");
  request_.robot = "uno5@nano";
  const auto tool = session.ask_for<wire::ErrorAnswer>(wire::Request(request_));
  EXPECT_EQ(tool.kind, "tool");
  EXPECT_EQ(tool.message, "install it");
  EXPECT_TRUE(session.end().ok());
}

TEST_F(SessionTest, GivesTheResultThatTheSimulationHasWithoutIt) {
  request_.seed = 3;
  request_.profile = "ideal";
  Session session(drivers());
  session.line();
  const auto result = session.ask_for<result::RunResult>(wire::Request(request_));

  test::BuiltInDriver driver;
  test::OneRobot one(driver, "laps:1");
  one.setup.seed = 3;
  one.setup.profile = robot::Profile::ideal;
  const judge::Outcome outcome = one.run(20 * kSecond);

  EXPECT_EQ(result.verdict, "reached");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.trace_hash, outcome.trace_hash);
  EXPECT_EQ(result.goal, "laps:1");
  EXPECT_EQ(result.seed, 3u);
  EXPECT_EQ(result.profile, "ideal");
  EXPECT_DOUBLE_EQ(result.for_s, 20.0);
  EXPECT_EQ(result.image_sha256, sha256("any"));
  EXPECT_EQ(result.map_sha256, sha256_of_file(request_.map));
  EXPECT_EQ(result.robot_sha256, one.robot.sha256);
  const auto again = session.ask_for<result::RunResult>(wire::Request(request_));
  EXPECT_EQ(again.trace_hash, result.trace_hash) << "one runner repeats a run";
}

TEST_F(SessionTest, SaysNothingButItsAnswerToAClientThatWaitsForThatAlone) {
  Session session(drivers());
  session.line();
  const auto told = session.ask_for<result::RunResult>(wire::Request(request_));
  EXPECT_EQ(session.events.size(), 1u);
  request_.started = false;
  const auto untold = session.ask_for<result::RunResult>(wire::Request(request_));
  EXPECT_EQ(session.events.size(), 0u);
  EXPECT_EQ(untold.trace_hash, told.trace_hash);
}

TEST_F(SessionTest, RunsSeveralRobotsAndAnswersWithAResultForEach) {
  request_.name = "A";
  request_.start = "10,14,E";
  request_.samples_every_ns = 100 * kMillisecond;
  request_.notes = true;
  wire::AgentRequest other{
      "B", "", request_.image, "uno5", "20,2,W", "none", 0, "at 50ms press start 10ms", "b.txt"};
  request_.agents = {other};
  Session session({"built-in", drivers().make, nullptr, {{"other", drivers().make}}});
  session.line();
  request_.agents[0].target = "other";
  const auto result = session.ask_for<result::RunResult>(wire::Request(request_));
  EXPECT_EQ(result.verdict, "reached");
  ASSERT_EQ(result.others.size(), 1u);
  EXPECT_EQ(result.others[0].goal, "none");
  EXPECT_EQ(result.others[0].image_sha256, sha256("any"));
  EXPECT_NE(result.others[0].trace_hash, result.trace_hash);
  std::array<int, 2> started{}, samples{}, notes{};
  for (const wire::Event& event : session.events) {
    if (const auto* one = std::get_if<wire::Started>(&event)) ++started[static_cast<std::size_t>(one->agent)];
    if (const auto* one = std::get_if<wire::Sample>(&event)) ++samples[static_cast<std::size_t>(one->agent)];
    if (const auto* one = std::get_if<wire::Note>(&event))
      notes[static_cast<std::size_t>(one->agent)] += one->is<result::ScriptActed>() != nullptr;
  }
  EXPECT_THAT(started, ::testing::ElementsAre(1, 1));
  EXPECT_EQ(samples[1], 201) << "the second robot runs until the time limit";
  EXPECT_GT(samples[0], 50);
  EXPECT_THAT(notes, ::testing::ElementsAre(0, 2)) << "each robot has its own script";
}

TEST_F(SessionTest, RefusesRobotsThatCannotBeTogether) {
  request_.name = "A";
  request_.start = "10,14,E";
  const wire::AgentRequest good{"B", "", request_.image, "uno5", "20,2,W", "none", 0, "", ""};
  const auto message_with = [&](auto spoil) {
    wire::RunRequest request = request_;
    request.agents = {good};
    spoil(request);
    const wire::ErrorAnswer error = refusal(request);
    EXPECT_EQ(error.kind, "input") << error.message;
    return error.message;
  };
  EXPECT_THAT(message_with([](auto& r) { r.agents[0].name = "A"; }), HasSubstr("two robots are named A"));
  EXPECT_THAT(message_with([](auto& r) { r.name = ""; }), HasSubstr("the first robot requires a name"));
  EXPECT_THAT(message_with([](auto& r) { r.gdb_port = 3333; }), HasSubstr("a run of its own"));
  EXPECT_THAT(message_with([](auto& r) { r.agents[0].target = "avr"; }),
              HasSubstr("robot B: unknown target of robosim-built-in: expected built-in, got “avr”"));
  EXPECT_THAT(message_with([](auto& r) { r.agents[0].start = "0,0,E"; }), StartsWith("robot B: "));
  EXPECT_THAT(message_with([](auto& r) { r.agents[0].start = "10,14,W"; }),
              HasSubstr("robot B starts on top of robot A"));
  EXPECT_THAT(message_with([](auto& r) { r.agents[0].goal = "station:77"; }), HasSubstr("robot B: "));
  EXPECT_THAT(message_with([](auto& r) { r.agents[0].robot = "uno9"; }), StartsWith("robot B: "));
  EXPECT_THAT(message_with([](auto& r) { r.agents[0].script = "at 1s pres start"; }), HasSubstr("robot B: "));
  EXPECT_THAT(message_with([&](auto& r) { r.agents.assign(256, good); }),
              HasSubstr("too many robots: expected at most 256, got 257"));
}

TEST_F(SessionTest, StreamsWhatWasAskedForAndNothingElse) {
  request_.goal = "none";
  request_.for_ns = 200 * kMillisecond;
  request_.script = "at 50ms press start 10ms";
  Session session(drivers());
  session.line();
  session.ask_for<result::RunResult>(wire::Request(request_));
  ASSERT_EQ(session.events.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<wire::Started>(session.events[0]));

  request_.samples_every_ns = 50 * kMillisecond;
  request_.notes = request_.pins = true;
  session.ask_for<result::RunResult>(wire::Request(request_));
  std::vector<std::int64_t> samples_us;
  std::size_t notes = 0, pins = 0;
  for (const wire::Event& event : session.events) {
    if (const auto* sample = std::get_if<wire::Sample>(&event)) samples_us.push_back(sample->t_us);
    notes += std::holds_alternative<wire::Note>(event);
    pins += std::holds_alternative<wire::PinChange>(event);
  }
  EXPECT_TRUE(std::holds_alternative<wire::Started>(session.events[0]));
  EXPECT_THAT(samples_us, ::testing::ElementsAre(0, 50'000, 100'000, 150'000, 200'000));
  EXPECT_EQ(notes, 2u) << "the script pressed and released a button";
  EXPECT_GT(pins, 6u) << "pins of both motors";
  EXPECT_EQ(1 + samples_us.size() + notes + pins, session.events.size());
}

TEST_F(SessionTest, TellsTheSameInTheSameOrderWhereItIsAskedForBatches) {
  request_.goal = "none";
  request_.for_ns = 3 * kSecond;
  request_.script = "at 50ms press start 10ms";
  request_.samples_every_ns = 10 * kMillisecond;
  request_.notes = request_.pins = request_.io = true;
  Session session(drivers());
  session.line();
  std::vector<std::string> one_by_one, in_batches;
  const auto keep_in = [](std::vector<std::string>& lines) {
    return [&lines](const wire::Event& event) {
      lines.push_back(wire::to_line(wire::Id(), wire::Answer(event)));
    };
  };
  session.ask_for<result::RunResult>(wire::Request(request_));
  for (const wire::Event& event : session.events) keep_in(one_by_one)(event);
  EXPECT_GT(one_by_one.size(), 100u);
  request_.batches = true;
  session.ask_for<result::RunResult>(wire::Request(request_));
  std::size_t lines = 0;
  wire::BatchReader reader(request_);
  for (const wire::Event& event : session.events) {
    ++lines;
    const auto* batch = std::get_if<wire::Batch>(&event);
    batch ? reader.read(batch->bytes, keep_in(in_batches)) : keep_in(in_batches)(event);
  }
  EXPECT_EQ(in_batches, one_by_one);
  EXPECT_GE(lines, 4u) << "no event is much more than 1 s late";
  EXPECT_LE(lines, 8u);
}

TEST_F(SessionTest, ARunMayTellMoreThanWaitsForItsReader) {
  request_.goal = "none";
  request_.for_ns = 30 * kSecond;
  request_.samples_every_ns = 10 * kMillisecond;
  request_.notes = request_.pins = request_.io = request_.batches = true;
  Session session(confined_drivers());
  session.line();
  session.send(wire::to_line(1, wire::Request(request_)));
  EXPECT_TRUE(session.comes_to_wait()) << "the test does not read, so the pipe is full";
  session.answer();
  wire::BatchReader reader(request_);
  std::vector<std::int64_t> samples_us;
  for (const wire::Event& event : session.events)
    if (const auto* batch = std::get_if<wire::Batch>(&event))
      reader.read(batch->bytes, [&](const wire::Event& told) {
        if (const auto* sample = std::get_if<wire::Sample>(&told)) samples_us.push_back(sample->t_us);
      });
  ASSERT_EQ(samples_us.size(), 3001u);
  for (std::size_t i = 0; i < samples_us.size(); ++i)
    ASSERT_EQ(samples_us[i], static_cast<std::int64_t>(i) * 10'000);
}

TEST_F(SessionTest, BlamesTheMachineForTooFewDescriptorsAndNoSketch) {
#ifdef ROBOSIM_ASAN
  GTEST_SKIP() << "the sanitizers' runtime opens files itself, and takes a refusal for a fault";
#endif
  request_.goal = "none";
  request_.for_ns = kSecond;
  int refused = 0, ran = 0;
  for (rlim_t descriptors = 4; descriptors < 32; ++descriptors) {
    Session session(
        [descriptors] {
          rlimit limit{};
          ::getrlimit(RLIMIT_NOFILE, &limit);
          limit.rlim_cur = descriptors;
          ::setrlimit(RLIMIT_NOFILE, &limit);
          for (int fd = 3; fd < 64; ++fd) ::close(fd);  // closes descriptors of this test
        },
        confined_drivers());
    session.line();
    const wire::Line said = session.ask(wire::to_line(1, wire::Request(request_)));
    if (const auto* error = std::get_if<wire::ErrorAnswer>(&said.content)) {
      EXPECT_EQ(error->kind, "tool") << descriptors;
      EXPECT_THAT(error->message, StartsWith("too many files are open")) << descriptors;
      ++refused;
    } else {
      EXPECT_EQ(std::get<result::RunResult>(said.content).verdict, "reached") << descriptors;
      ++ran;
    }
  }
  EXPECT_GT(refused, 4);
  EXPECT_GT(ran, 10);
}

TEST_F(SessionTest, SurvivesFirmwareThatTakesItsProcessDown) {
  for (const auto& [deed, reason] :
       {std::pair<void (*)(), const char*>{[] { ::raise(SIGKILL); },
                                           "it ended its process with signal 9 (Killed)"},
        std::pair<void (*)(), const char*>{[] { ::_exit(3); }, "it ended its process with exit status 3"}}) {
    Session session(drivers(deed));
    session.line();
    const auto result = session.ask_for<result::RunResult>(wire::Request(request_));
    EXPECT_EQ(result.verdict, "crashed");
    EXPECT_EQ(result.status, 1);
    ASSERT_TRUE(result.crash);
    EXPECT_EQ(result.crash->reason, reason);
    EXPECT_EQ(result.goal, "laps:1");
    EXPECT_EQ(result.image_sha256, sha256("any"));
    EXPECT_TRUE(std::holds_alternative<wire::RobotInfo>(session.ask(kDescribe).content));
    EXPECT_TRUE(session.end().ok());
  }
}

TEST_F(SessionTest, AnInterruptEndsTheRunWithItsResultAndNotTheRunner) {
  Session session(drivers([] { ::raise(SIGINT); }));
  session.line();
  session.interrupt();
  const auto result = session.ask_for<result::RunResult>(wire::Request(request_));
  EXPECT_EQ(result.verdict, "interrupted");
  EXPECT_EQ(result.status, 130);
  EXPECT_NEAR(result.time_s, 0.1, 0.002);
  EXPECT_TRUE(std::holds_alternative<wire::RobotInfo>(session.ask(kDescribe).content));
}

class DrivenSessionTest : public SessionTest {
 protected:
  DrivenSessionTest() : session_(drivers()) {
    request_.interactive = true;
    session_.line();
  }
  wire::Paused begin() { return session_.ask_for<wire::Paused>(wire::Request(request_)); }
  template <class Answer>
  Answer ask(const wire::DrivenRequest& request) {
    return session_.ask_for<Answer>(request);
  }

  Session session_;
};

TEST_F(DrivenSessionTest, StandsStillAtTheBeginningAndWhereItWasToldTo) {
  const wire::Paused at_start = begin();
  EXPECT_EQ(at_start.t_ns, 0);
  EXPECT_FALSE(at_start.driven);
  const auto later = ask<wire::Paused>(wire::GoOn{300 * kMillisecond, {}});
  EXPECT_EQ(later.t_ns, 300 * kMillisecond);
  EXPECT_EQ(later.stop, -1);
  EXPECT_TRUE(later.driven);
  const auto stopped = ask<wire::Paused>(
      wire::GoOn{std::nullopt, {result::Stop::rest(kSecond), result::Stop::reading("S3", true)}});
  EXPECT_EQ(stopped.stop, 1) << "the middle sensor is over the line while the robot drives";
  EXPECT_EQ(ask<result::RunResult>(wire::End{}).verdict, "interrupted");
}

TEST_F(DrivenSessionTest, GoesToItsVerdictWithTheTraceOfARunThatWasNotDriven) {
  begin();
  ask<wire::Paused>(wire::GoOn{kSecond, {}});
  const auto driven = ask<result::RunResult>(wire::GoOn{});
  EXPECT_EQ(driven.verdict, "reached");
  request_.interactive = false;
  EXPECT_EQ(session_.ask_for<result::RunResult>(wire::Request(request_)).trace_hash, driven.trace_hash);
}

TEST_F(DrivenSessionTest, ActsAtOnceAndSaysAsAScriptWhatItDoes) {
  begin();
  ask<wire::Paused>(wire::GoOn{200 * kMillisecond, {}});
  EXPECT_EQ(ask<wire::Accepted>(wire::Act{"press start 100ms\n\n  lift\n"}).lines,
            "at 200ms press start 100ms\nat 200ms   lift\n");
}

TEST_F(DrivenSessionTest, RefusesWhatMakesNoSenseAndStandsWhereItStood) {
  begin();
  EXPECT_THAT(ask<wire::Refused>(wire::Act{"pres start"}).message, StartsWith("script:1:"));
  EXPECT_THAT(ask<wire::Refused>(wire::Act{"press horn"}).message, HasSubstr("horn"));
  EXPECT_THAT(ask<wire::Refused>(wire::GoOn{0, {result::Stop::reading("S9", true)}}).message,
              HasSubstr("S9"));
  EXPECT_THAT(ask<wire::Refused>(wire::GoOn{0, {result::Stop::line("(")}}).message, HasSubstr("("));
  EXPECT_THAT(session_.ask_for<wire::Refused>(kDescribe).message, HasSubstr("a paused run"));
  EXPECT_THAT(session_.ask_for<wire::Refused>(std::string("{")).message,
              HasSubstr("one JSON object per line"));
  EXPECT_EQ(ask<wire::Paused>(wire::GoOn{kMillisecond, {}}).t_ns, kMillisecond);
}

TEST_F(DrivenSessionTest, HandsOutTheWholeEeprom) {
  begin();
  const auto eeprom = ask<wire::Eeprom>(wire::ReadEeprom{});
  EXPECT_EQ(eeprom.bytes, std::vector<std::uint8_t>(1024, 0xff))
      << "an Uno's EEPROM as it comes from the factory";
}

TEST_F(DrivenSessionTest, EndsWithItsClientAndAnswersNothing) {
  begin();
  EXPECT_TRUE(session_.end().ok());
  EXPECT_EQ(session_.line(), "");
}

}  // namespace robosim::runner::session_test
