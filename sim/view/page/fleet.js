// Selects the robot of a run whose signals, pins and serial text are shown next to the floor.

import { LiveRun } from './live.js';
import { shared } from './recording.js';
import { runOf } from './run.js';

/** Returns a run for each robot of a recording, all with the duration of the longest. */
export function runsOf({ header, streams, others }) {
  const runs = [{ header, streams }, ...others].map((one, number) => runOf(one, number));
  const duration = Math.max(...runs.map((run) => run.duration));
  for (const run of runs) run.duration = duration;
  return runs;
}

/** Returns a run for each robot of a live run, from the live run's header and its first `paused` message. */
export function liveRunsOf(header, state) {
  const all = [header, ...(header.others ?? [])];
  return all.map((own, number) => new LiveRun({ ...shared(header), ...own }, number === 0 ? state : state.others[number - 1], number));
}

/** A list to choose one of several robots. The r key and a click on the floor also choose a robot. */
export class Chooser {
  /** `chosen(number)` is called for each choice. */
  constructor(box, runs, chosen) {
    Object.assign(this, { runs, chosen, number: 0, select: box.querySelector('select') });
    box.hidden = runs.length < 2;
    for (const { number, name } of runs) this.select.append(new Option(name, number));
    this.select.addEventListener('change', () => this.choose(Number(this.select.value)));
  }
  /** Chooses a robot. Numbers beyond the last wrap around. */
  choose(number) {
    const { runs } = this;
    this.number = (number + runs.length) % runs.length;
    this.select.value = this.number;
    this.chosen(this.number);
  }
  step(by) { if (this.runs.length > 1) this.choose(this.number + by); }
  chooseByName(name) {
    const run = this.runs.find((one) => one.name === name);
    if (run) this.choose(run.number);
  }
  /** Chooses the robot that covers x, y of the floor at t. */
  chooseAt(x, y, t) {
    const reach = ({ robot }) => Math.max(...(robot.outline ?? [[60, 0]]).map(([forward, left]) => Math.hypot(forward, left)));
    const hit = this.runs.find((run) => { const pose = run.pose(t); return Math.hypot(pose.x - x, pose.y - y) < reach(run); });
    if (hit && this.runs.length > 1 && hit.number !== this.number) this.choose(hit.number);
  }
}
