#include "sim/view/serve/server.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "sim/base/base64.h"
#include "sim/base/descriptor.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/view/serve/folder.h"
#include "sim/view/serve/job_manager.h"
#include "tests/support/temporary_folder.h"

namespace robosim::serve {
namespace server_test {

using Json = nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

/// A folder that the server serves. A shell script replaces the program `robosim`.
class Serving : public testing::Test {
 protected:
  void SetUp() override {
    write(root() / "Mine/Mine.ino", "");
    write(root() / "Mine/robot.toml", "");
    write(root() / "floors/hall.map", "");
    write(outside_.path() / "Theirs/Theirs.ino", "");
    fs::create_directory_symlink(outside_.path(), root() / "away");
  }
  void serve(const std::string& program, std::chrono::milliseconds deadline = std::chrono::seconds(10),
             std::uintmax_t most_saved = 200'000'000) {
    const fs::path file = outside_.path() / "robosim";
    write(file, "#!/bin/sh\n" + program);
    fs::permissions(file, fs::perms::owner_all);
    server_.emplace(Settings{root(), file, "127.0.0.1", 0, deadline, most_saved});
    const std::string url = server_->url();
    http_.emplace(url.substr(0, url.size() - 1));
    http_->set_default_headers({{"X-Robosim", "1"}});
    thread_ = std::thread([this] { server_->serve(); });
  }
  void TearDown() override {
    if (!server_) return;
    server_->stop();
    thread_.join();
  }
  fs::path root() const { return folder_.path(); }
  std::string host() const { return server_->url().substr(7, server_->url().size() - 8); }
  int port() const { return std::stoi(host().substr(host().find(':') + 1)); }
  httplib::Result run(const std::string& json) { return http_->Post("/api/run", json, "application/json"); }
  static Json last_line(const std::string& body) {
    const std::size_t begin = body.rfind('\n', body.size() - 2);
    return Json::parse(body.substr(begin == body.npos ? 0 : begin + 1));
  }

  test::TemporaryFolder folder_, outside_;
  std::optional<Server> server_;
  std::optional<httplib::Client> http_;
  std::thread thread_;
};

TEST_F(Serving, TakesAnotherPortWhereTheUsualOneIsInUse) {
  serve("");
  const Server second(Settings{root(), outside_.path() / "robosim"});
  EXPECT_NE(second.url(), server_->url());
}

TEST_F(Serving, EndsIfItIsStoppedBeforeItServes) {
  Server server(Settings{root(), outside_.path() / "robosim"});
  server.stop();
  server.serve();
}

TEST_F(Serving, ListsWhatIsInTheFolderAndWhatIsOursAndNothingThatALinkLeadsTo) {
  serve("");
  const auto answer = http_->Get("/api/folder");
  ASSERT_TRUE(answer);
  const Json folder = Json::parse(answer->body);
  EXPECT_EQ(folder["sketches"][0], "./Mine");
  EXPECT_EQ(folder["robots"][0], "./Mine/robot.toml");
  EXPECT_EQ(folder["maps"][0], "./floors/hall.map");
  EXPECT_THAT(folder["maps"], Contains("oval"));
  EXPECT_THAT(folder["sketches"], Not(Contains("./away/Theirs")));
}

TEST_F(Serving, RunsAFileOfRobotsWithAScriptForEach) {
  write(root() / "two.toml", "map = \"oval\"\n  [[agent]]\nname = \"A\"\n");
  serve("echo \"$@\"; for last; do case \"$last\" in [AB]=*) cat \"${last#*=}\";; esac; done\n");
  const Json folder = Json::parse(http_->Get("/api/folder")->body);
  EXPECT_THAT(folder["sketches"], Contains("./two.toml"));
  EXPECT_THAT(folder["robots"], Not(Contains("./two.toml")));
  const auto answer =
      run(R"({"sketch": "./two.toml", "scripts": {"A": "at 1s press start\n", "B": "at 2s press start\n"}})");
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->body, HasSubstr("run ./two.toml --target host"));
  // The pipe may split the output into several messages, so each line is checked separately.
  EXPECT_THAT(answer->body, HasSubstr("at 1s press start\\n"));
  EXPECT_THAT(answer->body, HasSubstr("at 2s press start\\n"));
}

TEST_F(Serving, RunsWhatIsChosenAndKeepsItsPage) {
  serve(
      "echo \"$@\"; for last; do if [ \"$before\" = --record ]; then echo PAGE > \"$last\"; fi; "
      "before=$last; done; exit 1\n");
  const auto answer = run(
      R"({"sketch": "./Mine", "map": "oval", "target": "avr", "seed": 7, "for_s": 2.5, "script": "at 1s press start\n"})");
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->body, HasSubstr("run ./Mine --target avr --seed 7 --for 2.5s"));
  EXPECT_THAT(answer->body, HasSubstr("--map oval"));
  EXPECT_THAT(answer->body, HasSubstr("--script "));
  const Json done = last_line(answer->body)["done"];
  EXPECT_EQ(done["status"], 1);
  const auto page = http_->Get("/recording/" + std::to_string(done["recording"].get<int>()) + ".html");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->body, "PAGE\n");
  EXPECT_EQ(http_->Get("/recording/99.html")->status, 404);
}

