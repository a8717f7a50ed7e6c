// Assembles the page that replays a recording or shows a live run.

import { Chart, SensorStripes, Span } from './charts.js';
import { drawMark, GRADIENT, MARKS } from './colours.js';
import { Chooser, liveRunsOf, runsOf } from './fleet.js';
import { areaOf, FloorPicture } from './floor.js';
import { TimedList } from './lists.js';
import { LiveFeed, LivePlayer } from './live.js';
import { Now } from './now.js';
import { PinAxis, PinRow, Wiring } from './pins.js';
import { Player, SPEEDS } from './player.js';
import { BadFile, bytesOfBase64, bytesOfPage, readRecording } from './recording.js';
import { apart, runOfTable } from './run.js';
import { Timeline, timeText } from './timeline.js';
import { View } from './view.js';

const $ = (id) => document.getElementById(id);
const make = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};

/** Returns a function that describes the parts on a pin. */
function uses(run) {
  const of = new Map();
  for (const { name, pins } of run.robot.parts)
    for (const [use, pin] of Object.entries(pins)) {
      const key = run.header.pins[pin] ?? pin;
      of.set(key, [of.get(key), name, use].filter(Boolean).join(' '));
    }
  return (pin) => of.get(pin) ?? '';
}

class Page {
  /** `runs` contains a Run for each robot. */
  constructor(runs) {
    this.runs = runs;
    const run = this.run = runs[0];
    this.player = run.live ? new LivePlayer(run) : new Player(run);
    this.span = new Span(this.player);
    this.floor = new FloorPicture($('floor'), runs, () => this.redraw());
    this.view = new View($('floor'), areaOf(runs), () => this.drawFloor());
    this.timeline = new Timeline($('timeline'), this.player);
    this.extra = new Set();
    $('main').hidden = $('transport').hidden = false;
    this.serial = new TimedList($('serial'), run.lines, this.player, 'The sketch sent nothing.');
    this.events = new TimedList($('events'), run.events, this.player, 'Nothing happened.');
    this.connect();
    this.showRun();
    this.chooser = new Chooser($('robot-box'), runs, (number) => this.lookAt(number));
    this.player.onChange(() => this.move());
    this.span.onChange(() => this.drawTracks());
    new ResizeObserver(() => this.resize()).observe($('floor'));
    new ResizeObserver(() => { this.timeline.draw(); this.drawTracks(); }).observe($('plots').parentElement);
    this.view.fit();
    this.redraw();
    this.player.seek(run.duration);  // shows the whole trail at first; play begins at 0
  }

  /** Shows everything about the selected robot. */
  showRun() {
    const { run } = this;
    this.charts = [];
    this.pins = [];
    this.showTitle();
    this.now = new Now($('now'), run);
    this.makeColours();
    this.makeCharts();
    this.makePins();
    $('wiring').replaceChildren();
    this.wiring = new Wiring($('wiring'), run, this.player);
  }

  /** Selects the robot whose plots, pins and serial text are shown. */
  lookAt(number) {
    const run = this.run = this.player.run = this.runs[number];
    this.floor.lookAt(run);
    this.serial.show(run.lines);
    this.events.show(run.events);
    this.extra.clear();
    this.other = this.others && this.otherOf(run);
    this.showRun();
    this.redraw();
    this.player.tell();
    $('happened').textContent = `robot ${run.name}`;
    this.onLookAt?.();  // notifies the page that contains this one
  }

  showTitle() {
    const { header, result } = this.run;
    const name = this.runs.length > 1 ? `${header.name}: ${header.sketch}` : header.sketch;
    document.title = `${name} on ${header.map}: ${result.verdict}`;
    $('title').textContent = name;
    $('subtitle').textContent = `${header.robot} on ${header.map} · goal ${result.goal} · seed ${result.seed} · ${result.profile} · ${header.target}`;
    const verdict = $('verdict');
    verdict.replaceChildren(make('b', { textContent: `${this.run.live ? '●' : result.status === 0 ? '✓' : '✗'} ${result.verdict}` }), result.why);
    verdict.classList.toggle('good', result.status === 0);
    verdict.hidden = false;
    $('timeline').setAttribute('aria-valuemax', this.run.duration.toFixed(3));
    $('floor').setAttribute('aria-label', `${header.robot} on the floor ${header.map}. ${result.verdict}: ${result.why}`);
  }

