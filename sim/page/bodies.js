// Robots on the floor, as seen from above. `ctx` draws millimetres of the floor, y north; `px` is a pixel in them.

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

/** With its wheels, and what each sensor sees. */
export function drawRobot(ctx, px, run, t) {
  const pose = run.pose(t), { robot } = run;
  drawBody(ctx, px, pose, robot, style('robot'));
  placed(ctx, pose, () => {
    const { track = 0, wheel = 0 } = robot ?? {};
    for (const [side, name] of [[0.5, 'left'], [-0.5, 'right']]) {
      if (!track || !wheel) break;
      const width = Math.min(0.12 * track, 0.4 * wheel);
      ctx.fillStyle = style('wheel');
      ctx.fillRect(-wheel / 2, side * track - width / 2, wheel, width);
      const speed = run.at(`wheel_${name}_mm_s`, t) ?? 0;
      // Where the wheel would be in a tenth of a second.
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
