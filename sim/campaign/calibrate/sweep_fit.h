// Fits parameters of floor sensors to a slow sweep across a tape.
//
// A crossing is a series of readings over the tape. With wheel counts, the sensor's speed v is the rate of
// turn times the sensor's distance from the centre. Without counts, v is the tape's width divided by the
// crossing's duration at half depth (signal halfway between floor and tape). The speed gives each sample a
// position s across an edge, and
//   signal = W (1 - c) + B c,    c = clamp((w/2 + f/2 - d) / f, 0, min(1, w/f))
// as in sim/world/floor.h: c is the blackness, w the tape's width, d the distance from the tape's middle, and
// f the footprint. B is the signal over black. W is the signal over white at this edge, because the floor's
// brightness varies. W and the edge's position are fitted for each edge, f for all edges of a part together.
//
// The signal is linear in blackness: volts, or the rate 1 / time of an RC sensor.
//   black       mean over the middle of the tape
//   white       mean next to the tape, corrected for the light lost at the height in the robot file
//   noise       from second differences of neighbouring readings, minus the noise from rounding to codes; as
//               a share of black - white. Patches of the floor hardly change second differences
//   footprint   f; its uncertainty is the scatter of ten estimates, each from a tenth of the edges
//   track       path of the wheels / 2 pi over a whole turn, from a crossing to the second crossing after it
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/calibrate/log.h"
#include "sim/robot/description.h"
#include "sim/robot/parts/reflectance.h"

namespace robosim::calibrate {

/// A result with its standard deviation, SI.
struct Found {
  double value = 0.0;
  double sd = 0.0;
};

/// The results of one sensor. The top of this file defines the signals.
struct ElementFit {
  std::string name;
  Found white, black;
  double noise = 0.0, dark_noise = 0.0;  ///< noise of a reading over white and black, in the signal's unit
  std::size_t crossings = 0;
};

/// A sample of an edge for plots: its position, inwards from the edge, and its blackness.
struct EdgePoint {
  double s = 0.0;  ///< m
  double blackness = 0.0;
};

struct PartFit {
  const robot::ReflectanceSpec* part = nullptr;
  Found footprint;       ///< m; value 0: the samples are too far apart
  Found noise;           ///< as a share of the step from white to black
  Found seen;            ///< m, the tape's width at half depth, from the wheel counts; 0 without counts
  double spacing = 0.0;  ///< m between samples
  std::vector<ElementFit> elements;
  std::vector<EdgePoint> points;
};

struct SweepFit {
  std::vector<PartFit> parts;
  Found track;                       ///< m; value 0: undetermined
  std::vector<std::string> remarks;  ///< values that the sweep does not determine, one sentence each
};

/// Fits the sweeps. Throws InputError if the readings are impossible for this robot.
SweepFit fit_sweeps(const std::vector<Log>& logs, const robot::Description& robot, double tape_m);

}  // namespace robosim::calibrate