TEST_F(Serving, RefusesWantsThatMakeNoSense) {
  serve("echo ran\n");
  const std::pair<const char*, const char*> wrong[] = {
      {"", "expected a JSON object"},
      {"[]", "expected a JSON object"},
      {"{\"sketch\": ", "expected a JSON object"},
      {R"({"map": "oval"})", "expected a sketch of the served folder"},
      {R"({"sketch": "../outside"})", "expected a sketch of the served folder"},
      {R"({"sketch": "./away/Theirs"})", "expected a sketch of the served folder"},
      {R"({"sketch": "/etc"})", "expected a sketch of the served folder"},
      {R"({"sketch": "--help"})", "expected a sketch of the served folder"},
      {R"({"sketch": 3})", "sketch: expected a text"},
      {R"({"sketch": "./Mine", "robot": "/etc/passwd"})", "expected a robot of the served folder"},
      {R"({"sketch": "./Mine", "map": "./floors/../../x.map"})", "expected a map of the served folder"},
      {R"({"sketch": "./Mine", "map": "oval\u0000"})", "expected a map of the served folder"},
      {R"({"sketch": "./Mine", "target": "; rm -rf /"})", "target: expected host, avr or stm32"},
      {R"({"sketch": "./Mine", "seed": -1})", "seed: expected a number"},
      {R"({"sketch": "./Mine", "seed": "1"})", "seed: expected a number"},
      {R"({"sketch": "./Mine", "for_s": 1e9})", "for_s: expected a number"},
      {R"({"sketch": "./Mine", "goal": "--record=/tmp/x"})", "goal: expected the name of a goal"},
      {R"({"sketch": "./Mine", "record": "/tmp/x"})", "unknown key in the request: expected sketch, robot"},
      {R"({"sketch": "./Mine", "scripts": {"A": "at 1s press start"}})",
       "scripts: expected a file of several robots"},
      {R"({"sketch": "./Mine", "scripts": "at 1s press start"})", "scripts: expected an object"},
      {R"({"sketch": "./Mine", "scripts": {"../A": ""}})", "invalid name of a robot"},
      {R"({"sketch": "./Mine", "scripts": {"A": 1}})", "A: expected a text"},
  };
  for (const auto& [json, sentence] : wrong) {
    const auto answer = run(json);
    ASSERT_TRUE(answer) << json;
    EXPECT_EQ(answer->status, 400) << json;
    EXPECT_THAT(answer->body, HasSubstr(sentence)) << json;
  }
  EXPECT_EQ(run(std::string(300 * 1024, ' '))->status, 413);
  const std::string script = R"({"sketch": "./Mine", "script": ")" + std::string(70000, '#') + "\"}";
  EXPECT_EQ(run(script)->status, 400);
}

