#include "sim/world/radio_channel.h"

#include <algorithm>
#include <utility>

namespace robosim::world {

std::size_t RadioChannel::add_radio(int channel) {
  channels_.push_back(channel);
  state_.arriving.emplace_back();
  return channels_.size() - 1;
}

void RadioChannel::send(std::size_t from, std::uint8_t byte, SimTime at) {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (i == from || channels_[i] != channels_[from]) continue;
    std::vector<Arrival>& arriving = state_.arriving[i];
    const auto later = std::upper_bound(
        arriving.begin(), arriving.end(), std::pair(at, byte),
        [](const auto& key, const Arrival& arrival) { return key < std::pair(arrival.at, arrival.byte); });
    arriving.insert(later, {at, byte});
  }
}

std::optional<RadioChannel::Arrival> RadioChannel::take(std::size_t radio, SimTime t) {
  std::vector<Arrival>& arriving = state_.arriving[radio];
  if (arriving.empty() || arriving.front().at >= t) return std::nullopt;
  const Arrival first = arriving.front();
  arriving.erase(arriving.begin());
  return first;
}

}  // namespace robosim::world
