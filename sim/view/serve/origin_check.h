// Decides which requests are answered. A page of another site can make a user's browser send requests
// to `robosim serve`. Such a page can neither read the answers nor choose these headers:
//
//   Host             must be this server; otherwise another site's name leads here (DNS rebinding)
//   Origin           if present, must be this server
//   Sec-Fetch-Site   if present: "same-origin", or "none" (typed by the user)
//   X-Robosim        required for actions: a form of another site cannot send it
//
// Checks of other headers limit the size of requests and answers:
//   Range            at most one, since the answer contains the page once for each range
//   Content-Encoding none: a few bytes may unpack to any number of bytes
//   Transfer-Encoding, Content-Length   the length must be known before the body arrives
//
// If other machines may connect, a token is also required.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace robosim::serve {

/// The relevant headers of a request; "" = missing.
struct RequestHead {
  std::string method;
  std::string path;  ///< not decoded: may contain percent signs
  std::string host;
  std::string origin;
  std::string fetch_site;
  std::string robosim;  ///< X-Robosim
  std::string content_type;
  std::string token;  ///< from the query or the cookie
  std::string range;
  std::string content_encoding;
  std::string transfer_encoding;
  std::string content_length;
};

struct Refusal {
  int status;
  std::string sentence;
};

class OriginCheck {
 public:
  /// `address` is the listening address; `token` is "" if only this machine can connect.
  OriginCheck(std::string address, int port, std::string token);

  /// Returns the reason for refusing a request; nullopt if it may be answered.
  std::optional<Refusal> refuse(const RequestHead& asked) const;

  const std::string& token() const { return token_; }
  /// Returns the address to open: "http://127.0.0.1:8080/".
  std::string url() const;

 private:
  bool is_ours(std::string_view host) const;

  const std::string address_;
  const int port_;
  const std::string token_;
};

/// Returns whether only this machine can connect to a listening address.
bool is_loopback(std::string_view address);

/// Returns 128 random bits as 32 hexadecimal digits. Throws InputError if the machine has no source of random
/// bits.
std::string random_token();

}  // namespace robosim::serve
