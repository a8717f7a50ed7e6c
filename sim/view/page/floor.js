// Draws the floor: the map's geometry, the trail, and the robot with wheels and sensors.

import { drawBody, drawRobot } from './bodies.js';
import { drawMark, more, series, style } from './colours.js';
import { extent, indexAt, isLit, placeOf } from './run.js';
import { sized } from './view.js';

const rectangles = (list) => {
  const path = new Path2D();
  for (const [x, y, width, height] of list) path.rect(x, y, width, height);
  return path;
};

export function areaOf(runs) {
  const { floor } = runs[0];
  if (floor) return { x: 0, y: 0, width: floor.width, height: floor.height };
  const xs = runs.flatMap((r) => [...r.columns.x_mm]), ys = runs.flatMap((r) => [...r.columns.y_mm]);
  const least = (v) => v.reduce((a, b) => Math.min(a, b), Infinity), most = (v) => v.reduce((a, b) => Math.max(a, b), -Infinity);
  const x = least(xs) - 150, y = least(ys) - 150;
  return { x, y, width: most(xs) + 150 - x, height: most(ys) + 150 - y };
}

// In a run with more samples than LONG, draws the last LATELY samples as the trail. The other samples become
// a thin line.
const LONG = 30_000, LATELY = 12_000;
// With more robots than CROWD, draws the other robots' trails for the last CROWD_S seconds only.
const CROWD = 12, CROWD_S = 3;

/** Returns the colour of a robot that is not selected. */
const colourOf = ({ number }) => series(1 + number % 7);

export class FloorPicture {
  /** If the floor has a picture, `whenLoaded` is called when the picture can be drawn. */
  constructor(canvas, runs, whenLoaded) {
    this.canvas = canvas;
    this.runs = runs;
    const run = this.run = runs[0];
    this.colourBy = 'speed_mm_s';
    const { floor } = run;
    if (!floor) return;
    this.walls = rectangles(floor.walls);
    this.dark = rectangles(floor.dark);
    if (floor.picture) {
      this.picture = new Image();
      this.picture.onload = whenLoaded;
      this.picture.src = `data:image/png;base64,${floor.picture.png}`;
    }
    this.lines = [];  // paths, each with one width, colour and wear
    this.unseen = new Path2D();
    for (const { line: [x, y, toX, toY], arc, painted = true, width = floor.line, colour, worn = 0 } of floor.stripes) {
      const pen = this.lines.at(-1);
      if (pen?.width !== width || pen.colour !== colour || pen.worn !== worn) this.lines.push({ path: new Path2D(), width, colour, worn });
      const path = painted ? this.lines.at(-1).path : this.unseen;
      path.moveTo(x, y);
      if (arc) path.arc(arc[0], arc[1], arc[2], Math.atan2(y - arc[1], x - arc[0]), Math.atan2(toY - arc[1], toX - arc[0]));
      else path.lineTo(toX, toY);
    }
    this.marks = new Path2D();
    for (const [x, y, toX, toY, width] of floor.marks ?? []) {
      const length = Math.hypot(toX - x, toY - y), acrossX = (toY - y) / length * width / 2, acrossY = (x - toX) / length * width / 2;
      this.marks.moveTo(x + acrossX, y + acrossY);
      this.marks.lineTo(toX + acrossX, toY + acrossY);
      this.marks.lineTo(toX - acrossX, toY - acrossY);
      this.marks.lineTo(x - acrossX, y - acrossY);
      this.marks.closePath();
    }
  }

  /** Returns the value at the end of the colour scale. */
  get most() {
    const values = this.run.columns[this.colourBy];
    if (!values) return 1;
    const { least, most } = extent(values);
    return Math.max(most, -least, 1e-9);
  }

  draw(view, t, other, otherT) {
    const ctx = sized(this.canvas);
    this.ctx = ctx;
    this.view = view;
    ctx.save();
    ctx.translate(view.width / 2, view.height / 2);
    ctx.scale(view.scale, -view.scale);
    ctx.translate(-view.x, -view.y);
    this.px = 1 / view.scale;  // size of a pixel, mm
    if (this.run.floor) this.drawFloor(this.run.floor);
    this.drawChanges(t);
    if (this.run.floor) this.drawLights(this.run.floor, t);
    if (other) this.drawOther(other, otherT, style('other'));
    const since = this.runs.length > CROWD ? t - CROWD_S : 0;
    for (const peer of this.peers) this.drawOther(peer, t, colourOf(peer), since);
    this.drawTrail(t);
    ctx.restore();
    this.drawTold(t);
    this.drawStations(t);
    this.drawCollisions(t);
    ctx.save();
    ctx.translate(view.width / 2, view.height / 2);
    ctx.scale(view.scale, -view.scale);
    ctx.translate(-view.x, -view.y);
    if (other) drawBody(ctx, this.px, other.pose(otherT), this.run.robot, style('other'));
    for (const peer of this.peers) drawBody(ctx, this.px, peer.pose(t), peer.robot, colourOf(peer));
    drawRobot(ctx, this.px, this.run, t);
    ctx.restore();
    this.drawNames(t);
    this.drawScale();
  }

