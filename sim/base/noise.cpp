#include "sim/base/noise.h"

namespace robosim {

NoiseStream::NoiseStream(std::uint64_t seed, std::uint32_t robot, std::string_view part,
                         std::string_view purpose)
    : key_(mix(seed ^ 0x6A09E667F3BCC909u)) {
  const auto absorb = [this](std::string_view text) {
    for (const char c : text) key_ = (key_ ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    key_ = mix(key_ + text.size());
  };
  key_ = mix(key_ + robot);
  absorb(part);
  absorb(purpose);
}

}  // namespace robosim
