// Represents a run in progress (LiveRun) and its player. The data are lines from `robosim run --live`. A
// LiveRun has the interface of any other Run, but its data grow.

import { Player } from './player.js';
import { bytesOfBase64, column } from './recording.js';
import { changesBy, KIND, Run, toldGraph } from './run.js';

const LATELY_S = 10;  // span of plots and pins

/** A growing array of numbers. `all` contains the numbers so far. */
class Growing {
  constructor() { this.buffer = new Float64Array(1024); this.all = this.buffer.subarray(0, 0); }
  push(values) {
    const before = this.all.length, count = before + values.length;
    if (count > this.buffer.length) {
      const larger = new Float64Array(2 * count);
      larger.set(this.all);
      this.buffer = larger;
    }
    this.buffer.set(values, before);
    this.all = this.buffer.subarray(0, count);
  }
  drop() { this.all = this.buffer.subarray(0, this.all.length - 1); }
}

/** A stream of columns, decoded piece by piece. */
class GrowingStream {
  constructor(specs) {
    this.specs = specs.map((spec) => ({ order: 1, scale: 1, ...spec, before: { last: 0, change: 0 } }));
    this.of = Object.fromEntries(specs.map(({ name }) => [name, new Growing()]));
  }
  add({ count, bytes }) {
    this.specs.forEach((spec, i) => {
      const packed = bytesOfBase64(bytes[i]);
      this.of[spec.name].push(column(packed, 0, { ...spec, bytes: packed.length }, count, spec.before));
    });
  }
}

export class LiveRun extends Run {
  /** `header` is a recording's header. `state` is the first `paused` message of robot `number`. */
  constructor(header, state, number = 0) {
    super(header.sketch, new Float64Array(), {});
    const { started, robot_info: robot, result } = header;
    Object.assign(this, { number, name: header.name ?? '', live: true, header, started, robot, floor: header.floor, thinned: 0, streams: new Map(), told: { nodes: [], edges: [] }, changes: [] });
    this.result = { ...result, verdict: 'live', status: 0, why: 'the space key pauses and continues the run; the period key steps by a millisecond' };
    this.units = new Map(robot.gauges?.map((g) => [g.name, g.unit]));
    this.readings = started.readings;
    const names = ['x_mm', 'y_mm', 'yaw_rad', 'speed_mm_s', 'cross_track_mm', 'left', 'right', 'wheel_left_mm_s', 'wheel_right_mm_s', ...this.readings];
    this.now = new GrowingStream(['t_us', ...names].map((name) => ({ name })));  // until the first columns arrive
    this.take({ paused: state });
    const add = (name, unit, label, steps) => this.addGrowing(name, unit, label, steps, () => this.t, () => this.columns[name]);
    for (const [name, unit] of [['x_mm', 'mm'], ['y_mm', 'mm'], ['yaw_rad', 'rad'], ['speed_mm_s', 'mm/s']]) add(name, unit);
    if (robot.sensors.length) add('cross_track_mm', 'mm', 'off the line');
    for (const side of ['left', 'right']) add(side, '', `motor ${side}`);
    for (const side of ['left', 'right']) add(`wheel_${side}_mm_s`, 'mm/s', `wheel ${side}`);
    for (const name of this.readings) add(name, this.units.get(name) ?? '', name, !robot.sensors.some((s) => s.name === name));
    this.sensors = robot.sensors.filter((s) => this.columns[s.name]);
  }

  addGrowing(name, unit, label, steps, t, values) {
    this.signals.push({ name, unit, label: label ?? name.replace(/_(mm_s|mm|rad)$/, '').replaceAll('_', ' '), steps: Boolean(steps), get t() { return t(); }, get values() { return values(); } });
  }

  /** Adds a line of the run. Returns what must be redrawn: 'pins', or '' if only the shown time changes. */
  take({ event, paused, result, ...line }) {
    if (event === 'columns') {
      this.sources.push(...(line.sources ?? []));
      return this.takeColumns(line.streams);
    }
    if (event === 'serial') {
      const t = line.t_ns / 1e9, text = line.text.replace(/\r?\n$/, '');
      this.lines.push({ t, text });
      this.addEvent(t, 'serial', text);
      if (text.startsWith('found ')) this.told = toldGraph(this);
    }
    if (event === 'note') {
      this.header.notes.push(line);
      this.addEvent(line.t_ns / 1e9, KIND[line.kind] ?? 'script', line.text);
    }
    if (paused) {
      const { sample: s } = paused;
      this.dropNow();
      const row = { t_us: paused.t_ns / 1000, x_mm: s.x, y_mm: s.y, yaw_rad: s.yaw, speed_mm_s: s.speed_mm_s, cross_track_mm: s.cross_track, left: s.left, right: s.right,
        wheel_left_mm_s: s.wheels?.[0] ?? 0, wheel_right_mm_s: s.wheels?.[1] ?? 0 };
      this.readings.forEach((name, i) => { row[name] = s.readings[i]; });
      for (const [name, growing] of Object.entries(this.now.of)) growing.push([row[name] ?? 0]);
      this.hasNow = true;
      this.share();
      this.duration = paused.t_ns / 1e9;
    }
    if (result) this.result = result;
    return '';
  }

