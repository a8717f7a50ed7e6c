// Tests the page of `robosim serve` in a browser: builds, runs and controls sketches of a user's folder.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/browser/driver.h"

namespace robosim::test {
namespace serve_test {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using Json = nlohmann::json;

// Waits until a run is displayed and no work is in progress.
constexpr const char* kShown =
    "const shown = () => $('replay').contentWindow?.robosim;"
    "const ready = () => until(() => !$('replay').hidden && shown()?.touchable && $('stop').hidden && "
    "!$('state').textContent);";

class Serve : public ::testing::Test {
 protected:
  void SetUp() override {
    ROBOSIM_NEEDS_BROWSER();
    folder_.write("Echo/Echo.ino",
                  "void setup() { Serial.begin(115200); Serial.println(\"ready\"); }\n"
                  "void loop() { if (Serial.available()) Serial.write(Serial.read()); }\n");
    folder_.write("Broken/Broken.ino", "void setup() { oops }\nvoid loop() {}\n");
    server_.emplace(std::vector<std::string>{ROBOSIM_COMMAND, "serve", folder_.path().string()}, "Open ");
  }
  Json in_page(const std::string& where, const std::string& body) {
    browser().open(server_->where() + "#" + where);
    return browser().run(kShown + body);
  }

  Folder folder_;
  std::optional<Started> server_;
};

TEST_F(Serve, RunsASketchAndActsAtTheMomentThatIsShown) {
  const Json seen = in_page("sketch=PidFollower&map=oval&robot=uno5&run=1", R"(
    await ready();
    const before = shown().run;
    shown().player.seek(2);
    $('hand').value = 'obstacle';
    const [x, y] = shown().view.toScreen(1250, 1450);
    const floor = $('replay').contentDocument.getElementById('floor');
    const box = floor.getBoundingClientRect();
    for (const kind of ['pointerdown', 'click'])
      floor.dispatchEvent(new PointerEvent(kind, { clientX: box.left + x, clientY: box.top + y, bubbles: true }));
    await until(() => shown() && shown().run !== before);
    await ready();
    return { verdict: before.result.verdict, script: $('script').value, now: shown().run.result.verdict,
      same: before.columns.x_mm.slice(0, 200).every((value, i) => value === shown().run.columns.x_mm[i]),
      at: shown().player.t, put: shown().run.changes.map(({ disc, from }) => [...disc, 1000 * from].map(Math.round)) };)");
  EXPECT_EQ(seen["verdict"], "reached");
  EXPECT_EQ(seen["script"], "at 2000ms obstacle 12,2\n");
  EXPECT_EQ(seen["now"], "stuck");
  EXPECT_EQ(seen["put"], Json::parse("[[1250, 1450, 33, 2000]]")) << "drawn at its position";
  EXPECT_EQ(seen["same"], true) << "the run is unchanged before that moment";
  EXPECT_GE(seen["at"], 2.0);
  browser().picture(std::filesystem::path(ROBOSIM_PICTURES) / "serve.png");
}

TEST_F(Serve, SendsTextsToASketchOfTheFolder) {
  const Json lines = in_page("sketch=./Echo&map=oval&seconds=3&run=1", R"(
    await ready();
    const before = shown().run;
    shown().player.seek(1);
    $('text').value = 'say "hi"';
    $('send').requestSubmit();
    await until(() => shown() && shown().run !== before);
    await ready();
    return shown().run.lines.map((line) => line.text.trim());)");
  EXPECT_THAT(lines, Contains("ready"));
  EXPECT_THAT(lines, Contains("say \"hi\""));
}

// Runs faster than real time, so that the test does not wait.
TEST_F(Serve, WatchesARunWhileItRuns) {
  const Json seen = in_page("sketch=./Echo&map=oval&robot=uno5&seconds=3000&live=1", R"(
    await until(() => shown()?.run.live && shown().player.playing);
    const { run, player } = shown(), now = () => run.duration, atOnce = window.fetch;
    let late = 0;  // ms by which every other request is delayed: requests must stay in order
    window.fetch = async (path, ...more) => {
      if (path.startsWith('/api/live/')) await new Promise((r) => setTimeout(r, late = 40 - late));
      return atOnce(path, ...more);
    };
    player.pause();
    let stood = now();
    player.step(60000);  // the run may have continued before it paused
    await until(() => now() - stood >= 60);
    stood = now();
    player.step(250);
    await until(() => now() > stood);
    const stepped = Math.round(1000 * (now() - stood));
    $('text').value = 'hello';
    $('send').requestSubmit();
    [...$('buttons').children].find((b) => b.textContent === 'press start').click();
    await until(() => $('script').value.includes('press start') && $('script').value.includes('hello'));
    player.step(100);
    await until(() => run.lines.some((line) => line.text === 'hello'));
    const pressed = run.reading('start', now());
    player.setSpeed(64);
    player.step(1);
    player.play();
    await until(() => now() - stood > 5);
    const moved = run.t.length;
    $('stop').click();
    await ready();
    return { stepped, lines: run.lines.map((line) => line.text), pressed, moved, script: $('script').value,
      verdict: shown().run.result.verdict, kept: shown().run.lines.map((line) => line.text), until: shown().run.duration - now() };)");
  EXPECT_EQ(seen["stepped"], 250) << seen.dump();
  EXPECT_EQ(seen["lines"], Json::parse(R"(["ready", "hello"])"));
  EXPECT_EQ(seen["pressed"], 1);
  EXPECT_GT(seen["moved"], 500);
  EXPECT_THAT(seen["script"].get<std::string>(), HasSubstr("ms press start for 200ms\n"));
  EXPECT_EQ(seen["verdict"], "interrupted");
  EXPECT_EQ(seen["kept"], seen["lines"]) << "the run's recording is displayed at the end";
}

// Runs two robots from a file, PidFollower and Echo, on one line. Sends a text to the second robot, first in
// a recorded run, and then in a live run.
TEST_F(Serve, RunsSeveralRobotsAndActsOnTheOneThatIsLookedAt) {
  folder_.write("two.toml",
                "map = \"oval\"\n[[agent]]\nname = \"A\"\nsketch = \"PidFollower\"\ngoal = \"none\"\n"
                "[[agent]]\nname = \"B\"\nsketch = \"./Echo\"\ngoal = \"none\"\nstart = \"20,2,W\"\n");
  const Json seen = in_page("sketch=./two.toml&robot=uno5&seconds=4&run=1", R"(
    await ready();
    const before = shown().runs;
    shown().player.seek(2);
    shown().chooser.choose(1);
    const own = $('script').value;
    $('text').value = 'hello';
    $('send').requestSubmit();
    await until(() => shown() && shown().runs !== before);
    await ready();
    const again = shown().runs;
    shown().chooser.choose(1);
    return { names: before.map((run) => run.name), own, script: $('script').value, whose: $('whose').textContent,
      lines: again.map((run) => run.lines.map((line) => line.text.trim())), looked: $('replay').contentDocument.getElementById('title').textContent };)");
  EXPECT_EQ(seen["names"], Json::parse(R"(["A", "B"])"));
  EXPECT_EQ(seen["own"], "");
  EXPECT_EQ(seen["whose"], " of B");
  EXPECT_EQ(seen["script"], "at 2000ms send \"hello\\n\"\n");
  EXPECT_EQ(seen["lines"][1], Json::parse(R"(["ready", "hello"])"));
  EXPECT_EQ(seen["looked"], "B: ./Echo");
  browser().picture(std::filesystem::path(ROBOSIM_PICTURES) / "serve_fleet.png");

  const Json live = in_page("sketch=./two.toml&robot=uno5&seconds=3000&live=1", R"(
    await until(() => shown()?.run.live && shown().player.playing);
    const { runs, player } = shown(), now = () => shown().run.duration;
    await until(() => now() > 0.4);
    shown().chooser.choose(1);
    $('text').value = 'hello';
    $('send').requestSubmit();
    await until(() => $('script').value.includes('hello'));
    await until(() => runs[1].lines.some((line) => line.text === 'hello'));
    const drawn = runs.map((run) => run.pose(now()));
    shown().player.pause();
    await until(() => !shown().player.playing);
    shown().redraw();
    return { lines: runs.map((run) => run.lines.map((line) => line.text)), apart: Math.hypot(drawn[0].x - drawn[1].x, drawn[0].y - drawn[1].y),
      driven: Math.hypot(drawn[0].x - runs[0].columns.x_mm[0], drawn[0].y - runs[0].columns.y_mm[0]), script: $('script').value };)");
  EXPECT_EQ(live["lines"][1], Json::parse(R"(["ready", "hello"])")) << live.dump();
  EXPECT_EQ(live["lines"][0].size(), 0u) << live.dump();
  EXPECT_GT(live["apart"], 200.0);
  EXPECT_GT(live["driven"], 5.0);
  EXPECT_THAT(live["script"].get<std::string>(), HasSubstr("ms send \"hello\\n\"\n"));
  browser().picture(std::filesystem::path(ROBOSIM_PICTURES) / "serve_fleet_live.png");
}

TEST_F(Serve, DrawsAMapAndKeepsItAndAFileThatIsDropped) {
  const Json seen = in_page("sketch=./Echo", R"(
    await until(() => document.documentElement.dataset.ready);
    const said = (is) => until(() => is($('map-said').textContent));
    $('edit').click();
    await until(() => $('map-text').value);
    const opened = $('map-name').value;
    $('map-new').click();
    await until(() => $('map-name').value === 'my.map');
    $('map-text').value = $('map-text').value.replace('corner', 'corners');
    $('map-text').onchange();
    await said((text) => text.includes('corners'));
    const broken = $('map-said').textContent;
    $('map-undo').click();
    const undone = !$('map-text').value.includes('corners');
    $('map-text').value = $('map-text').value.replace(/^\+\+\+\n_+\n____/m, '[legend]\n3 = "wet"\n$&').replace(/(\n_+\n)____(_{16}\n)/, '$1___3$2');
    $('map-text').onchange();
    await said((text) => !text);
    const key = (name, more = {}) => $('sheet').dispatchEvent(new KeyboardEvent('keydown', { key: name, bubbles: true, ...more }));
    key(' ');
    for (const [to, times] of [['Right', 9], ['Down', 5], ['Left', 9], ['Up', 5]])
      for (let i = 0; i < times; i++) key(`Arrow${to}`, { shiftKey: true });
    key('5');
    key(' ');
    $('tool').value = 'path';
    $('sheet').setPointerCapture = () => {};
    const { left, top } = $('sheet').getBoundingClientRect(), scale = Math.min(($('sheet').clientWidth - 16) / 2000, ($('sheet').clientHeight - 16) / 1200);
    for (const [x, y] of [[1300, 300], [1600, 300], [1600, 700], [1300, 700], [1300, 300]])
      for (const kind of ['pointerdown', 'pointerup'])
        $('sheet').dispatchEvent(new PointerEvent(kind, { clientX: left + 8 + x * scale, clientY: top + 8 + (1200 - y) * scale, pointerId: 1 }));
    $('map-name').value = 'my';
    $('map-save').click();
    await said((text) => text.startsWith('saved'));
    $('map-save').click();
    await until(() => !$('map-replace').hidden);
    const files = new DataTransfer();
    files.items.add(new File(['void setup() {}\nvoid loop() {}\n'], 'Dropped.ino'));
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: files, bubbles: true }));
    await until(() => $('sketch').value === './Dropped');
    const image = new DataTransfer();
    image.items.add(new File([':00000001FF\n'], 'Image.hex'));
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: image, bubbles: true }));
    await until(() => $('sketch').value === './Image.hex');
    const own = $('target').disabled && $('target').selectedOptions[0].text === 'its own chip';
    image.items.clear();
    image.items.add(new File(['no program'], 'Wrong.elf'));
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: image, bubbles: true }));
    await until(() => $('said').textContent);
    return { opened, undone, own, wrong: $('said').textContent, broken, text: $('map-text').value, map: $('map').value, sketches: [...$('sketch').options].map((o) => o.value) };)");
  EXPECT_THAT(seen["broken"].get<std::string>(), HasSubstr("my.map:3"));
  EXPECT_EQ(seen["undone"], true) << "typed text is undone, too";
  EXPECT_EQ(seen["opened"], "my-oval.map") << "the run's map, as nothing else is chosen";
  EXPECT_EQ(seen["map"], "./my.map") << "the name gets its ending";
  EXPECT_THAT(seen["text"].get<std::string>(), AllOf(HasSubstr("[legend]\n4 = \"wet line\"\n3 = \"wet\"\n"),
                                                     HasSubstr("\n_S.4......._________\n")))
      << "a line through a puddle";
  EXPECT_EQ(seen["own"], true) << "an image is for its own chip";
  EXPECT_EQ(
      seen["wrong"],
      "Wrong.elf: expected a program for a chip that Robosim knows (an AVR or an ARM microcontroller)\n");
  EXPECT_EQ(read_file(folder_ / "Image.hex"), ":00000001FF\n");
  EXPECT_THAT(seen["sketches"], Contains("./Dropped"));
  EXPECT_EQ(read_file(folder_ / "my.map"), seen["text"].get<std::string>());
  const Json checked = Json::parse(robosim_command({"map", "check", "my.map", "--json"}, folder_.path()).out);
  EXPECT_EQ(checked["paths"][0]["closed"], true) << checked.dump();
  EXPECT_NEAR(checked["paths"][0]["smallest_radius_m"].get<double>(), 0.2, 0.001);
  browser().picture(std::filesystem::path(ROBOSIM_PICTURES) / "editor.png");
}

