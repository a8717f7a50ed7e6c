// Lists of events and of the sketch's output, which follow the shown time.

import { MARKS } from './colours.js';
import { timeText } from './timeline.js';

const ROW_PX = 26;

/** A list of any length, of which only the visible rows are in the page. */
export class TimedList {
  constructor(element, rows, player, nothing) {
    Object.assign(this, { element, rows, player, now: -2 });
    this.inner = document.createElement('div');
    this.inner.className = 'rows';
    this.nothing = Object.assign(document.createElement('p'), { className: 'empty', textContent: nothing });
    this.grow();
    element.addEventListener('scroll', () => this.draw());
    element.addEventListener('click', (e) => {
      const row = e.target.closest('[data-row]');
      if (row) { player.pause(); player.seek(this.rows[row.dataset.row].t); }
    });
  }

  /** Replaces the rows. */
  show(rows) {
    this.rows = rows;
    this.count = undefined;
    this.now = -2;
    this.grow();
  }

  /** Updates the list after rows have been added. */
  grow() {
    if (this.count === this.rows.length) return;
    this.count = this.rows.length;
    this.inner.style.height = `${this.count * ROW_PX}px`;
    this.element.replaceChildren(this.count ? this.inner : this.nothing);
    this.draw();
  }

  /** Returns the number of rows that are not after the shown time. */
  passed() {
    let low = 0, high = this.rows.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.rows[middle].t <= this.player.t + 1e-9) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  move() {
    const now = this.passed() - 1;
    if (now === this.now || !this.element.clientHeight) return;
    this.now = now;
    const y = now * ROW_PX, { scrollTop, clientHeight } = this.element;
    if (y < scrollTop || y + ROW_PX > scrollTop + clientHeight) this.element.scrollTop = y - clientHeight / 2;
    this.draw();
  }

  draw() {
    if (!this.rows.length) return;
    const first = Math.max(Math.floor(this.element.scrollTop / ROW_PX) - 4, 0);
    const last = Math.min(first + Math.ceil(this.element.clientHeight / ROW_PX) + 8, this.rows.length);
    this.inner.replaceChildren(...this.rows.slice(first, last).map((row, k) => this.row(row, first + k)));
  }

  row({ t, text, kind }, i) {
    const element = document.createElement('button');
    element.className = `row${i === this.now ? ' current' : ''}${i > this.now ? ' future' : ''}`;
    element.dataset.row = i;
    element.style.top = `${i * ROW_PX}px`;
    element.title = text;
    const time = Object.assign(document.createElement('time'), { textContent: timeText(t) });
    const words = Object.assign(document.createElement('span'), { textContent: text });
    element.append(time);
    if (kind) {
      const dot = Object.assign(document.createElement('i'), { className: `dot ${MARKS[kind].shape}`, title: MARKS[kind].label });
      dot.style.setProperty('--colour', MARKS[kind].colour);
      element.append(dot);
    }
    element.append(words);
    return element;
  }
}
