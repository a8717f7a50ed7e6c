// A page, opened from the disk in Debian's chromium without a window.
#pragma once

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "sim/base/base64.h"
#include "sim/base/file.h"
#include "tests/system/command.h"

namespace robosim::test {

inline const std::string& chromium() {
  static const std::string program = "/usr/bin/chromium";
  return program;
}

/// Starts chromium with one more flag on a page; gives what it prints.
inline std::string open_in_chromium(const std::string& flag, const std::filesystem::path& page,
                                    int width = 1400, int height = 900) {
  const Folder profile;
  const Ended ended = robosim_command(
      {"--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
       "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars",
       "--user-data-dir=" + profile.path().string(), "--virtual-time-budget=30000",
       "--window-size=" + std::to_string(width) + "," + std::to_string(height), flag,
       "file://" + page.string()},
      profile.path(), nullptr, "/dev/null", chromium());
  if (ended.status != 0)
    throw std::runtime_error("chromium ended with " + std::to_string(ended.status) + ": " + ended.err);
  return ended.out;
}

/// Appends a script to a page, opens it, and gives what the script's function returned. It may use `page`,
/// the page's own object (null where there is nothing to show), `$`, `key(name)` and `tick()`, which waits
/// until what was begun is done.
inline nlohmann::json in_page(const std::filesystem::path& page, const std::string& body, int width = 1400,
                              int height = 900) {
  const std::filesystem::path tried = page.string() + ".tried.html";
  write_file(tried, read_file(page) + R"(<script type="module">
const tick = () => new Promise((done) => setTimeout(done, 20));
while (!document.documentElement.dataset.ready) await tick();
const page = window.robosim ?? null;
const $ = (id) => document.getElementById(id);
const key = (name, more = {}) => document.body.dispatchEvent(new KeyboardEvent('keydown', { key: name, bubbles: true, ...more }));
let result;
try {
  result = { value: await (async () => {)" +
                        body + R"(})() };
} catch (error) {
  result = { error: `${error.message} ${error.stack}` };
}
const bytes = new TextEncoder().encode(JSON.stringify(result));
document.documentElement.textContent = `RESULT${btoa(Array.from(bytes, (b) => String.fromCharCode(b)).join(''))}END`;
</script>)");
  const std::string dom = open_in_chromium("--dump-dom", tried, width, height);
  const std::size_t begin = dom.find("RESULT"), end = dom.find("END", begin);
  if (begin == dom.npos || end == dom.npos)
    throw std::runtime_error("the page gave no result: " + dom.substr(0, 300));
  const auto json = nlohmann::json::parse(from_base64(dom.substr(begin + 6, end - begin - 6)));
  if (json.contains("error")) throw std::runtime_error(json["error"].get<std::string>());
  return json.contains("value") ? json["value"] : nlohmann::json();
}

}  // namespace robosim::test
