#include "sim/view/serve/origin_check.h"

#include <fmt/format.h>

#include <fstream>

#include "sim/base/error.h"

namespace robosim::serve {
namespace {

constexpr std::size_t kLongestPath = 200;

bool is_plain(std::string_view path) {
  if (path.empty() || path[0] != '/' || path.size() > kLongestPath) return false;
  for (const char c : path) {
    const bool fine = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '/' || c == '.' || c == '-' || c == '_';
    if (!fine) return false;
  }
  return path.find("..") == path.npos && path.find("//") == path.npos;
}

bool is_count(std::string_view text) {
  return !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == text.npos;
}

// Compares texts in a time that does not depend on their content, so that timing does not reveal the token.
bool equal(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  return difference == 0;
}

}  // namespace

OriginCheck::OriginCheck(std::string address, int port, std::string token)
    : address_(std::move(address)), port_(port), token_(std::move(token)) {}

std::string OriginCheck::url() const {
  const bool is_v6 = address_.find(':') != address_.npos;
  return fmt::format("http://{}{}{}:{}/{}", is_v6 ? "[" : "", address_, is_v6 ? "]" : "", port_,
                     token_.empty() ? "" : "?token=" + token_);
}

bool OriginCheck::is_ours(std::string_view host) const {
  const std::string port = fmt::format(":{}", port_);
  if (!host.ends_with(port)) return false;
  host.remove_suffix(port.size());
  if (host == address_ || host == "[" + address_ + "]") return true;
  if (is_loopback(address_)) return host == "localhost" || host == "127.0.0.1" || host == "[::1]";
  // A server on all addresses accepts any IP address as its name, because the token protects it. It accepts
  // no host name, because an attacker may own the name.
  return address_ == "0.0.0.0" && host.find_first_not_of("0123456789.") == host.npos;
}

std::optional<Refusal> OriginCheck::refuse(const RequestHead& asked) const {
  if (!is_plain(asked.path)) return Refusal{400, "invalid path: Robosim serves no such path"};
  if (!is_ours(asked.host))
    return Refusal{421, "wrong name of the server: expected the address that robosim serve has printed"};
  const Refusal foreign{403, "pages of other sites cannot use Robosim"};
  if (!asked.origin.empty() && asked.origin != "http://" + asked.host) return foreign;
  if (!asked.fetch_site.empty() && asked.fetch_site != "same-origin" && asked.fetch_site != "none")
    return foreign;
  if (!token_.empty() && !equal(asked.token, token_))
    return Refusal{401, "the token is missing: open the address that robosim serve has printed"};
  if (asked.range.find(',') != asked.range.npos)
    return Refusal{416, "the header Range has several ranges: expected one at most"};
  if (asked.method == "GET" || asked.method == "HEAD") return std::nullopt;
  if (asked.method != "POST") return Refusal{405, "unknown method: expected GET or POST"};
  if (asked.robosim.empty()) return Refusal{403, "the header X-Robosim is missing"};
  if (asked.content_type != "application/json")
    return Refusal{415, "the Content-Type: expected application/json"};
  if (!asked.content_encoding.empty())
    return Refusal{415, "the body has a Content-Encoding: expected none; send the JSON as it is"};
  if (!asked.transfer_encoding.empty() || !is_count(asked.content_length))
    return Refusal{411, "the length of the body is unknown: expected a Content-Length in bytes"};
  return std::nullopt;
}

bool is_loopback(std::string_view address) {
  return address == "localhost" || address == "::1" || address.starts_with("127.");
}

std::string random_token() {
  std::ifstream source("/dev/urandom", std::ios::binary);
  std::string token;
  for (int i = 0; i < 16; ++i) {
    const int byte = source.get();
    if (byte < 0) throw InputError({"/dev/urandom"}, "cannot read random numbers");
    token += fmt::format("{:02x}", byte);
  }
  return token;
}

}  // namespace robosim::serve