TEST_F(Serve, KeepsSayingThatAMapIsSavedWhenAnAnswerAboutItsFloorComesLate) {
  const Json seen = in_page("sketch=./Echo", R"(
    await until(() => document.documentElement.dataset.ready);
    $('edit').click();
    await until(() => $('map-text').value);
    $('map-new').click();
    await until(() => $('sheet').ariaBusy === 'false');
    const atOnce = window.fetch, late = [];
    window.fetch = async (path, ...more) => {
      const answer = await atOnce(path, ...more);
      if (path === '/api/floor') await new Promise((r) => late.push(r));
      return answer;
    };
    $('sheet').dispatchEvent(new KeyboardEvent('keydown', { key: ' ', bubbles: true }));
    $('map-save').click();
    await until(() => $('map-said').textContent && late.length);
    const before = $('map-said').textContent;
    late.pop()();
    await drawn();
    return [before, $('map-said').textContent];)");
  EXPECT_EQ(seen, Json::parse(R"(["saved as my.map","saved as my.map"])"));
}

TEST_F(Serve, ZoomsIntoTheMapThatIsEdited) {
  const Json seen = in_page("sketch=./Echo", R"(
    await until(() => document.documentElement.dataset.ready);
    const sheet = $('sheet'), cells = () => $('map-text').value.split('\n').slice(4);
    $('edit').click();
    await until(() => $('map-text').value);
    $('map-new').click();
    await until(() => sheet.ariaBusy === 'false');
    await drawn();
    sheet.setPointerCapture = () => {};
    $('tool').value = 'wall';
    const box = sheet.getBoundingClientRect(), pitch = Math.min((sheet.clientWidth - 16) / 20, (sheet.clientHeight - 16) / 12);
    const px = 8 + 6.5 * pitch, py = 8 + 4.5 * pitch;  // in the middle of a cell
    const press = (dx, dy) => {
      for (const kind of ['pointerdown', 'pointerup'])
        sheet.dispatchEvent(new PointerEvent(kind, { clientX: box.left + px + dx * pitch, clientY: box.top + py + dy * pitch, pointerId: 1 }));
    };
    const put = () => cells().flatMap((row, y) => [...row].flatMap((c, x) => (c === '#' ? [[x, y]] : [])));
    const dark = (dx, dy) => {
      const ratio = sheet.width / sheet.clientWidth;
      return sheet.getContext('2d').getImageData(Math.round((px + dx * pitch) * ratio), Math.round((py + dy * pitch) * ratio), 1, 1).data[0] < 180;
    };
    const places = [[0, 0], [1.4, 1.4], [-1.4, -1.4], [4, -4], [2.6, 0]];
    const isDrawn = () => until(() => dark(...places[0]) && dark(...places[3]));
    const walls = [];
    sheet.dispatchEvent(new WheelEvent('wheel', { deltaY: -Math.log(4) / 0.0015, clientX: box.left + px, clientY: box.top + py, cancelable: true }));
    press(0, 0);
    press(1.4, 1.4);  // the same cell, at four times the size
    walls.push(put());
    press(4, -4);
    walls.push(put());
    await isDrawn();
    const seen = places.map((place) => dark(...place));
    const key = (name) => sheet.dispatchEvent(new KeyboardEvent('keydown', { key: name, bubbles: true }));
    key('0');  // shows the whole map again
    press(2, 0);
    walls.push(put());
    key('+');
    for (let i = 0; i < 30; i++) key('-');  // does not zoom out further
    press(3, 0);
    walls.push(put());
    return { walls, seen };)");
  EXPECT_EQ(seen["walls"][0], Json::parse("[[6,4]]")) << "the cell under the pointer stays there";
  EXPECT_EQ(seen["walls"][1], Json::parse("[[7,3],[6,4]]"));
  EXPECT_EQ(seen["seen"], Json::parse("[true,true,true,true,false]")) << "drawn where the mouse was pressed";
  EXPECT_EQ(seen["walls"][2], Json::parse("[[7,3],[6,4],[8,4]]"));
  EXPECT_EQ(seen["walls"][3], Json::parse("[[7,3],[6,4],[8,4],[9,4]]"));
}

