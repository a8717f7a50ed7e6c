#include "sim/result/advice.h"

namespace robosim::result {

std::string without_wirings(const std::string& advice) {
  return advice.find(kTryWirings) == advice.npos ? advice : "";
}

std::string without_host(std::string advice) {
  if (advice == kTryHost) return kWatch;
  if (const std::string last = std::string(kAlso) + kTryHost; advice.ends_with(last))
    return advice.substr(0, advice.size() - last.size());
  const std::string joined = std::string(kTryHost) + kIfNot;
  if (const std::size_t at = advice.find(joined); at != std::string::npos) advice.erase(at, joined.size());
  return advice;
}

}  // namespace robosim::result