TEST_F(Serving, RefusesOtherSites) {
  serve("echo ran\n");
  http_->set_default_headers({{"Origin", "http://evil.example"}, {"X-Robosim", "1"}});
  EXPECT_EQ(run(R"({"sketch": "./Mine"})")->status, 403);
  EXPECT_EQ(http_->Get("/api/folder")->status, 403);
  http_->set_default_headers({{"Host", "evil.example"}});
  EXPECT_EQ(http_->Get("/")->status, 421);
  const std::string ours = host();
  http_->set_default_headers({});
  EXPECT_EQ(http_->Get("/", {{"Host", ours}})->status, 200);
  EXPECT_EQ(http_->Get("/", {{"Host", ours}, {"Host", "evil.example"}})->status, 421);
}

Descriptor connected(int port) {
  Descriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in server{};
  server.sin_family = AF_INET;
  server.sin_port = htons(static_cast<std::uint16_t>(port));
  server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket.get(), reinterpret_cast<sockaddr*>(&server), sizeof server) != 0)
    throw std::runtime_error("no connection");
  return socket;
}

std::string read_all(const Descriptor& socket) {
  std::string all;
  char bytes[1000];
  for (ssize_t size = 0; (size = ::read(socket.get(), bytes, sizeof bytes)) > 0;)
    all.append(bytes, static_cast<std::size_t>(size));
  return all;
}

// A page of another site could hide a request in the body of a refused request. The server must not read this
// body as a request.
TEST_F(Serving, TakesNoRequestFromTheBodyOfARefusedOne) {
  serve("echo ran\n");
  std::string body;
  while (body.size() < 200'000) body += "GET /api/folder HTTP/1.1\r\nHost: " + host() + "\r\n\r\n";
  for (const std::string& own : {"Host: " + host() + "\r\nOrigin: http://evil.example", "Host: " + host(),
                                 std::string("Host: evil.example")}) {
    const Descriptor socket = connected(port());
    const std::string all = "POST /api/run HTTP/1.1\r\n" + own +
                            "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
    ASSERT_EQ(::send(socket.get(), all.data(), all.size(), MSG_NOSIGNAL), static_cast<ssize_t>(all.size()));
    const std::string answer = read_all(socket);
    EXPECT_THAT(answer, testing::StartsWith("HTTP/1.1 4")) << own;
    EXPECT_EQ(answer.find("HTTP/1.1", 1), answer.npos) << answer;
    EXPECT_THAT(answer, testing::EndsWith("}")) << "the answer is complete";
  }
}

TEST_F(Serving, ReadsNoBodyThatGrows) {
  serve("echo ran\n");
  const std::string head =
      "POST /api/file HTTP/1.1\r\nHost: " + host() + "\r\nX-Robosim: 1\r\nContent-Type: application/json\r\n";
  const auto answer = [&](const std::string& request) {
    const Descriptor socket = connected(port());
    ::send(socket.get(), request.data(), request.size(), MSG_NOSIGNAL);
    return read_all(socket).substr(0, 12);
  };
  for (const char* coding : {"gzip", "deflate", "br"})
    EXPECT_EQ(answer(head + "Content-Encoding: " + coding + "\r\nContent-Length: 2\r\n\r\n{}"),
              "HTTP/1.1 415")
        << coding;
  EXPECT_EQ(answer(head + "Transfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n"), "HTTP/1.1 411");
  EXPECT_EQ(answer(head + "\r\n{}"), "HTTP/1.1 411")
      << "without a length, the body would end only with the connection";
  EXPECT_EQ(answer(head + "Content-Length: 2\r\nContent-Length: 2\r\n\r\n{}"), "HTTP/1.1 411");
  EXPECT_EQ(answer(head + "Content-Length: 999999999\r\n\r\n{}"), "HTTP/1.1 413");
}

TEST_F(Serving, CopiesAPageOncePerRequest) {
  serve("");
  std::string ranges = "bytes=0-";
  for (int i = 0; i < 1500; ++i) ranges += ",0-";
  EXPECT_EQ(http_->Get("/live.html", {{"Range", ranges}})->status, 416);
  EXPECT_LT(http_->Get("/live.html", {{"Range", ranges}})->body.size(), 1'000'000u);
  EXPECT_EQ(http_->Get("/bench.css", {{"Range", "bytes=0-9"}})->body.size(), 10u);
}

TEST_F(Serving, ReadsNoJsonThatIsNestedDeeply) {
  serve("echo ran\n");
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  EXPECT_EQ(run(deep)->status, 400);
  EXPECT_EQ(run(R"({"sketch": "./Mine", "x": )" + deep + "}")->status, 400);
  EXPECT_EQ(
      http_->Post("/api/live/1", "{\"a\": " + deep.substr(99'000, 2'000) + "}", "application/json")->status,
      400);
  for (const char* path : {"/api/file", "/api/map", "/api/floor"})
    EXPECT_EQ(http_->Post(path, R"({"name": )" + deep + "}", "application/json")->status, 400) << path;
}

TEST_F(Serving, HandsEachRunTheFoldersThatItMayRead) {
  serve("echo \"$ROBOSIM_FILE_SCOPE\"\n");
  const auto answer = run(R"({"sketch": "./Mine"})");
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->body, HasSubstr("{\"say\":\"" + root().string() + "\\n"));
}