  makeCharts() {
    const { run, span } = this;
    const panel = $('plots');
    panel.replaceChildren();
    this.charts = [];
    const add = (title, names, onClose) => {
      const signals = names.map((n) => run.signal(n) ?? this.other?.signal(n)).filter(Boolean);
      const others = this.other ? signals.map((s) => this.other.signal(s.name)).filter((s) => s && !signals.includes(s)) : [];
      if (signals.length) this.charts.push(new Chart(panel, span, title, signals, others, onClose));
    };
    if (run.sensors.length) this.charts.push(new SensorStripes(panel, span, run));
    if (this.other) this.charts.push(new Chart(panel, span, 'distance to the other run', [apart(run, this.other)]));
    add('off the line', ['cross_track_mm']);
    add('speed', ['speed_mm_s', 'wheel_left_mm_s', 'wheel_right_mm_s']);
    add('motor commands', ['left', 'right']);
    for (const name of this.extra)
      add((run.signal(name) ?? this.other?.signal(name))?.label, [name], () => { this.extra.delete(name); this.makeCharts(); });
    const more = make('select', { id: 'add-signal' });
    more.setAttribute('aria-label', 'plot another signal');
    more.append(make('option', { textContent: '+ another signal …', value: '' }));
    for (const { name, label } of run.signals) more.append(make('option', { textContent: label, value: name }));
    for (const { name, label } of this.other?.signals ?? [])
      if (!run.signal(name)) more.append(make('option', { textContent: `${label}, of the other run`, value: name }));
    more.addEventListener('change', () => { this.extra.add(more.value); this.makeCharts(); });
    panel.append(more);
    this.drawTracks();
  }

  makeColours() {
    $('colour-by').replaceChildren();
    for (const [name, label] of [['speed_mm_s', 'by speed, m/s'], ['cross_track_mm', 'by error, mm']])
      if (this.run.signal(name)) $('colour-by').append(make('option', { value: name, textContent: label }));
    if (this.run.signal(this.floor.colourBy)) $('colour-by').value = this.floor.colourBy;
    else this.floor.colourBy = $('colour-by').value;
  }

  makePins() {
    const { run, span } = this;
    const use = uses(run);
    const panel = $('pins');
    panel.replaceChildren();
    this.pins = [];
    if (run.thinned) panel.append(make('p', { className: 'note', textContent: `This run was long: only the last change of each pin in every ${1000 * run.thinned} ms is stored.` }));
    if (!run.pins.length) panel.append(make('p', { className: 'empty', textContent: 'no pin was used' }));
    for (const pin of run.pins) this.pins.push(new PinRow(panel, span, pin, use(pin.name)));
    if (run.pins.length) this.pins.push(new PinAxis(panel, span));
  }

