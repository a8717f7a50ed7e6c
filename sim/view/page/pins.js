// Shows the board's pins like a logic analyser: levels, PWM as areas with the duty cycle as height, volts as
// curves.

import { series, style } from './colours.js';
import { short, Track } from './charts.js';
import { extent, indexAt } from './run.js';
import { sized } from './view.js';

const LOW = 0, HIGH = 1, FLOATING = 2, PULSING = 3;
const TEXT = ['low', 'high', 'not driven', 'PWM'];

export function pinText(pin, t) {
  const i = indexAt(pin.t, t);
  if (!pin.t.length || pin.t[0] > t) return '';
  if (pin.isAnalog) return `${short(pin.volts[i])} V`;
  if (pin.level[i] !== PULSING) return TEXT[pin.level[i]];
  return pin.tone[i] > 0 ? `${pin.tone[i]} Hz` : `PWM ${Math.round(100 * pin.duty[i])} %`;
}

/** Returns the sketch line that set the pin's current state: "Blink.ino:12 in loop()"; '' if unknown. */
export function sourceText(pin, t, sources) {
  const i = indexAt(pin.t, t);
  if (!pin.source || !pin.t.length || pin.t[i] > t) return '';
  const { file, line, function: name } = sources[pin.source[i] - 1] ?? {};
  return file ? `${file}:${line}${name ? ` in ${name}()` : ''}` : '';
}

const NEAR_PX = 5, PIN_LEFT = 4;

export class PinRow {
  constructor(parent, span, pin, use) {
    Object.assign(this, { span, pin });
    const box = Object.assign(document.createElement('section'), { className: 'pin' });
    const name = Object.assign(document.createElement('div'), { className: 'pin-name' });
    name.innerHTML = '<button></button> <span></span> <em></em>';
    [this.title, this.use, this.now] = name.children;
    this.title.textContent = pin.name;
    this.title.title = `go to the next change of ${pin.name} (with shift: the previous one)`;
    this.title.setAttribute('aria-label', this.title.title);
    this.title.addEventListener('click', (e) => this.stepChange(e.shiftKey ? -1 : 1));
    this.use.textContent = use;
    this.now.dataset.pin = pin.name + (pin.isAnalog ? ' volts' : '');
    box.append(name);
    parent.append(box);
    this.track = new Track(box, span, pin.isAnalog ? 40 : 26, `pin ${pin.name} over time`, PIN_LEFT);
    this.track.snap = (t) => this.changeNear(t);
    this.source = Object.assign(document.createElement('div'), { className: 'pin-source' });
    if (pin.source) box.append(this.source);
  }

  /** Returns the time of an edge near t; otherwise t. */
  changeNear(t) {
    const { t: times } = this.pin, i = indexAt(times, t);
    const near = [times[i], times[i + 1]].filter((at) => Math.abs(this.track.xOf(at) - this.track.xOf(t)) <= NEAR_PX);
    return near.length ? near.reduce((a, b) => (Math.abs(a - t) <= Math.abs(b - t) ? a : b)) : t;
  }

  stepChange(direction) {
    const { player } = this.span, { t: times } = this.pin;
    let i = indexAt(times, player.t);
    if (direction < 0 && times[i] >= player.t) i--;
    if (direction > 0 && times[i] <= player.t) i++;
    player.pause();
    if (i >= 0 && i < times.length) player.seek(times[i]);
  }

  draw() {
    const ctx = sized(this.track.canvas);
    const height = this.track.canvas.clientHeight;
    ctx.save();
    ctx.beginPath();
    ctx.rect(this.track.xOf(this.span.from), 0, this.track.width, height);
    ctx.clip();
    ctx.fillStyle = style('track');
    ctx.fillRect(0, 0, this.track.canvas.clientWidth, height);
    this.track.axis(ctx, height);
    ctx.lineWidth = 1.5;
    ctx.strokeStyle = series(0);
    const yOf = (share) => height - 4 - share * (height - 8);
    if (this.pin.isAnalog) {
      const most = Math.max(extent(this.pin.volts).most, 0.1);
      this.track.curve(ctx, this.pin.t, this.pin.volts, (v) => yOf(v / most), true);
    } else {
      this.drawLevels(ctx, yOf);
    }
    ctx.restore();
    this.move();
  }

