// Draws robots on the floor, seen from above. `ctx` is a canvas context whose unit is 1 mm of the floor, with
// y to the north. `px` is the size of a pixel in mm.

import { seen, style } from './colours.js';

function placed(ctx, pose, draw) {
  ctx.save();
  ctx.translate(pose.x, pose.y);
  ctx.rotate(pose.yaw);
  draw();
  ctx.restore();
}

export function drawBody(ctx, px, pose, robot, colour) {
  placed(ctx, pose, () => {
    const outline = new Path2D();
    for (const [x, y] of robot?.outline ?? [[60, 0], [-40, 40], [-40, -40]]) outline.lineTo(x, y);
    outline.closePath();
    ctx.fillStyle = colour;
    ctx.globalAlpha = 0.22;
    ctx.fill(outline);
    ctx.globalAlpha = 1;
    ctx.strokeStyle = colour;
    ctx.lineWidth = 1.6 * px;
    ctx.stroke(outline);
  });
}

/** Returns the positions of a robot's steered wheels, and their angles to the left in rad. Returns [] if the
 *  robot has no such wheels. */
export function steeredWheels(run, t) {
  const { steering, track } = run.robot ?? {};
  const reading = steering && run.at(steering.servo, t);
  if (reading === undefined) return [];
  const { base, wheels, middle, ratio, limit } = steering;
  const turned = Math.min(Math.max((reading - middle) * ratio, -limit), limit) * Math.PI / 180;
  // All axles point to one centre, on the line of the driven axle.
  const angle = (y) => Math.abs(turned) < 1e-6 ? 0 : Math.atan(base / (base / Math.tan(turned) - y));
  return (wheels === 2 ? [track / 2, -track / 2] : [0]).map((y) => ({ x: base, y, angle: angle(y) }));
}

/** Draws a robot with its wheels, and the reading of each sensor. */
export function drawRobot(ctx, px, run, t) {
  const pose = run.pose(t), { robot } = run;
  drawBody(ctx, px, pose, robot, style('robot'));
  placed(ctx, pose, () => {
    const { track = 0, wheel = 0 } = robot ?? {};
    const width = Math.min(0.12 * track, 0.4 * wheel);
    ctx.fillStyle = style('wheel');
    for (const { x, y, angle } of steeredWheels(run, t))
      placed(ctx, { x, y, yaw: angle }, () => ctx.fillRect(-wheel / 2, -width / 2, wheel, width));
    for (const [side, name] of [[0.5, 'left'], [-0.5, 'right']]) {
      if (!track || !wheel) break;
      ctx.fillStyle = style('wheel');
      ctx.fillRect(-wheel / 2, side * track - width / 2, wheel, width);
      const speed = run.at(`wheel_${name}_mm_s`, t) ?? 0;
      // Shows how far the wheel moves in a tenth of a second.
      ctx.fillStyle = style('robot');
      ctx.fillRect(0, side * track - 1.2 * px, 0.1 * speed, 2.4 * px);
    }
    ctx.lineWidth = px;
    for (const sensor of run.sensors) {
      const side = Math.max(sensor.footprint || 6, 4 * px);
      ctx.fillStyle = seen(run.reading(sensor.name, t));
      ctx.strokeStyle = '#333';
      ctx.fillRect(sensor.x - side / 2, sensor.y - side / 2, side, side);
      ctx.strokeRect(sensor.x - side / 2, sensor.y - side / 2, side, side);
    }
    ctx.strokeStyle = style('robot');
    ctx.beginPath();
    ctx.arc(0, 0, 2.5 * px, 0, 2 * Math.PI);
    ctx.stroke();
  });
}
