// Tests the web page that runs Robosim in the browser as WebAssembly (docs/howto/tab.md), from a plain file
// server and offline.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/browser/driver.h"

namespace robosim::test {
namespace tab_test {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;

// JavaScript functions for the tests: they pass a file to the page, run a sketch, and wait for a message or a
// displayed run.
constexpr const char* kTab = R"(
  const shown = () => $('replay').contentWindow?.robosim;
  const give = async (name, content) => {
    const files = new DataTransfer();
    files.items.add(new File([content], name));
    $('files').files = files.files;
    $('files').dispatchEvent(new Event('change'));
    await until(() => [...document.querySelectorAll('option')].some((option) => option.text === name));
  };
  const run = async () => {
    const before = $('replay').src;
    $('run').click();
    await until(() => $('said').textContent || ($('replay').src !== before && shown()));
    return { said: $('said').textContent, hash: $('hash').textContent };
  };
  await until(() => document.documentElement.dataset.ready);
  const stock = await (await fetch('stock.json')).json();
)";

class Tab : public ::testing::Test {
 protected:
  void SetUp() override {
    ROBOSIM_NEEDS_BROWSER();
    if (!std::filesystem::exists(ROBOSIM_TAB "/sw.js")) {
      const char* const missing = "the tab is not built: cmake --preset tab && cmake --build --preset tab";
      if (is_required("tab")) FAIL() << missing;
      GTEST_SKIP() << missing;
    }
    server_.emplace(
        std::vector<std::string>{"/usr/bin/python3", "-u", "-m", "http.server", "0", "--bind", "127.0.0.1",
                                 "--directory", std::filesystem::path(ROBOSIM_TAB).parent_path().string()},
        "port ");
    open();
  }
  void open(const std::string& where = "") {
    browser().open("http://127.0.0.1:" + server_->where() + "/tab/" + where);
  }
  Json in_page(const std::string& body) { return browser().run(kTab + body); }

  std::optional<Started> server_;
};

TEST_F(Tab, RunsAnImageAsTheCommandDoesAndWithoutANetworkToo) {
  const Folder folder;
  ASSERT_EQ(
      robosim_command({"build", "PidFollower", "--target", "avr", "--out", folder.path().string()}).status,
      0);
  const std::string hex = (folder / "PidFollower.hex").string();
  const Json native = Json::parse(robosim_command({"run", hex, "--map", "tight", "--json"}).out);
  const std::string steps = "await give('own.hex', " + Json(read_file(hex)).dump() +
                            "); $('map').value = 'tight'; return await run();";

  EXPECT_EQ(in_page(steps)["hash"], native["trace_hash"]);
  browser().picture(std::filesystem::path(ROBOSIM_PICTURES) / "tab.png");

  in_page("await navigator.serviceWorker.ready; return 0;");
  server_->end();
  open();
  EXPECT_EQ(in_page(steps)["hash"], native["trace_hash"]) << "offline";
}

TEST_F(Tab, PressesAButtonAtTheMomentThatIsShown) {
  open("#sketch=AiNavigator&map=city&seconds=5&run=1");
  const Json seen = in_page(R"(
    await until(() => !$('hands').hidden);
    const before = shown();
    before.player.seek(1);
    [...$('buttons').children].find((button) => button.textContent === 'press start').click();
    await until(() => shown() && shown() !== before);
    return { script: $('script').value, was: before.run.pose(5).x, is: shown().run.pose(5).x };)");
  EXPECT_EQ(seen["script"], "at 1000ms press start for 200ms\n");
  EXPECT_GT(seen["is"].get<double>() - seen["was"].get<double>(), 100.0) << "waits for the button";
}

TEST_F(Tab, PassesARunOnInALink) {
  const Json sent = in_page(R"(
    await give('own.hex', stock.sketches.PidFollower.hex);
    await give('own.map', stock.maps.tight.replace('tight', 'own'));
    $('seed').value = 7;
    const { hash } = await run();
    $('share').click();
    await until(() => location.hash);
    return { hash, link: location.hash };)");
  ASSERT_LE(sent["link"].get<std::string>().size(), 8192u);
  browser().open("about:blank");
  open(sent["link"].get<std::string>());
  const Json got = in_page(R"(
    await until(() => $('equal').textContent);
    return { equal: $('equal').textContent, hash: $('hash').textContent, seed: $('seed').value };)");
  EXPECT_THAT(got["equal"].get<std::string>(), HasSubstr("equal to the shared run"));
  EXPECT_EQ(got["hash"], sent["hash"]);
  EXPECT_EQ(got["seed"], "7");
}

TEST_F(Tab, RunsOnAMapThatWasEditedInThePage) {
  const Json seen = in_page(R"(
    $('edit-map').click();
    $('own-text').value = $('own-text').value.replace('"laps:1"', '"laps:2"');
    $('own-text').dispatchEvent(new Event('input'));
    await run();
    return { map: $('map').selectedOptions[0].text, goal: shown().run.result.goal };)");
  EXPECT_EQ(seen, Json::parse(R"({"map": "my-oval.map", "goal": "laps:2"})"));
}

TEST_F(Tab, SaysWhatIsWrongWithAFile) {
  const Json said = in_page(R"(
    const all = [];
    for (const [name, content, kind, good] of [
      ['own.map', '####\n#S?#\n####\n', 'map', 'oval'], ['own.toml', 'board = "unoo"\n', 'robot', 'uno5'],
      ['own.hex', ':10zz\n', 'sketch', 'PidFollower'], ['own.elf', 'no program', 'sketch', 'PidFollower']]) {
      await give(name, content);
      all.push((await run()).said);
      $(kind).value = good;
    }
    return all;)");
  EXPECT_THAT(said[0].get<std::string>(), StartsWith("own.map:2:3: unexpected character"));
  EXPECT_THAT(said[1].get<std::string>(), HasSubstr("own.toml:1:9: "));
  EXPECT_EQ(said[2], "own.hex:1: expected a line of an Intel HEX file");
  EXPECT_EQ(said[3],
            "own.elf: expected a program for a chip that Robosim knows (an AVR or an ARM microcontroller)");
}

}  // namespace tab_test
}  // namespace robosim::test
