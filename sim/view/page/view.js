// Selects the visible part of the floor, and its scale. Dragging, the mouse wheel and pinching change them.
// Positions on the floor are in mm, with y to the north. Positions on the screen are in CSS pixels, with y
// down.

const LEAST_PX_PER_MM = 0.005, MOST_PX_PER_MM = 20;
const MARGIN_PX = 12, SCALE_PX = 40;  // the scale and the trail's colours are below the floor

export class View {
  constructor(canvas, area, changed) {
    Object.assign(this, { canvas, area, changed });
    this.scale = 1;
    this.x = this.y = 0;  // place on the floor at the canvas's middle
    this.follows = false;
    this.fits = true;     // until the user moves the view
    this.pointers = new Map();
    canvas.addEventListener('wheel', (e) => this.wheel(e), { passive: false });
    canvas.addEventListener('pointerdown', (e) => this.down(e));
    canvas.addEventListener('pointermove', (e) => this.move(e));
    for (const name of ['pointerup', 'pointercancel']) canvas.addEventListener(name, (e) => this.pointers.delete(e.pointerId));
    canvas.addEventListener('dblclick', (e) => this.zoom(2, e.offsetX, e.offsetY));
  }

  get width() { return this.canvas.clientWidth; }
  get height() { return this.canvas.clientHeight; }

  toScreen(x, y) { return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale]; }
  toFloor(px, py) { return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale]; }

  fit() {
    const { x, y, width, height } = this.area;
    const free = this.height - 2 * MARGIN_PX - SCALE_PX;
    this.scale = Math.max(Math.min((this.width - 2 * MARGIN_PX) / width, free / height), LEAST_PX_PER_MM);  // a hidden canvas has no size
    this.x = x + width / 2;
    this.y = y + height / 2 - SCALE_PX / 2 / this.scale;
    this.fits = true;
    this.follows = false;
    this.changed();
  }

  follow(on) {
    this.follows = on;
    this.fits = false;
    this.changed();
  }

  /** Zooms around a pixel: the place under this pixel stays there. */
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const [x, y] = this.toFloor(px, py);
    this.scale = Math.min(Math.max(this.scale * factor, LEAST_PX_PER_MM), MOST_PX_PER_MM);
    const [now_x, now_y] = this.toFloor(px, py);
    this.x += x - now_x;
    this.y += y - now_y;
    this.fits = false;
    this.changed();
  }

  pan(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
    this.fits = this.follows = false;
    this.changed();
  }

  wheel(e) {
    e.preventDefault();
    const pixels = e.deltaMode === 1 ? 16 * e.deltaY : e.deltaY;
    this.zoom(Math.exp(-pixels * (e.ctrlKey ? 0.01 : 0.0015)), e.offsetX, e.offsetY);
  }

  down(e) {
    this.canvas.setPointerCapture(e.pointerId);
    this.pointers.set(e.pointerId, [e.offsetX, e.offsetY]);
  }

  move(e) {
    const before = this.pointers.get(e.pointerId);
    if (!before) return;
    const now = [e.offsetX, e.offsetY];
    if (this.pointers.size === 2) {
      const other = [...this.pointers].find(([id]) => id !== e.pointerId)[1];
      const apart = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]);
      this.zoom(apart(now) / Math.max(apart(before), 1), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
    } else if (this.pointers.size === 1) {
      this.pan(now[0] - before[0], now[1] - before[1]);
    }
    this.pointers.set(e.pointerId, now);
  }
}

/** Resizes a canvas to its displayed size in device pixels. Returns its cleared context, in CSS pixels. */
export function sized(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const ctx = canvas.getContext('2d');
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  ctx.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
  return ctx;
}
