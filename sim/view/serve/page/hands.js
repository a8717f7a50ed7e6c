// Converts the user's actions on the robot to lines of the script (docs/reference/scripts.md) at the replay's
// shown time. Used by the page of `robosim serve` and by the tab (sim/view/tab).

/** Returns a page button for each of the robot's buttons and bumpers. A click calls `act`. */
export function buttonsOf(page, act) {
  const pressed = page.run.robot.parts.filter(({ type }) => type === 'button' || type === 'bumper');
  return pressed.map(({ name }) => Object.assign(document.createElement('button'), {
    type: 'button', textContent: `press ${name}`, onclick: () => act(`press ${name} for 200ms`),
  }));
}

export const sending = (text) => `send "${text.replace(/[\\"]/g, '\\$&')}\\n"`;

/** Returns the action of a click on the floor at x, y (mm): puts the robot or an obstacle there. */
function put(page, what, x, y) {
  const { cell, height } = page.run.header.floor;
  if (what === 'obstacle') return `obstacle ${Math.floor(x / cell)},${Math.floor((height - y) / cell)}`;
  const eighth = Math.round(page.run.pose(page.player.t).yaw / (Math.PI / 4));
  return `place ${Math.round(x)}mm,${Math.round(y)}mm,${['E', 'NE', 'N', 'NW', 'W', 'SW', 'S', 'SE'][(eighth + 8) % 8]}`;
}

/** Handles clicks on the floor. `what()` returns the object to place: "robot", "obstacle", or nothing. */
export function onClicks(page, floor, what, act) {
  let from = null;
  floor.addEventListener('pointerdown', ({ clientX, clientY }) => { from = { clientX, clientY, run: page.run }; });
  floor.addEventListener('click', (e) => {
    if (!what() || !from || Math.hypot(e.clientX - from.clientX, e.clientY - from.clientY) > 4) return;  // a drag
    if (from.run !== page.run) return;  // the click has selected another robot
    act(put(page, what(), ...page.view.toFloor(e.offsetX, e.offsetY)));
  });
}

/** Returns the script with an additional line: `what` at `t` seconds. */
export function withLine(script, t, what) {
  const before = script.trimEnd();
  return `${before ? `${before}\n` : ''}at ${Math.floor(t * 1000)}ms ${what}\n`;
}