TEST_F(Serving, RemovesTheFolderOfAServerThatWasKilled) {
  const auto folders = [&] {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(outside_.path() / "tmp"))
      found.push_back(entry.path().filename().string());
    return found;
  };
  fs::create_directory(outside_.path() / "tmp");
  const char* const usual = std::getenv("TMPDIR");
  const std::string before = usual ? usual : "";
  ::setenv("TMPDIR", (outside_.path() / "tmp").c_str(), 1);
  const pid_t killed = ::fork();
  if (killed == 0) {
    const PageFolder pages;
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(killed, nullptr, 0);
  EXPECT_EQ(folders().size(), 1u);
  {
    const PageFolder first, second;
    EXPECT_EQ(folders().size(), 2u) << "only the killed server's folder is removed";
  }
  EXPECT_TRUE(folders().empty());
  before.empty() ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", before.c_str(), 1);
}

TEST_F(Serving, WritesThroughNoLinkWhicheverFolderItReplaces) {
  serve("");
  fs::create_directory(outside_.path() / "target");
  fs::create_directory_symlink(outside_.path() / "target", root() / "New");
  write(outside_.path() / "target.map", "");
  fs::create_symlink(outside_.path() / "target.map", root() / "hall.map");
  fs::create_symlink(outside_.path() / "target.map", root() / ("new.map.tmp" + std::to_string(::getpid())));
  const auto status = [&](const Json& json) {
    return http_->Post("/api/file", json.dump(), "application/json")->status;
  };
  EXPECT_EQ(status({{"name", "New.ino"}, {"text", "void loop() {}"}, {"replace", true}}), 400);
  EXPECT_EQ(status({{"name", "hall.map"}, {"text", "S..\n"}, {"replace", true}}), 400);
  EXPECT_EQ(status({{"name", "new.map"}, {"text", "S..\n"}}), 200);
  EXPECT_TRUE(fs::is_empty(outside_.path() / "target"));
  EXPECT_TRUE(fs::is_empty(outside_.path() / "target.map"));
}

/// Sends `text` to the server, and then single bytes with pauses, until an answer arrives.
struct Drips {
  Drips(int port, std::string text) {
    const Descriptor socket = connected(port);
    pollfd answers{socket.get(), POLLIN, 0};
    for (int drops = 0; ::poll(&answers, 1, 2) == 0 && drops < kMost; ++drops) {
      if (::send(socket.get(), text.data(), text.size(), MSG_NOSIGNAL) < 0) break;
      text = "x";
    }
    answer = read_all(socket);
  }
  static constexpr int kMost = 1000;
  std::string answer;
};

