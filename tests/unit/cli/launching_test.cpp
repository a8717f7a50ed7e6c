#include "sim/cli/launching.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "sim/base/error.h"

namespace robosim::cli {
namespace launching_test {

TEST(ScenarioText, SendIsTheShortFormOfALineOfScript) {
  RunArguments arguments;
  EXPECT_EQ(scenario_text(arguments), "");
  arguments.send = {"go\\n", "2"};
  EXPECT_EQ(scenario_text(arguments), "at 1s send \"go\\n\"\nat 1s send \"2\"\n");
}

TEST(ScenarioText, SendsComeAfterTheScriptWhoseLineNumbersStay) {
  const auto path = std::filesystem::temp_directory_path() / ("robosim-script-" + std::to_string(::getpid()));
  std::ofstream(path) << "at 2s press start";
  RunArguments arguments;
  arguments.script = path;
  arguments.send = {"x"};
  EXPECT_EQ(scenario_text(arguments), "at 2s press start\nat 1s send \"x\"\n");
  std::filesystem::remove(path);
  EXPECT_THROW(scenario_text(arguments), InputError);
}

}  // namespace launching_test
}  // namespace robosim::cli
