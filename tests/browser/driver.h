// Controls Debian's chromium, without a window, through its chromedriver (W3C WebDriver). All tests of a
// program share one browser.
#pragma once

#include <httplib.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "sim/base/base64.h"
#include "sim/base/child.h"
#include "sim/base/file.h"
#include "tests/support/require_target.h"
#include "tests/system/command.h"

/// Skips the test or SetUp if the browser is missing. If ROBOSIM_REQUIRE names the browser, the test fails
/// instead. A browser that does not start is a failure in both cases.
#define ROBOSIM_NEEDS_BROWSER()                                                                           \
  do {                                                                                                    \
    if (std::filesystem::exists("/usr/bin/chromedriver") && std::filesystem::exists("/usr/bin/chromium")) \
      break;                                                                                              \
    const std::string missing = "the browser is missing: sudo apt install chromium chromium-driver";      \
    if (::robosim::test::is_required("browser")) FAIL() << missing;                                       \
    GTEST_SKIP() << missing;                                                                              \
  } while (false)

namespace robosim::test {

/// Starts a program that prints its address when it is ready. The address is the word after `before`.
class Started {
 public:
  Started(std::vector<std::string> words, const std::string& before) {
    ChildStart start;
    start.words = std::move(words);
    start.own_group = true;
    start.input = ChildStart::kNothing;
    start.output = pipe_.write.get();
    child_.emplace(start);
    pipe_.write = Descriptor();
    std::string said;
    char c;
    while (said.find(before) == said.npos && ::read(pipe_.read.get(), &c, 1) == 1) said += c;
    while (::read(pipe_.read.get(), &c, 1) == 1 && c > ' ') where_ += c;
    if (where_.ends_with(".")) where_.pop_back();
    if (where_.empty()) throw std::runtime_error(start.words[0] + " does not start: it says " + said);
  }
  const std::string& where() const { return where_; }
  /// Ends the program as Ctrl-C does.
  Ending end() {
    child_->send(SIGINT);
    return child_->wait();
  }

 private:
  Pipe pipe_;
  std::optional<Child> child_;
  std::string where_;
};

class Driver {
 public:
  Driver()
      : program_({"/usr/bin/chromedriver", "--port=0"}, "successfully on port "),
        http_("http://127.0.0.1:" + program_.where()) {
    http_.set_read_timeout(90);
    const nlohmann::json options{
        {"binary", "/usr/bin/chromium"},
        {"args",
         {"--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--disable-quic",
          "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
          "--disable-extensions", "--hide-scrollbars", "--allow-file-access-from-files"}}};
    const nlohmann::json wanted{{"goog:chromeOptions", options}, {"timeouts", {{"script", 60'000}}}};
    const auto session = call("/session", {{"capabilities", {{"alwaysMatch", wanted}}}});
    session_ = "/session/" + session["sessionId"].get<std::string>();
  }
  ~Driver() { http_.Delete(session_); }

  /// Opens a page, and reloads it if it is already open.
  void open(const std::string& url, int width = 1300, int height = 850) {
    call(session_ + "/url", {{"url", "about:blank"}});
    const nlohmann::json screen{
        {"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}};
    call(session_ + "/goog/cdp/execute", {{"cmd", "Emulation.setDeviceMetricsOverride"}, {"params", screen}});
    call(session_ + "/url", {{"url", url}});
  }
  /// Runs the body of an async function, and returns its result. The body may use `$`, `key(name)`,
  /// `until(is)` and `drawn()`. The function `drawn()` waits until the page has been laid out and drawn
  /// again.
  nlohmann::json run(const std::string& body) {
    const std::string script =
        "const done = arguments[0]; const $ = (id) => document.getElementById(id);"
        "const until = async (is) => {"
        "  for (let i = 0; !is(); i++) {"
        "    if (i === 2000) throw new Error(`timeout: waited for ${is}`);"
        "    await new Promise((r) => setTimeout(r, 20));"
        "  }"
        "};"
        "const drawn = () => new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)));"
        "const key = (name, more = {}) => document.body.dispatchEvent("
        "new KeyboardEvent('keydown', { key: name, bubbles: true, ...more }));"
        "(async () => {" +
        body + "})().then((value) => done({ value }), (e) => done({ error: `${e} ${e.stack}` }));";
    const auto result =
        call(session_ + "/execute/async", {{"script", script}, {"args", nlohmann::json::array()}});
    if (result.contains("error")) throw std::runtime_error(result["error"].get<std::string>());
    return result.contains("value") ? result["value"] : nlohmann::json();
  }
  void picture(const std::filesystem::path& file) {
    const auto answer = http_.Get(session_ + "/screenshot");
    if (!answer) throw std::runtime_error("chromedriver gives no picture");
    write_file(file, from_base64(nlohmann::json::parse(answer->body)["value"].get<std::string>()));
  }

 private:
  nlohmann::json call(const std::string& path, const nlohmann::json& what) {
    const auto answer = http_.Post(path, what.dump(), "application/json");
    if (!answer) throw std::runtime_error("chromedriver does not answer");
    const auto value = nlohmann::json::parse(answer->body)["value"];
    if (answer->status != 200) throw std::runtime_error(value.dump());
    return value;
  }

  Started program_;
  httplib::Client http_;
  std::string session_;
};

/// Returns the browser of this program. Starts the browser at the first call.
inline Driver& browser() {
  static Driver driver;
  return driver;
}

/// Opens a run's page from disk, and returns the result of `body`. In the body, `page` is the page's
/// JavaScript object `window.robosim`, or null if the page has no run.
inline nlohmann::json in_page(const std::filesystem::path& page, const std::string& body, int width = 1400,
                              int height = 900) {
  browser().open("file://" + page.string(), width, height);
  return browser().run(
      "await until(() => document.documentElement.dataset.ready); const page = window.robosim ?? null;" +
      body);
}

}  // namespace robosim::test