  drawFloor(floor) {
    const { ctx } = this;
    const [paper, paint] = floor.light_line ? ['line', 'paper'] : ['paper', 'line'];
    ctx.fillStyle = style(paper);
    ctx.fillRect(0, 0, floor.width, floor.height);
    if (this.picture?.complete) {
      const { width, height } = floor.picture;
      ctx.save();
      ctx.scale(1, -1);
      ctx.drawImage(this.picture, 0, -height, width, height);
      ctx.restore();
    }
    ctx.fillStyle = style('wall');
    ctx.fill(this.walls);
    ctx.fillStyle = ctx.strokeStyle = style(paint);
    ctx.fill(this.dark);
    this.drawAreas(floor, false);
    ctx.fillStyle = style(paint);
    ctx.lineCap = ctx.lineJoin = 'round';  // as in the simulation, which paints half a width around the path
    for (const { path, width, colour = style(paint), worn } of this.lines) {
      ctx.lineWidth = width;
      ctx.strokeStyle = colour;
      ctx.globalAlpha = 1 - worn;
      ctx.stroke(path);
    }
    ctx.globalAlpha = 1;
    ctx.fill(this.marks);
    this.drawAreas(floor, true);
    ctx.save();
    ctx.lineCap = 'butt';
    ctx.lineWidth = floor.line / 8;
    ctx.setLineDash([floor.line / 2, floor.line / 2]);
    ctx.strokeStyle = style('wall');
    ctx.stroke(this.unseen);
    ctx.restore();
    ctx.fillStyle = '#8a4b08';
    for (const [x, y] of floor.obstacles) ctx.fillRect(x - 0.35 * floor.cell, y - 0.35 * floor.cell, 0.7 * floor.cell, 0.7 * floor.cell);
    ctx.strokeStyle = style('wall');  // everything outside is wall
    ctx.lineWidth = 2 * this.px;
    ctx.strokeRect(-this.px, -this.px, floor.width + 2 * this.px, floor.height + 2 * this.px);
  }

  drawAreas(floor, overLines) {
    const { ctx } = this;
    ctx.save();
    ctx.beginPath();
    ctx.rect(0, 0, floor.width, floor.height);
    ctx.clip();
    for (const { colour, disc, corners, over_lines = false } of floor.areas ?? []) {
      if (over_lines !== overLines) continue;
      const path = new Path2D();
      if (disc) path.arc(disc[0], disc[1], disc[2], 0, 2 * Math.PI);
      else for (const [x, y] of corners) path.lineTo(x, y);
      ctx.fillStyle = colour;
      ctx.fill(path);
    }
    ctx.restore();
  }

  /** Calls visit(from, to) for each segment to draw until t, with the indices of the segment's two samples.
   *  Begins at index `first`. Skips samples that are less than a pixel apart. Returns the coordinates of the
   *  last segment, which ends at the pose at t. */
  walk(run, t, visit, first = 0) {
    const { x_mm: x, y_mm: y } = run.columns;
    const last = indexAt(run.t, t);
    let at = first;
    for (let i = first + 1; i <= last; i++) {
      const carried = run.carried(i - 1);
      if (!carried && i < last && Math.abs(x[i] - x[at]) + Math.abs(y[i] - y[at]) < this.px) continue;
      visit(carried ? i : at, i);
      at = i;
    }
    const now = run.pose(t);
    return [x[at], y[at], now.x, now.y];
  }

  /** Returns the index of the trail's first sample. */
  trailBegins(run, t) { return run.t.length > LONG ? Math.max(indexAt(run.t, t) - LATELY, 0) : 0; }

  /** Returns the path of a long run. Each place is drawn only once, because an hour of laps would take
   *  seconds to paint. */
  wholeTrail() {
    const { run, px } = this;
    const { x_mm: x, y_mm: y } = run.columns;
    const key = `${px} ${run.t.length >> 12}`;
    if (this.whole?.key === key) return this.whole.path;
    const path = new Path2D(), seen = new Set(), cell = 2 * px;
    this.walk(run, run.duration, (a, b) => {
      const place = Math.floor(x[b] / cell) * 1e6 + Math.floor(y[b] / cell);
      if (seen.has(place)) return;
      seen.add(place);
      path.moveTo(x[a], y[a]);
      path.lineTo(x[b], y[b]);
    });
    this.whole = { key, path };
    return path;
  }

