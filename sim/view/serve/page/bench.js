// Implements the form of `robosim serve`. The form requests a run from the server, and shows the run's page
// below. Pressing a button, or sending a text, adds a line to the script at the shown time, and repeats the
// run. Equal input gives an equal run, so that everything before that time is unchanged. A run that is
// watched live receives the line at once.

import { put } from '/drop.js';
import { Editor } from '/editor.js';
import { buttonsOf, onClicks, sending, withLine } from '/hands.js';
import { Scripts } from '/scripts.js';
import { post, Watch } from '/watch.js';

const $ = (id) => document.getElementById(id);
const scripts = new Scripts($('script'), $('whose'));
let running = null;   // AbortController of the current run
let watching = null;  // a Watch
let isLost = false;   // the server does not answer

/** Replaces the options. Returns the previous choice if it no longer exists; otherwise ''. */
function options(select, names, first, home = '.') {
  const before = select.value;
  select.replaceChildren();
  if (first !== undefined) select.append(new Option(first, ''));
  for (const name of names) select.append(new Option(name === '.' ? home : name.replace(/^\.\//, ''), name));
  if (![...select.options].some((option) => option.value === before)) return before;
  select.value = before;
  return '';
}

/** Updates the choices from the server. Returns a sentence if a previous choice no longer exists. */
async function list() {
  const answer = await fetch('/api/folder');
  const folder = await answer.json();
  if (!answer.ok) throw new Error(folder.error);
  document.title = `${folder.folder} · Robosim`;
  const gone = {
    sketch: options($('sketch'), folder.sketches, undefined, folder.folder),
    robot: options($('robot'), folder.robots, 'the sketch’s own'),
    map: options($('map'), folder.maps, 'the sketch’s own, or oval'),
  };
  targets();
  const kind = Object.keys(gone).find((key) => gone[key]);
  return kind ? `The ${kind} ${gone[kind]} is no longer in the folder: choose another.` : '';
}

function say(text, bad = false) {
  $('said').textContent += text;
  $('said').classList.toggle('bad', bad);
  $('said').hidden = !$('said').textContent.trim();
}

/** Returns the page in the frame below the form if the frame shows a run; otherwise null. */
const shown = () => $('replay').hidden ? null : $('replay').contentWindow?.robosim ?? null;

function show(recording, moment) {
  const frame = $('replay');
  frame.hidden = false;
  $('first').hidden = true;
  frame.onload = () => {
    const begun = setInterval(() => {
      const page = shown();
      if (!page) return;
      clearInterval(begun);
      touchable(page);
      if (moment === undefined) return;
      page.player.seek(moment);
      if (moment < Infinity) page.player.toggle();
    }, 20);
  };
  frame.src = `/recording/${recording}.html`;
  if (matchMedia('(max-width: 700px)').matches) frame.scrollIntoView();
}

/** Sets up the buttons and the clicks on the floor, for the selected robot. */
function touchable(page) {
  scripts.show(page.runs);
  page.onLookAt = () => {
    scripts.lookAt(page.run.number);
    $('buttons').replaceChildren(...buttonsOf(page, act));
  };
  page.onLookAt();
  onClicks(page, $('replay').contentDocument.getElementById('floor'), () => $('hand').value, act);
  page.touchable = true;  // for tests
}

/** Adds an action at the shown time, and repeats the run from there. If a run is being
 *  watched, sends the action to it instead. */
function act(what) {
  const page = shown();
  if (watching) return watching.ask({ do: 'script', lines: what, agent: page.run.number });
  const t = page ? page.player.t : 0;
  $('script').value = withLine($('script').value, t, what);
  $('script-box').open = true;
  run(Math.floor(t * 1000) / 1000);
}

const wanted = () => ({
  sketch: $('sketch').value, robot: $('robot').value, map: $('map').value, target: $('target').disabled ? 'avr' : $('target').value,
  seed: Number($('seed').value), for_s: Number($('seconds').value), ...scripts.wanted(),
});

const run = (moment) => underWay('building and running …', async (signal) => {
  await finish(await post('/api/run', wanted(), signal), moment);
});

/** Watches a run live, at the pace of the clock. */
const live = () => underWay('building …', async (signal) => {
  let said = '', gone = false;
  const mine = watching = new Watch($('replay'), {
    say: (text) => { said += text; },
    begun: (page) => {
      $('state').textContent = 'live';
      touchable(page);
    },
    did: (lines, agent) => scripts.add(agent, lines),
    refused: (sentence) => say(`${sentence}\n`, true),
    gone: () => { gone = true; },
  });
  signal.addEventListener('abort', () => mine.close?.());
  $('replay').hidden = false;
  $('first').hidden = true;
  try {
    const done = await mine.run(wanted());
    if (gone) throw new TypeError('gone');
    if (done) conclude(done, said, mine.page && Infinity);
  } finally {
    if (watching === mine) watching = null;
  }
});

async function underWay(state, work) {
  running?.abort();
  const mine = running = new AbortController();
  $('said').textContent = '';
  $('said').hidden = true;
  $('state').textContent = state;
  $('stop').hidden = false;
  try {
    const gone = await list();  // the files may have changed
    if (gone) throw new Error(gone);
    await work(mine.signal);
  } catch (error) {
    if (mine.signal.aborted) return;
    $('state').textContent = '';
    if (error instanceof TypeError) lose();  // thrown by fetch if the server does not answer
    else say(`${error.message}\n`, true);
  } finally {
    if (running === mine) { running = null; $('stop').hidden = true; }
  }
}

async function finish(answer, moment) {
  const reader = answer.body.pipeThrough(new TextDecoderStream()).getReader();
  let text = '', done = null, said = '';
  for (;;) {
    const { value, done: end } = await reader.read();
    if (end) break;
    text += value;
    const lines = text.split('\n');
    text = lines.pop();
    for (const line of lines) {
      const message = JSON.parse(line);
      if (message.say) said += message.say;
      done = message.done ?? done;
    }
  }
  if (!done) throw new Error('The run was cut off.');
  conclude(done, said, moment);
}

/** Shows the recording of a finished run, or the reason why there is no recording. */
function conclude(done, said, moment) {
  const failed = !done.recording;
  $('state').textContent = failed ? 'it did not run' : '';
  if (failed) $('replay').hidden = true;
  const told = said.replace(/^robosim: the (map|robot) is .*\n/gm, '');  // the form shows this already
  if (failed) say(`${told}${done.sentence ? `${done.sentence}\n` : ''}`, true);
  if (!failed) show(done.recording, moment);
}

/** Waits until the server answers again. */
function lose() {
  $('state').textContent = 'the server has stopped: start robosim serve again';
  if (isLost) return;
  isLost = true;
  const again = setInterval(async () => {
    try {
      await list();
      clearInterval(again);
      isLost = false;
      $('state').textContent = 'the server is back';
    } catch { /* not yet */ }
  }, 1000);
}

// Notices a lost server even while the user does nothing.
setInterval(() => {
  if (!document.hidden && !running && !isLost) fetch('/bench.css', { cache: 'no-store' }).catch(lose);
}, 2000);

$('sketch').addEventListener('change', () => { targets(); scripts.forget(); });
$('wanted').addEventListener('submit', (e) => { e.preventDefault(); run(); });
const editor = new Editor({ listed: list, maps: $('map') });

/** Returns the map of the run: the chosen one, the only one next to the sketch, or else oval. */
function mapOfRun() {
  const own = [...$('map').options].map(({ value }) => value).filter((map) => map.startsWith(`${$('sketch').value}/`));
  return $('map').value || (own.length === 1 ? own[0] : 'oval');
}
$('edit').addEventListener('click', () => editor.open(mapOfRun()).catch((error) => say(`${error.message}\n`, true)));

/** Chooses a file that was added to the folder. */
function chooseFile(place) {
  const kind = place.endsWith('.map') ? 'map' : place.endsWith('.toml') ? 'robot' : 'sketch';
  $(kind).value = place.endsWith('.ino') ? place.slice(0, place.lastIndexOf('/')) : place;
  targets();
}

/** Selects the target of a finished image, which only runs on its own chip. */
function targets() {
  const image = /\.(hex|elf)$/.test($('sketch').value);
  const target = $('target');
  target.disabled = image;
  $('own-chip').hidden = !image;
  if (image) target.value = 'own';
  else if (target.value === 'own') target.value = 'host';
}

const dropped = {
  listed: list,
  put: chooseFile,
  say: (sentence, bad) => { $('state').textContent = bad ? '' : sentence; if (bad) say(`${sentence}\n`, true); },
  ask: (question, yes, then) => {
    const button = Object.assign(document.createElement('button'), { type: 'button', textContent: yes, onclick: then });
    $('state').replaceChildren(`${question} `, button);
  },
};
$('add').addEventListener('change', () => put($('add').files, dropped));
document.addEventListener('dragover', (e) => e.preventDefault());
document.addEventListener('drop', (e) => {
  e.preventDefault();
  put(e.dataTransfer.files, dropped);
});

$('live').addEventListener('click', () => live());
$('stop').addEventListener('click', () => {
  if (watching?.page) return watching.ask({ do: 'end' });  // its recording so far is saved
  running?.abort();
  $('state').textContent = 'stopped';
});
$('send').addEventListener('submit', (e) => {
  e.preventDefault();
  act(sending($('text').value));
});
const KEYS = ['sketch', 'robot', 'map', 'target', 'seed', 'seconds', 'script'];

/** Sets a field of the form from a link. Throws an Error with a sentence for an invalid value. */
function choose(key, value) {
  const field = $(key), before = field.value;
  const isFile = ['sketch', 'robot', 'map'].includes(key);
  for (const name of isFile ? [value, `./${value}`] : [value]) {
    field.value = name;
    if (field.value === name || key === 'script') return;
  }
  field.value = before;
  throw new Error(isFile ? `Unknown ${key} in the link: expected one in this folder or one that comes with Robosim, got ${value}.` : `Invalid ${key} in the link: ${value}.`);
}

/** Applies a link such as /#sketch=./Follower&map=oval&run=1. It sets fields of the form. run=1 starts a run;
 *  live=1 starts a run and watches it live. */
async function follow() {
  const where = new URLSearchParams(location.hash.slice(1));
  for (const [key, value] of where) {
    if (KEYS.includes(key)) choose(key, value);
    else if (!['run', 'live'].includes(key)) throw new Error(`Unknown key ${key} in the link: expected ${KEYS.join(', ')}, run or live.`);
  }
  targets();
  if (where.has('run')) await run();
  if (where.has('live')) live();
}

async function begin() {
  await list();
  addEventListener('hashchange', () => follow().catch((error) => say(`${error.message}\n`, true)));
  await follow();
}

begin().catch((error) => say(`${error.message}\n`, true)).finally(() => { document.documentElement.dataset.ready = 'true'; });
