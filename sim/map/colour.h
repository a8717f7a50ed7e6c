// Defines the colours of the floor and their reflectance for sensors.
//
// `infrared` is the reflectance for a sensor such as TCRT5000 or QTR (950 nm), relative to white paper;
// `light` is the reflectance for red, green and blue light. All values are estimates. Pigments that look dark
// to the eye hardly absorb infra-red. Makers of reflective sensors state that coloured PVC reflects 40 to
// 80 % as much as a white card. For bright metal they state 110 to 160 %, since metal reflects like a mirror
// if emitter and receiver look straight down.
//
// In infra-red, green is therefore much nearer to white than to black. An infra-red sensor alone cannot
// distinguish a single green square from a dirty floor.
#pragma once

#include <array>
#include <string>

namespace robosim::map {

enum class Hue { black, white, grey, green, silver, red };

struct HueFigures {
  const char* name;
  double infrared;
  std::array<double, 3> light;  ///< red, green, blue
  const char* drawn;            ///< HTML colour for pictures
};

/// The values of each Hue, in the order of the enumerators. For grey, only the name is used: Colour computes
/// the other values from `black`.
constexpr std::array<HueFigures, 6> kHues = {{{"black", 0.00, {0.00, 0.00, 0.00}, "#202020"},
                                              {"white", 1.00, {1.00, 1.00, 1.00}, "#ffffff"},
                                              {"grey", 0.50, {0.50, 0.50, 0.50}, "#909090"},
                                              {"green", 0.65, {0.12, 0.45, 0.18}, "#1f9d4d"},
                                              {"silver", 1.25, {1.30, 1.30, 1.30}, "#b9c4ce"},
                                              {"red", 0.75, {0.70, 0.10, 0.10}, "#c8322b"}}};

/// The colour of a paint.
struct Colour {
  Hue hue = Hue::black;
  double black = 0.5;  ///< share of black in a grey, 0..1

  const HueFigures& figures() const { return kHues[static_cast<std::size_t>(hue)]; }
  double infrared() const { return hue == Hue::grey ? 1.0 - black : figures().infrared; }
  /// Returns the reflectance for a channel: 0 = red, 1 = green, 2 = blue.
  double light(std::size_t channel) const {
    return hue == Hue::grey ? 1.0 - black : figures().light[channel];
  }
  /// Returns the HTML colour for pictures.
  std::string drawn() const;
  bool operator==(const Colour&) const = default;
};

}  // namespace robosim::map
