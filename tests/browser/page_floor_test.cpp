// Tests how a recording's page (`robosim run --record run.html`) draws the floor, and what is on the floor.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/browser/page.h"

namespace robosim::test {
namespace page_floor_test {

using Json = nlohmann::json;

TEST_F(Page, DrawsTheFloorWhereTheSimulationHasIt) {
  // Samples the middle of each stripe, and points 3 mm inside and outside its edges. The robot is elsewhere.
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

// Paint beyond the floor's edge is clipped: only the floor's outline is drawn there.
TEST_F(Page, EndsTheFloorAtItsEdge) {
  std::string map = read_file(std::filesystem::path(ROBOSIM_MAPS) / "oval.map");
  map.insert(map.rfind("+++"),
             "[[area]]\ncolour = \"red\"\nat = [\"0 mm\", \"0 mm\"]\nradius = \"150 mm\"\n"
             "[[surface]]\nkind = \"wet\"\nat = [\"0 mm\", \"600 mm\"]\nradius = \"150 mm\"\n");
  write_file(*folder / "edge.map", map);
  const Ended ended = robosim_command(
      {"run", "PidFollower", "--map", "edge.map", "--goal", "none", "--for", "1s", "--record", "edge.html"},
      folder->path());
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json shown = in_page(*folder / "edge.html", R"(
    page.setTheme('light');
    const { width, height } = page.run.floor, ratio = devicePixelRatio;
    page.view.fit();
    page.view.zoom(0.8);
    page.drawFloor();
    const colour = (x, y) => {
      const [sx, sy] = page.view.toScreen(x, y);
      return [...$('floor').getContext('2d').getImageData(Math.round(sx * ratio), Math.round(sy * ratio), 1, 1).data].join();
    };
    const px = 1 / page.view.scale;
    return { red: colour(60, 60), wet: colour(60, 600), floor: colour(width / 2, height / 2), background: colour(width / 2, height + 60),
      outside: [[-60, 60], [60, -60], [-60, 600]].map(([x, y]) => colour(x, y)),
      edges: [[-px, height / 3], [width + px, height / 3], [width / 3, -px], [width / 3, height + px]].map(([x, y]) => colour(x, y)) };)");
  EXPECT_NE(shown["red"], shown["floor"]) << shown;
  EXPECT_NE(shown["wet"], shown["floor"]) << shown;
  for (const Json& beyond : shown["outside"]) EXPECT_EQ(beyond, shown["background"]) << shown;
  for (const Json& edge : shown["edges"]) {
    EXPECT_NE(edge, shown["background"]) << "a robot collides there, so an edge is drawn: " << shown;
    EXPECT_NE(edge, shown["floor"]) << shown;
  }
}

// A door, paint, bare floor, a moving obstacle and a lamp are drawn as they are at the displayed moment.
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

TEST_F(Page, DrawsTheGraphThatTheSketchTellsAsItGrows) {
  write_file(*folder / "scan.script", "at 1s press start 100ms\n");
  const Ended ended = robosim_command({"run", "AiNavigator", "--map", "b", "--goal", "none", "--for", "60s",
                                       "--script", "scan.script", "--record", "scan.html"},
                                      folder->path());
  ASSERT_EQ(ended.status, 0) << ended.err;
  // A node is drawn in the graph's colour only after the sketch reported the node.
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
  EXPECT_EQ(shown["named"], shown["stations"]) << "each station is at its position";
  EXPECT_EQ(shown["nodes"], 6);
  EXPECT_EQ(shown["edges"], Json::parse("[[0,1],[1,2],[2,3],[2,4],[1,5]]"));
  EXPECT_EQ(shown["before"], Json::parse("[false,false,false,false,false,false]"));
  EXPECT_EQ(shown["after"], Json::parse("[true,true,true,true,true,true]"));
}

// Redrawing an hour's laps at each moment would take a browser many seconds.
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
  EXPECT_GT(strokes["moved"], 2'000) << "the last two minutes are drawn";
  EXPECT_LT(strokes["moved"], 26'000);
  EXPECT_LT(strokes["zoomed"], 40'000);
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

}  // namespace page_floor_test
}  // namespace robosim::test
