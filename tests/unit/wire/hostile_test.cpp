// Tests malformed lines of the runner protocol: lines that are truncated or nested too deeply, or that have a
// changed byte or a value of a wrong type. Each malformed line causes one message that names the fault, and
// has no other effect.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sim/wire/protocol.h"

namespace robosim::wire {
namespace hostile_test {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using Json = nlohmann::json;

std::string request_fault(const std::string& line) { return parse_request(line).fault; }
std::string driven_fault(const std::string& line) { return parse_driven_request(line).fault; }

/// Returns the error message for an answer, or "" if the answer is valid.
std::string answer_fault(const std::string& line) {
  try {
    parse_line(line);
  } catch (const RunnerError& error) {
    return error.what();
  }
  return "";
}

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

RunRequest whole_request() {
  RunRequest r;
  r.image = "a.so";
  r.map = "m";
  r.robot = "uno5";
  r.start = "1,2,E";
  r.goal = "tour";
  r.script = "at 1s press start";
  r.clock_ns = 5;
  r.gdb_port = 3333;
  r.samples_every_ns = 1'000'000;
  r.pins = r.io = r.interactive = true;
  r.source_ns.emplace(1, 2);
  r.counters = "c";
  return r;
}

std::string whole_result() {
  RunResult r;
  r.verdict = "crashed";
  r.crash = Crash{"division by zero", {"loop", "A.ino", 7}, {{"f", "B.ino", 1}}, "PC 0x1", "c"};
  r.resources = Resources{1, 2, 3, 4, 5, 6.0, 7.0, 0.5, 0.25};
  r.metrics.laps_s = {1.0};
  r.metrics.stations = {"1"};
  r.events = {{1.0, "e"}};
  return to_line(Id(std::int64_t{1}), r);
}

TEST(Hostile, ARequestThatIsNoObjectIsToldWhoItIsThatListens) {
  for (const char* line : {"GET / HTTP/1.1", "", "[]", "42", "null", "{", "{\"id\": NaN}", "{\"id\": 1e999}",
                           "{\"id\": 1, \"do\": \"\xff\"}"}) {
    EXPECT_THAT(request_fault(line), HasSubstr("one JSON object per line")) << line;
    EXPECT_THAT(driven_fault(line), HasSubstr("one JSON object per line")) << line;
  }
  EXPECT_EQ(request_fault("GET / HTTP/1.1"),
            "the request to this runner of Robosim: expected one JSON object per line, got “GET / HTTP/1.1”");
}

TEST(Hostile, ARequestOfAnotherVersionOrNameIsToldWhatIsKnown) {
  EXPECT_EQ(request_fault(R"({"id": 1, "protocol": 2, "do": "run"})"),
            "\"protocol\" in the request: expected 1, the version of this runner");
  EXPECT_EQ(request_fault(R"({"id": 1, "do": "walk"})"),
            "\"do\" in the request to a runner: expected \"describe_robot\" or \"run\", got “walk”");
  EXPECT_THAT(
      request_fault(R"({"id": 1})"),
      HasSubstr("\"do\" in the request to a runner: expected \"describe_robot\" or \"run\", got none"));
  EXPECT_THAT(request_fault(R"({"do": "run"})"), HasSubstr("\"id\" in the request: expected a number"));
  EXPECT_EQ(driven_fault(R"({"id": 1, "do": "run"})"),
            "\"do\" in the request to a paused run: expected \"script\", \"continue\", \"eeprom\" or "
            "\"end\", got “run”");
  EXPECT_EQ(request_fault(R"({"id": 1, "protocol": 1, "do": "describe_robot", "robot": "uno5"})"), "");
}

TEST(Hostile, ASentenceNamesTheKeyAndWhatIsAllowed) {
  const std::string begin = R"({"id": 1, "do": "run", "image": "i", "map": "m", "robot": "r")";
  EXPECT_EQ(request_fault(begin + "}"), "");
  EXPECT_EQ(request_fault(begin + R"(, "for_ns": -1})"),
            "\"for_ns\" in the request: expected a whole number from 0");
  EXPECT_EQ(request_fault(begin + R"(, "gdb_port": 65536})"),
            "\"gdb_port\" in the request: expected a whole number from 0 to 65535");
  EXPECT_EQ(request_fault(begin + R"(, "samples_every_ns": 1500000})"),
            "\"samples_every_ns\" in the request: expected a multiple of 1000000 from 0");
  EXPECT_EQ(request_fault(begin + R"(, "seed": 18446744073709551616})"),
            "\"seed\" in the request: expected a whole number from 0");
  EXPECT_EQ(request_fault(begin + R"(, "for_ns": 9223372036854775808})"),
            "\"for_ns\" in the request: expected a whole number from 0");
  EXPECT_EQ(request_fault(begin + R"(, "profile": "real"})"),
            "\"profile\" in the request: expected \"ideal\", \"typical\", \"typical@1\" or \"typical@2\"");
  EXPECT_EQ(request_fault(begin + R"(, "stream": ["pin", "pins"]})"),
            "\"stream\" in the request: expected an array of \"pin\", \"serial\", \"note\" and \"io\"");
  EXPECT_EQ(request_fault(begin + R"(, "source": [1]})"),
            "\"source\" in the request: expected an array of 2");
  EXPECT_THAT(request_fault(begin + R"(, "sed": 1})"),
              HasSubstr("\"sed\" in the request: unknown key; expected id, do, protocol, image"));
  EXPECT_EQ(request_fault(R"({"id": 1, "do": "run", "map": "m", "robot": "r"})"),
            "\"image\" in the request: missing key; expected a string that is not empty");
  EXPECT_EQ(driven_fault(R"({"id": 1, "do": "continue", "until": [{"motors": true}, {"motors": 1}]})"),
            "\"until[1].motors\" in the request: expected true or false");
  EXPECT_EQ(driven_fault(R"({"id": 1, "do": "continue", "until": [{}]})"),
            "\"until[0]\" in the request: expected exactly one of the keys serial, line, note, event, "
            "visited, at, reading, pin, motors or rest_ns");
  EXPECT_THAT(driven_fault(R"({"id": 1, "do": "continue", "until": [{"serial": "a", "note": "b"}]})"),
              HasSubstr("expected exactly one of the keys"));
  EXPECT_THAT(driven_fault(R"({"id": 1, "do": "continue", "until": [{"note": "b", "from": 1}]})"),
              HasSubstr("\"until[0].from\" in the request: unknown key"));
}

TEST(Hostile, DeepNestingIsRefusedEverywhere) {
  constexpr std::size_t kDepth = 100'000;
  const std::string deep = nested(kDepth);
  EXPECT_NE(request_fault(deep), "");
  EXPECT_NE(request_fault(std::string(kDepth, '[')), "");
  EXPECT_NE(request_fault("{\"id\": " + deep + "}"), "");
  EXPECT_NE(request_fault("{\"id\": 1, \"do\": " + deep + "}"), "");
  EXPECT_NE(request_fault("{\"id\": 1, \"protocol\": " + deep + ", \"do\": \"run\"}"), "");
  EXPECT_NE(request_fault("{\"id\": 1, \"do\": \"run\", \"image\": " + deep + "}"), "");
  EXPECT_NE(request_fault("{\"id\": 1, \"do\": \"describe_robot\", \"robot\": \"r\", \"x\": " + deep + "}"),
            "");
  EXPECT_NE(driven_fault("{\"id\": 1, \"do\": \"continue\", \"until\": " + deep + "}"), "");
  EXPECT_NE(answer_fault(deep), "");
  EXPECT_NE(answer_fault("{\"hello\": " + deep + "}"), "");
  EXPECT_NE(answer_fault("{\"id\": 1, \"result\": " + deep + "}"), "");
  EXPECT_NE(answer_fault("{\"id\": 1, \"event\": " + deep + "}"), "");
  EXPECT_NE(answer_fault("{\"id\": 1, \"accepted\": {\"lines\": \"\", \"new\": " + deep + "}}"), "");
}

TEST(Hostile, AnyKeyWithAValueOfAnotherKindIsNamed) {
  const Json odd[] = {nullptr,
                      true,
                      -1,
                      1.5,
                      1e300,
                      "",
                      std::string(1000, '"'),
                      Json::array(),
                      Json::object(),
                      Json::parse("[[[]]]"),
                      18446744073709551615u};
  const Json request = Json::parse(to_line(1, Request(whole_request())));
  for (const auto& [key, value] : request.items()) {
    for (const Json& other : odd) {
      Json changed = request;
      changed[key] = other;
      const std::string fault = request_fault(changed.dump());
      EXPECT_THAT(fault,
                  AnyOf("", HasSubstr("\"" + key + "\""), HasSubstr("\"" + key + "["), HasSubstr("\"do\"")));
    }
    Json without = request;
    without.erase(key);
    EXPECT_THAT(request_fault(without.dump()), AnyOf("", HasSubstr("\"" + key + "\"")));
  }
  const Json answer = Json::parse(whole_result());
  for (const auto& [key, value] : answer["result"].items()) {
    for (const Json& other : odd) {
      Json changed = answer;
      changed["result"][key] = other;
      EXPECT_THAT(answer_fault(changed.dump()), AnyOf("", HasSubstr("result." + key)));
    }
  }
}

TEST(Hostile, LinesThatAreCutOffOrTurnedOverAreRefusedOrReadAndNothingElse) {
  const std::string request = to_line(1, Request(whole_request()));
  const std::string driven = to_line(1, DrivenRequest(GoOn{5, {Stop::serial("a"), Stop::rest(3)}}));
  const std::string answer = whole_result();
  for (std::size_t i = 0; i < answer.size(); i += 3) {
    EXPECT_NE(answer_fault(answer.substr(0, std::min(i, answer.size() - 2))), "") << i;
    EXPECT_NE(request_fault(request.substr(0, std::min(i, request.size() - 2))), "") << i;
    EXPECT_NE(driven_fault(driven.substr(0, std::min(i, driven.size() - 2))), "") << i;
    for (const char c : {'\0', '"', '{', '9', '-', '\xff', ' '}) {
      std::string turned = answer;
      turned[i] = c;
      answer_fault(turned);
      turned = request;
      turned[i % request.size()] = c;
      request_fault(turned);
      turned = driven;
      turned[i % driven.size()] = c;
      driven_fault(turned);
    }
  }
}

TEST(Hostile, NoEventIsBeforeTheStartNorLaterThanATimeCanBe) {
  const auto byte_at = [](const std::string& t) {
    return answer_fault(R"({"id": 2, "event": "byte", "t_ns": )" + t + R"(, "value": 97, "sent": true})");
  };
  EXPECT_EQ(byte_at("0"), "");
  EXPECT_THAT(byte_at("-1"), HasSubstr("t_ns"));
  EXPECT_THAT(byte_at("9000000000000000000"), HasSubstr("t_ns"));
}

TEST(Hostile, NoEventIsOfARobotThatCannotBe) {
  const std::string note = R"({"id":1,"event":"serial","t_ns":1,"text":"a","agent":)";
  EXPECT_EQ(answer_fault(note + "255}"), "");
  EXPECT_THAT(answer_fault(note + "256}"), HasSubstr("agent"));
  EXPECT_THAT(answer_fault(note + "-1}"), HasSubstr("agent"));
}

TEST(Hostile, MemoryIsTwoHexadecimalDigitsAByte) {
  for (const char* digits : {"0", "abc", "zz", "0x", "-1", " 1"})
    EXPECT_THAT(answer_fault(std::string(R"({"id": 1, "eeprom": ")") + digits + "\"}"),
                HasSubstr("two hexadecimal digits"))
        << digits;
}

}  // namespace hostile_test
}  // namespace robosim::wire
