// Implements the form above a replay, without a server: a worker runs the sketch. The page that
// `robosim run --record run.html` writes shows the recording.

import { TextEditor } from './edit.js';
import { buttonsOf, onClicks, sending, withLine } from './hands.js';
import { MOST_LINK, ofFile, ofLink, packed, toFile, toLink, unpacked } from './share.js';

const $ = (id) => document.getElementById(id);
const REPLAY = '<script id="recording" type="application/octet-stream">';

let stock;   // content of stock.json: { sketches: { name: { robot, board, hex } }, robots: { name: { board, toml } }, maps: { name: text } }
let worker = null, replay = '';
let last = null;      // { wanted, result, rec }
let expected = null;  // the trace hash of a shared run
const own = { sketch: new Map(), robot: new Map(), map: new Map() };  // by name, each { name, bytes }

const OWN = 'own:';
const KINDS = { hex: 'sketch', elf: 'sketch', toml: 'robot', map: 'map' };

// ---- choices

function fill(select, stockNames, kind) {
  const before = select.value;
  const group = (label, options) => {
    const element = document.createElement('optgroup');
    element.label = label;
    element.append(...options);
    return element;
  };
  const mine = [...own[kind].keys()].map((name) => new Option(name, OWN + name));
  const theirs = stockNames.map((name) => new Option(name, name));
  select.replaceChildren(...(mine.length ? [group('yours', mine), group('Robosim’s', theirs)] : theirs));
  if ([...select.options].some((option) => option.value === before)) select.value = before;
}

/** Returns the possible robots. A stock sketch is an image for one board; a user's image may be for any board. Omits
 *  robots with an STM32, which does not run here. The folder has them, because other robots may be based on them. */
function robotsFor(sketch) {
  const board = stock.sketches[sketch]?.board;
  return Object.keys(stock.robots).filter((name) => board ? stock.robots[name].board === board : stock.robots[name].board !== 'bluepill');
}

function fillAll() {
  fill($('sketch'), Object.keys(stock.sketches), 'sketch');
  fill($('robot'), robotsFor($('sketch').value), 'robot');
  fill($('map'), Object.keys(stock.maps), 'map');
}

function chooseSketch() {
  fill($('robot'), robotsFor($('sketch').value), 'robot');
  const robot = stock.sketches[$('sketch').value]?.robot;
  if (robot && !$('robot').value.startsWith(OWN)) $('robot').value = robot;
}

const chosen = (kind) => {
  const { value } = $(kind);
  return value.startsWith(OWN) ? { ...own[kind].get(value.slice(OWN.length)) } : value;  // a copy: the file may be edited
};

function wantedNow() {
  return {
    sketch: chosen('sketch'), robot: chosen('robot'), map: chosen('map'), seed: $('seed').value, goal: $('goal').value.trim(),
    seconds: Number($('seconds').value), profile: $('profile').value, script: $('script').value,
  };
}

/** Sets the form from values of wantedNow(). Throws an Error with a sentence for files that this folder does not
 *  have. */
function want({ sketch, robot, map, ...more }) {
  const has = { sketch: stock.sketches, robot: stock.robots, map: stock.maps };
  for (const [kind, value] of Object.entries({ sketch, robot, map }))
    if (typeof value === 'string' && !Object.hasOwn(has[kind], value))
      throw new Error(`There is no ${kind} ${value} here; there are ${Object.keys(has[kind]).join(', ')}.`);
  for (const [kind, value] of Object.entries({ sketch, robot, map })) if (value?.name) own[kind].set(value.name, value);
  fillAll();
  const set = (id, value) => {
    if (value === undefined) return;
    const text = value.name ? OWN + value.name : String(value);
    $(id).value = text;
    if ($(id).value !== text && id !== 'script') throw new Error(`Invalid ${id} in the link: ${value.name ?? value}.`);
  };
  set('sketch', sketch);
  chooseSketch();
  set('robot', robot);
  set('map', map);
  for (const key of ['seed', 'goal', 'seconds', 'profile', 'script']) set(key, more[key]);
  $('more').open = Boolean($('goal').value || $('script').value);
}

// ---- files

async function take(files) {
  complain('');
  try {
    await takeAll(files);
  } catch (error) {
    complain(error.message);
  }
}

async function takeAll(files) {
  for (const file of files) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const shared = ofFile(bytes);
    const kind = KINDS[file.name.split('.').pop().toLowerCase()];
    if (shared) await takeShared(shared);
    else if (kind) want({ [kind]: { name: file.name, bytes } });
    else complain(`${file.name}: this page takes an image (.hex, .elf), a robot (.toml), a map (.map) or a shared run (.run).`);
  }
}

