// Represents a run that can be queried: the robot's pose at a time, the events, the signals. A Run is made
// from a recording, or from a table that a real robot has logged. Times are in seconds.

import { BadFile, lazily } from './recording.js';

/** Returns the last index whose time is not after t; 0 before the first time. */
export function indexAt(times, t) {
  let low = 0, high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

const extents = new WeakMap();  // caches results: an hour's values would take milliseconds in every frame

/** Returns the minimum and maximum of the values; 0 counts as one of them. */
export function extent(values) {
  let known = extents.get(values);
  if (known) return known;
  known = { least: 0, most: 0 };
  for (const value of values) {
    if (value < known.least) known.least = value;
    if (value > known.most) known.most = value;
  }
  extents.set(values, known);
  return known;
}

const seconds = (values, perSecond) => Float64Array.from(values, (t) => t / perSecond);

export const KIND = {
  station_visited: 'landmark', lap_done: 'landmark', collision_began: 'collision', script_acted: 'script',
  fault_began: 'fault', fault_ended: 'fault', power_lost: 'fault', power_back: 'fault', part_told: 'told',
};

// A robot that moves this far and this fast between two samples was moved manually.
const CARRIED_MM = 150, CARRIED_MM_S = 10000;

export class Run {
  constructor(title, t, columns) {
    this.title = title;
    this.t = t;
    this.columns = columns;  // by name, each a Float64Array; x_mm and y_mm always exist
    this.duration = t.length ? t[t.length - 1] : 0;
    this.signals = [];
    this.events = [];
    this.lines = [];  // lines of serial output: { t, text }
    this.pins = [];   // { name, t, level, duty, tone, source }
    this.sources = [];  // lines of the sketch that drove pins; a pin's `source` is an index from 1
    this.sensors = [];
    for (const [name, unit] of [['x_mm', 'mm'], ['y_mm', 'mm'], ['yaw_rad', 'rad'], ['speed_mm_s', 'mm/s']])
      this.addSignal(name, unit);
  }

  /** Adds a signal. `from` provides the signal's times and values, which are read on first access. */
  addSignal(name, unit, label, steps = false, from = { times: () => this.t, values: () => this.columns[name], count: name in this.columns ? this.t.length : 0 }) {
    if (!from.count) return;
    const signal = { name, unit, label: label ?? name.replace(/_(mm_s|mm|rad)$/, '').replaceAll('_', ' '), steps };
    lazily(signal, 't', from.times);
    lazily(signal, 'values', from.values);
    this.signals.push(signal);
  }

  signal(name) { return this.signals.find((s) => s.name === name); }

  /** Returns whether the robot was moved manually from sample i to the next. */
  carried(i) {
    if (this.hand?.[i + 1]) return true;
    const { x_mm: x, y_mm: y } = this.columns;
    const far = Math.hypot(x[i + 1] - x[i], y[i + 1] - y[i]);
    return far > CARRIED_MM && far > CARRIED_MM_S * (this.t[i + 1] - this.t[i]);
  }

  /** Returns the value of a column at t, interpolated between samples. */
  at(name, t) {
    const values = this.columns[name];
    if (!values) return undefined;
    const i = indexAt(this.t, t);
    if (i + 1 >= values.length || t <= this.t[i] || this.carried(i)) return values[i];
    return values[i] + (t - this.t[i]) / (this.t[i + 1] - this.t[i]) * this.change(name, i);
  }

  change(name, i) {
    const change = this.columns[name][i + 1] - this.columns[name][i];
    if (name !== 'yaw_rad') return change;
    return change - 2 * Math.PI * Math.round(change / (2 * Math.PI));  // the short way round
  }

  pose(t) { return { x: this.at('x_mm', t), y: this.at('y_mm', t), yaw: this.at('yaw_rad', t) ?? this.course(t) }; }

  /** Returns the heading of a robot for which only positions are known. */
  course(t) {
    const { x_mm: x, y_mm: y } = this.columns;
    const i = Math.min(indexAt(this.t, t), x.length - 2);
    for (let k = Math.max(i, 0); k >= 0; k--)
      if (x[k + 1] !== x[k] || y[k + 1] !== y[k]) return Math.atan2(y[k + 1] - y[k], x[k + 1] - x[k]);
    return 0;
  }

  /** Returns a reading at the last sample before t. */
  reading(name, t) { return this.columns[name]?.[indexAt(this.t, t)]; }

  addEvent(t, kind, text) { this.events.push({ t, kind, text }); }
  sortEvents() { this.events.sort((a, b) => a.t - b.t); }
}

/** Returns the value of a signal at t, as its curve is drawn. */
export function valueAt({ t: times, values, steps }, t) {
  const i = indexAt(times, t);
  if (steps || i + 1 >= values.length || t <= times[i]) return values[i];
  return values[i] + (t - times[i]) / (times[i + 1] - times[i]) * (values[i + 1] - values[i]);
}

/** Returns the graph that the sketch has reported in lines such as "found station 2" or "found junction 1". A
 *  node is the robot's place at the time of the line; an edge is the robot's way between two nodes.
 *  { nodes: [{ t, x, y, name }], edges: [{ t, a, b }] } */
export function toldGraph(run) {
  const nodes = [], edges = [];
  const { cell = 0, height = 0, junctions = [] } = run.floor ?? {};
  const places = [...run.started.stations.map(({ x, y }) => [(x + 0.5) * cell, height - (y + 0.5) * cell]), ...junctions];
  const near = (from, x, y, most) => {
    let best = -1, distance = most;
    from.forEach(([px, py], i) => { const d = Math.hypot(px - x, py - y); if (d < distance) [best, distance] = [i, d]; });
    return best;
  };
  for (const { t, text } of run.lines) {
    const found = /^found (station|junction) ?(\d*)$/.exec(text);
    if (!found) continue;
    const { x, y } = run.pose(t), place = near(places, x, y, 1.5 * cell);
    const [nx, ny] = places[place] ?? [x, y];
    nodes.push({ t, x: nx, y: ny, name: found[1] === 'station' ? found[2] : '' });
  }
  if (!nodes.length) return { nodes, edges };
  const { x_mm: x, y_mm: y } = run.columns, spots = nodes.map((n) => [n.x, n.y]);
  for (let i = 0, last = -1; i < run.t.length; i++) {
    const at = near(spots, x[i], y[i], 0.6 * cell);
    if (at < 0 || at === last) continue;
    const t = Math.max(run.t[i], nodes[at].t);
    if (last >= 0 && !edges.some(({ a, b }) => (a === at && b === last) || (a === last && b === at))) edges.push({ t, a: last, b: at });
    last = at;
  }
  return { nodes, edges };
}

/** Returns the distance between two robots at equal times, as a signal. */
export function apart(run, other) {
  const t = run.t.filter((at) => at >= other.t[0] && at <= other.duration);
  const values = t.map((at) => {
    const one = run.pose(at), two = other.pose(at);
    return Math.hypot(one.x - two.x, one.y - two.y);
  });
  return { name: 'apart_mm', unit: 'mm', label: 'apart', t, values, steps: false };
}

/** Returns the run of robot `number`. */
export function runOf({ header, streams }, number = 0) {
  const samples = streams.get('samples') ?? { t_us: new Float64Array() };
  const { result, started, robot_info: robot } = header;
  const run = new Run(header.sketch, seconds(samples.t_us, 1e6), samples);
  Object.assign(run, { number, name: header.name ?? '', header, result, started, robot, floor: header.floor, thinned: header.thinned_ns / 1e9 });
  run.duration = Math.max(run.duration, result.time_s);
  if (robot.sensors.length) run.addSignal('cross_track_mm', 'mm', 'off the line');
  for (const side of ['left', 'right']) run.addSignal(side, '', `motor ${side}`);
  for (const side of ['left', 'right']) run.addSignal(`wheel_${side}_mm_s`, 'mm/s', `wheel ${side}`);
  const units = new Map(robot.gauges?.map((g) => [g.name, g.unit]));
  for (const name of started.readings) run.addSignal(name, units.get(name) ?? '', name, !robot.sensors.some((s) => s.name === name));
  run.sensors = robot.sensors.filter((s) => s.name in samples);
  run.units = units;

  const counts = new Map(header.streams.map(({ name, count }) => [name, count]));
  for (const [name, stream] of streams) {
    const [kind, pin] = name.split(' ');
    const row = { name: pin, isAnalog: kind === 'volts' };
    lazily(row, 't', () => seconds(stream.t_ns, 1e9));
    const from = (column) => ({ times: () => row.t, values: () => stream[column], count: counts.get(name) });
    if (kind === 'pin') {
      for (const [what, column] of [['level', 'level'], ['duty', 'duty'], ['tone', 'tone_hz'], ['source', 'source']])
        if (column in stream) lazily(row, what, () => stream[column]);
      run.pins.push(row);
      if (stream.level.includes(3)) run.addSignal(`${pin} duty`, '', `${pin} duty`, true, from('duty'));
    } else if (kind === 'volts') {
      lazily(row, 'volts', () => stream.volts);
      run.addSignal(name, 'V', `${pin} volts`, true, from('volts'));
      run.pins.push(row);
    }
  }
  run.sources = header.sources ?? [];
  run.pins.sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true }));

  addSerial(run, streams.get('serial'));
  run.told = toldGraph(run);
  run.changes = changesBy(header.notes);
  const notes = header.notes.filter(({ agent = 0 }) => agent === number);
  run.hand = handOf(run.t, notes);
  for (const note of notes) run.addEvent(note.t_ns / 1e9, KIND[note.kind] ?? 'script', note.text);
  for (const { t_us, sensor, left } of header.line ?? [])
    run.addEvent(t_us / 1e6, 'line', left ? `the line is left: ${sensor} saw it last` : `back on the line, under ${sensor}`);
  run.addEvent(result.time_s, 'end', `${result.verdict}: ${result.why}`);
  run.sortEvents();
  return run;
}