  /** Removes the last row, which is the robot's state between two samples. */
  dropNow() {
    if (this.hasNow) for (const growing of Object.values(this.now.of)) growing.drop();
    this.hasNow = false;
  }

  share() {
    for (const [name, growing] of Object.entries(this.now.of)) this.columns[name] = growing.all;
    this.times ??= new Growing();
    const known = this.known ?? 0, { t_us: t } = this.columns;
    while (this.times.all.length > known) this.times.drop();
    this.times.push(t.subarray(known).map((us) => us / 1e6));
    this.known = t.length - (this.hasNow ? 1 : 0);
    this.t = this.times.all;
  }

  takeColumns(streams) {
    let redraw = '';
    for (const rows of streams) {
      const [kind, pin] = rows.stream.split(' ');
      if (!this.streams.has(rows.stream)) {
        const stream = new GrowingStream(rows.columns);
        this.streams.set(rows.stream, stream);
        if (kind === 'samples') {
          this.dropNow();
          this.now = stream;
        } else {
          this.addPin(kind, pin, stream.of);
          redraw = 'pins';
        }
      }
      if (kind === 'samples') this.dropNow();
      this.streams.get(rows.stream).add(rows);
      if (kind === 'samples') this.share();
      else this.streams.get(rows.stream).seconds.push(this.streams.get(rows.stream).of.t_ns.all.subarray(-rows.count).map((ns) => ns / 1e9));
    }
    return redraw;
  }

  addPin(kind, name, of) {
    const t = new Growing();
    this.streams.get(`${kind} ${name}`).seconds = t;
    const pin = { name, isAnalog: kind === 'volts', get t() { return t.all; } };
    if (kind === 'volts') {
      Object.defineProperty(pin, 'volts', { get: () => of.volts.all });
      this.addGrowing(`volts ${name}`, 'V', `${name} volts`, true, () => t.all, () => of.volts.all);
    } else {
      for (const [key, column] of [['level', 'level'], ['duty', 'duty'], ['tone', 'tone_hz'], ['source', 'source']]) Object.defineProperty(pin, key, { get: () => of[column]?.all });
      this.addGrowing(`${name} duty`, '', `${name} duty`, true, () => t.all, () => of.duty.all);
    }
    this.pins.push(pin);
    this.pins.sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true }));
  }
}

/** Sends play and pause as requests to the run. Stops following the run when the user seeks to an earlier
 *  time. */
export class LivePlayer extends Player {
  constructor(run) {
    super(run);
    this.follows = true;
    this.ask = () => {};  // sends a request; set by the owner of the connection
  }
  /** Follows the run after it has grown. */
  grow() { if (this.follows) this.t = this.run.duration; }
  seek(t) {
    super.seek(t);
    this.follows = this.t >= this.run.duration - 1e-9;
  }
  play() {
    this.follows = true;
    this.t = this.run.duration;
    this.playing = true;
    this.ask({ do: 'play', speed: this.speed });
    this.tell();
  }
  pause() {
    if (this.playing) this.ask({ do: 'pause' });
    super.pause();
  }
  step(ms) {
    if (!this.follows || ms < 0) return super.step(ms);
    this.pause();
    this.ask({ do: 'step', ms });
  }
  setSpeed(speed) {
    this.speed = speed;
    if (this.playing) this.ask({ do: 'play', speed });
    this.tell();
  }
}

/** Passes the lines of a run to its page. Redraws the page once per frame, and its expensive parts only ten
 *  times a second. */
export class LiveFeed {
  constructor(page) {
    Object.assign(this, { page, due: false, drawn: 0, pins: false });
    page.span.seconds = LATELY_S;
  }

  take({ agent = 0, paused, result, ...line }) {
    const { runs, run } = this.page, one = runs[agent];
    if (paused) runs.forEach((each, i) => each.take({ paused: i === 0 ? paused : { ...paused.others[i - 1], t_ns: paused.t_ns } }));
    if (result) runs.forEach((each, i) => each.take({ result: i === 0 ? result : result.others[i - 1] }));
    const fresh = line.event && one ? one.take({ agent, ...line }) : '';
    if (line.event === 'note') for (const each of runs) each.changes = changesBy(run.header.notes);
    this.pins = (fresh === 'pins' && one === run) || this.pins;
    if (this.due) return;
    this.due = true;
    requestAnimationFrame((now) => this.draw(now));
    // A hidden page gets no frames, but its state may be queried.
    setTimeout(() => this.draw(performance.now()), 100);
  }

  draw(now) {
    if (!this.due) return;
    this.due = false;
    const { page } = this, { player, run, span } = page;
    player.grow();
    if (player.follows) span.from = Math.max(run.duration - span.seconds, 0);
    page.move();
    const whole = now - this.drawn > 100 || !player.playing;
    if (!whole) return;
    this.drawn = now;
    if (this.pins) page.makePins();
    this.pins = false;
    page.grow();
  }
}
