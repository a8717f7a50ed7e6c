// Stores the shown time of a replay, and changes it. All other parts of the page listen to the changes.

const SPEEDS = [1 / 16, 1 / 8, 1 / 4, 1 / 2, 1, 2, 4, 8, 16, 32, 64];

export class Player {
  constructor(run) {
    this.run = run;
    this.t = 0;
    this.speed = 1;
    this.playing = false;
    this.listeners = [];
  }

  onChange(listener) { this.listeners.push(listener); }
  tell() { for (const listener of this.listeners) listener(this); }

  seek(t) {
    this.t = Math.min(Math.max(t, 0), this.run.duration);
    this.tell();
  }

  /** Moves by milliseconds, which are the simulation's ticks. */
  step(ms) {
    this.pause();
    this.seek((Math.round(this.t * 1000) + ms) / 1000);
  }

  /** Moves to the next or previous event, and returns all events of that time. If `kind` is given, ignores
   *  events of other kinds. Returns [] if no event is found. In that case, moves to the end or the start of
   *  the run, or stays in place if `kind` is given. */
  stepEvent(direction, kind) {
    this.pause();
    const events = this.run.events.filter((e) => !kind || e.kind === kind);
    const found = direction > 0 ? events.find((e) => e.t > this.t + 1e-9)
      : events.findLast((e) => e.t < this.t - 1e-9);
    if (found || !kind) this.seek(found ? found.t : direction > 0 ? this.run.duration : 0);
    return found ? events.filter((e) => e.t === found.t) : [];
  }

  faster(steps) {
    const i = SPEEDS.indexOf(this.speed) + steps;
    this.setSpeed(SPEEDS[Math.min(Math.max(i, 0), SPEEDS.length - 1)]);
  }
  setSpeed(speed) { this.speed = speed; this.tell(); }

  toggle() { this.playing ? this.pause() : this.play(); }
  pause() { this.playing = false; this.tell(); }
  play() {
    if (this.t >= this.run.duration) this.t = 0;
    this.playing = true;
    let before = performance.now();
    const frame = (now) => {
      if (!this.playing) return;
      // A frame may have begun before play() was called.
      const t = this.t + Math.min(Math.max(now - before, 0) / 1000, 0.1) * this.speed;
      before = now;
      if (t >= this.run.duration) this.playing = false;
      this.seek(t);
      if (this.playing) requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
    this.tell();
  }
}

export { SPEEDS };