TEST_F(Serve, ShowsWhatTheCompilerSays) {
  const Json said = in_page("sketch=./Broken&run=1",
                            "await until(() => $('said').textContent); return $('said').textContent;");
  EXPECT_THAT(said.get<std::string>(), HasSubstr("Broken.ino:1:16: error: 'oops' was not declared"));
}

// A link with an unknown or invalid part runs nothing at all.
TEST_F(Serve, RunsNothingElseThanALinkAsksFor) {
  for (const auto& [link, sentence] :
       {std::pair{"sketch=./Nobody&map=oval&run=1",
                  "Unknown sketch in the link: expected one in this folder or one that comes with Robosim, "
                  "got ./Nobody."},
        std::pair{"sketch=./Echo&map=./nowhere.map&run=1", "got ./nowhere.map."},
        std::pair{"sketch=./Echo&robot=uno7&live=1", "got uno7."},
        std::pair{"skech=./Echo&run=1", "Unknown key skech in the link"},
        std::pair{"sketch=./Echo&seed=soon&run=1", "Invalid seed in the link: soon."}}) {
    const Json seen = in_page(link,
                              "await until(() => document.documentElement.dataset.ready); return "
                              "[$('said').textContent, $('replay').hidden, $('stop').hidden];");
    EXPECT_THAT(seen[0].get<std::string>(), HasSubstr(sentence));
    EXPECT_EQ(seen[1], true) << link;
    EXPECT_EQ(seen[2], true) << link;
  }
  const Json begun =
      in_page("sketch=./Echo",
              "await until(() => document.documentElement.dataset.ready); return $('sketch').value;");
  EXPECT_EQ(begun, "./Echo");
  std::filesystem::rename(folder_ / "Echo", folder_ / "Renamed");
  const Json gone = browser().run(
      "$('run').click(); await until(() => $('said').textContent); return [$('said').textContent, "
      "$('replay').hidden];");
  EXPECT_EQ(gone[0], "The sketch ./Echo is no longer in the folder: choose another.\n");
  EXPECT_EQ(gone[1], true);
}

TEST_F(Serve, SaysThatItsServerIsGone) {
  const Json state =
      in_page("sketch=./Echo", R"(await until(() => document.documentElement.dataset.ready); return 1;)");
  EXPECT_EQ(state, 1);
  EXPECT_TRUE(server_->end().ok());
  // The message appears for users who only watch, and for users who start a run.
  for (const char* deed : {"", "$('state').textContent = ''; $('run').click();"})
    EXPECT_THAT(
        browser()
            .run(std::string(deed) + "await until(() => $('state').textContent.includes('has stopped')); "
                                     "return $('state').textContent;")
            .get<std::string>(),
        HasSubstr("start robosim serve again"));
}

}  // namespace serve_test
}  // namespace robosim::test
