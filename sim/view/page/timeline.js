// Shows the whole run on one line: the cross-track error, and a mark for each event. Dragging changes the
// shown time.

import { drawMark, MARKS, style } from './colours.js';
import { extent } from './run.js';
import { sized } from './view.js';

const MARGIN = 14;

export function timeText(t, digits = 3) {
  if (t < 60) return `${t.toFixed(digits)} s`;
  const whole = Math.floor(t / 60);
  return `${whole}:${(t - 60 * whole).toFixed(digits).padStart(digits ? digits + 3 : 2, '0')}`;
}

const envelopes = new WeakMap();  // the last envelope for each array of values

/** Returns the minimum and maximum of a signal in each of `width` pixels; NaN in pixels without a value. */
export function envelope(times, values, from, to, width, first, last) {
  const key = `${from} ${to} ${width} ${first} ${last}`, known = envelopes.get(values);
  if (known?.key === key) return known;
  const made = { key, ...envelopeOf(times, values, from, to, width, first, last) };
  envelopes.set(values, made);
  return made;
}

function envelopeOf(times, values, from, to, width, first, last) {
  const least = new Float64Array(width).fill(NaN), most = new Float64Array(width).fill(NaN);
  for (let i = first; i <= last; i++) {
    const px = Math.floor((times[i] - from) / (to - from) * width);
    if (px < 0 || px >= width) continue;
    if (!(values[i] >= least[px])) least[px] = values[i];
    if (!(values[i] <= most[px])) most[px] = values[i];
  }
  return { least, most };
}

export class Timeline {
  constructor(canvas, player) {
    Object.assign(this, { canvas, player });
    this.head = canvas.parentElement.querySelector('.head');
    this.tip = canvas.parentElement.querySelector('.tip');
    let dragging = false;
    const scrub = (e) => player.seek(this.timeAt(e.offsetX));
    canvas.addEventListener('pointerdown', (e) => {
      canvas.setPointerCapture(e.pointerId);
      dragging = true;
      player.pause();
      const near = this.eventAt(e.offsetX, e.offsetY);
      near ? player.seek(near.t) : scrub(e);
    });
    canvas.addEventListener('pointermove', (e) => {
      if (dragging) scrub(e);
      this.point(e);
    });
    for (const name of ['pointerup', 'pointercancel']) canvas.addEventListener(name, () => { dragging = false; });
    canvas.addEventListener('pointerleave', () => { this.tip.hidden = true; });
  }

  get run() { return this.player.run; }
  get width() { return this.canvas.clientWidth - 2 * MARGIN; }
  xOf(t) { return MARGIN + t / Math.max(this.run.duration, 1e-9) * this.width; }
  timeAt(x) { return Math.min(Math.max((x - MARGIN) / this.width, 0), 1) * this.run.duration; }

  /** Returns the event whose mark is near a pixel. */
  eventAt(x, y) {
    if (y > 22) return undefined;
    let best, distance = 7;
    for (const event of this.run.events) {
      const d = Math.abs(this.xOf(event.t) - x);
      if (d < distance || (d === distance && event.kind !== 'serial')) [best, distance] = [event, d];
    }
    return best;
  }

  point(e) {
    const event = this.eventAt(e.offsetX, e.offsetY);
    this.tip.textContent = event ? `${timeText(event.t)}  ${event.text}` : timeText(this.timeAt(e.offsetX));
    this.tip.hidden = false;
    const half = this.tip.offsetWidth / 2;
    this.tip.style.left = `${Math.min(Math.max(e.offsetX, half + 4), this.canvas.clientWidth - half - 4)}px`;
  }

  draw() {
    const ctx = sized(this.canvas);
    const { run } = this;
    const top = 24, bottom = this.canvas.clientHeight - 16;
    ctx.fillStyle = style('track');
    ctx.fillRect(MARGIN, top, this.width, bottom - top);
    this.drawError(ctx, top, bottom);
    this.drawTicks(ctx, bottom);
    // Draws rare marks over frequent ones.
    const order = ['serial', 'told', 'landmark', 'script', 'line', 'fault', 'collision', 'end'];
    for (const kind of order)
      for (const event of run.events)
        if (event.kind === kind) {
          const x = this.xOf(event.t);
          if (kind !== 'serial') {
            ctx.fillStyle = MARKS[kind].colour;
            ctx.globalAlpha = 0.5;
            ctx.fillRect(x - 0.5, top, 1, bottom - top);
            ctx.globalAlpha = 1;
          }
          drawMark(ctx, kind, x, 12, kind === 'serial' ? 4 : 5);
        }
    this.move();
  }

  drawError(ctx, top, bottom) {
    const { run } = this;
    const signal = run.signal('cross_track_mm') ?? run.signal('speed_mm_s');
    const width = Math.floor(this.width);
    if (!signal || width < 2) return;
    const { most } = envelope(signal.t, signal.values, 0, run.duration, width, 0, signal.t.length - 1);
    const range = extent(signal.values), highest = Math.max(range.most, -range.least, 1e-9);
    ctx.fillStyle = style('error');
    for (let i = 0, h = 0; i < width; i++) {
      if (!Number.isNaN(most[i])) h = Math.abs(most[i]) / highest * (bottom - top - 2);
      ctx.fillRect(MARGIN + i, bottom - h, 1, h);
    }
  }

  drawTicks(ctx, bottom) {
    const step = niceStep(this.run.duration / Math.max(this.width / 90, 1));
    ctx.fillStyle = style('dim');
    ctx.font = '11px system-ui, sans-serif';
    ctx.textBaseline = 'top';
    ctx.textAlign = 'center';
    for (let i = 0; i * step <= this.run.duration * 1.0001; i++) {
      const x = this.xOf(i * step);
      ctx.fillRect(x - 0.5, bottom, 1, 3);
      const text = timeText(i * step, step < 0.1 ? 2 : step < 1 ? 1 : 0), half = ctx.measureText(text).width / 2;
      if (x + half < this.canvas.clientWidth) ctx.fillText(text, Math.max(x, half), bottom + 4);
    }
  }

  move() {
    this.head.style.transform = `translateX(${this.xOf(this.player.t)}px)`;
    if (this.player.playing) return;  // a screen reader would announce nothing else
    this.canvas.setAttribute('aria-valuenow', this.player.t.toFixed(3));
    this.canvas.setAttribute('aria-valuetext', timeText(this.player.t));
  }
}

/** Returns the smallest of 1, 2, 5, 10, 20 … that is not less than `least`. */
export function niceStep(least) {
  const ten = 10 ** Math.floor(Math.log10(Math.max(least, 1e-9)));
  return [1, 2, 5, 10].map((k) => k * ten).find((step) => step >= least * 0.999);
}