  drawTrail(t) {
    const { ctx, run, px } = this;
    const { x_mm: x, y_mm: y } = run.columns;
    const values = run.columns[this.colourBy], most = this.most;
    const bins = Array.from({ length: 24 }, () => new Path2D());
    const all = new Path2D();
    const ahead = run.t.length > LONG ? this.wholeTrail() : new Path2D();
    if (run.t.length <= LONG)
      this.walk(run, run.duration, (a, b) => {
        if (run.t[b] < t) return;
        ahead.moveTo(x[a], y[a]);
        ahead.lineTo(x[b], y[b]);
      });
    const bin = (i) => bins[values ? Math.min(Math.floor(Math.abs(values[i]) / most * 24), 23) : 0];
    const [fromX, fromY, toX, toY] = this.walk(run, t, (a, b) => {
      for (const path of [all, bin(b)]) { path.moveTo(x[a], y[a]); path.lineTo(x[b], y[b]); }
    }, this.trailBegins(run, t));
    for (const path of [all, bin(indexAt(run.t, t))]) { path.moveTo(fromX, fromY); path.lineTo(toX, toY); }
    const width = Math.max(Math.min(run.floor ? 0.4 * run.floor.line : 6, 6 * px), 2.5 * px);
    ctx.lineCap = ctx.lineJoin = 'round';
    ctx.lineWidth = 1.2 * px;
    ctx.strokeStyle = style('ahead');
    ctx.stroke(ahead);
    ctx.lineWidth = 1.8 * width;
    ctx.strokeStyle = style('casing');
    ctx.stroke(all);
    ctx.lineWidth = width;
    bins.forEach((path, i) => {
      ctx.strokeStyle = more((i + 0.5) / 24);
      ctx.stroke(path);
    });
  }

  /** Returns all robots except the selected one. */
  get peers() { return this.runs.filter((run) => run !== this.run); }

  /** Shows another robot's sensors, trail and graph. */
  lookAt(run) {
    this.run = run;
    this.whole = null;
  }

  drawNames(t) {
    if (this.runs.length < 2) return;
    const { ctx, view } = this;
    ctx.font = '600 12px system-ui, sans-serif';
    ctx.textAlign = 'left';
    ctx.textBaseline = 'middle';
    ctx.lineWidth = 3;
    ctx.lineJoin = 'round';
    ctx.strokeStyle = style('panel');
    for (const run of this.runs) {
      const { x, y } = run.pose(t), [px, py] = view.toScreen(x, y);
      const aside = 8 + 0.5 * (run.robot?.track ?? 80) * view.scale;
      ctx.fillStyle = run === this.run ? style('robot') : colourOf(run);
      ctx.strokeText(run.name, px + aside, py - aside);
      ctx.fillText(run.name, px + aside, py - aside);
    }
  }

  drawOther(other, t, colour, since = 0) {
    const { ctx, px } = this;
    const { x_mm: x, y_mm: y } = other.columns;
    const path = new Path2D();
    const first = Math.max(this.trailBegins(other, t), since > 0 ? indexAt(other.t, since) : 0);
    this.walk(other, t, (a, b) => { path.moveTo(x[a], y[a]); path.lineTo(x[b], y[b]); }, first);
    ctx.lineCap = 'round';
    ctx.lineWidth = 5 * px;
    ctx.strokeStyle = style('casing');
    ctx.stroke(path);
    ctx.lineWidth = 2.5 * px;
    ctx.strokeStyle = colour;
    ctx.stroke(path);
  }

  /** Draws the graph that the sketch has reported until t. */
  drawTold(t) {
    const { ctx, view } = this, { nodes = [], edges = [] } = this.run.told ?? {};
    const at = (node) => view.toScreen(node.x, node.y);
    ctx.save();
    ctx.strokeStyle = ctx.fillStyle = style('told');
    ctx.lineWidth = 4;
    ctx.setLineDash([2, 6]);
    ctx.lineCap = 'round';
    for (const { t: since, a, b } of edges) {
      if (since > t) continue;
      ctx.beginPath();
      ctx.moveTo(...at(nodes[a]));
      ctx.lineTo(...at(nodes[b]));
      ctx.stroke();
    }
    ctx.setLineDash([]);
    for (const node of nodes) {
      if (node.t > t) continue;
      ctx.beginPath();
      ctx.arc(...at(node), node.name ? 15 : 8, 0, 2 * Math.PI);
      ctx.stroke();
    }
    ctx.restore();
  }

