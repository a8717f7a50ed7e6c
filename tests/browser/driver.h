// Chromium without a window, driven by Debian's chromedriver (W3C WebDriver): for pages that ask a server.
#pragma once

#include <httplib.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "sim/base/base64.h"
#include "sim/base/child.h"
#include "sim/base/file.h"
#include "tests/browser/browser.h"

namespace robosim::test {

/// A program that says where it is when it is ready: the word behind `before` on its standard output.
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
  }
  const std::string& where() const { return where_; }
  /// Ends it as Ctrl-C does.
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
    http_.set_read_timeout(60);
    const nlohmann::json options{
        {"binary", chromium()},
        {"args", {"--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1300,850"}}};
    const auto session =
        call("/session", {{"capabilities", {{"alwaysMatch", {{"goog:chromeOptions", options}}}}}});
    session_ = "/session/" + session["sessionId"].get<std::string>();
  }
  ~Driver() { http_.Delete(session_); }

  void open(const std::string& url) { call(session_ + "/url", {{"url", url}}); }
  /// What an async function's body returns.
  nlohmann::json run(const std::string& body) {
    const std::string script =
        "const done = arguments[0]; const $ = (id) => document.getElementById(id);"
        "const until = async (is) => { while (!is()) await new Promise((r) => setTimeout(r, 20)); };"
        "(async () => {" +
        body + "})().then(done, (e) => done(`failed: ${e}`));";
    return call(session_ + "/execute/async", {{"script", script}, {"args", nlohmann::json::array()}});
  }
  void picture(const std::filesystem::path& file) {
    const auto answer = http_.Get(session_ + "/screenshot");
    if (answer)
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

}  // namespace robosim::test
