// Tests both ends of the runner protocol within one process. Each end reads everything that the other end can
// write.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <random>

#include "sim/wire/json_parse.h"
#include "sim/wire/json_text.h"
#include "sim/wire/json_writer.h"
#include "sim/wire/protocol.h"

namespace robosim::wire {
namespace both_ends_test {

/// Fills a message with unusual values that its description allows.
class Filler {
 public:
  static constexpr bool kReads = true;
  static constexpr bool kDescribes = false;

  explicit Filler(std::mt19937_64& random, int depth = 0) : random_(random), depth_(depth) {}

  template <class T>
  void operator()(const char*, T&& value, const char*, const Rules& rules = {}) {
    fill(value, rules);
  }

  template <class Kind, class T>
  void choice(Kind& kind, Kind own, const char*, T& value, const char*, const Rules& rules = {}) {
    if (below(++choices_) != 0) return;
    kind = own;
    fill(value, rules);
  }

  template <class... What>
  void kinds(const char*, std::optional<std::variant<What...>>& what, const char*) {
    std::size_t chosen = below(sizeof...(What) + 1);
    const auto fill_one = [&]<class T>(const T*) {
      if (chosen-- == 0) fields(*this, std::get<T>(what.emplace(T{})));
    };
    (fill_one(static_cast<const What*>(nullptr)), ...);
  }

 private:
  std::uint64_t below(std::uint64_t n) { return random_() % n; }

  template <class T>
  void fill(T& value, const Rules& rules) {
    if constexpr (Described<Filler, T>) {
      Filler inner(random_, depth_ + 1);
      fields(inner, value);
    } else if constexpr (std::is_same_v<T, bool>) {
      value = below(2) == 1;
    } else if constexpr (std::is_same_v<T, char>) {
      value = "NESW"[below(4)];
    } else if constexpr (std::is_integral_v<T>) {
      fill_whole(value, rules);
    } else if constexpr (std::is_floating_point_v<T>) {
      static constexpr double kOdd[] = {0.0, -0.0, 1.0, 0.1, -1e308, 5e-324, 1e16, 123456789012345680.0};
      value = kOdd[below(std::size(kOdd))];
    } else if constexpr (std::is_same_v<T, std::string>) {
      fill_text(value, rules);
    } else {
      fill_many(value, rules);
    }
  }

  template <class T>
  void fill_whole(T& value, const Rules& rules) {
    using Limits = std::numeric_limits<T>;
    const auto least = std::max(static_cast<std::int64_t>(Limits::min()), rules.least);
    const auto most = std::min(static_cast<std::uint64_t>(Limits::max()),
                               rules.most == std::numeric_limits<std::int64_t>::max()
                                   ? static_cast<std::uint64_t>(Limits::max())
                                   : static_cast<std::uint64_t>(rules.most));
    const std::array<T, 3> odd{static_cast<T>(least), static_cast<T>(most),
                               std::max(static_cast<T>(least), static_cast<T>(below(100)))};
    value = odd[below(odd.size())];
    value = static_cast<T>(value - value % static_cast<T>(rules.multiple_of));
  }

  void fill_text(std::string& value, const Rules& rules) {
    static const std::string kOdd[] = {"8",
                                       "007",
                                       "",
                                       "plain",
                                       "\"quoted\" \\ and\ttabbed\r\n",
                                       std::string("a NUL \0 inside", 14),
                                       "Größe 日本語 🤖",
                                       "\xff\xfe no UTF-8 \xc3",
                                       "12345678901234567890",
                                       std::string(500, 'x')};
    if (rules.one_of.size() > 0) {
      value = rules.one_of.begin()[below(rules.one_of.size())];
      return;
    }
    do value = kOdd[below(std::size(kOdd))];
    while (rules.not_empty && value.empty());
  }

