// The page of `robosim run --record run.html`, as a browser shows it: every number against the recording.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/record/compressed.h"
#include "sim/record/record_page.h"
#include "sim/record/recording_header.h"
#include "tests/browser/driver.h"

namespace robosim::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Json = nlohmann::json;

class Page : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new Folder;
    write_file(*folder / "go.script",
               "at 1s press start 100ms\nat 2500ms cover S3 200ms\nat 4s send \"hi\\n\"\n");
    const Ended ended = robosim_command({"run", "PidFollower", "--map", "tight", "--script", "go.script",
                                         "--record", "run.html", "--record", "run.rec"},
                                        folder->path());
    if (ended.status != 0) throw std::runtime_error(ended.err);
    recording = new record::Recording(record::Recording::read(file()));
  }
  static void TearDownTestSuite() {
    delete recording;
    delete folder;
    recording = nullptr;
    folder = nullptr;
  }
  void SetUp() override { ROBOSIM_NEEDS_BROWSER(); }
  static std::filesystem::path file() { return *folder / "run.html"; }

  static inline Folder* folder = nullptr;
  static inline record::Recording* recording = nullptr;
};

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
  EXPECT_LT(steps["last"], steps["steps"].back()[0]) << "and back again";
  EXPECT_EQ(steps["scrubbed"], steps["steps"][0][1]) << "by other ways than by steps, too";
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
  EXPECT_EQ(t["after"], t["scrubbed"]) << "the button is up";
  EXPECT_NEAR(std::atof(t["now"].get<std::string>().c_str()), t["after"].get<double>(), 0.0006);
}

TEST_F(Page, DrawsTheFloorWhereTheSimulationHasIt) {
  // The middle of each stripe, 3 mm within its edges and 3 mm outside; the robot is elsewhere.
  const Json wrong = in_page(file(), R"(
    page.player.seek(0);
    page.run.t = page.run.t.slice(0, 1);  // no trail
    page.setTheme('light');
    const canvas = $('floor'), ctx = canvas.getContext('2d'), ratio = canvas.width / canvas.clientWidth;
    const light = (x, y) => {
      const [px, py] = page.view.toScreen(x, y);
      return ctx.getImageData(Math.round(px * ratio), Math.round(py * ratio), 1, 1).data[0];
    };
    const wrong = [], { floor } = page.run;
    let looked = 0;
    for (const stripe of floor.stripes) {
      const [x, y, toX, toY] = stripe.line;
      let middle = [(x + toX) / 2, (y + toY) / 2], normal;
      if (stripe.arc) {
        const [cx, cy, r] = stripe.arc, out = [middle[0] - cx, middle[1] - cy], length = Math.hypot(...out);
        normal = out.map((v) => v / length);
        middle = [cx + normal[0] * r, cy + normal[1] * r];
      } else {
        const length = Math.hypot(toX - x, toY - y);
        normal = [-(toY - y) / length, (toX - x) / length];
      }
      for (const side of [-1, 1])
        for (const [off, dark] of [[floor.line / 2 - 3, true], [floor.line / 2 + 3, false]]) {
          Object.assign(page.view, { x: middle[0], y: middle[1], scale: 2, fits: false });
          page.drawFloor();
          const robot = page.run.pose(0);
          if (Math.hypot(middle[0] - robot.x, middle[1] - robot.y) < 120) continue;
          const value = light(middle[0] + side * off * normal[0], middle[1] + side * off * normal[1]);
          looked++;
          if ((value < 100) !== dark) wrong.push([stripe, side, off, value]);
        }
    }
    return { wrong, looked };)");
  EXPECT_GT(wrong["looked"].get<int>(), 12);
  EXPECT_EQ(wrong["wrong"].size(), 0u) << wrong["wrong"].dump();
}

TEST_F(Page, ZoomsAboutThePointer) {
  const Json moved = in_page(file(), R"(
    const before = page.view.toFloor(300, 200), scale = page.view.scale;
    const { left, top } = $('floor').getBoundingClientRect();
    $('floor').dispatchEvent(new WheelEvent('wheel', { deltaY: -400, clientX: left + 300, clientY: top + 200, cancelable: true }));
    const after = page.view.toFloor(300, 200);
    return [after[0] - before[0], after[1] - before[1], page.view.scale / scale];)");
  EXPECT_NEAR(moved[0], 0.0, 1.0);
  EXPECT_NEAR(moved[1], 0.0, 1.0);
  EXPECT_GT(moved[2], 1.5);
}

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
  EXPECT_THAT(over["bare"].get<std::string>(), HasSubstr("a log of 0.10 s, x and y taken for mm"));
  EXPECT_THAT(over["text"].get<std::string>(), HasSubstr("log.csv (a log of 2.00 s)"));
  EXPECT_NEAR(over["pose"]["x"], 1700, 1e-6);
  EXPECT_NEAR(over["pose"]["y"], 275, 1e-6);
  EXPECT_EQ(over["battery"], 7.2);
  EXPECT_THAT(over["problem"].get<std::string>(),
              HasSubstr("bad.csv: a log needs columns for time, x and y"));
  EXPECT_THAT(over["worse"].get<std::string>(),
              HasSubstr("worse.csv, line 3: time, x and y must be numbers"));
  EXPECT_TRUE(over["still"].get<bool>()) << "a bad file takes nothing away";
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
  EXPECT_EQ(rows[2], rows[0]) << "after the last comes the first";
  EXPECT_EQ(rows[3], rows[1]) << "a click on B's body";
}

