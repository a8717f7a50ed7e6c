// Tests a recording's page (run.html) with several runs: a second run over the first, and several robots.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/browser/page.h"

namespace robosim::test {
namespace page_runs_test {

using ::testing::HasSubstr;
using Json = nlohmann::json;

TEST_F(Page, LaysALogOfARealRobotOverTheRun) {
  const Json over = in_page(file(), R"(
    await page.open(new File(['t_ms,x_m,y_m,battery\n0,1.0,0.2,7.4\n1000,1.5,0.25,7.3\n2000,1.9,0.3,7.2\n'], 'log.csv'));
    const seen = { text: $('other-box').textContent, pose: page.other.pose(1.5), battery: page.other.signal('battery').values[2] };
    await page.open(new File(['a,b\n1,2\n'], 'bad.csv'));
    seen.problem = $('problem').textContent;
    await page.open(new File(['t,x,y\n0,1,1\n0.1,oops,2\n'], 'worse.csv'));
    seen.worse = $('problem').textContent;
    seen.still = !$('other-box').hidden;
    await page.open(new File(['t,x,y\n0,1,1\n0.1,1,2\n'], 'bare.csv'));
    seen.bare = $('other-box').textContent;
    return seen;)");
  EXPECT_THAT(over["bare"].get<std::string>(), HasSubstr("a log of 0.10 s, x and y read as mm"));
  EXPECT_THAT(over["text"].get<std::string>(), HasSubstr("log.csv (a log of 2.00 s)"));
  EXPECT_NEAR(over["pose"]["x"], 1700, 1e-6);
  EXPECT_NEAR(over["pose"]["y"], 275, 1e-6);
  EXPECT_EQ(over["battery"], 7.2);
  EXPECT_THAT(over["problem"].get<std::string>(),
              HasSubstr("bad.csv: the log’s columns: expected time, x and y"));
  EXPECT_THAT(over["worse"].get<std::string>(),
              HasSubstr("worse.csv, line 3: time, x and y: expected numbers"));
  EXPECT_TRUE(over["still"].get<bool>()) << "a bad file removes nothing";
}

TEST_F(Page, LaysAnotherRecordingOverTheRun) {
  const std::string other = base64(read_file(*folder / "run.rec"));
  const Json over = in_page(file(), "const text = `" + other + R"(`;
    await page.open(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], 'other.rec'));
    return [$('other-box').textContent, page.other.duration, page.run.duration, $('problem').hidden];)");
  EXPECT_THAT(over[0].get<std::string>(), HasSubstr("other.rec (PidFollower, seed 1, host: reached)"));
  EXPECT_EQ(over[1], over[2]);
  EXPECT_TRUE(over[3].get<bool>());
}

TEST_F(Page, BeginsWithTheRunThatReplayHasLaidOverIt) {
  // A log of a robot that does not leave the start of the recorded run.
  const auto samples = recording->stream("samples");
  write_file(*folder / "my \"log\" ü.csv", fmt::format("t_s;x_mm;y_mm;volts\n0;{0};{1};7,4\n9;{0};{1};7,1\n",
                                                       samples[1][0], samples[2][0]));
  const Ended ended = robosim_command(
      {"replay", "run.html", "--over", "my \"log\" ü.csv", "--record", "both.html"}, folder->path());
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json shown = in_page(*folder / "both.html", R"(
    page.player.seek(5);
    const apart = Number(document.querySelector('#plots [data-signal="apart_mm"]').textContent);
    const { x, y } = page.run.pose(5), begin = page.run.pose(0);
    $('add-signal').value = 'volts';
    $('add-signal').dispatchEvent(new Event('change'));
    page.player.seek(1);
    const volts = document.querySelector('#plots [data-signal="volts"]').textContent;
    return [$('other-box').textContent, apart, Math.hypot(x - begin.x, y - begin.y), volts];)");
  EXPECT_THAT(shown[0].get<std::string>(), HasSubstr("my \"log\" ü.csv"));
  EXPECT_GT(shown[1], 300);
  EXPECT_NEAR(shown[1], shown[2], 0.6);
  EXPECT_EQ(shown[3], "7.37") << "between two of the log's rows";
}

TEST_F(Page, ShowsOfSeveralRobotsTheOneThatIsChosenAndWhereTheOthersAre) {
  folder->write("Talks.ino",
                "void setup() { Serial.begin(9600); Serial.println(\"mine\"); }\nvoid loop() {}\n");
  const Ended ended =
      robosim_command({"run", "A=PidFollower", "B=./Talks.ino", "--robot", "uno5", "--map", "oval", "--start",
                       "B=20,2,W", "--for", "3s", "--goal", "none", "--record", "two.html"},
                      folder->path());
  ASSERT_EQ(ended.status, 1) << "B stands still: " << ended.err;
  const auto two = record::Recording::read(*folder / "two.html");
  const Json shown = in_page(*folder / "two.html", R"(
    const seen = () => ({ robot: $('robot-box').querySelector('select').value, title: $('title').textContent,
      lines: page.serial.rows.map((row) => row.text), speed: parseFloat($('now-speed_mm_s').textContent) });
    page.player.seek(2);
    const rows = [seen()];
    key('r');
    rows.push(seen());
    key('r');
    rows.push(seen());
    const { x, y } = page.runs[1].pose(2), [px, py] = page.view.toScreen(x, y), box = $('floor').getBoundingClientRect();
    for (const type of ['pointerdown', 'click'])
      $('floor').dispatchEvent(new MouseEvent(type, { clientX: box.x + px, clientY: box.y + py, bubbles: true }));
    rows.push(seen());
    return { rows, x, hidden: $('robot-box').hidden };)");
  const Json& rows = shown["rows"];
  EXPECT_EQ(shown["x"], two.stream("samples", 1)[1][200]);
  EXPECT_FALSE(shown["hidden"].get<bool>());
  EXPECT_EQ(rows[0]["title"], "A: PidFollower");
  EXPECT_NEAR(rows[0]["speed"], two.stream("samples", 0)[4][200], 0.51);
  EXPECT_EQ(rows[1]["title"], "B: ./Talks.ino");
  EXPECT_EQ(rows[1]["robot"], "1");
  EXPECT_EQ(rows[1]["speed"], 0);
  EXPECT_EQ(rows[1]["lines"], Json({"mine"}));
  EXPECT_EQ(rows[2], rows[0]) << "the first robot follows the last one";
  EXPECT_EQ(rows[3], rows[1]) << "a click on B's body selects B";
}

}  // namespace page_runs_test
}  // namespace robosim::test
