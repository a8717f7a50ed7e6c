// Defines colours that colour-blind people can distinguish. Series use the colours of Okabe and Ito.
// Magnitudes use a part of the colour map "plasma" (van der Walt and Smith). The ends of this colour map
// are omitted, because they would be invisible on the line or the floor.

const SERIES = {
  light: ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#b07a00', '#2f9bd8', '#7a5195', '#6f6f00'],
  dark: ['#56b4e9', '#f08a3c', '#2fc79b', '#e39ac6', '#e69f00', '#9ad0f5', '#b79ad0', '#d6d05a'],
};
export function series(i) { return SERIES[document.documentElement.dataset.theme ?? 'light'][i % 8]; }

const PLASMA = [[84, 2, 163], [126, 3, 168], [156, 23, 158], [182, 48, 139], [204, 71, 120], [222, 95, 101],
  [237, 121, 83], [248, 149, 64], [253, 180, 47]];

/** Returns the colour of a magnitude. `share` is 0 to 1. */
export function more(share) {
  const at = Math.min(Math.max(share, 0), 1) * (PLASMA.length - 1);
  const i = Math.min(Math.floor(at), PLASMA.length - 2), part = at - i;
  return `rgb(${PLASMA[i].map((from, k) => Math.round(from + part * (PLASMA[i + 1][k] - from))).join(' ')})`;
}

export const GRADIENT = `linear-gradient(to right, ${[0, 1, 2, 3, 4, 5, 6, 7, 8].map((i) => more(i / 8)).join(', ')})`;

/** Returns the colour of a line sensor's reading: 0 = only white, 1 = only black. */
export function seen(level) {
  const mix = (from, to) => Math.round(from + Math.min(Math.max(level, 0), 1) * (to - from));
  return `rgb(${mix(255, 230)} ${mix(255, 110)} ${mix(255, 0)})`;
}

/** The kinds of events, each with a colour and a shape. */
export const MARKS = {
  landmark: { colour: '#0072b2', shape: 'circle', label: 'stations, laps' },
  line: { colour: '#cc79a7', shape: 'diamond', label: 'line left, found' },
  serial: { colour: '#7f868f', shape: 'bar', label: 'serial' },
  script: { colour: '#009e73', shape: 'triangle', label: 'script' },
  fault: { colour: '#e69f00', shape: 'square', label: 'faults, power' },
  collision: { colour: '#d55e00', shape: 'cross', label: 'collisions' },
  told: { colour: '#56b4e9', shape: 'circle', label: 'displays' },
  end: { colour: '#222', shape: 'flag', label: 'the end' },
};

/** Returns a colour of the page's current style, light or dark. */
export function style(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

export function drawMark(ctx, kind, x, y, r) {
  const { colour, shape } = MARKS[kind];
  ctx.fillStyle = ctx.strokeStyle = kind === 'end' ? style('text') : colour;
  ctx.lineWidth = 2;
  ctx.beginPath();
  if (shape === 'circle') ctx.arc(x, y, r, 0, 2 * Math.PI);
  if (shape === 'square') ctx.rect(x - r, y - r, 2 * r, 2 * r);
  if (shape === 'bar') ctx.rect(x - 1, y - r, 2, 2 * r);
  if (shape === 'triangle') { ctx.moveTo(x - r, y + r); ctx.lineTo(x + r, y + r); ctx.lineTo(x, y - r); }
  if (shape === 'diamond') {
    ctx.moveTo(x - 1.2 * r, y); ctx.lineTo(x, y - 1.2 * r); ctx.lineTo(x + 1.2 * r, y); ctx.lineTo(x, y + 1.2 * r);
  }
  if (shape === 'flag') { ctx.rect(x - 1, y - 1.4 * r, 2, 2.8 * r); ctx.rect(x, y - 1.4 * r, 2 * r, 1.4 * r); }
  if (shape === 'cross') {
    ctx.moveTo(x - r, y - r); ctx.lineTo(x + r, y + r); ctx.moveTo(x - r, y + r); ctx.lineTo(x + r, y - r);
    ctx.stroke();
  } else {
    ctx.fill();
  }
}