  template <class T>
  void fill_many(std::vector<T>& value, const Rules& rules) {
    value.resize(depth_ < 3 ? below(4) : 0);  // limits the depth, because a result may contain results
    for (T& element : value) fill(element, rules);
  }
  template <class T>
  void fill_many(std::optional<T>& value, const Rules& rules) {
    if (below(2)) fill(*(value = T{}), rules);
  }
  template <class... T>
  void fill_many(std::tuple<T&...>& value, const Rules& rules) {
    std::apply([&](auto&... element) { (fill(element, rules), ...); }, value);
  }
  template <class A, class B>
  void fill_many(std::pair<A, B>& value, const Rules& rules) {
    fill(value.first, rules);
    fill(value.second, rules);
  }
  template <class T, std::size_t N>
  void fill_many(std::array<T, N>& value, const Rules& rules) {
    for (T& element : value) fill(element, rules);
  }
  template <std::size_t N>
  void fill_many(NameList<bool, N>& value, const Rules&) {
    for (auto& name : value.names) *name.holds = below(2) == 1;
  }
  template <class List>
  void fill_many(PinsByUse<List>& value, const Rules& rules) {
    value.list = {{"in1", "8"}, {"in2", "A0"}, {"q", "REG1.Q4"}};
    fill(value.list[2].second, rules);
  }

  std::mt19937_64& random_;
  int depth_;
  std::uint64_t choices_ = 0;
};

class BothEnds : public ::testing::Test {
 protected:
  static constexpr int kTimes = 50;

  template <class T>
  T odd() {
    T message{};
    Filler filler(random_);
    fields(filler, message);
    return message;
  }

  /// Expects that the client can read an answer, and that writing the result gives the same line again.
  template <class T>
  void expect_same_answer(const T& message, std::int64_t id = 7) {
    const std::string line = to_line(Id(id), Answer(message));
    EXPECT_EQ(parsed_json(line), nlohmann::json::parse(line)) << line;
    const Line read = parse_line(line);
    EXPECT_EQ(read.content.index(), Answer(message).index()) << line;
    EXPECT_EQ(to_line(read.id < 0 ? Id() : Id(std::int64_t{read.id}), read.content), line);
  }

  /// Expects that JsonText and nlohmann write a message as the same text.
  template <class T>
  void expect_same_text(const T& message) {
    std::string text;
    JsonText::append(text, message);
    EXPECT_EQ(text, text_of(to_json(message)));
  }

  template <class T>
  void expect_same_answers() {
    for (int i = 0; i < kTimes; ++i) {
      const T message = odd<T>();
      expect_same_answer(message);
      expect_same_text(message);
    }
  }
  template <class T>
  void expect_same_events() {
    for (int i = 0; i < kTimes; ++i) {
      const T message = odd<T>();
      expect_same_answer(Event(message));
      expect_same_text(message);
    }
  }

  template <class Any, class T>
  void expect_same_requests(Asked<Any> (*parse)(std::string_view)) {
    for (int i = 0; i < kTimes; ++i) {
      const std::string line = to_line(i, Any(odd<T>()));
      const Asked<Any> asked = parse(line);
      ASSERT_TRUE(asked.request) << asked.fault << "\n" << line;
      EXPECT_EQ(to_line(i, *asked.request), line);
      EXPECT_EQ(std::get<std::uint64_t>(asked.id), static_cast<std::uint64_t>(i));
    }
  }