TEST_F(Serving, WaitsForNoRequestForEver) {
  serve("", std::chrono::milliseconds(200));
  const std::string head =
      " HTTP/1.1\r\nHost: " + host() + "\r\nX-Robosim: 1\r\nContent-Type: application/json\r\n";
  const std::string body = head + "Content-Length: 2000\r\n\r\n{";
  for (const std::string& begin :
       {"POST /api/run" + body, "POST /api/file" + body, "GET /" + head + "X-Long: ", std::string("GET /")}) {
    const Drips slow(port(), begin);
    EXPECT_THAT(slow.answer, HasSubstr("HTTP/1.1 408")) << begin;
    EXPECT_THAT(slow.answer, HasSubstr("the request is too slow: expected all of it within 0.2 s")) << begin;
  }
}

TEST_F(Serving, ReadsNoHeadWithoutAnEnd) {
  serve("");
  const Descriptor socket = connected(port());
  std::string lines = "GET / HTTP/1.1\r\n";
  std::size_t sent = 0;
  constexpr std::size_t kMost = 1u << 30;
  for (ssize_t size = 0; size >= 0 && sent < kMost; sent += static_cast<std::size_t>(size)) {
    size = ::send(socket.get(), lines.data(), lines.size(), MSG_NOSIGNAL);
    lines.clear();
    while (lines.size() < 100'000) lines += "a:b\r\n";
    if (size < 0) break;
  }
  EXPECT_LT(sent, kMost) << "the connection is closed long before";
}

TEST_F(Serving, WaitsForARunThatTakesLongerThanARequestMay) {
  const fs::path pipe = outside_.path() / "go on";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  serve("read -r line < '" + pipe.string() + "'\necho \"$line\"\n", std::chrono::milliseconds(500));
  std::string said;
  std::thread page([&] {
    const auto answer = run(R"({"sketch": "./Mine"})");
    said = answer ? answer->body : "nothing";
  });
  {
    std::ofstream goes_on(pipe);  // blocks until the pipe has a reader
    const Drips slow(port(), "GET /");
    EXPECT_THAT(slow.answer, HasSubstr("408"));
    goes_on << "ran\n";
  }
  page.join();
  EXPECT_THAT(said, HasSubstr("ran"));
}

// Returns the JSON of a request that saves a file. The default text is a tiny map.
std::string file_json(const std::string& name, bool replace = false, const std::string& text = "S..\n") {
  return Json{{"name", name}, {"text", text}, {"replace", replace}}.dump();
}

TEST_F(Serving, KeepsFilesInTheFolderAndNothingOverWhatIsThereUnasked) {
  serve("");
  const auto keep = [&](const std::string& json) {
    return http_->Post("/api/file", json, "application/json");
  };
  EXPECT_EQ(Json::parse(keep(file_json("hall.map"))->body)["saved"], "./hall.map");
  EXPECT_EQ(Json::parse(keep(file_json("New.ino", false, "void loop() {}"))->body)["saved"], "./New/New.ino");
  EXPECT_EQ(Json::parse(http_->Get("/api/folder")->body)["sketches"][1], "./New");
  EXPECT_EQ(keep(file_json("hall.map", false, "...\n"))->status, 409);
  EXPECT_EQ(read_file(root() / "hall.map"), "S..\n");
  EXPECT_EQ(keep(file_json("hall.map", true, "...\n"))->status, 200);
  EXPECT_EQ(read_file(root() / "hall.map"), "...\n");
  EXPECT_EQ(keep(file_json("./floors/hall.map", true))->status, 200) << "a listed map may be replaced";
  const auto text = http_->Post("/api/map", R"({"name": "./floors/hall.map"})", "application/json");
  EXPECT_EQ(Json::parse(text->body)["text"], "S..\n");
  const auto floor = http_->Post("/api/floor", R"({"text": "S..\n"})", "application/json");
  EXPECT_EQ(Json::parse(floor->body)["floor"]["width"], 300) << floor->body;
  EXPECT_THAT(http_->Post("/api/floor", R"({"name": "a.map", "text": "S..\n.\n"})", "application/json")->body,
              HasSubstr("a.map:2"));
}

TEST_F(Serving, FillsNoDisk) {
  serve("", std::chrono::seconds(10), 3 * 4096);
  const auto keep = [&](const std::string& name, std::size_t size) {
    return http_->Post("/api/file", file_json(name, true, std::string(size, ' ')), "application/json");
  };
  EXPECT_EQ(keep("A.ino", 5000)->status, 200);
  EXPECT_EQ(keep("B.ino", 10'000)->status, 400) << "more bytes than remain";
  EXPECT_EQ(keep("A.ino", 10)->status, 200);
  const auto refused = keep("C.ino", 10);
  EXPECT_EQ(refused->status, 400) << "a small file occupies a block of the disk";
  EXPECT_THAT(refused->body, HasSubstr("no space is left: expected at most"));
  EXPECT_FALSE(fs::exists(root() / "C"));
}

TEST_F(Serving, KeepsAnImageAndRunsItOnItsOwnChip) {
  serve("echo \"$@\"\n");
  const auto keep = [&](const std::string& name, const std::string& bytes) {
    const std::string json = Json{{"name", name}, {"base64", base64(bytes)}}.dump();
    return http_->Post("/api/file", json, "application/json");
  };
  const std::string hex = ":00000001FF\n";
  std::string elf =
      "\x7F"
      "ELF\1\1\1" +
      std::string(400'000, '\0');
  elf[18] = 83;  // the machine is an AVR
  EXPECT_EQ(Json::parse(keep("Mine.hex", hex)->body)["saved"], "./Mine.hex");
  EXPECT_EQ(keep("Mine.elf", elf)->status, 200);
  EXPECT_EQ(read_file(root() / "Mine.elf"), elf);
  EXPECT_EQ(keep("Other.elf", "no program")->status, 400);
  EXPECT_EQ(keep("Other.hex", "no lines")->status, 400);
  EXPECT_EQ(keep("Other.ino", "void setup() {}")->status, 400) << "only images use base64";
  EXPECT_EQ(http_->Post("/api/file", file_json("Other.hex", false, hex), "application/json")->status, 400);
  EXPECT_EQ(keep("Large.elf", elf + std::string(2'500'000, 'x'))->status, 413);
  const auto answer = run(R"({"sketch": "./Mine.hex", "target": "host"})");
  EXPECT_THAT(answer->body, HasSubstr("run ./Mine.hex --seed 1"));
  EXPECT_THAT(answer->body, Not(HasSubstr("--target")));
}

TEST_F(Serving, WritesNothingElseAndNowhereElse) {
  serve("");
  fs::create_symlink(outside_.path() / "Theirs/Theirs.ino", root() / "link.map");
  fs::create_directory_symlink(outside_.path(), root() / "Away");
  write(outside_.path() / "x.map", "S..\n");
  const std::string names[] = {"../x.map",
                               "/tmp/x.map",
                               "floors/x.map",
                               "./floors/../../x.map",
                               "./floors/new.map",
                               "./away/x.map",
                               "x.sh",
                               "x.map.sh",
                               ".x.map",
                               "checks.toml",
                               "",
                               "x.map\n",
                               "x%2fy.map",
                               "..\\x.map",
                               std::string(64, 'x') + ".map",
                               "link.map",
                               "Away.ino",
                               std::string("x.map\0", 6)};
  const auto before = [&] {
    std::vector<std::string> all;
    for (const fs::path& folder : {root(), outside_.path()})
      for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) all.push_back(entry.path().string() + read_file(entry.path()));
    return all;
  };
  const auto all = before();
  for (const std::string& name : names) {
    const auto answer = http_->Post("/api/file", file_json(name, true), "application/json");
    ASSERT_TRUE(answer) << name;
    EXPECT_EQ(answer->status, 400) << name << answer->body;
  }
  for (const std::string json :
       {"[]", "{\"name\": 1}", "{\"path\": \"x.map\"}", "{\"name\": \"x.map\", \"replace\": 1}"})
    EXPECT_EQ(http_->Post("/api/file", json, "application/json")->status, 400) << json;
  EXPECT_EQ(http_->Post("/api/file", file_json("bad.map", false, "S.?\n"), "application/json")->status, 400);
  EXPECT_EQ(http_->Post("/api/file", file_json("nul.toml", false, std::string(1, '\0')), "application/json")
                ->status,
            400);
  EXPECT_EQ(
      http_->Post("/api/file", file_json("large.toml", false, std::string(300'000, 'x')), "application/json")
          ->status,
      413);
  for (const char* name : {"./away/x.map", "/etc/passwd", "../x.map", "link"})
    EXPECT_EQ(http_->Post("/api/map", Json{{"name", name}}.dump(), "application/json")->status, 400) << name;
  EXPECT_EQ(before(), all);
}

// The shell script replaces robosim. The script prints an event, repeats the first line that it reads, and
// ends with status 4.
TEST_F(Serving, TellsWhatAWatchedRunSaysAndPassesRequestsOn) {
  serve("echo warned >&2; echo '{\"event\": 1}'; while read -r line; do echo \"$line\"; exit 4; done\n");
  EXPECT_EQ(http_->Post("/api/live/1", R"({"do": "play"})", "application/json")->status, 409)
      << "no run has started yet";
  const auto prepared = http_->Post("/api/live", R"({"sketch": "./Mine"})", "application/json");
  ASSERT_TRUE(prepared);
  const std::string path = "/api/live/" + std::to_string(Json::parse(prepared->body)["live"].get<int>());
  std::string events;
  httplib::Client page(server_->url().substr(0, server_->url().size() - 1));
  bool asked = false;
  const auto answer = page.Get(path, [&](const char* text, std::size_t size) {
    events.append(text, size);
    if (!asked && events.find("\"event\"") != events.npos) {
      asked = true;
      for (const auto& [request, status] : {std::pair<std::string, int>{"[]", 400},
                                            {"{\"do\": \"" + std::string(5000, 'x') + "\"}", 400},
                                            {"{\n\"do\":\n\"play\"}", 200}})
        EXPECT_EQ(http_->Post(path, request, "application/json")->status, status) << request.substr(0, 20);
    }
    return true;
  });
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->get_header_value("Content-Type"), "text/event-stream");
  EXPECT_THAT(events, HasSubstr("data: {\"event\": 1}\n\n"));
  EXPECT_THAT(events, HasSubstr("data: {\"say\":\"warned\\n\"}\n\n"));
  EXPECT_THAT(events, HasSubstr("data: {\"do\":\"play\"}\n\n")) << "in one line";
  EXPECT_THAT(events, HasSubstr("\"status\":4"));
  EXPECT_THAT(http_->Get(path)->body, HasSubstr("no such run to watch")) << "a run can be watched only once";
  EXPECT_EQ(http_->Get("/api/live/1234567890")->status, 404);
}

// The program keeps a pipe open until it ends. The test then reads the end of file from the pipe.
TEST_F(Serving, EndsARunWhosePageHasGone) {
  const fs::path pipe = outside_.path() / "alive";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const Descriptor reader(::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  serve("exec 9>" + pipe.string() + "\necho begun\nexec sleep 1000\n");
  const std::string wanted = R"({"sketch": "./Mine"})";
  const auto goes_away = [](const char* text, std::size_t size, std::uint64_t, std::uint64_t) {
    return std::string_view(text, size).find("begun") == std::string_view::npos;
  };
  const auto expect_gone = [&] {
    pollfd waits{reader.get(), POLLIN, 0};
    ::poll(&waits, 1, -1);
    char byte;
    EXPECT_EQ(::read(reader.get(), &byte, 1), 0) << "the program is gone";
  };
  httplib::Request request;
  request.method = "POST";
  request.path = "/api/run";
  request.headers = {{"X-Robosim", "1"}, {"Content-Type", "application/json"}};
  request.body = wanted;
  request.content_receiver = goes_away;
  EXPECT_FALSE(http_->send(request));
  expect_gone();
  const auto prepared = http_->Post("/api/live", wanted, "application/json");
  request.method = "GET";
  request.path = "/api/live/" + std::to_string(Json::parse(prepared->body)["live"].get<int>());
  request.body.clear();
  EXPECT_FALSE(http_->send(request));
  expect_gone();
}

}  // namespace server_test
}  // namespace robosim::serve