  drawLevels(ctx, yOf) {
    const { t, level, duty } = this.pin;
    const { from, to } = this.span;
    const end = Math.min(to, this.span.player.run.duration);
    const first = indexAt(t, from), last = indexAt(t, to);
    let x = -1, low = 0, high = 0;
    ctx.beginPath();
    for (let i = first; i <= last; i++) {
      if (t[i] > to) break;
      const begin = this.track.xOf(Math.max(t[i], from)), stop = this.track.xOf(i < last ? t[i + 1] : end);
      if (level[i] === PULSING) {
        ctx.fillStyle = series(4);
        ctx.globalAlpha = 0.55;
        ctx.fillRect(begin, yOf(duty[i]), Math.max(stop - begin, 0.5), yOf(0) - yOf(duty[i]));
        ctx.globalAlpha = 1;
      }
      const share = { [LOW]: 0, [HIGH]: 1, [FLOATING]: 0.5, [PULSING]: duty[i] }[level[i]];
      // Draws many changes in one pixel as one stroke from the lowest to the highest.
      if (Math.floor(stop) === x) {
        low = Math.min(low, share);
        high = Math.max(high, share);
        continue;
      }
      if (x >= 0 && low !== high) { ctx.moveTo(x, yOf(low)); ctx.lineTo(x, yOf(high)); }
      ctx.lineTo(begin, yOf(share));
      ctx.lineTo(stop, yOf(share));
      [x, low, high] = [Math.floor(stop), share, share];
    }
    ctx.stroke();
  }

  move() {
    this.track.moveHead();
    const { t, run } = this.span.player;
    this.now.textContent = pinText(this.pin, t);
    this.source.textContent = sourceText(this.pin, t, run.sources);
    this.source.title = this.source.textContent;
  }
}

/** The time axis below the pins. */
export class PinAxis {
  constructor(parent, span) {
    const box = Object.assign(document.createElement('section'), { className: 'pin axis' });
    box.append(document.createElement('div'));
    parent.append(box);
    this.track = new Track(box, span, 18, 'time of the pins', PIN_LEFT);
  }
  draw() {
    this.track.axis(sized(this.track.canvas), 0);
    this.move();
  }
  move() { this.track.moveHead(); }
}

/** A table of pins: the parts on each pin according to the robot's file, and the sketch's use of the pin. */
export class Wiring {
  constructor(panel, run, player) {
    Object.assign(this, { panel, run, player, cells: [] });
    const on = new Map(run.header.pins.map((pin) => [pin, []]));
    for (const { name, type, pins } of run.robot.parts)
      for (const [use, pin] of Object.entries(pins)) {
        const key = run.header.pins[pin] ?? String(pin);
        on.set(key, [...(on.get(key) ?? []), { name, type, use }]);
      }
    const unwired = new Map(run.result.usage?.unwired.map(({ pin, how }) => [pin, how]));
    const unused = new Set(run.result.usage?.unused);
    const table = Object.assign(document.createElement('table'), { className: 'wiring' });
    table.createCaption().textContent = `${run.header.robot} · ${run.robot.board?.name ?? ''}`;
    const row = (texts, tag = 'td') => {
      const line = table.insertRow();
      for (const text of texts) line.append(Object.assign(document.createElement(tag), { textContent: text }));
      return line;
    };
    row(['pin', 'leads to', 'type of part', 'now'], 'th');
    for (const [pin, parts] of on) {
      const loose = unwired.get(pin);
      const line = row([pin, parts.map(({ name, use }) => `${name} ${use}`).join(', ') || (loose ? `nothing, but the sketch has ${loose} it` : 'free'),
        [...new Set(parts.map(({ type }) => type))].join(', ')]);
      if (loose) line.className = 'loose';
      if (!parts.length && !loose) line.className = 'free';
      if (parts.length && parts.every(({ name }) => unused.has(name))) line.cells[2].append(' (never used)');
      const now = document.createElement('td');
      now.dataset.wire = pin;
      line.append(now);
      this.cells.push({ now, pin });
    }
    panel.append(table);
  }

  move() {
    if (this.panel.hidden) return;
    const tracks = (name) => this.run.pins.filter((pin) => pin.name === name);
    for (const { now, pin } of this.cells) now.textContent = tracks(pin).map((track) => pinText(track, this.player.t)).filter(Boolean).join(', ');
  }
}
