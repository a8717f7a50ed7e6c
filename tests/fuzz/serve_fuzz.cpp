// Sends arbitrary headers and bodies to `robosim serve`. The server answers in HTTP or not at all. It does
// not write outside of the served folder, nor through a link in that folder.
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <thread>

#include "sim/base/descriptor.h"
#include "sim/view/serve/server.h"
#include "tests/fuzz/require.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace robosim;
namespace fs = std::filesystem;

/// A served folder with links that lead out of it, and its server. All inputs share them.
class Served {
 public:
  Served() {
    fs::create_directories(path_ / "outside");
    fs::create_directories(path_ / "served/Mine");
    std::ofstream(path_ / "served/Mine/Mine.ino") << "void setup() {}\n";
    std::ofstream(path_ / "served/hall.map") << "S..\n";
    fs::create_directory_symlink("../outside", path_ / "served/New");
    fs::create_symlink("../outside/link.map", path_ / "served/link.map");
    server_ = std::make_unique<serve::Server>(
        serve::Settings{path_ / "served", "/bin/true", "127.0.0.1", 0, std::chrono::milliseconds(200)});
    thread_ = std::thread([this] { server_->serve(); });
  }
  ~Served() {
    server_->stop();
    thread_.join();
  }

  std::string host() const { return server_->url().substr(7, server_->url().size() - 8); }
  std::string answer(std::string_view request) const {
    const Descriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in server{};
    server.sin_family = AF_INET;
    server.sin_port = htons(static_cast<std::uint16_t>(std::stoi(host().substr(host().find(':') + 1))));
    server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    require(::connect(socket.get(), reinterpret_cast<sockaddr*>(&server), sizeof server) == 0, "it listens");
    while (!request.empty()) {
      const ssize_t sent = ::send(socket.get(), request.data(), request.size(), MSG_NOSIGNAL);
      if (sent <= 0) break;
      request.remove_prefix(static_cast<std::size_t>(sent));
    }
    ::shutdown(socket.get(), SHUT_WR);
    std::string all;
    char bytes[4096];
    for (ssize_t size = 0; (size = ::read(socket.get(), bytes, sizeof bytes)) > 0;)
      all.append(bytes, static_cast<std::size_t>(size));
    return all;
  }
  bool is_clean() const { return fs::is_empty(path_ / "outside"); }

 private:
  const test::TemporaryFolder temporary_;
  const fs::path path_ = temporary_.path();
  std::unique_ptr<serve::Server> server_;
  std::thread thread_;
};

/// Replaces `@`, which stands for the server's address in an input. The address differs from run to run.
std::string with_host(std::string_view text, const std::string& host) {
  std::string all;
  for (const char c : text) c == '@' ? all += host : all += c;
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Served served;
  const std::string answer =
      served.answer(with_host({reinterpret_cast<const char*>(data), size}, served.host()));
  require(answer.empty() || answer.starts_with("HTTP/1.1 "), "answers are HTTP");
  require(served.is_clean(), "nothing is written outside");
  return 0;
}