  std::mt19937_64 random_{1};
};

TEST_F(BothEnds, AgreeOnEveryAnswer) {
  expect_same_answers<RobotInfo>();
  expect_same_answers<RunResult>();
  expect_same_answers<Paused>();
  expect_same_answers<Accepted>();
  expect_same_answers<ErrorAnswer>();
  expect_same_answer(Eeprom{});
  expect_same_answer(Eeprom{{0, 1, 0x7f, 0x80, 0xff}});
  expect_same_answer(Refused{"no \"such\" thing"});
}

TEST_F(BothEnds, AgreeOnHello) {
  const Hello hello = parse_hello(to_line({}, Hello{"robosim-x", kProtocol, "1.2", "x"}), "x");
  EXPECT_EQ(hello.program, "robosim-x");
  EXPECT_EQ(hello.version, "1.2");
  EXPECT_EQ(hello.target, "x");
}

template <class... Kinds>
void for_each(const std::variant<Kinds...>*, auto visit) {
  (visit(static_cast<const Kinds*>(nullptr)), ...);
}

TEST_F(BothEnds, AgreeOnEveryEvent) {
  for_each(static_cast<const Event*>(nullptr), [&]<class T>(const T*) { expect_same_events<T>(); });
}

TEST_F(BothEnds, AgreeOnEveryRequest) {
  for_each(static_cast<const Request*>(nullptr),
           [&]<class T>(const T*) { expect_same_requests<Request, T>(parse_request); });
  for_each(static_cast<const DrivenRequest*>(nullptr),
           [&]<class T>(const T*) { expect_same_requests<DrivenRequest, T>(parse_driven_request); });
  for_each(static_cast<const LiveRequest*>(nullptr),
           [&]<class T>(const T*) { expect_same_requests<LiveRequest, T>(parse_live_request); });
}

TEST_F(BothEnds, AnAnswerRepeatsTheNumberOfItsRequestAsItWas) {
  for (const std::string id : {"0", "-3", "1.5", "18446744073709551615"}) {
    const auto asked = parse_request("{\"id\": " + id + ", \"do\": \"describe_robot\", \"robot\": \"uno5\"}");
    EXPECT_EQ(to_line(asked.id, Accepted{}), "{\"id\":" + id + ",\"accepted\":{\"lines\":\"\"}}\n");
  }
}

TEST_F(BothEnds, ARunRequestArrivesAsItWasMeant) {
  RunRequest sent;
  sent.image = "a.so";
  sent.map = "oval";
  sent.robot = "uno5";
  sent.for_ns = 5;
  sent.seed = std::numeric_limits<std::uint64_t>::max();
  sent.profile = "ideal";
  sent.gdb_port = 65535;
  sent.samples_every_ns = 10'000'000;
  sent.pins = sent.notes = true;
  sent.source_ns.emplace(3, 4);
  const auto asked = parse_request(to_line(1, Request(sent)));
  ASSERT_TRUE(asked.request) << asked.fault;
  const auto& got = std::get<RunRequest>(*asked.request);
  EXPECT_EQ(got.image, "a.so");
  EXPECT_EQ(got.for_ns, 5);
  EXPECT_EQ(got.seed, sent.seed);
  EXPECT_EQ(got.profile, "ideal");
  EXPECT_EQ(got.gdb_port, 65535);
  EXPECT_EQ(got.script_file, "script");
  EXPECT_TRUE(got.pins && got.notes && !got.serial && !got.io && !got.interactive);
  EXPECT_EQ(got.source_ns, sent.source_ns);
}

TEST_F(BothEnds, EveryStopArrivesAsItWasMeant) {
  const std::vector<Stop> sent{Stop::serial("a", 3),
                               Stop::line("^b$"),
                               Stop::note("c"),
                               Stop::event("lap_done"),
                               Stop::visited("1"),
                               Stop::at("dock"),
                               Stop::reading("S1", false),
                               Stop::pin("D13", false),
                               Stop::motors(false),
                               Stop::rest(9)};
  const auto asked = parse_driven_request(to_line(1, DrivenRequest(GoOn{17, sent})));
  ASSERT_TRUE(asked.request) << asked.fault;
  const auto& got = std::get<GoOn>(*asked.request);
  EXPECT_EQ(got.to_ns, 17);
  ASSERT_EQ(got.until.size(), sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    EXPECT_EQ(got.until[i].kind, sent[i].kind) << i;
    EXPECT_EQ(got.until[i].text, sent[i].text) << i;
    EXPECT_EQ(got.until[i].from, sent[i].from) << i;
    EXPECT_EQ(got.until[i].level, sent[i].level) << i;
    EXPECT_EQ(got.until[i].rest_ns, sent[i].rest_ns) << i;
  }
}

}  // namespace both_ends_test
}  // namespace robosim::wire
