// Tests the page of `robosim run --record run.html` in a browser. Compares the displayed moments, and every
// number, with the recording.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/browser/page.h"

namespace robosim::test {
namespace page_test {

using ::testing::HasSubstr;
using Json = nlohmann::json;

TEST_F(Page, ShowsTheNumbersThatWereRecorded) {
  const Json shown = in_page(file(), R"(
    const rows = [];
    for (let ms = 0; ms <= 7000; ms += 130) {
      page.player.seek(ms / 1000);
      const text = (id) => parseFloat($(id).firstChild.textContent);
      rows.push({ row: ms / 10, time: $('time').textContent, speed: text('now-speed_mm_s'),
        error: text('now-cross_track_mm'), left: text('now-left'), right: text('now-right'),
        S1: Number(document.querySelector('[data-sensor="S1"]').textContent),
        S3: Number(document.querySelector('[data-sensor="S3"]').textContent),
        plotted: Number(document.querySelector('#plots [data-signal="wheel_left_mm_s"]').textContent),
        x: page.run.pose(ms / 1000).x, y: page.run.pose(ms / 1000).y, yaw: page.run.pose(ms / 1000).yaw });
    }
    return rows;)");
  const auto samples = recording->stream("samples");
  ASSERT_GT(shown.size(), 50u);
  for (const Json& one : shown) {
    const std::size_t row = one["row"];
    const auto at = [&](std::size_t column) { return samples[column][row]; };
    EXPECT_EQ(std::atof(one["time"].get<std::string>().c_str()), std::round(at(0) / 1000) / 1000);
    EXPECT_NEAR(one["speed"], at(4), 0.51);
    EXPECT_NEAR(one["error"], at(5), 0.051);
    EXPECT_NEAR(one["left"], at(6), 0.0051);
    EXPECT_NEAR(one["right"], at(7), 0.0051);
    EXPECT_NEAR(one["S1"], at(10), 0.0051);
    EXPECT_NEAR(one["S3"], at(12), 0.0051);
    EXPECT_NEAR(one["plotted"], at(8), 0.51);
    EXPECT_EQ(one["x"], at(1));
    EXPECT_EQ(one["y"], at(2));
    EXPECT_EQ(one["yaw"], at(3));
  }
}

TEST_F(Page, ShowsOneNumberForOneThingBetweenSamplesToo) {
  const Json apart = in_page(file(), R"(
    const apart = [];
    for (let ms = 1003; ms < 7000; ms += 117) {
      page.player.seek(ms / 1000);
      for (const [name, most] of [['speed_mm_s', 1], ['cross_track_mm', 0.1], ['left', 0.01], ['right', 0.01]]) {
        const now = parseFloat($(`now-${name}`).firstChild.textContent);
        const plotted = Number(document.querySelector(`#plots [data-signal="${name}"]`).textContent);
        if (Math.abs(now - plotted) > most) apart.push([ms, name, now, plotted]);
      }
    }
    return apart;)");
  EXPECT_EQ(apart, Json::array());
}

TEST_F(Page, StepsThroughEverythingThatHappened) {
  const Json steps = in_page(file(), R"(
    const steps = [];
    key('Home');
    for (let before = -1; page.player.t > before || before < 0;) {
      before = page.player.t;
      key('n');
      if (page.player.t > before) steps.push([page.player.t, $('happened').textContent]);
    }
    key('p');
    const last = page.player.t;
    page.player.seek(steps[1][0] - 1e-6);
    return { steps, last, scrubbed: $('happened').textContent };)");
  std::vector<double> expected;
  for (const wire::Note& note : recording->header().notes)
    if (note.t_ns > 0) expected.push_back(1e-9 * static_cast<double>(note.t_ns));
  std::vector<std::string> texts;
  for (const Json& step : steps["steps"]) texts.push_back(step[1]);
  EXPECT_THAT(texts, ::testing::Contains("start pressed"));
  EXPECT_THAT(texts, ::testing::Contains("S3 covered"));
  EXPECT_THAT(texts.back(), HasSubstr("reached: The goal laps:1"));
  for (const double t : expected)
    EXPECT_TRUE(std::any_of(steps["steps"].begin(), steps["steps"].end(), [&](const Json& step) {
      return std::fabs(step[0].get<double>() - t) < 1e-9;
    })) << t;
  EXPECT_LT(steps["last"], steps["steps"].back()[0]) << "the key p steps back";
  EXPECT_EQ(steps["scrubbed"], steps["steps"][0][1]) << "seeking shows the same text as stepping";
}

TEST_F(Page, GoesToWhereTheLineIsLeft) {
  const Json at = in_page(file(), R"(
    page.run.events.push({ t: 2.5, kind: 'line', text: 'the line is left' }, { t: 4.5, kind: 'line', text: 'back on the line' });
    page.run.sortEvents();
    const at = [];
    for (const [name, more] of [['Home'], ['l'], ['l'], ['End'], ['L', { shiftKey: true }], ['L', { shiftKey: true }]]) {
      key(name, more);
      at.push(page.player.t);
    }
    return [at[1], at[2], at[4], at[5]];)");
  EXPECT_EQ(at, Json::parse("[2.5, 4.5, 4.5, 2.5]"));
}

TEST_F(Page, SaysThatTheLineIsLeftWhereNoSensorSeesItAndNowhereElse) {
  const auto lines_of = [&](const std::string& map) {
    robosim_command({"run", "PidFollower", "--map", map, "--for", "6s", "--record", "line.html"},
                    folder->path());
    return in_page(*folder / "line.html", R"(
      const lines = page.run.events.filter((e) => e.kind === 'line');
      key('Home');
      key('l');
      return { texts: lines.map((e) => e.text), goes: page.player.t === (lines[0]?.t ?? 0), happened: $('happened').textContent };)");
  };
  const Json oval = lines_of("oval"), f = lines_of("f");
  EXPECT_EQ(oval["texts"], Json::array())
      << "one sensor is always over the line, and its reading is constant";
  EXPECT_THAT(f["texts"][0].get<std::string>(), HasSubstr("the line is left: S"));
  EXPECT_EQ(oval["goes"], true) << "without such a moment, the key l changes nothing";
  EXPECT_EQ(oval["happened"], "after this time the line is neither left nor found");
  EXPECT_EQ(f["goes"], true) << "the key l seeks the moment";
  EXPECT_THAT(f["happened"].get<std::string>(), HasSubstr("the line is left: S"));
}

TEST_F(Page, StepsByAMillisecondAndScrubs) {
  const Json t = in_page(file(), R"(
    page.player.seek(1.2346);
    key('.');
    const on = page.player.t;
    key(','); key(',');
    const back = page.player.t;
    key('ArrowRight', { shiftKey: true });
    const second = page.player.t;
    const line = $('timeline'), { left, top, height } = line.getBoundingClientRect();
    const at = (type, seconds) => line.dispatchEvent(new PointerEvent(type, { clientX: left + page.timeline.xOf(seconds),
      clientY: top + height / 2, pointerId: 1, bubbles: true }));
    line.setPointerCapture = () => {};
    at('pointerdown', 3);
    at('pointermove', 5);
    const scrubbed = page.player.t;
    at('pointerup', 5);
    at('pointermove', 6);
    return { on, back, second, scrubbed, after: page.player.t, now: line.getAttribute('aria-valuenow') };)");
  EXPECT_EQ(t["on"], 1.236);
  EXPECT_EQ(t["back"], 1.234);
  EXPECT_EQ(t["second"], 2.234);
  EXPECT_NEAR(t["scrubbed"], 5.0, 0.01);
  EXPECT_EQ(t["after"], t["scrubbed"]) << "moving without the button pressed does not seek";
  EXPECT_NEAR(std::atof(t["now"].get<std::string>().c_str()), t["after"].get<double>(), 0.0006);
}

TEST_F(Page, SaysWhichPinLeadsWhereAndWhatIsOnIt) {
  const Json rows = in_page(file(), R"(
    document.getElementById('tab-wiring').click();
    page.player.seek(3);
    return [...document.querySelectorAll('.wiring tr')].map((row) => [...row.cells].map((cell) => cell.textContent));)");
  const auto row = [&](const std::string& pin) {
    for (const Json& one : rows)
      if (one[0] == pin) return one;
    return Json();
  };
  EXPECT_EQ(row("D0")[1], "free");
  EXPECT_EQ(row("D4"), Json::parse(R"(["D4", "start pin", "button", "high"])"));
  EXPECT_EQ(row("D5")[1], "left en");
  EXPECT_THAT(row("D5")[3].get<std::string>(), HasSubstr("PWM "));
  EXPECT_EQ(row("A2")[1], "S S3");
  EXPECT_THAT(row("A2")[3].get<std::string>(), HasSubstr(" V"));
  EXPECT_THAT(row("D11")[2].get<std::string>(), HasSubstr("never used"));
}

TEST_F(Page, SaysWhichLineOfTheSketchDroveAPin) {
  ROBOSIM_NEEDS_TARGET("avr");
  folder->write("Blink/Blink.ino",
                "void light(bool on) {\n  digitalWrite(13, on);\n}\n"
                "void setup() {\n  pinMode(13, OUTPUT);\n}\n"
                "void loop() {\n  light(true);\n  delay(10);\n  PORTB &= ~_BV(5);\n  delay(10);\n}\n");
  const Ended ended = robosim_command({"run", "./Blink", "--map", "oval", "--robot", "uno5", "--target",
                                       "avr", "--goal", "none", "--for", "100ms", "--record", "blink.html"},
                                      folder->path());
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json seen = in_page(*folder / "blink.html", R"(
    $('tab-pins').click();
    const row = page.pins.find((one) => one.pin.name === 'D13'), { canvas } = row.track;
    const said = () => [row.now.textContent, row.source.textContent];
    page.span.set(0.1, 0);
    const edges = Array.from(row.pin.t), seen = [];
    canvas.setPointerCapture = () => {};
    const { left, top } = canvas.getBoundingClientRect();
    for (const t of edges.slice(2, 5)) {  // 3 px beside the edge
      canvas.dispatchEvent(new PointerEvent('pointerdown', { clientX: left + row.track.xOf(t) - 3, clientY: top + 9, pointerId: 1, bubbles: true }));
      canvas.dispatchEvent(new PointerEvent('pointerup', { pointerId: 1, bubbles: true }));
      seen.push([page.player.t === t, ...said()]);
    }
    row.title.click();
    const next = page.player.t === edges[5];
    row.title.dispatchEvent(new MouseEvent('click', { shiftKey: true }));
    const back = page.player.t === edges[4];
    page.player.seek(0);
    return { seen, next, back, before: said()[1] };)");
  EXPECT_EQ(
      seen["seen"],
      Json::parse(R"x([[true, "low", "Blink.ino:10 in loop()"], [true, "high", "Blink.ino:2 in light()"],
                                          [true, "low", "Blink.ino:10 in loop()"]])x"));
  EXPECT_TRUE(seen["next"]);
  EXPECT_TRUE(seen["back"]);
  EXPECT_EQ(seen["before"], "") << "the pin has not been driven yet";
}

TEST_F(Page, FitsAPhoneAndNamesEveryButton) {
  for (const int width : {360, 1400}) {
    const Json faults = in_page(file(), R"(
      const faults = [];
      const width = document.body.clientWidth;
      for (const part of document.body.querySelectorAll('header, main, footer, .stage, aside'))
        if (part.scrollWidth > part.clientWidth || part.getBoundingClientRect().right > width) faults.push(`too wide: ${part.className || part.tagName}`);
      const left = (id) => $(id).getBoundingClientRect().left;
      for (const zoom of [1, 0.9, 0.9, 0.9, 0.9, 0.9, 0.9]) {
        page.view.zoom(zoom);
        page.drawFloor();
        if (left('floor') + page.floor.scaleEnds > $('colour-by').closest('label').parentElement.getBoundingClientRect().left) faults.push('the scale is hidden');
      }
      page.player.seek(0);
      $('event-on').click();
      if (!$('happened').textContent || !$('happened').getClientRects().length) faults.push('what happened is not shown');
      for (const tab of ['plots', 'pins', 'serial', 'events']) {
        $(`tab-${tab}`).click();
        const times = document.querySelector('#pins .axis canvas');
        if (tab === 'pins' && !times.getContext('2d').getImageData(0, 0, times.width, times.height).data.some(Boolean)) faults.push('no times below the pins');
        for (const button of document.querySelectorAll('button, select, [role="slider"]')) {
          const box = button.getBoundingClientRect();
          if (!box.width || button.closest('dialog')) continue;
          const name = button.getAttribute('aria-label') || button.textContent.trim();
          if (!name) faults.push(`no name: ${button.outerHTML}`);
          if (!button.closest('.panel') && (box.left < 0 || box.right > width || box.bottom > innerHeight)) faults.push(`outside: ${name}`);
        }
      }
      if (performance.getEntriesByType('resource').length) faults.push('it loads something');
      return faults;)",
                                width, 900);
    EXPECT_EQ(faults.size(), 0u) << width << ": " << faults.dump(1);
  }
}

// `robosim serve` hides a run's page while the page of the server shows the compiler's messages.
TEST_F(Page, IsDrawnAgainAfterItWasHidden) {
  const Json scales = in_page(file(), R"(
    const shown = page.view.scale;
    $('main').hidden = true;
    await drawn();
    page.resize();
    $('main').hidden = false;
    await drawn();
    page.resize();
    return [shown, page.view.scale];)");
  EXPECT_EQ(scales[0], scales[1]);
}

}  // namespace page_test
}  // namespace robosim::test