/** Returns the changes that scripts make to the world, each { verb, argument, from, to } in seconds. An obstacle has a
 *  `disc`, and `moves` if it moves. A shut door, paint and bare floor have a `box`. A light has `on`. */
export function changesBy(notes) {
  const all = [];
  const end = (t, what) => { for (const one of all) if (one.to > t && what(one)) one.to = t; };
  for (const { verb, part, argument, disc, moves, box, t_ns } of notes) {
    const t = t_ns / 1e9, add = (more) => all.push({ verb, argument, from: t, to: Infinity, ...more });
    if (verb === 'obstacle' || verb === 'clear') {
      end(t, (one) => one.disc && one.argument === argument);
      if (disc) add({ disc, moves });
    } else if (box) {
      const isDoor = part !== '';  // independent of the verb, which is `restore` when a change is undone
      end(t, (one) => one.box && one.argument === argument && (one.verb === 'door') === isDoor);
      if (isDoor ? part === 'shut' : verb !== 'restore') add({ verb: isDoor ? 'door' : verb, box });
    } else if (verb === 'light' || verb === 'restore') {
      add({ verb: 'light', on: part === 'on' });
    }
  }
  return all;
}

/** Returns the place of a script's obstacle at t: [x, y]. */
export function placeOf({ disc: [x, y], moves, from }, t) {
  if (!moves) return [x, y];
  const share = Math.min((t - from) / moves[2], 1);
  return [x + share * (moves[0] - x), y + share * (moves[1] - y)];
}

