// Plain functions that use no pins, so that a test needs no robot.
#pragma once

/// Returns the difference of the motors' duty cycles, -255..255, for readings of the left and the right
/// sensor, 0..1023.
inline int steer(int left, int right) {
  const long difference = (static_cast<long>(right) - left) / 4;
  return static_cast<int>(difference > 255 ? 255 : difference < -255 ? -255 : difference);
}
