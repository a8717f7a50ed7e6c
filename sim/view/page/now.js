// Shows measurements and lamps at the shown time.

import { short } from './charts.js';
import { seen } from './colours.js';

const element = (tag, properties = {}, ...children) => {
  const one = Object.assign(document.createElement(tag), properties);
  one.append(...children);
  return one;
};

export class Now {
  constructor(panel, run) {
    panel.replaceChildren();
    this.shows = [];
    const of = (name, label, unit, digits) => {
      const value = element('b', { id: `now-${name}` });
      panel.append(element('div', {}, value, label));
      this.shows.push((t) => {
        value.textContent = run.at(name, t).toFixed(digits);
        if (unit) value.append(element('small', { textContent: ` ${unit}` }));
      });
    };
    of('speed_mm_s', 'speed', 'mm/s', 0);
    if (run.signal('cross_track_mm')) of('cross_track_mm', 'off the line', 'mm', 1);
    of('left', 'motor left', '', 2);
    of('right', 'motor right', '', 2);
    if (run.sensors.length) panel.append(this.sensors(run));
    const others = run.started.readings.filter((name) => !run.sensors.some((s) => s.name === name));
    if (others.length) panel.append(this.lamps(run, others));
  }

  sensors(run) {
    const box = element('div', { className: 'sensors' });
    for (const { name } of [...run.sensors].sort((a, b) => b.y - a.y || a.x - b.x)) {
      const level = element('i', { title: name });
      level.dataset.sensor = name;
      box.append(element('span', {}, level, name));
      this.shows.push((t) => {
        const value = run.reading(name, t);
        level.style.background = seen(value);
        level.textContent = value.toFixed(2).replace(/^0\./, '.').replace('1.00', '1').replace('.00', '0');
      });
    }
    return box;
  }

  lamps(run, names) {
    const lamps = element('div', { className: 'onoff' });
    for (const name of names) {
      const lamp = element('span', { textContent: name });
      lamp.dataset.reading = name;
      lamps.append(lamp);
      this.shows.push((t) => {
        const value = run.reading(name, t);
        if (run.units.has(name)) lamp.textContent = `${name} ${short(value)} ${run.units.get(name)}`;
        else lamp.classList.toggle('on', value >= 0.5);
      });
    }
    return lamps;
  }

  move(t) { for (const show of this.shows) show(t); }
}