  connect() {
    const { player, view, span } = this;
    const on = (id, action) => $(id).addEventListener('click', action);
    on('play', () => player.toggle());
    on('tick-back', () => player.step(-1));
    on('tick-on', () => player.step(1));
    on('event-back', () => this.stepEvent(-1));
    on('event-on', () => this.stepEvent(1));
    on('zoom-in', () => view.zoom(1.5));
    on('zoom-out', () => view.zoom(1 / 1.5));
    on('fit', () => view.fit());
    on('follow', () => this.toggleFollow());
    on('span-in', () => span.zoom(0.5));
    on('span-out', () => span.zoom(2));
    on('span-all', () => span.set(Infinity));
    on('theme', () => this.setTheme(document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark'));
    on('help-button', () => $('help').showModal());
    for (const speed of SPEEDS)
      $('speed').append(make('option', { value: speed, textContent: speed < 1 ? `×1/${1 / speed}` : `×${speed}` }));
    $('speed').addEventListener('change', (e) => player.setSpeed(Number(e.target.value)));
    $('colour-by').addEventListener('change', (e) => {
      this.floor.colourBy = e.target.value;
      this.drawFloor();
    });
    $('gradient').style.background = GRADIENT;
    for (const [kind, { label }] of Object.entries(MARKS)) {
      const canvas = make('canvas', { width: 32, height: 32 });
      canvas.style.width = canvas.style.height = '16px';
      const ctx = canvas.getContext('2d');
      ctx.scale(2, 2);
      drawMark(ctx, kind, 8, 8, 5);
      $('marks').append(make('li', {}, canvas, label));
    }
    const tabs = [...document.querySelectorAll('[role="tab"]')];
    for (const tab of tabs) {
      tab.addEventListener('click', () => this.openTab(tab));
      tab.addEventListener('keydown', (e) => {
        const step = { ArrowLeft: -1, ArrowRight: 1 }[e.key];
        if (!step) return;
        e.stopPropagation();
        const next = tabs[(tabs.indexOf(tab) + step + tabs.length) % tabs.length];
        this.openTab(next);
        next.focus();
      });
    }
    let pressed = null;
    $('floor').addEventListener('pointerdown', (e) => { pressed = e; });
    $('floor').addEventListener('click', (e) => {
      if (pressed && Math.hypot(e.clientX - pressed.clientX, e.clientY - pressed.clientY) > 4) return;  // a drag
      this.chooser.chooseAt(...view.toFloor(e.offsetX, e.offsetY), player.t);
    });
    document.addEventListener('keydown', (e) => this.key(e));
    $('other-file').addEventListener('change', ({ target }) => {
      if (target.files[0]) this.open(target.files[0]);
      target.value = '';  // so that the same file can be chosen again
    });
    document.addEventListener('dragover', (e) => e.preventDefault());
    document.addEventListener('drop', (e) => {
      e.preventDefault();
      if (e.dataTransfer.files[0]) this.open(e.dataTransfer.files[0]);
    });
  }

  key(e) {
    const { player } = this;
    if (e.ctrlKey || e.metaKey || e.altKey || $('help').open || e.target.matches('select, input')) return;
    const far = e.shiftKey ? 10 : 1;
    const actions = {
      ' ': () => player.toggle(), ',': () => player.step(-1), '.': () => player.step(1), '<': () => player.step(-10), '>': () => player.step(10),
      ';': () => player.step(-10), ':': () => player.step(10),
      ArrowLeft: () => player.step(-100 * far), ArrowRight: () => player.step(100 * far),
      p: () => this.stepEvent(-1), n: () => this.stepEvent(1), l: () => this.stepEvent(e.shiftKey ? -1 : 1, 'line'), Home: () => player.seek(0), End: () => player.seek(this.run.duration),
      '+': () => player.faster(1), '=': () => player.faster(1), '-': () => player.faster(-1),
      r: () => this.chooser.step(e.shiftKey ? -1 : 1), f: () => this.toggleFollow(), 0: () => this.view.fit(), '?': () => $('help').showModal(),
    };
    const action = actions[e.key] ?? actions[e.key.toLowerCase()];
    if (!action || (e.key === ' ' && e.target.matches('button, [role="tab"]'))) return;
    e.preventDefault();
    action();
  }

  stepEvent(direction, kind) {
    const happened = this.player.stepEvent(direction, kind);
    if (happened.length) this.tellHappened(happened.map((e) => e.text).join(' · '));
    else if (kind) this.tellHappened(`${direction > 0 ? 'after this time' : 'before this time'} the line is neither left nor found`);
  }

  tellHappened(text) {
    if ($('happened').textContent !== text) $('happened').textContent = text;
  }

  toggleFollow() {
    this.view.follow(!this.view.follows);
    if (this.view.follows && this.view.scale < 0.4) this.view.zoom(0.5 / this.view.scale);
    this.drawFloor();
  }

  openTab(tab) {
    for (const each of document.querySelectorAll('[role="tab"]')) {
      const open = each === tab;
      each.setAttribute('aria-selected', open);
      each.tabIndex = open ? 0 : -1;
      $(each.getAttribute('aria-controls')).hidden = !open;
    }
    this.drawTracks();
    for (const list of [this.serial, this.events]) { list.now = -2; list.move(); list.draw(); }
    this.wiring.move();
  }

  setTheme(theme) {
    document.documentElement.dataset.theme = theme;
    this.redraw();
  }

  /** Applies the parameters of a link: run.html#t=3.2&tab=pins&theme=dark&span=0.5&robot=B */
  goTo(where) {
    if (where.has('robot')) this.chooser.chooseByName(where.get('robot'));
    if (where.has('theme')) this.setTheme(where.get('theme'));
    if (where.has('tab')) this.openTab($(`tab-${where.get('tab')}`) ?? $('tab-plots'));
    if (Number(where.get('t')) > 0) this.player.seek(Number(where.get('t')));
    if (Number(where.get('span')) > 0) this.span.set(Number(where.get('span')));
  }

  /** Draws another run over this one. An invalid file leaves the page unchanged. */
  async open(file) {
    const { over = [null] } = this;
    try {
      this.compare(await runsOfFile(file), file.name);
      $('problem').hidden = true;
    } catch (error) {
      if (this.over !== over) this.compare(...over);
      complain(error);
    }
  }

  /** Compares with another run. `others` are the Runs of the other run's robots; null ends the comparison. */
  compare(others, name) {
    this.over = [others, name];
    this.others = others;
    const other = this.other = others && this.otherOf(this.run);
    const box = $('other-box');
    box.hidden = !other;
    if (other) {
      const whose = others.length > 1 ? `${others.length} robots, ${other.name}: ` : '';
      const what = other.result ? `${whose}${other.title}, seed ${other.result.seed}, ${other.header.target}: ${other.result.verdict}` : other.what;
      box.replaceChildren(`over it: ${name} (${what})`, make('button', { textContent: 'remove', onclick: () => this.compare(null) }));
    }
    this.view.area = areaOf(other ? [...this.runs, ...others] : this.runs);
    this.makeCharts();
    this.redraw();
  }

  /** Returns the other run's robot with the same name, otherwise its first robot. */
  otherOf(run) { return this.others.find(({ name }) => name === run.name) ?? this.others[0]; }

  drawFloor() {
    const { view, player, floor } = this;
    if (view.follows) ({ x: view.x, y: view.y } = this.run.pose(player.t));
    floor.draw(view, player.t, this.other, this.other && Math.min(player.t, this.other.duration));
    $('follow').setAttribute('aria-pressed', view.follows);
    $('gradient-most').textContent = floor.colourBy === 'speed_mm_s' ? (floor.most / 1000).toFixed(2) : floor.most.toFixed(1);
  }

  get tracks() {
    if (!$('plots').hidden) return this.charts;
    return $('pins').hidden ? [] : this.pins;
  }
  drawTracks() { for (const track of this.tracks) track.draw(); }

  redraw() {
    this.drawFloor();
    this.timeline.draw();
    this.drawTracks();
  }

  resize() {
    if (this.view.fits) this.view.fit();
    this.redraw();
  }

  /** Redraws after the run has grown. */
  grow() {
    for (const chart of this.charts) chart.measure?.();
    for (const list of [this.serial, this.events]) list.grow();
    $('timeline').setAttribute('aria-valuemax', this.run.duration.toFixed(3));
    this.timeline.draw();
    this.drawTracks();
  }

  /** Updates the page after the shown time has changed. */
  move() {
    const { player, run, span } = this;
    $('time').textContent = timeText(player.t);
    const play = $('play');
    play.classList.toggle('playing', player.playing);
    play.setAttribute('aria-label', player.playing ? 'pause' : 'play');
    $('speed').value = player.speed;
    this.now.move(player.t);
    // Screen readers announce events while the user steps, but not while the run plays.
    $('happened').setAttribute('aria-live', player.playing ? 'off' : 'polite');
    this.tellHappened(run.events.findLast((e) => e.t <= player.t)?.text ?? '');
    span.follow();
    this.drawFloor();
    this.timeline.move();
    for (const track of this.tracks) track.move();
    this.serial.move();
    this.events.move();
    this.wiring.move();
  }
}

const runsOfFile = async (file) => runsOfBytes(new Uint8Array(await file.arrayBuffer()), file.name);

async function runsOfBytes(bytes, name) {
  const begin = new TextDecoder('latin1').decode(bytes.subarray(0, 64)).trimStart().toLowerCase();
  const isPage = begin.startsWith('<!doctype html'), text = () => new TextDecoder().decode(bytes);
  if (!isPage && !begin.startsWith('robosim.rec/') && !/\.(rec|html)$/i.test(name)) return [runOfTable(text(), name)];
  try {
    return runsOf(await readRecording(isPage ? bytesOfPage(text()) : bytes));
  } catch (error) {
    throw error instanceof BadFile ? new BadFile(`${name}: ${error.message}`) : error;
  }
}

function complain(error) {
  const known = error instanceof BadFile;
  $('problem').textContent = known ? error.message : `The page could not show this: ${error.message}`;
  $('problem').hidden = false;
  if (!known) throw error;
}

/** Prepares this page, which has no recording, for a live run. The page that contains this one calls
 *  robosimLive(header, paused), which returns { page, feed }. */
function awaitRun() {
  $('subtitle').textContent = 'waiting for the run …';
  window.robosimLive = (header, state) => {
    const page = new Page(liveRunsOf(header, state));
    window.robosim = page;
    return { page, feed: new LiveFeed(page) };
  };
}

async function begin() {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  document.documentElement.dataset.theme = dark.matches ? 'dark' : 'light';
  try {
    if (typeof DecompressionStream === 'undefined') throw new BadFile('This browser is too old for the page: it needs Chromium 80, Firefox 113, Safari 16.4 or later.');
    if (location.hash === '#live') return awaitRun();
    const page = new Page(runsOf(await readRecording(bytesOfBase64($('recording').textContent))));
    dark.addEventListener('change', (e) => page.setTheme(e.matches ? 'dark' : 'light'));
    const { textContent: over, dataset } = $('over');
    if (over) {
      const name = new TextDecoder().decode(bytesOfBase64(dataset.name));
      await page.open(new File([bytesOfBase64(over)], name));
    }
    page.goTo(new URLSearchParams(location.hash.slice(1)));
    window.robosim = page;  // for tests, and for users at the console
  } catch (error) {
    $('subtitle').textContent = '';
    complain(error);
  }
  document.documentElement.dataset.ready = 'true';
}

begin();