/** Returns whether the map's light `number`, from 1, is on at t. */
export function isLit(changes, number, t) {
  const last = changes.findLast((one) => one.verb === 'light' && one.from <= t && (one.argument === 'all' || Number(one.argument) === number));
  return last?.on ?? true;
}

/** Returns for each sample whether a script has moved the robot since the sample before. */
function handOf(t, notes) {
  const acts = notes.filter(({ verb }) => ['place', 'lift', 'lower', 'sweep'].includes(verb));
  if (!acts.length) return undefined;
  const moved = new Uint8Array(t.length);
  for (let i = 0, next = 0, sweeps = false; i < t.length; i++) {
    moved[i] = sweeps;
    for (; next < acts.length && acts[next].t_ns / 1e9 <= t[i]; next++) {
      moved[i] = 1;
      sweeps = acts[next].verb === 'sweep';
    }
  }
  return moved;
}

function addSerial(run, serial) {
  if (!serial) return;
  const utf8 = new TextDecoder();
  let at = 0;
  for (let i = 0; i < serial.t_ns.length; i++) {
    const text = utf8.decode(serial.utf8.subarray(at, at + serial.bytes[i])).replace(/\r?\n$/, '');
    at += serial.bytes[i];
    run.lines.push({ t: serial.t_ns[i] / 1e9, text });
    run.addEvent(serial.t_ns[i] / 1e9, 'serial', text);
  }
}