async function takeShared(bytes) {
  const { hash, ...wanted } = await unpacked(bytes);
  want(wanted);
  expected = hash;
}

function connectDrops(target) {
  const ours = (e) => [...e.dataTransfer.files].some((file) => /\.(hex|elf|toml|map|run)$/i.test(file.name));
  target.addEventListener('dragover', (e) => { e.preventDefault(); document.body.classList.add('dropping'); });
  for (const kind of ['dragleave', 'drop']) target.addEventListener(kind, () => document.body.classList.remove('dropping'));
  target.addEventListener('drop', (e) => {
    if (target !== document && !ours(e)) return;  // the replay handles recordings
    e.preventDefault();
    e.stopImmediatePropagation();
    take(e.dataTransfer.files);
  }, true);
}

const decoded = (bytes) => new TextDecoder().decode(bytes);

function textOf(kind) {
  const part = chosen(kind);
  if (part.name) return { name: part.name, text: decoded(part.bytes) };
  return { name: part, text: kind === 'map' ? stock.maps[part] : stock.robots[part].toml };
}

// ---- running

function complain(sentence) {
  $('said').textContent = sentence;
  $('said').hidden = !sentence;
  if (sentence) $('said').scrollIntoView({ block: 'nearest' });
}

const encoded = (text) => new TextEncoder().encode(text);

/** Returns the message for the worker: files, and the request that names them. */
function requestOf(wanted) {
  const { sketch, robot, map } = wanted;
  const files = {};
  for (const { name, bytes } of own.robot.values()) files[name] = bytes;  // a robot may be based on another
  const put = (part, name, text) => {
    files[part.name ?? name] = part.bytes ?? encoded(text());
    return part.name ?? name;
  };
  const request = {
    image: put(sketch, `${sketch}.hex`, () => stock.sketches[sketch].hex),
    map: put(map, `${map}.map`, () => stock.maps[map]),
    robot: robot.name ?? robot,
    for_ns: Math.round(wanted.seconds * 1e9),
    seed: Number(wanted.seed), profile: wanted.profile,
    ...(wanted.goal && { goal: wanted.goal }),
    ...(wanted.script.trim() && { script: wanted.script }),
  };
  return { files, request };
}

function newWorker() {
  worker?.terminate();
  worker = new Worker('worker.js');
  // Browsers optimise code that has run for a while. After this run, the user's first run is faster.
  const first = { sketch: 'PidFollower', robot: 'uno5', map: 'oval', seed: 1, seconds: 3, profile: 'typical', goal: '', script: '' };
  worker.postMessage({ robots: robotTexts(), ...requestOf(first), silent: true });
}

const robotTexts = () => Object.fromEntries(Object.entries(stock.robots).map(([name, { toml }]) => [name, toml]));

async function run(moment) {
  const wanted = wantedNow();
  const { files, request } = requestOf(wanted);
  complain('');
  $('state').textContent = 'running …';
  $('stop').hidden = false;
  $('run').disabled = true;
  const done = await new Promise((resolve) => {
    worker.onmessage = ({ data }) => {
      if (data.reached === undefined) resolve(data);
      else $('state').textContent = `running … ${data.reached.toFixed(0)} s`;
    };
    worker.onerror = (e) => resolve({ error: { message: `The run could not begin: ${e.message ?? 'the worker is missing'}.` } });
    $('stop').onclick = () => { newWorker(); resolve({ stopped: true }); };
    worker.postMessage({ robots: robotTexts(), files, request });
  });
  $('stop').hidden = true;
  $('run').disabled = false;
  $('state').textContent = done.stopped ? 'stopped' : '';
  if (done.error) complain(done.error.message);
  if (!done.result) return;
  last = { wanted, result: done.result, rec: done.recording };
  show(done, moment);
}

/** Adds an action at the shown time, and repeats the run from there. */
function act(what) {
  const { t } = $('replay').contentWindow.robosim.player;
  $('script').value = withLine($('script').value, t, what);
  $('more').open = true;
  run(t);
}

const base64 = (bytes) => new Promise((resolve) => {
  const reader = new FileReader();
  reader.onload = () => resolve(reader.result.slice(reader.result.indexOf(',') + 1));
  reader.readAsDataURL(new Blob([bytes]));
});

const pageOf = async (rec) => new Blob([replay.replace(REPLAY, REPLAY + await base64(rec))], { type: 'text/html' });

