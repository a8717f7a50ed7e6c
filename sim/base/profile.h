// Defines the profile of a run, which sets the realism of the run. `ideal` has no noise and no spread, and
// never changes. `typical` has noise and spread from cited sources (docs/explanation/fidelity.md). `typical`
// gets a new version when its models or parameters change; older versions stay available.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace robosim {

enum class Profile {
  ideal,
  typical_1,
  typical_2,  ///< optics, noise, floors and stock motors as measured
  typical = typical_1,
};

/// All names, for options and messages. "typical" is typical@1.
inline constexpr std::initializer_list<const char*> kProfileNames = {"ideal", "typical", "typical@1",
                                                                     "typical@2"};

/// Returns the profile of one of kProfileNames.
Profile profile_of(std::string_view name);

/// Returns the profile's name with its version: "typical@2".
std::string to_string(Profile profile);

}  // namespace robosim
