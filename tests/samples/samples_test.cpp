// Runs the sketches of samples/ as their users do. Each folder has two tests. First, the folder's checks.toml
// must pass on each target that the file names. Second, `robosim compare` runs the file's first check on host
// and AVR. It must find no difference, or the differences in differs.txt if the folder has this file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "sim/base/config.h"
#include "sim/base/escaped.h"
#include "tests/support/require_target.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace samples_test {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<std::string> samples() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(ROBOSIM_SAMPLES)) {
    if (entry.is_directory()) names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class Sample : public testing::TestWithParam<std::string> {
 protected:
  fs::path folder() const { return fs::path(ROBOSIM_SAMPLES) / GetParam(); }
};

INSTANTIATE_TEST_SUITE_P(Of, Sample, testing::ValuesIn(samples()),
                         [](const auto& name) { return name.param; });

TEST_P(Sample, DoesWhatItsChecksAskFor) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Ended ended = robosim_command({"test"}, folder());
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
}

/// Returns the options of `run` and `compare` for a check. Paths begin at the sample's folder.
std::vector<std::string> options(const ConfigValue& check) {
  std::vector<std::string> words;
  for (const char* key : {"map", "robot", "start", "goal", "for", "profile", "script", "send"}) {
    const ConfigValue* value = check.find(key);
    if (!value) continue;
    const std::string word = as_string(*value, key);
    words.insert(words.end(), {std::string("--") + key, std::string(key) == "send" ? escaped(word) : word});
  }
  return words;
}

bool runs_on_both(const ConfigValue& check) {
  const ConfigValue* target = check.find("target");
  return target && target->kind == ConfigValue::Kind::array;
}

TEST_P(Sample, DoesTheSameOnHostAndAvrButForWhatItSays) {
  ROBOSIM_NEEDS_TARGET("avr");
  const fs::path file = folder() / "checks.toml";
  const ConfigValue checks = parse_toml(read_file(file), file);
  const ConfigValue& first = checks.find("check")->items.front();
  const bool differs = fs::exists(folder() / "differs.txt");
  if (!runs_on_both(first) && !differs) {
    EXPECT_EQ(as_string(*first.find("target"), "target"), "avr")
        << "a sample runs on host and chip, or on the chip alone";
    return;
  }
  std::vector<std::string> words = options(first);
  words.insert(words.begin(), {"compare", ".", "--target", "host,avr"});
  const Ended ended = robosim_command(words, folder());
  if (!differs) {
    EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
    return;
  }
  EXPECT_EQ(ended.status, 1) << ended.out << ended.err;
  std::istringstream lines(read_file(folder() / "differs.txt"));
  for (std::string line; std::getline(lines, line);) EXPECT_THAT(ended.out, HasSubstr(line));
}

TEST(Samples, AreAllOnTheirPage) {
  const std::string page = read_file(ROBOSIM_SAMPLES_PAGE);
  for (const std::string& name : samples()) {
    EXPECT_THAT(page, HasSubstr("[`" + name + "`](../../samples/" + name + "/" + name + ".ino)"));
  }
}

TEST(Samples, AreWhatARobotFileAndChecksMake) {
  for (const std::string& name : samples()) {
    for (const std::string& file : {name + ".ino", std::string("robot.toml"), std::string("checks.toml")}) {
      EXPECT_TRUE(fs::exists(fs::path(ROBOSIM_SAMPLES) / name / file)) << name << " has no " << file;
    }
  }
}

}  // namespace samples_test
}  // namespace robosim::test
