"""Drives a simulated robot from Python, 50 ms at a time.

The sketch SerialCommander obeys orders on its serial port. Run this in a clone of Robosim, with robosim on the PATH.
"""
import json
import subprocess

robot = subprocess.Popen(
    ["robosim", "run", "samples/SerialCommander", "--map", "samples/SerialCommander/room.map", "--goal", "none", "--live"],
    stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def ask(**request):
    robot.stdin.write(json.dumps({"id": 1, **request}) + "\n")
    robot.stdin.flush()


def step(ms, order=None):
    """Sends an order, simulates `ms` milliseconds, and returns the robot's state: place, heading, speed, readings."""
    if order:
        ask(do="script", lines="send " + json.dumps(order))
    ask(do="step", ms=ms)
    step.until += ms * 1_000_000
    for line in robot.stdout:
        answer = json.loads(line)
        if "refused" in answer or "error" in answer:
            raise RuntimeError(line)
        if answer.get("event") == "serial":
            print("the sketch sends", repr(answer["text"]))
        if "paused" in answer and answer["paused"]["t_ns"] >= step.until:
            return answer["paused"]["sample"]
    raise RuntimeError("the run has ended")


step.until = 0
step(500)
step(50, "F 1000\n")
for _ in range(10):
    state = step(50)
    print(f"{state['t_us'] / 1e6:.2f} s: x {state['x']:.0f} mm, y {state['y']:.0f} mm, {state['speed_mm_s']:.0f} mm/s")
robot.stdin.close()
robot.wait()
