// Draws curves over time. All curves show the same time span. The mouse wheel with Ctrl, Alt or Shift zooms
// the span. Dragging changes the shown time.

import { seen, series, style } from './colours.js';
import { extent, indexAt, valueAt } from './run.js';
import { envelope, niceStep, timeText } from './timeline.js';
import { sized } from './view.js';

const LEFT = 46, RIGHT = 8, LEAST_S = 0.002;

/** The time span that charts and pins show. */
export class Span {
  constructor(player) {
    this.player = player;
    this.seconds = player.run.duration || 1;
    this.from = 0;
    this.listeners = [];
  }
  get to() { return this.from + this.seconds; }
  onChange(listener) { this.listeners.push(listener); }

  zoom(factor, at = this.player.t) {
    const share = (at - this.from) / this.seconds;
    this.set(this.seconds * factor, at - share * Math.min(Math.max(this.seconds * factor, LEAST_S), this.player.run.duration || 1));
  }
  set(seconds, from = this.player.t - seconds / 2) {
    const { duration } = this.player.run;
    this.seconds = Math.min(Math.max(seconds, LEAST_S), duration || 1);
    this.from = Math.min(Math.max(from, 0), Math.max(duration - this.seconds, 0));
    for (const listener of this.listeners) listener();
  }
  /** Moves the span so that it contains the shown time. */
  follow() {
    const { t } = this.player;
    if (t < this.from || t > this.to) this.set(this.seconds, t - (this.player.playing ? 0.1 : 0.5) * this.seconds);
  }
}

