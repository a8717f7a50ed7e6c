// How real a run is: its profile. `ideal` has no noise and no spread, and never changes. `typical` has both,
// with sources (docs/fidelity.md); when its models or figures change it gets a new version, and the older
// ones can still be named.
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

/// All names, for options and messages. "typical" is the newest version.
inline constexpr std::initializer_list<const char*> kProfileNames = {"ideal", "typical", "typical@1",
                                                                     "typical@2"};

/// The profile of one of kProfileNames.
Profile profile_of(std::string_view name);

/// Its name, with the version: "typical@2".
std::string to_string(Profile profile);

}  // namespace robosim
