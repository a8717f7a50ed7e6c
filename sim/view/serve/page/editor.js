// Lets the user draw maps (docs/reference/maps.md). The text is the map: drawing changes the text, and the
// server interprets the text, as in every run. So everything that only the text can express stays, and an
// invalid text stays unchanged.

import { post } from '/watch.js';

const $ = (id) => document.getElementById(id);
const CELLS = { line: '.', floor: '_', wall: '#', obstacle: 'x', start: 'S', goal: 'G' };
const NEW_MAP = `+++\nname = "my-map"\ncorner = "200 mm"\n+++\n${`${'_'.repeat(20)}\n`.repeat(12)}`;

/** Returns { front, rows }: the settings between +++, and the rows of cells. */
export function parts(text) {
  const found = /^\+\+\+\r?\n([\s\S]*?)^\+\+\+(?:\r?\n|$)/m.exec(text);
  const has = found && found.index === 0;
  return { front: has ? found[1] : '', rows: text.slice(has ? found[0].length : 0).split(/\r?\n/).filter((row, i, all) => i < all.length - 1 || row) };
}
export const join = ({ front, rows }) => `${front ? `+++\n${front}+++\n` : ''}${rows.map((row) => `${row}\n`).join('')}`;

/** Chooses a legend digit for drawing with `tool` on a cell with the digit `found`. The cell keeps its surface.
 *  Returns { digit, front }: the digit, and the settings with this digit. Returns null if `found` has no
 *  surface, the tool cannot have one, or no digit is free. */
