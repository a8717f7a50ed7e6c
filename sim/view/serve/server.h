// `robosim serve`: serves the page for a folder by HTTP.
//
//   GET  /                    the page; its files have their own paths, such as /bench.js
//   GET  /api/folder          the choices: sketches, robots and maps (folder.h)
//   POST /api/run             runs a request; the answer is a line of JSON for each piece of output,
//                             {"say": "…"}, and at its end {"done": {"status", "recording", "sentence"}}
//   GET  /recording/N.html    the page of run N (docs/reference/recordings.md)
//   POST /api/live            prepares a run for watching: {"live": N}
//   GET  /api/live/N          starts run N. Server-sent events are the lines of `robosim run --live`,
//                             {"say": "…"} and {"done": …}. The run ends when its listener leaves
//   POST /api/live/N          sends a request to run N: {"id": 1, "do": "pause"}
//   POST /api/map             {"name"}: a map's text
//   POST /api/floor           {"text"}: the floor of a map's text, or its error
//   POST /api/file            {"name", "text" or "base64", "replace"}: writes a file (file_store.h)
//   GET  /live.html           the page of a run, without the run's data
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace robosim::serve {

struct Settings {
  std::filesystem::path folder;
  std::filesystem::path robosim;               ///< the program
  std::string address = "127.0.0.1";           ///< to listen on; if not loopback, a token is required
  int port = 0;                                ///< 0 = 8080, or any free port if 8080 is in use
  std::chrono::milliseconds deadline{10'000};  ///< for receiving a request, head and body
  /// The number of bytes that the server may write into its folder until it ends. Each file counts as at
  /// least 4096 bytes.
  std::uintmax_t most_saved = 200'000'000;
};

class Server {
 public:
  /// Starts to listen. Throws InputError if that fails.
  explicit Server(const Settings& settings);
  ~Server();

  /// Returns the address to open in the browser.
  std::string url() const;
  /// Answers requests until stop() is called.
  void serve();
  /// May be called by a signal handler's thread.
  void stop();

 private:
  struct Impl;
  const std::unique_ptr<Impl> impl_;
};

}  // namespace robosim::serve