  drawStations(t) {
    const { ctx, run, view } = this;
    if (!run.floor) return;
    const { cell, height } = run.floor;
    const robots = this.runs.map((one) => ({ ...one.pose(t), size: Math.max(...(one.robot?.outline ?? []).map(([x, y]) => Math.hypot(x, y)), 0) }));
    ctx.font = '600 12px system-ui, sans-serif';
    ctx.textAlign = 'center';
    ctx.textBaseline = 'middle';
    for (const { name, x, y } of run.started.stations) {
      const at = [(x + 0.5) * cell, height - (y + 0.5) * cell];
      let [px, py] = view.toScreen(...at);
      // Puts the name above a robot that stands at the station, so that it does not cover the robot.
      const on = robots.find((robot) => Math.hypot(robot.x - at[0], robot.y - at[1]) < robot.size + 10 * this.px);
      if (on) py = view.toScreen(on.x, on.y + on.size)[1] - 12;
      const width = Math.max(ctx.measureText(name).width + 10, 20);
      ctx.beginPath();
      ctx.roundRect(px - width / 2, py - 10, width, 20, 10);
      ctx.fillStyle = '#fff';
      ctx.fill();
      ctx.strokeStyle = '#0072b2';
      ctx.lineWidth = 2;
      ctx.stroke();
      ctx.fillStyle = '#1b1b1b';
      ctx.fillText(name, px, py + 0.5);
    }
    ctx.fillStyle = style('wall');
    for (const [x, y] of run.floor.junctions) {
      const [px, py] = view.toScreen(x, y);
      ctx.beginPath();
      ctx.arc(px, py, 3, 0, 2 * Math.PI);
      ctx.fill();
    }
  }

  /** Draws the changes that scripts make to the world. */
  drawChanges(t) {
    const { ctx, run } = this;
    const now = (run.changes ?? []).filter(({ from, to }) => from <= t && t < to);
    const [paper, paint] = run.floor?.light_line ? ['line', 'paper'] : ['paper', 'line'];
    const colours = { paint: style(paint), erase: style(paper), door: '#8a4b08', obstacle: '#8a4b08' };
    for (const verb of [['paint', 'erase'], ['door', 'obstacle']])
      for (const change of now.filter((one) => verb.includes(one.verb))) {
        const path = new Path2D();
        if (change.disc) path.arc(...placeOf(change, t), change.disc[2], 0, 2 * Math.PI);
        else path.rect(...change.box);
        ctx.fillStyle = colours[change.verb];
        ctx.fill(path);
      }
  }

  /** Draws the room's lights: a patch of sun, a lamp at its place, daylight in the corner. Lights that are off are
   *  hollow. */
  drawLights(floor, t) {
    const { ctx, px } = this;
    let everywhere = 0;
    (floor.lights ?? []).forEach(({ at, radius = 0, moves = [0, 0] }, i) => {
      const lit = isLit(this.run.changes ?? [], i + 1, t);
      const [x, y] = at ? [at[0] + moves[0] * t, at[1] + moves[1] * t] : [(16 + 24 * everywhere++) * px, floor.height - 16 * px];
      const path = new Path2D();
      path.arc(x, y, radius || 8 * px, 0, 2 * Math.PI);
      ctx.fillStyle = radius ? 'rgb(240 200 0 / 35%)' : '#f0c800';
      ctx.strokeStyle = '#8a7400';
      ctx.lineWidth = 1.5 * px;
      if (lit) ctx.fill(path);
      ctx.stroke(path);
    });
  }

  drawCollisions(t) {
    for (const event of this.run.events) {
      if (event.kind !== 'collision' || event.t > t) continue;
      const pose = this.run.pose(event.t);
      drawMark(this.ctx, 'collision', ...this.view.toScreen(pose.x, pose.y), 7);
    }
  }

  drawScale() {
    const { ctx, view } = this;
    const room = Math.min(Math.max(view.width - 290, 40), 110);  // next to the trail's colour scale
    const aim = room / view.scale, ten = 10 ** Math.floor(Math.log10(aim));
    const length = [5, 2, 1].map((k) => k * ten).find((mm) => mm <= aim);
    const text = length >= 1000 ? `${length / 1000} m` : `${length} mm`;
    const y = view.height - 14, x = 14;
    this.scaleEnds = x + length * view.scale;
    ctx.fillStyle = style('panel');
    ctx.beginPath();
    ctx.roundRect(x - 6, y - 22, Math.max(length * view.scale, 40) + 12, 30, 6);
    ctx.fill();
    ctx.fillStyle = style('text');
    ctx.fillRect(x, y, length * view.scale, 2);
    ctx.fillRect(x, y - 4, 1.5, 6);
    ctx.fillRect(x + length * view.scale - 1.5, y - 4, 1.5, 6);
    ctx.font = '12px system-ui, sans-serif';
    ctx.textAlign = 'left';
    ctx.textBaseline = 'alphabetic';
    ctx.fillText(text, x, y - 6);
  }
}