export function onSurface(front, found, tool) {
  const words = Object.fromEntries([...(/^\[legend\]\r?\n((?:(?!\[).*\n?)*)/m.exec(front)?.[1] ?? '').matchAll(/^([3-9])\s*=\s*"(.*?)"/gm)].map(([, digit, means]) => [digit, means]));
  const [, kind] = /^(?!floor|line|wall|gap|obstacle)(\w+)/.exec(words[found] ?? '') ?? [];
  if (!kind || !['line', 'floor', 'obstacle'].includes(tool)) return null;
  const means = `${kind} ${tool}`, is = (digit) => words[digit] === means || (tool === 'floor' && words[digit] === kind);
  const known = Object.keys(words).find(is);
  if (known) return { digit: known, front };
  const digit = [...'3456789'].find((free) => !new RegExp(`^${free}\\s*=`, 'm').test(front));
  return digit ? { digit, front: front.replace(/^\[legend\]\r?\n/m, `[legend]\n${digit} = "${means}"\n`) } : null;
}

/** Returns the segment from a pose to a place: a straight line, or the only arc that begins with this
 *  heading. */
export function segmentTo({ x, y, heading }, toX, toY) {
  const chord = Math.hypot(toX - x, toY - y);
  let off = Math.atan2(toY - y, toX - x) - heading;
  off -= 2 * Math.PI * Math.round(off / (2 * Math.PI));
  const end = { x: toX, y: toY, heading: heading + 2 * off };
  if (Math.abs(off) < 0.03) return { text: `{ length = "${chord.toFixed(1)} mm" }`, end: { ...end, heading } };
  return { text: `{ radius = "${(chord / (2 * Math.sin(Math.abs(off)))).toFixed(1)} mm", angle = "${(off * 360 / Math.PI).toFixed(2)} deg" }`, end };
}

export class Editor {
  constructor({ listed, maps }) {
    Object.assign(this, { listed, maps, undone: [], known: '', typing: false, floor: null, path: null, cursor: { x: 1, y: 1 }, asked: 0, said: 0 });
    this.fit();
    this.canvas = $('sheet');
    this.text = $('map-text');
    $('map-close').onclick = () => { $('editor').hidden = true; };
    $('map-new').onclick = () => this.load('my.map', NEW_MAP);
    $('map-save').onclick = () => this.save(false);
    $('map-replace').onclick = () => this.save(true);
    $('map-undo').onclick = () => this.undo();
    $('map-end').onclick = () => this.endPath();
    $('tool').onchange = () => this.endPath();
    this.text.oninput = () => this.typed();
    this.text.onchange = () => { this.typed(); this.typing = false; };
    this.canvas.onpointerdown = (e) => this.down(e);
    this.canvas.onpointermove = (e) => this.move(e);
    this.canvas.onpointerup = (e) => this.up(e);
    this.canvas.onkeydown = (e) => this.key(e);
    this.canvas.onwheel = (e) => { e.preventDefault(); this.zoom(Math.exp(-0.0015 * e.deltaY), e.offsetX, e.offsetY); };
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  async open(name) {
    $('editor').hidden = false;
    if (!name) return this.load('my.map', NEW_MAP);
    const answer = await post('/api/map', { name });
    this.load(name.startsWith('./') ? name : `my-${name}.map`, (await answer.json()).text);
  }

  load(name, text) {
    $('map-name').value = name;
    this.text.value = text;
    this.undone = [];
    this.path = null;
    this.floor = null;  // the floor of another map must not be used for drawing
    this.canvas.ariaBusy = 'true';
    this.fit();
    this.draw();
    this.canvas.focus();
    return this.look();
  }

  /** Records typing as a single step for undo. */
  typed() {
    if (this.text.value === this.known) return;
    if (!this.typing) this.undone.push(this.known);
    this.typing = true;
    this.look();
  }

  /** Replaces the text, and records the previous one for undo. */
  change(text) {
    if (text === this.text.value) return;
    this.undone.push(this.text.value);
    this.text.value = text;
    this.typing = false;
    this.look();
  }
  undo() {
    this.typing = false;
    if (this.undone.length) this.text.value = this.undone.pop();
    this.path = null;
    this.look();
  }

  /** Requests the floor of the text from the server. Keeps the last valid floor. */
  async look() {
    const mine = ++this.asked, { said } = this;
    this.known = this.text.value;
    $('map-replace').hidden = true;
    try {
      const answer = await post('/api/floor', { name: $('map-name').value, text: this.text.value });
      const { floor } = await answer.json();
      if (mine !== this.asked) return;
      this.floor = floor;
      if (said === this.said) this.say('');  // newer messages stay
    } catch (error) {
      if (mine === this.asked) this.say(error.message);
    }
    if (mine === this.asked) this.canvas.ariaBusy = 'false';
    this.draw();
  }
  say(sentence) {
    this.said++;
    $('map-said').textContent = sentence;
  }

  async save(replace) {
    try {
      const named = $('map-name').value.trim();
      const name = named.endsWith('.map') ? named : `${named}.map`;
      const answer = await post('/api/file', { name, text: this.text.value, replace });
      const { saved } = await answer.json();
      $('map-replace').hidden = true;
      await this.listed();
      this.maps.value = saved;
      this.say(`saved as ${saved.slice(2)}`);
    } catch (error) {
      this.say(error.message);
      $('map-replace').hidden = !error.message.endsWith('already');
    }
  }

  // Coordinates: mm on the floor, y up; cells from the top left.
  get scale() { return this.larger * Math.min((this.canvas.clientWidth - 16) / this.floor.width, (this.canvas.clientHeight - 16) / this.floor.height); }
  toFloor(px, py) { return [(px - this.left) / this.scale, this.floor.height - (py - this.top) / this.scale]; }
  toSheet(x, y) { return [this.left + x * this.scale, this.top + (this.floor.height - y) * this.scale]; }
  /** Shows the whole map. */
  fit() { Object.assign(this, { larger: 1, left: 8, top: 8 }); }
  /** Zooms around a pixel: the place under this pixel stays there. */
  zoom(factor, px, py) {
    if (!this.floor) return;
    const [x, y] = this.toFloor(px, py);
    this.larger = Math.min(Math.max(this.larger * factor, 1), 1000);
    if (this.larger === 1) this.fit();
    else this.shift(px, py, ...this.toSheet(x, y));
    this.draw();
  }
  shift(px, py, fromX, fromY) {
    this.left += px - fromX;
    this.top += py - fromY;
  }
  /** Keeps the cell at the keyboard cursor visible. */
  keepInSight() {
    const [px, py] = this.toSheet(...this.middle(this.cursor)), { clientWidth: width, clientHeight: height } = this.canvas;
    const edge = Math.min(10 + this.scale * this.floor.cell / 2, width / 2, height / 2), within = (at, most) => Math.min(Math.max(at, edge), most - edge);
    if (this.larger > 1) this.shift(within(px, width), within(py, height), px, py);
  }
  cellAt(e) {
    const [x, y] = this.toFloor(e.offsetX, e.offsetY);
    return { x: Math.floor(x / this.floor.cell), y: Math.floor((this.floor.height - y) / this.floor.cell) };
  }

  setCell({ x, y }) {
    const map = parts(this.text.value), tool = $('tool').value, kept = onSurface(map.front, map.rows[y]?.[x], tool);
    const c = kept?.digit ?? CELLS[tool];
    if (!map.rows.length) return this.say('this map has no rows of cells: draw paths');
    if (!(x >= 0 && y >= 0 && y < map.rows.length && x < map.rows[0].length)) return undefined;
    const put = (row, at) => `${row.slice(0, at)}${c}${row.slice(at + 1)}`;
    if (c === 'S' || c === 'G') map.rows = map.rows.map((row) => row.replaceAll(c, '.'));
    map.rows[y] = put(map.rows[y], x);
    map.front = kept?.front ?? map.front;
    return this.change(join(map));
  }

  /** Sets a station. Its name is in the field next to the tools. */
  setStation({ x, y }) {
    const map = parts(this.text.value), name = $('station').value.trim() || `s${x}-${y}`;
    const line = `${name} = [${x}, ${y}]\n`;
    map.front = map.front.replace(new RegExp(`^${name.replace(/[^\w-]/g, '')} = \\[\\d+, \\d+\\]\n`, 'm'), '');
    map.front = map.front.includes('[stations]\n') ? map.front.replace('[stations]\n', `[stations]\n${line}`) : `${map.front}\n[stations]\n${line}`;
    this.change(join(map));
  }

  /** Adds a click to a path of straights and arcs. The clicks set its start, its direction, and the end of each
   *  segment. */
  addToPath(x, y) {
    const step = this.floor.cell / 2;
    [x, y] = [Math.round(x / step) * step, Math.round(y / step) * step];
    if (!this.path) {
      this.path = { from: [x, y], segments: [], before: this.text.value };
      this.say('now click the end of the first straight');
      return this.draw();
    }
    const { path } = this;
    if (!path.end) {
      path.heading = Math.atan2(y - path.from[1], x - path.from[0]);
      path.end = { x: path.from[0], y: path.from[1], heading: path.heading };
    }
    const { text, end } = segmentTo(path.end, x, y);
    path.segments.push(text);
    path.end = end;
    const map = parts(path.before);
    map.front += `\n[[path]]\nfrom = ["${path.from[0]} mm", "${path.from[1]} mm"]\nheading = "${(path.heading * 180 / Math.PI).toFixed(3)} deg"\nsegments = [\n${path.segments.map((s) => `  ${s},\n`).join('')}]\n`;
    return this.change(join(map));
  }
  endPath() {
    this.path = null;
    this.draw();
  }

  addSurface([x, y], [toX, toY]) {
    const map = parts(this.text.value), mm = (value) => `"${Math.round(value)} mm"`;
    if (Math.min(Math.abs(toX - x), Math.abs(toY - y)) < 5) return this.say('drag from one corner of the surface to the opposite one');
    map.front += `\n[[surface]]\nat = [${mm((x + toX) / 2)}, ${mm((y + toY) / 2)}]\nsize = [${mm(Math.abs(toX - x))}, ${mm(Math.abs(toY - y))}]\nkind = "${$('surface').value}"\n`;
    return this.change(join(map));
  }

  apply(cell, place) {
    const tool = $('tool').value;
    if (tool in CELLS) this.setCell(cell);
    if (tool === 'station') this.setStation(cell);
    if (tool === 'path') this.addToPath(...place);
  }

  down(e) {
    if (!this.floor) return;
    this.canvas.setPointerCapture(e.pointerId);
    this.from = this.toFloor(e.offsetX, e.offsetY);
    this.cursor = this.last = this.cellAt(e);
    this.apply(this.cursor, this.from);
  }
  move(e) {
    if (!this.from || !this.floor) return;
    const cell = this.cellAt(e);
    if (cell.x === this.last.x && cell.y === this.last.y) return;
    // Draws all cells in between, since a fast pointer skips cells.
    const steps = Math.max(Math.abs(cell.x - this.last.x), Math.abs(cell.y - this.last.y));
    for (let i = 1; i <= steps && ['line', 'floor', 'wall'].includes($('tool').value); i++)
      this.setCell({ x: Math.round(this.last.x + (cell.x - this.last.x) * i / steps), y: Math.round(this.last.y + (cell.y - this.last.y) * i / steps) });
    this.cursor = this.last = cell;
    this.draw();
  }
  up(e) {
    if (this.from && $('tool').value === 'surface') this.addSurface(this.from, this.toFloor(e.offsetX, e.offsetY));
    this.from = null;
  }

  key(e) {
    if (!this.floor) return;
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
    const tools = [...$('tool').options];
    if (step) this.cursor = { x: this.cursor.x + step[0], y: this.cursor.y + step[1] };
    else if (e.key === ' ' || e.key === 'Enter') this.apply(this.cursor, this.middle(this.cursor));
    else if ((e.ctrlKey || e.metaKey) && e.key === 'z') this.undo();
    else if (e.key === 'Escape') this.endPath();
    else if (['+', '=', '-'].includes(e.key)) this.zoom(e.key === '-' ? 1 / 1.5 : 1.5, ...this.toSheet(...this.middle(this.cursor)));
    else if (e.key === '0') this.fit();
    else if (tools[Number(e.key) - 1]) $('tool').value = tools[Number(e.key) - 1].value;
    else return;
    e.preventDefault();
    if (step) this.keepInSight();
    if (step && e.shiftKey) this.apply(this.cursor, this.middle(this.cursor));
    this.draw();
  }
  middle({ x, y }) { return [(x + 0.5) * this.floor.cell, this.floor.height - (y + 0.5) * this.floor.cell]; }

  draw() {
    const { canvas, floor } = this, ratio = devicePixelRatio || 1;
    if (!canvas.clientWidth) return;
    Object.assign(canvas, { width: canvas.clientWidth * ratio, height: canvas.clientHeight * ratio });
    if (!floor) return;
    const ctx = canvas.getContext('2d'), { scale } = this;
    ctx.setTransform(ratio * scale, 0, 0, -ratio * scale, this.left * ratio, (this.top + floor.height * scale) * ratio);
    const [paper, paint] = floor.light_line ? ['#222', '#fff'] : ['#fdfcf8', '#111'];
    ctx.fillStyle = paper;
    ctx.fillRect(0, 0, floor.width, floor.height);
    ctx.save();
    ctx.beginPath();
    ctx.rect(0, 0, floor.width, floor.height);
    ctx.clip();
    for (const { colour, disc, corners } of floor.areas ?? []) {
      const area = new Path2D();
      if (disc) area.arc(disc[0], disc[1], disc[2], 0, 2 * Math.PI);
      else for (const [x, y] of corners) area.lineTo(x, y);
      ctx.fillStyle = colour;
      ctx.fill(area);
    }
    this.drawSurfaces(ctx);
    ctx.restore();
    this.drawGrid(ctx, 1 / scale);
    ctx.fillStyle = '#6b7280';
    for (const [x, y, width, height] of floor.walls) ctx.fillRect(x, y, width, height);
    ctx.fillStyle = paint;
    for (const [x, y, width, height] of floor.dark) ctx.fillRect(x, y, width, height);
    ctx.lineCap = 'round';
    for (const { line: [x, y, toX, toY], arc, painted = true, width = floor.line, colour = paint } of floor.stripes) {
      ctx.beginPath();
      ctx.moveTo(x, y);
      if (arc) ctx.arc(arc[0], arc[1], arc[2], Math.atan2(y - arc[1], x - arc[0]), Math.atan2(toY - arc[1], toX - arc[0]));
      else ctx.lineTo(toX, toY);
      ctx.lineWidth = painted ? width : width / 6;
      ctx.strokeStyle = colour;
      ctx.stroke();
    }
    ctx.fillStyle = '#8a4b08';
    for (const [x, y] of floor.obstacles) ctx.fillRect(x - 0.35 * floor.cell, y - 0.35 * floor.cell, 0.7 * floor.cell, 0.7 * floor.cell);
    this.drawLabels(ctx, scale);
    ctx.lineWidth = 2 / scale;
    ctx.strokeStyle = '#0072b2';
    ctx.strokeRect(this.cursor.x * floor.cell, floor.height - (this.cursor.y + 1) * floor.cell, floor.cell, floor.cell);
    if (this.path) {
      const { x, y } = this.path.end ?? { x: this.path.from[0], y: this.path.from[1] };
      ctx.fillStyle = '#d55e00';
      ctx.fillRect(x - 5 / scale, y - 5 / scale, 10 / scale, 10 / scale);
    }
    $('map-end').disabled = !this.path;
  }

  drawGrid(ctx, px) {
    const { width, height, cell } = this.floor;
    if (cell < 5 * px) return;  // would cover the map
    ctx.fillStyle = 'rgb(128 128 128 / 25%)';
    for (let x = 0; x <= width + px; x += cell) ctx.fillRect(x, 0, px, height);
    for (let y = 0; y <= height + px; y += cell) ctx.fillRect(0, y, width, px);
  }

  drawSurfaces(ctx) {
    const mm = (text) => parseFloat(text) * (/\d\s*m$/.test(text) ? 1000 : /cm$/.test(text) ? 10 : 1);
    ctx.fillStyle = 'rgb(0 114 178 / 22%)';
    for (const [, at, size] of this.text.value.matchAll(/\[\[surface\]\]\s+at = \[(.*?)\]\s+size = \[(.*?)\]/g)) {
      const [x, y, width, height] = [...at.matchAll(/"(.*?)"/g), ...size.matchAll(/"(.*?)"/g)].map(([, text]) => mm(text));
      ctx.fillRect(x - width / 2, y - height / 2, width, height);
    }
  }

  drawLabels(ctx, scale) {
    const { floor } = this, { front, rows } = parts(this.text.value);
    const label = (text, x, y) => {
      ctx.save();
      ctx.translate((x + 0.5) * floor.cell, floor.height - (y + 0.5) * floor.cell);
      ctx.scale(1 / scale, -1 / scale);
      ctx.font = '600 12px system-ui, sans-serif';
      ctx.textAlign = 'center';
      ctx.textBaseline = 'middle';
      const wide = ctx.measureText(text).width + 10;
      ctx.fillStyle = '#0072b2';
      ctx.fillRect(-wide / 2, -9, wide, 18);
      ctx.fillStyle = '#fff';
      ctx.fillText(text, 0, 0.5);
      ctx.restore();
    };
    rows.forEach((row, y) => [...row].forEach((c, x) => { if (c === 'S' || c === 'G') label(c, x, y); }));
    const stations = /\[stations\]\n([^[]*(?:\[\d+, \d+\][^[]*)*)/.exec(front)?.[1] ?? '';
    for (const [, name, x, y] of stations.matchAll(/^([\w-]+) = \[(\d+), (\d+)\]/gm)) label(name, Number(x), Number(y));
  }
}