/** Formats a number with about three digits. */
export function short(value) {
  if (value === undefined || Number.isNaN(value)) return '';
  const size = Math.abs(value);
  return value.toFixed(size >= 100 || value === 0 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}

/** A canvas with a time axis, and a vertical line at the shown time. Handles zooming and dragging. */
export class Track {
  constructor(parent, span, height, label, left = LEFT) {
    this.span = span;
    this.left = left;
    this.box = Object.assign(document.createElement('div'), { className: 'trace' });
    this.canvas = Object.assign(document.createElement('canvas'), { height });
    this.canvas.style.height = `${height}px`;
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', label);
    this.head = Object.assign(document.createElement('div'), { className: 'head' });
    this.box.append(this.canvas, this.head);
    parent.append(this.box);
    const { player } = span;
    let dragging = false;
    this.snap = (t) => t;
    const scrub = (e) => player.seek(this.snap(this.timeAt(e.offsetX)));
    this.canvas.addEventListener('pointerdown', (e) => {
      this.canvas.setPointerCapture(e.pointerId);
      dragging = true;
      player.pause();
      scrub(e);
    });
    this.canvas.addEventListener('pointermove', (e) => dragging && scrub(e));
    for (const name of ['pointerup', 'pointercancel']) this.canvas.addEventListener(name, () => { dragging = false; });
    this.canvas.addEventListener('wheel', (e) => {
      if (!e.ctrlKey && !e.shiftKey && Math.abs(e.deltaY) < Math.abs(e.deltaX)) return;
      if (!e.ctrlKey && !e.altKey && !e.shiftKey) return;  // lets the list scroll
      e.preventDefault();
      span.zoom(Math.exp((e.deltaY || e.deltaX) * 0.002), this.timeAt(e.offsetX));
    }, { passive: false });
  }

  get width() { return Math.max(this.canvas.clientWidth - this.left - RIGHT, 10); }
  xOf(t) { return this.left + (t - this.span.from) / this.span.seconds * this.width; }
  timeAt(x) { return this.span.from + Math.min(Math.max((x - this.left) / this.width, 0), 1) * this.span.seconds; }

  moveHead() {
    const x = this.xOf(this.span.player.t);
    this.head.hidden = x < this.left - 1 || x > this.left + this.width + 1;
    this.head.style.transform = `translateX(${x}px)`;
  }

  /** Draws values as a line or as steps. If there are many values, draws the minimum and maximum in each pixel. */
  curve(ctx, times, values, yOf, steps) {
    const { from, to } = this.span;
    const first = indexAt(times, from), last = Math.min(indexAt(times, to) + 1, times.length - 1);
    ctx.beginPath();
    if (last - first > 3 * this.width) {
      const width = Math.floor(this.width);
      const { least, most } = envelope(times, values, from, to, width, first, last);
      for (let i = 0; i < width; i++) {
        if (Number.isNaN(most[i])) continue;
        ctx.lineTo(this.left + i, yOf(most[i]));
        if (least[i] !== most[i]) ctx.lineTo(this.left + i, yOf(least[i]));
      }
    } else {
      for (let i = first; i <= last; i++) {
        const x = this.xOf(times[i]), y = yOf(values[i]);
        if (steps && i > first) ctx.lineTo(x, yOf(values[i - 1]));
        ctx.lineTo(x, y);
      }
      if (steps && times[last] < to) ctx.lineTo(this.xOf(Math.min(to, this.span.player.run.duration)), yOf(values[last]));
    }
    ctx.stroke();
  }

  axis(ctx, bottom) {
    const step = niceStep(this.span.seconds / Math.max(this.width / 80, 1));
    ctx.font = '11px system-ui, sans-serif';
    ctx.textBaseline = 'top';
    const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    for (let i = Math.ceil(this.span.from / step); i * step <= this.span.to; i++) {
      const x = this.xOf(i * step);
      ctx.fillStyle = style('grid');
      ctx.fillRect(x - 0.5, 0, 1, bottom);
      ctx.fillStyle = style('dim');
      ctx.textAlign = x < 12 ? 'left' : 'center';
      if (x < this.left + this.width - 12) ctx.fillText(timeText(i * step, digits), x, bottom + 3);
    }
  }
}

/** A chart of several signals with one unit. Shows their current values next to their names. */
export class Chart {
  constructor(parent, span, title, signals, others = [], onClose) {
    Object.assign(this, { signals, others, span });
    const box = Object.assign(document.createElement('section'), { className: 'chart' });
    const legend = Object.assign(document.createElement('div'), { className: 'legend' });
    const unit = signals[0]?.unit;
    legend.append(Object.assign(document.createElement('strong'), { textContent: title + (unit ? `, ${unit}` : '') }));
    this.values = signals.map((signal, i) => {
      const item = Object.assign(document.createElement('span'), { className: 'item' });
      const value = document.createElement('b');
      value.dataset.signal = signal.name;
      const dot = document.createElement('i');
      value.dot = dot;
      item.append(dot, signals.length > 1 ? `${signal.label} ` : '', value);
      legend.append(item);
      return value;
    });
    if (onClose) {
      const close = Object.assign(document.createElement('button'), { className: 'close', textContent: '×', title: `remove ${title}` });
      close.setAttribute('aria-label', close.title);
      close.addEventListener('click', () => { box.remove(); onClose(this); });
      legend.append(close);
    }
    box.append(legend);
    parent.append(box);
    this.track = new Track(box, span, 84, `${title} over time`);
    this.measure();
  }

  /** Finds the minimum and maximum of all signals. */
  measure() {
    const ranges = [...this.signals, ...this.others].map((s) => extent(s.values));
    this.least = Math.min(...ranges.map((r) => r.least));
    this.most = Math.max(this.least + 1e-6, ...ranges.map((r) => r.most));
  }

  draw() {
    const ctx = sized(this.track.canvas);
    const bottom = this.track.canvas.clientHeight - 16;
    const yOf = (value) => 4 + (this.most - value) / (this.most - this.least) * (bottom - 8);
    this.track.axis(ctx, bottom);
    ctx.textAlign = 'right';
    ctx.textBaseline = 'middle';
    for (const value of new Set([this.least, 0, this.most])) {
      ctx.fillStyle = style('grid');
      ctx.fillRect(LEFT, yOf(value) - 0.5, this.track.width, 1);
      ctx.fillStyle = style('dim');
      if (value === 0 || Math.abs(yOf(value) - yOf(0)) > 12) ctx.fillText(short(value), LEFT - 5, Math.max(yOf(value), 6));
    }
    ctx.save();
    ctx.beginPath();
    ctx.rect(LEFT, 0, this.track.width, bottom);
    ctx.clip();
    ctx.lineJoin = 'round';
    ctx.lineWidth = 1.6;
    ctx.setLineDash([4, 3]);
    for (const other of this.others) {
      ctx.strokeStyle = style('other');
      this.track.curve(ctx, other.t, other.values, yOf, other.steps);
    }
    ctx.setLineDash([]);
    this.signals.forEach((signal, i) => {
      ctx.strokeStyle = this.values[i].dot.style.background = series(i);
      this.track.curve(ctx, signal.t, signal.values, yOf, signal.steps);
    });
    ctx.restore();
    this.move();
  }

  move() {
    this.track.moveHead();
    const { t } = this.span.player;
    this.signals.forEach((signal, i) => { this.values[i].textContent = short(valueAt(signal, t)); });
  }
}

/** Shows the line sensors as stripes: pale for a light surface, dark orange for a dark one. */
export class SensorStripes {
  constructor(parent, span, run) {
    Object.assign(this, { span, run });
    const box = Object.assign(document.createElement('section'), { className: 'chart' });
    const [pale, dark] = run.floor?.light_line ? ['line', 'floor'] : ['floor', 'line'];
    box.innerHTML = `<div class="legend"><strong>line sensors, left to right</strong><span class="item">${pale} <i class="scale"></i> ${dark}</span></div>`;
    box.querySelector('.scale').style.background = `linear-gradient(to right, ${seen(0)}, ${seen(1)})`;
    parent.append(box);
    this.sensors = [...run.sensors].sort((a, b) => b.y - a.y || a.x - b.x);
    this.track = new Track(box, span, 14 * this.sensors.length + 18, 'line sensors over time');
  }

  draw() {
    const ctx = sized(this.track.canvas);
    const bottom = this.track.canvas.clientHeight - 16, height = bottom / this.sensors.length;
    const width = Math.floor(this.track.width), { t } = this.run;
    this.track.axis(ctx, bottom);
    this.sensors.forEach(({ name }, row) => {
      const values = this.run.columns[name];
      const y = row * height;
      ctx.fillStyle = style('dim');
      ctx.textAlign = 'right';
      ctx.textBaseline = 'middle';
      ctx.fillText(name, LEFT - 5, y + height / 2, LEFT - 8);
      let run = 0, colour = '';
      for (let px = 0; px <= width; px++) {
        const i = indexAt(t, this.span.from + (px + 0.5) / width * this.span.seconds);
        const next = px === width || this.span.from + px / width * this.span.seconds > this.run.duration ? '' : seen(Math.round(values[i] * 16) / 16);
        if (next === colour) continue;
        ctx.fillStyle = colour;
        if (colour) ctx.fillRect(LEFT + run, y + 0.5, px - run, height - 1);
        [run, colour] = [px, next];
      }
    });
    this.move();
  }

  move() { this.track.moveHead(); }
}
