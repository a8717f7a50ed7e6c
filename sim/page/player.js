// The moment that is shown, and what moves it. Everything else listens.

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

  /** A millisecond is what a simulation takes at a time. */
  step(ms) {
    this.pause();
    this.seek((Math.round(this.t * 1000) + ms) / 1000);
  }

  /** To the next event, or the one before; gives all that happened then. After the last one it goes to the end, but where a
   *  kind is given it stays. */
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
