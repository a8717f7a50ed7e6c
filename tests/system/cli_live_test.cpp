// Tests `robosim run --live`: a program controls the run by lines of JSON.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/system/command.h"

namespace robosim::test {
namespace cli_live_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Json = nlohmann::json;

TEST(CliLive, ServesRequestsAndIsTheRunThatItsScriptGives) {
  const Folder folder;
  folder.write("requests",
               "{\"id\": 1, \"do\": \"step\", \"ms\": 1500}\n"
               "{\"id\": 1, \"do\": \"script\", \"lines\": \"obstacle 12,2\"}\n"
               "{\"id\": 1, \"do\": \"script\", \"lines\": \"obstacle 99,2\"}\n"
               "{\"id\": 1, \"do\": \"play\", \"speed\": 1e9}\n"
               "{\"id\": 1, \"do\": \"step\", \"ms\": 9000}\n");
  const std::vector<std::string> what{"run",     "PidFollower", "--map", "oval",
                                      "--robot", "uno5",        "--for", "3s"};
  std::vector<std::string> live = what, script = what;
  live.push_back("--live");
  const Ended ended = robosim_command(live, folder.path(), nullptr, (folder / "requests").string().c_str());
  ASSERT_EQ(ended.status, 4) << ended.err;
  std::vector<std::string> refused;
  std::string accepted;
  std::vector<std::int64_t> stood;
  Json first, result;
  std::istringstream lines(ended.out);
  for (std::string line; std::getline(lines, line);) {
    const Json json = Json::parse(line);
    if (first.is_null()) first = json;
    if (json.contains("refused")) refused.push_back(json["refused"]);
    if (json.contains("accepted")) accepted += json["accepted"]["lines"].get<std::string>();
    if (json.contains("paused")) stood.push_back(json["paused"]["t_ns"].get<std::int64_t>() / 1'000'000);
    if (json.contains("result")) result = json["result"];
  }
  EXPECT_EQ(first["recording"]["map"], "oval");
  EXPECT_GT(first["recording"]["floor"]["stripes"].size(), 3u);
  EXPECT_THAT(stood, ElementsAre(0, 1500));
  EXPECT_EQ(accepted, "at 1500ms obstacle 12,2\n");
  EXPECT_THAT(refused, ElementsAre(HasSubstr("99,2"), "speed: expected a number from 0 to 1000"));
  folder.write("script", accepted);
  script.insert(script.end(), {"--json", "--script", "script"});
  EXPECT_EQ(Json::parse(robosim_command(script, folder.path()).out)["trace_hash"], result["trace_hash"]);
}

TEST(CliLive, TellsSeveralRobotsAndActsOnTheOneThatIsNamed) {
  const Folder folder;
  folder.write("requests",
               "{\"id\": 1, \"do\": \"script\", \"lines\": \"place 500mm,200mm,N\", \"agent\": 1}\n"
               "{\"id\": 1, \"do\": \"script\", \"lines\": \"power off\", \"agent\": 2}\n"
               "{\"id\": 1, \"do\": \"step\", \"ms\": 5}\n");
  const Ended ended = robosim_command({"run", "A=PidFollower", "B=PidFollower", "--map", "oval", "--robot",
                                       "uno5", "--start", "B=20,2,W", "--for", "3s", "--live"},
                                      folder.path(), nullptr, (folder / "requests").string().c_str());
  Json first, paused;
  std::vector<std::string> refused;
  std::istringstream lines(ended.out);
  for (std::string line; std::getline(lines, line);) {
    const Json json = Json::parse(line);
    if (first.is_null()) first = json;
    if (json.contains("refused")) refused.push_back(json["refused"]);
    if (json.contains("paused")) paused = json["paused"];
  }
  EXPECT_EQ(first["recording"]["name"], "A");
  ASSERT_EQ(first["recording"]["others"].size(), 1u) << ended.err;
  EXPECT_EQ(first["recording"]["others"][0]["name"], "B");
  EXPECT_EQ(first["recording"]["others"][0]["started"]["start"], Json({20, 2, "W"}));
  EXPECT_THAT(refused, ElementsAre("agent: expected a robot from 0 to 1, got 2"));
  EXPECT_NEAR(paused["others"][0]["sample"]["x"].get<double>(), 500.0, 5.0);
  EXPECT_GT(paused["sample"]["x"], 1000.0);
}

}  // namespace cli_live_test
}  // namespace robosim::test