TEST_F(Page, BeginsWithTheRunThatReplayHasLaidOverIt) {
  // A log of a robot that stands where the recorded one begins.
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

TEST_F(Page, SaysThatTheLineIsLeftWhereNoSensorSeesItAndNowhereElse) {
  const auto lines_of = [&](const std::string& map) {
    robosim_command({"run", "PidFollower", "--map", map, "--for", "6s", "--record", "line.html"},
                    folder->path());
    return in_page(*folder / "line.html",
                   "return page.run.events.filter((e) => e.kind === 'line').map((e) => e.text);");
  };
  EXPECT_EQ(lines_of("oval"), Json::array())
      << "one sensor is over the line throughout, and always reads the same";
  EXPECT_THAT(lines_of("f")[0].get<std::string>(), HasSubstr("the line is left: S"));
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
  EXPECT_EQ(seen["before"], "") << "nothing has driven it yet";
}

TEST_F(Page, DrawsTheGraphThatTheSketchTellsAsItGrows) {
  write_file(*folder / "scan.script", "at 1s press start 100ms\n");
  const Ended ended = robosim_command({"run", "AiNavigator", "--map", "b", "--goal", "none", "--for", "60s",
                                       "--script", "scan.script", "--record", "scan.html"},
                                      folder->path());
  ASSERT_EQ(ended.status, 0) << ended.err;
  // Around a node there is the colour of the graph once it is told, and not before.
  const Json shown = in_page(*folder / "scan.html", R"(
    const { nodes, edges } = page.run.told, { height, cell } = page.run.floor;
    const stations = page.run.started.stations.map((s) => [s.name, (s.x + 0.5) * cell, height - (s.y + 0.5) * cell]);
    page.setTheme('light');
    const pink = (t, { x, y }) => {
      page.player.seek(t);
      const canvas = $('floor'), ratio = canvas.width / canvas.clientWidth, [px, py] = page.view.toScreen(x, y);
      const { data } = canvas.getContext('2d').getImageData((px - 22) * ratio, (py - 22) * ratio, 44 * ratio, 44 * ratio);
      for (let i = 0; i < data.length; i += 4) if (data[i] === 204 && data[i + 1] === 121 && data[i + 2] === 167) return true;
      return false;
    };
    return { named: nodes.filter((n) => n.name).map((n) => [n.name, n.x, n.y]), stations, nodes: nodes.length,
      edges: edges.map(({ a, b }) => [a, b]), before: nodes.map((n) => pink(n.t - 0.01, n)), after: nodes.map((n) => pink(n.t + 4, n)) };)");
  EXPECT_EQ(shown["named"], shown["stations"]) << "each where it is";
  EXPECT_EQ(shown["nodes"], 6);
  EXPECT_EQ(shown["edges"], Json::parse("[[0,1],[1,2],[2,3],[2,4],[1,5]]"));
  EXPECT_EQ(shown["before"], Json::parse("[false,false,false,false,false,false]"));
  EXPECT_EQ(shown["after"], Json::parse("[true,true,true,true,true,true]"));
}

// An hour's laps over each other would take a browser many seconds to paint, at each moment anew.
TEST_F(Page, PaintsALongRunWithFewStrokes) {
  const Ended ended = robosim_command(
      {"run", "PidFollower", "--map", "oval", "--goal", "none", "--for", "400s", "--record", "long.html"},
      folder->path());
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json strokes = in_page(*folder / "long.html", R"(
    let count = 0;
    const lineTo = Path2D.prototype.lineTo;
    Path2D.prototype.lineTo = function (...to) { count++; lineTo.apply(this, to); };
    page.view.zoom(1.5);
    const zoomed = count;
    page.player.seek(390);
    return { samples: page.run.t.length, zoomed, moved: count - zoomed };)");
  EXPECT_GT(strokes["samples"], 40'000);
  EXPECT_GT(strokes["moved"], 2'000) << "the last two minutes are there";
  EXPECT_LT(strokes["moved"], 26'000);
  EXPECT_LT(strokes["zoomed"], 40'000);
}

TEST_F(Page, SaysInOneSentenceThatItsRecordingIsBroken) {
  const std::string good = read_file(file());
  const std::size_t at = good.find("octet-stream\">") + 14;
  const std::string lacking = base64(record::kRecordingMagic + record::deflated("{}\n"));
  for (const auto& [broken, sentence] :
       {std::pair{good.substr(0, at) + good.substr(good.find("</script>", at)), "no recording of Robosim"},
        std::pair{good.substr(0, at) + lacking + good.substr(good.find("</script>", at)),
                  "header is damaged"},
        std::pair{good.substr(0, at + 2000) + good.substr(good.find("</script>", at)), "damaged or cut off"},
        std::pair{good.substr(0, at + 60) + "AAAA" + good.substr(at + 64), "damaged"},
        std::pair{good.substr(0, at + 60) + "<!!>" + good.substr(at + 64), "damaged"}}) {
    write_file(*folder / "broken.html", broken);
    const Json said = in_page(*folder / "broken.html",
                              "return [$('problem').hidden, $('problem').textContent, $('main').hidden];");
    EXPECT_FALSE(said[0].get<bool>());
    EXPECT_THAT(said[1].get<std::string>(), HasSubstr(sentence));
    EXPECT_TRUE(said[2].get<bool>());
  }
}

// In its style, in its recording, in its program: none of its own runs.
TEST_F(Page, SaysThatItIsCutOff) {
  const std::string good = read_file(file());
  const std::size_t begins = good.find("octet-stream\">") + 14;
  for (const std::size_t size : {good.find("</style>") - 100, begins + 5000, good.rfind("begin();")}) {
    write_file(*folder / "cut.html", good.substr(0, size));
    const Json said = in_page(*folder / "cut.html", "return document.body.innerText;");
    EXPECT_THAT(said.get<std::string>(),
                AllOf(HasSubstr("This page is cut off"), ::testing::Not(HasSubstr("reading"))))
        << size;
  }
  const Json over = in_page(file(), "const cut = " + Json(good.substr(0, begins + 5000)).dump() + R"(;
    await page.open(new File([cut], 'cut.html'));
    return $('problem').textContent;)");
  EXPECT_THAT(over.get<std::string>(), HasSubstr("cut off"));
}

TEST_F(Page, FitsAPhoneAndNamesEveryButton) {
  for (const int width : {360, 1400}) {
    const Json faults = in_page(file(), R"(
      const faults = [];
      const width = document.body.clientWidth;
      for (const part of document.body.querySelectorAll('header, main, footer, .stage, aside'))
        if (part.scrollWidth > part.clientWidth || part.getBoundingClientRect().right > width) faults.push(`too wide: ${part.className || part.tagName}`);
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

// As on the page of robosim serve, while the compiler's messages are shown.
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

// People look at these: a wide screen and a phone's, light and dark.
TEST_F(Page, IsPhotographed) {
  const std::filesystem::path pictures = ROBOSIM_PICTURES;
  for (const char* tab : {"plots", "pins", "serial", "events", "wiring"}) {
    for (const auto& [theme, width] : {std::pair{"light", 1400}, std::pair{"dark", 390}}) {
      const auto picture = pictures / (std::string(tab) + "-" + theme + "-" + std::to_string(width) + ".png");
      in_page(file().string() + "#t=2.6&tab=" + tab + "&theme=" + theme, "await drawn();", width, 900);
      browser().picture(picture);
      EXPECT_GT(std::filesystem::file_size(picture), 20'000u);
    }
  }
}

/// The share of two pictures' points that differ, of the whole where their sizes do. Letters' edges are drawn
/// a little otherwise by another version of the browser.
double difference(const std::filesystem::path& a, const std::filesystem::path& b) {
  browser().open("about:blank");
  const auto source = [](const std::filesystem::path& file) {
    return Json("data:image/png;base64," + base64(read_file(file))).dump();
  };
  return browser().run("const sources = [" + source(a) + ", " + source(b) + R"(];
    const points = async (src) => {
      const image = Object.assign(new Image(), { src });
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
      const ctx = canvas.getContext('2d');
      ctx.drawImage(image, 0, 0);
      return ctx.getImageData(0, 0, image.width, image.height);
    };
    const [one, other] = [await points(sources[0]), await points(sources[1])];
    if (one.width !== other.width || one.height !== other.height) return 1;
    let count = 0;
    for (let i = 0; i < one.data.length; i += 4)
      count += [0, 1, 2].some((k) => Math.abs(one.data[i + k] - other.data[i + k]) > 48);
    return count / (one.data.length / 4);)");
}

TEST_F(Page, IsInTheDocs) {
  const std::filesystem::path pictures = ROBOSIM_PICTURES;
  const auto run = [&](std::vector<std::string> words) {
    ASSERT_EQ(robosim_command(std::move(words), folder->path()).status, 0);
  };
  const auto picture = [&](const char* page, const char* name, int height) {
    browser().open("file://" + (*folder / page).string(), 1200, height);
    browser().run(
        "await until(() => document.documentElement.dataset.ready || !$('recording')); await drawn();");
    browser().picture(pictures / name);
    const std::filesystem::path kept = std::filesystem::path(ROBOSIM_DOCS_PICTURES) / name;
    if (std::getenv("ROBOSIM_WRITE_DOCS"))
      std::filesystem::copy_file(pictures / name, kept, std::filesystem::copy_options::overwrite_existing);
    EXPECT_LT(difference(pictures / name, kept), 0.02)
        << kept
        << " is not what the page looks like: ROBOSIM_WRITE_DOCS=1 ./robosim test --browser makes it anew";
  };
  run({"run", "PidFollower", "--map", "tight", "--record", "one.html"});
  run({"run", "PidFollower", "--map", "tight", "--seed", "2", "--record", "two.rec"});
  run({"replay", "one.html", "--over", "two.rec", "--record", "both.html"});
  run({"new", "MyFollower"});
  run({"sweep", "PidFollower", "./MyFollower", "--map", "tight", "--robot", "uno5", "--seeds", "1..30",
       "--csv", "runs.csv"});
  run({"report", "runs.csv"});
  picture("one.html#t=2.6&theme=light", "page.png", 760);
  picture("both.html#t=5&theme=light", "two-runs.png", 760);
  picture("report.html", "report.png", 860);
}

// A door, paint, bare floor, an obstacle that moves, a lamp: each where it is at the moment that is shown.
TEST_F(Page, DrawsAWorldThatChanges) {
  write_file(*folder / "changes.script",
             "at 1s door 5,8 5,10 shut for 1s\nat 1s obstacle 4,3 radius 40mm to 10,3 in 2s for 3s\n"
             "at 1s paint 4,6 9,6 for 1s\nat 2s light 1 off\n");
  std::string map = read_file(std::filesystem::path(ROBOSIM_MAPS) / "oval.map");
  map.insert(map.rfind("+++"),
             "[[light]]\nlevel = \"1 %\"\nat = [\"450 mm\", \"850 mm\"]\nheight = \"500 mm\"\n");
  write_file(*folder / "lit.map", map);
  const Ended ended = robosim_command({"run", "PidFollower", "--map", "lit.map", "--script", "changes.script",
                                       "--goal", "none", "--for", "5s", "--record", "changes.html"},
                                      folder->path());
  ASSERT_LE(ended.status, 1) << ended.err;
  const Json shown = in_page(*folder / "changes.html", R"(
    page.view.fit();
    const { cell, height } = page.run.floor;
    const colour = (t, x, y) => {
      page.player.seek(t);
      page.drawFloor();
      const [sx, sy] = page.view.toScreen(x, y), k = window.devicePixelRatio;
      return [...$('floor').getContext('2d').getImageData(Math.round(sx * k), Math.round(sy * k), 1, 1).data].slice(0, 3);
    };
    const at = (column, row) => [(column + 0.5) * cell, height - (row + 0.5) * cell];
    return { bare: colour(0.5, ...at(7, 6)), painted: colour(1.5, ...at(7, 6)), bareAgain: colour(2.5, ...at(7, 6)),
      open: colour(0.5, ...at(5, 9)), shut: colour(1.5, ...at(5, 9)), openAgain: colour(2.5, ...at(5, 9)),
      can: colour(1.001, ...at(4, 3)), left: colour(2, ...at(4, 3)), onItsWay: colour(2, ...at(7, 3)), there: colour(3.5, ...at(10, 3)), away: colour(4.5, ...at(10, 3)),
      lit: colour(1.5, 450, 850), dark: colour(2.5, 450, 850) };)");
  const Json floor = shown["bare"], brown = Json::array({0x8a, 0x4b, 0x08});
  EXPECT_LT(shown["painted"][0], 60);
  EXPECT_EQ(shown["bareAgain"], floor);
  EXPECT_EQ(shown["open"], floor);
  EXPECT_EQ(shown["shut"], brown);
  EXPECT_EQ(shown["openAgain"], floor);
  EXPECT_EQ(shown["can"], brown);
  EXPECT_EQ(shown["left"], floor);
  EXPECT_EQ(shown["onItsWay"], brown);
  EXPECT_EQ(shown["there"], brown);
  EXPECT_EQ(shown["away"], floor);
  EXPECT_EQ(shown["lit"], Json::array({0xf0, 0xc8, 0}));
  EXPECT_EQ(shown["dark"], floor);
}

}  // namespace
}  // namespace robosim::test
