#include "sim/launch/run_settings.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace robosim::launch::run_settings_test {

TEST(ScenarioText, SendIsTheShortFormOfALineOfScript) {
  RunSettings settings;
  EXPECT_EQ(scenario_text(settings), "");
  settings.send = {"go\\n", "2"};
  EXPECT_EQ(scenario_text(settings), "at 1s send \"go\\n\"\nat 1s send \"2\"\n");
}

TEST(ScenarioText, SendsComeAfterTheScriptWhoseLineNumbersStay) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder / "script";
  std::ofstream(path) << "at 2s press start";
  RunSettings settings;
  settings.script = path;
  settings.send = {"x"};
  EXPECT_EQ(scenario_text(settings), "at 2s press start\nat 1s send \"x\"\n");
  std::filesystem::remove(path);
  EXPECT_THROW(scenario_text(settings), InputError);
}

}  // namespace robosim::launch::run_settings_test
