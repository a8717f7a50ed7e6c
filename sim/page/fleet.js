// The robots of one run: whose signals, pins and serial text are shown beside the floor.

import { LiveRun } from './live.js';
import { shared } from './recording.js';
import { runOf } from './run.js';

/** Of a recording: a run for each robot, all as long as the longest. */
export function runsOf({ header, streams, others }) {
  const runs = [{ header, streams }, ...others].map((one, number) => runOf(one, number));
  const duration = Math.max(...runs.map((run) => run.duration));
  for (const run of runs) run.duration = duration;
  return runs;
}

/** The same of what begins a run that is watched, and of its first `paused`. */
export function liveRunsOf(header, state) {
  const all = [header, ...(header.others ?? [])];
  return all.map((own, number) => new LiveRun({ ...shared(header), ...own }, number === 0 ? state : state.others[number - 1], number));
}

/** The list of robots, where there are several; keys and clicks on the floor choose, too. */
export class Chooser {
  /** `chosen(number)` is called for each choice. */
  constructor(box, runs, chosen) {
    Object.assign(this, { runs, chosen, number: 0, select: box.querySelector('select') });
    box.hidden = runs.length < 2;
    for (const { number, name } of runs) this.select.append(new Option(name, number));
    this.select.addEventListener('change', () => this.choose(Number(this.select.value)));
  }
  /** Of numbers beyond the last it begins anew. */
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
  /** The robot on which x, y of the floor is, at t. */
  chooseAt(x, y, t) {
    const reach = ({ robot }) => Math.max(...(robot.outline ?? [[60, 0]]).map(([forward, left]) => Math.hypot(forward, left)));
    const hit = this.runs.find((run) => { const pose = run.pose(t); return Math.hypot(pose.x - x, pose.y - y) < reach(run); });
    if (hit && this.runs.length > 1 && hit.number !== this.number) this.choose(hit.number);
  }
}