const TIME = { t: 1, t_s: 1, time: 1, time_s: 1, seconds: 1, t_ms: 1e3, time_ms: 1e3, millis: 1e3, t_us: 1e6, micros: 1e6, t_ns: 1e9 };
const PLACE = { x_mm: 1, x: 1, x_cm: 10, x_m: 1000, y_mm: 1, y: 1, y_cm: 10, y_m: 1000 };

/** Returns the run in a robot's log, a table of t, x, y and any other columns. */
export function runOfTable(text, title) {
  const rows = text.split(/\r?\n/).filter((row) => row.trim() && !row.startsWith('#'));
  const separator = rows[0]?.includes(';') ? ';' : rows[0]?.includes('\t') ? '\t' : ',';
  const cells = (row) => row.split(separator).map((cell) => cell.trim().replace(/^"(.*)"$/, '$1'));
  const names = cells(rows[0] ?? '');
  const find = (table, first) => names.findIndex((n) => n.toLowerCase() in table && n.toLowerCase().startsWith(first));
  const [time, x, y] = [find(TIME, ''), find(PLACE, 'x'), find(PLACE, 'y')];
  if (time < 0 || x < 0 || y < 0)
    throw new BadFile(`${title}: the log’s columns: expected time, x and y (t_s, t_ms or t_us; x_mm or x_m; y_mm or y_m), got ${names.slice(0, 8).join(', ') || 'none'}.`);
  const columns = names.map(() => new Float64Array(rows.length - 1));
  for (let i = 1; i < rows.length; i++) {
    const row = cells(rows[i]);
    for (let k = 0; k < names.length; k++) columns[k][i - 1] = Number(separator === ',' ? row[k] : row[k]?.replace(',', '.'));
    if (![time, x, y].every((k) => Number.isFinite(columns[k][i - 1]) && row[k] !== ''))
      throw new BadFile(`${title}, line ${i + 1}: time, x and y: expected numbers, got ${row[time]}, ${row[x]}, ${row[y]}.`);
    if (i > 1 && columns[time][i - 1] < columns[time][i - 2])
      throw new BadFile(`${title}, line ${i + 1}: time goes backwards, from ${columns[time][i - 2]} to ${columns[time][i - 1]}.`);
  }
  if (rows.length < 3) throw new BadFile(`${title}: the log is too short: expected at least two rows.`);
  const scale = (k, table) => columns[k].map((value) => value * table[names[k].toLowerCase()]);
  const all = Object.fromEntries(names.map((name, k) => [name, columns[k]]));
  all.x_mm = scale(x, PLACE);
  all.y_mm = scale(y, PLACE);
  const run = new Run(title, seconds(columns[time], TIME[names[time].toLowerCase()]), all);
  run.what = `a log of ${(run.duration - run.t[0]).toFixed(2)} s${[x, y].every((k) => names[k].includes('_')) ? '' : ', x and y read as mm'}`;
  for (let k = 0; k < names.length; k++)
    if (k !== time && k !== x && k !== y && !run.signal(names[k])) run.addSignal(names[k], '');
  return run;
}