/** Sets up the loaded replay, shows the given time, and plays on. */
function begun(moment) {
  const frame = $('replay'), page = frame.contentWindow.robosim;
  if (!page) return setTimeout(begun, 20, moment);
  connectDrops(frame.contentDocument);
  $('buttons').replaceChildren(...buttonsOf(page, act));
  $('hands').hidden = false;
  onClicks(page, frame.contentDocument.getElementById('floor'), () => $('hand').value, act);
  if (moment === undefined) return;
  page.player.seek(moment);
  page.player.toggle();
}

async function show({ result, took, recording }, moment) {
  $('hash').textContent = result.trace_hash;
  $('speed').textContent = `${result.time_s.toFixed(1)} s in ${took.toFixed(1)} s of this machine: ${(result.time_s / took).toFixed(0)} × real time`;
  const equal = $('equal');
  equal.textContent = !expected ? '' : expected === result.trace_hash ? '✓ equal to the shared run' : '✗ not the shared run: something in it differs';
  equal.className = expected === result.trace_hash ? 'good' : 'bad';
  expected = null;
  const frame = $('replay');
  URL.revokeObjectURL(frame.src);
  frame.onload = () => begun(moment);
  frame.src = URL.createObjectURL(await pageOf(recording));
  $('first').hidden = true;
  $('came').hidden = frame.hidden = false;
  if (matchMedia('(max-width: 700px)').matches) frame.scrollIntoView();
}

// ---- saving and sharing

function save(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

function nameOf({ sketch, map, seed }) {
  const stem = (part) => (part.name ?? part).replace(/\.\w+$/, '');
  return `${stem(sketch)}-${stem(map)}-${seed}`;
}

async function share() {
  const bytes = await packed(last.wanted, last.result.trace_hash);
  if (!bytes) return complain('This image has content for the EEPROM, which cannot be shared: pass on the .elf itself.');
  const fragment = `#share=${toLink(bytes)}`;
  if (fragment.length > MOST_LINK) {
    save(toFile(bytes), `${nameOf(last.wanted)}.run`);
    $('state').textContent = `${fragment.length} characters are too many for a link (${MOST_LINK}): the run is saved as a file, to be dropped onto this page.`;
    return;
  }
  history.replaceState(null, '', fragment);
  const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
  $('state').textContent = copied ? 'The link is copied; it is in the address line, too.' : 'The link is in the address line.';
}

// ---- begin

/** Applies a link such as #sketch=PidFollower&map=oval&run=1. It sets fields of the form; run=1 starts a run.
 *  share() makes links such as #share=… */
async function follow() {
  const where = new URLSearchParams(location.hash.slice(1));
  if (where.has('share')) await takeShared(ofLink(where.get('share')));
  else want(Object.fromEntries(where));
  if (where.has('run') || expected) await run();
}

async function keepOffline() {
  if (!('serviceWorker' in navigator)) return;
  await navigator.serviceWorker.register('sw.js');
  await navigator.serviceWorker.ready;
  $('offline').textContent = 'This page is stored on your machine and works without a network.';
}

async function begin() {
  if (typeof CompressionStream === 'undefined') throw new Error('This browser is too old for the page: it needs Chromium 95, Firefox 113, Safari 16.4 or later.');
  [stock, replay] = await Promise.all([fetch('stock.json').then((r) => r.json()), fetch('replay.html').then((r) => r.text())]);
  newWorker();
  want({ sketch: 'PidFollower', map: 'oval' });
  $('sketch').addEventListener('change', chooseSketch);
  $('wanted').addEventListener('submit', (e) => { e.preventDefault(); run(); });
  $('files').addEventListener('change', (e) => take(e.target.files));
  connectDrops(document);
  $('save-page').addEventListener('click', async () => save(await pageOf(last.rec), `${nameOf(last.wanted)}.html`));
  $('save-rec').addEventListener('click', () => save(new Blob([last.rec]), `${nameOf(last.wanted)}.rec`));
  $('share').addEventListener('click', share);
  const editor = new TextEditor(textOf, (kind, file) => { want({ [kind]: file }); $('more').open = true; $('save-own').hidden = false; });
  $('save-own').addEventListener('click', () => save(new Blob([editor.file.bytes]), editor.file.name));
  addEventListener('hashchange', () => location.hash.includes('=') && follow().catch((error) => complain(error.message)));
  $('send').addEventListener('submit', (e) => { e.preventDefault(); act(sending($('text').value)); });
  keepOffline().catch(() => {});
  await follow();
}

begin().catch((error) => complain(error.message)).finally(() => { document.documentElement.dataset.ready = 'true'; });
