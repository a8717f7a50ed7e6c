// Which requests are answered at all. A page of another site can make the browser of whoever runs `robosim
// serve` send requests here; it can neither read the answers nor choose these headers:
//
//   Host             must be ours: else another site's name leads here (DNS rebinding)
//   Origin           if there is one, it must be ours
//   Sec-Fetch-Site   if there is one: "same-origin", or "none" (typed by a person)
//   X-Robosim        must be there where something is done: a form of another site cannot send it
//
// The others say how large a request becomes, so that the HTTP library reads none that is larger:
//   Range            at most one, for the answer has the page once for each
//   Content-Encoding none: a few bytes may unpack to any number
//   Transfer-Encoding, Content-Length   the length is said before the body comes
//
// Where others than this machine may connect, a token is wanted, too.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace robosim::serve {

/// What a request says of itself; "" = nothing.
struct Asked {
  std::string method;
  std::string path;  ///< as it came, with percent signs
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

class Guard {
 public:
  /// `address` is what it listens on; `token` is "" where only this machine can connect.
  Guard(std::string address, int port, std::string token);

  /// Nothing = it may be answered.
  std::optional<Refusal> refuse(const Asked& asked) const;

  const std::string& token() const { return token_; }
  /// What to open: "http://127.0.0.1:8080/".
  std::string url() const;

 private:
  bool is_ours(std::string_view host) const;

  const std::string address_;
  const int port_;
  const std::string token_;
};

/// Whether nobody but this machine can connect to an address that is listened on.
bool is_loopback(std::string_view address);

/// 128 random bits as 32 hexadecimal digits. Throws InputError where the machine has none.
std::string random_token();

}  // namespace robosim::serve
