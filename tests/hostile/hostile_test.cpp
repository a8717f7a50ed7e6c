// Tests hostile sketches, folders and requests, each against the whole command. docs/explanation/security.md
// lists the guarantees. The test takes an hour: `cmake --workflow --preset hostile`.
#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <regex>
#include <set>

#include "sim/base/child.h"
#include "sim/base/descriptor.h"
#include "sim/base/program_sandbox.h"
#include "tests/hostile/input.h"
#include "tests/hostile/watched.h"
#include "tests/support/temporary_folder.h"

namespace robosim::hostile {
namespace hostile_test {

namespace fs = std::filesystem;

constexpr double kGivenUp_s = 900.0;  ///< a command that takes longer is considered endless
constexpr double kLate_s = 10.0;
constexpr std::size_t kMostMemory_kb = 300 * 1024;
/// Phrases in the messages about the limits that docs/explanation/security.md lists. A run that reaches such
/// a limit may take longer than kLate_s.
constexpr const char* kLimits[] = {"loops without end",
                                   "slept",
                                   "sleeps",
                                   "processor time",
                                   "only waited",
                                   "took more than",
                                   "the request is too slow",
                                   "printed more than"};

/// Returns the built command, or the command that ROBOSIM_HOSTILE_COMMAND names, to compare the two.
std::string command() {
  const char* const other = ::getenv("ROBOSIM_HOSTILE_COMMAND");
  return other ? other : ROBOSIM_COMMAND;
}

/// The outcome of one input.
struct Record {
  std::string suite, mechanism, variant, mode, outcome;
  double wall_s = 0.0, processor_s = 0.0;
  std::size_t largest_kb = 0, sum_kb = 0;
  std::vector<std::string> findings;
};

/// A user's machine: the folder of a school class, private files outside of it, a home and a cache.
class Place {
 public:
  static Place& get() {
    static Place place;
    return place;
  }
  const fs::path& root() const { return folder_.path(); }
  fs::path sketch() const { return root() / "class/S"; }
  std::map<std::string, std::string> replaced() const {
    return {{kSecretHere, (root() / "outside/secret.h").string()},
            {kPortHere, std::to_string(port_.number())}};
  }

  /// Replaces the sketch S. Returns false if this user may not create such a file.
  bool write_sketch(const Input& input) {
    fs::remove_all(sketch());
    const bool made = make(sketch(), input.entries, replaced());
    before_ = state_of(root(), kUnwatched);
    canaries_.take();
    return made;
  }
  /// Returns the protected files that a command has opened or changed.
  std::vector<std::string> touched() {
    std::vector<std::string> all = canaries_.take();
    for (std::string& one : all) one = "touched: " + one;
    const auto after = state_of(root(), kUnwatched);
    for (const auto& [name, state] : after)
      if (const auto was = before_.find(name); was == before_.end() || was->second != state)
        all.push_back((was == before_.end() ? "written: " : "changed: ") + name);
    for (const auto& [name, state] : before_)
      if (after.count(name) == 0) all.push_back("removed: " + name);
    if (port_.was_reached()) all.emplace_back("connected to a port");
    return all;
  }

 private:
  Place() {
    const auto write = [&](const char* name, const std::string& text) { make(root(), {{name, text}}, {}); };
    for (const char* name : {"secret.h", "secret", "secret.toml", "secret.map"})
      write((std::string("outside/") + name).c_str(), fmt::format("#error {}\n", kSecret));
    write("outside/Theirs/Theirs.ino", fmt::format("#error {}\n", kSecret));
    write("outside/Lib/Lib.h", fmt::format("#error {}\n", kSecret));
    write("class/neighbour/neighbour.ino", "void setup() {}\nvoid loop() {}\n");
    write("home/.ssh/id", kSecret);
    for (const char* folder : {"home", "tmp", "cache"}) fs::create_directories(root() / folder);
    const char* const cache = ::getenv("ROBOSIM_HOSTILE_CACHE");
    ::setenv("XDG_CACHE_HOME", cache ? cache : (root() / "cache").c_str(), 1);
    ::setenv("HOME", (root() / "home").c_str(), 1);
    ::setenv("TMPDIR", (root() / "tmp").c_str(), 1);
    ::setenv("HOSTILE_SECRET", kSecret, 1);
    adopt_orphans();
    canaries_ = Canaries(
        {root() / "outside", root() / "outside/Lib", root() / "outside/Theirs", root() / "home/.ssh"});
  }

  inline static const std::vector<std::string> kUnwatched = {"cache", "outside", "home/.ssh"};
  test::TemporaryFolder folder_;
  QuietPort port_;
  Canaries canaries_{{}};
  std::map<std::string, std::string> before_;
};

/// Returns the limit of wall time, which grows with the machine's load.
double late_s() {
  double load = 0.0;
  ::getloadavg(&load, 1);
  return kLate_s * (1.0 + load);
}

/// Returns a description of the first control character, or character that reorders text; "" if the text has
/// none.
std::string carried_out(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto at = [&](std::size_t k) { return static_cast<unsigned char>(k < text.size() ? text[k] : 0); };
    const unsigned char c = at(i);
    if (c == 0x1b) {
      const std::size_t end = text.find_first_not_of("[0123456789;", i + 1);
      if (at(i + 1) == '[' && end != text.npos && (text[end] == 'm' || text[end] == 'K'))
        continue;  // a sequence that Robosim prints
    }
    const bool control = (c < 0x20 && c != '\n' && c != '\r' && c != '\t') || c == 0x7f;
    const bool c1 = c == 0xc2 && at(i + 1) >= 0x80 && at(i + 1) < 0xa0;
    const bool order = c == 0xe2 && ((at(i + 1) == 0x80 && at(i + 2) >= 0xaa && at(i + 2) <= 0xae) ||
                                     (at(i + 1) == 0x81 && at(i + 2) >= 0xa6 && at(i + 2) <= 0xa9));
    const bool alone = c >= 0x80 && c < 0xc0 && (i == 0 || at(i - 1) < 0x80);
    if (control || c1 || order || alone) return fmt::format("byte {:#x} at {}", c, i);
  }
  return "";
}

bool has(const std::string& text, const std::string& what) { return text.find(what) != text.npos; }

std::vector<std::string> judge_texts(const std::string& out, const std::string& err) {
  std::vector<std::string> findings;
  for (const std::string& text : {out, err}) {
    if (has(text, kSecret)) findings.emplace_back("shows the secret");
    if (has(text, "root:x:0:")) findings.emplace_back("shows /etc/passwd");
    if (has(text, "internal error") || has(text, "please report")) findings.emplace_back("internal error");
  }
  return findings;
}

std::vector<std::string> judge(const Watched& watched, const Input& input, bool prints_serial) {
  std::vector<std::string> findings = judge_texts(watched.out, watched.err);
  const auto found = [&](std::string what) { findings.push_back(std::move(what)); };
  const std::set<int> fine = {1, 2, 4};
  if (watched.endless) found("endless");
  if (fine.count(watched.status) == 0) found(fmt::format("status {}", watched.status));
  if (watched.sum_kb > kMostMemory_kb)
    found(fmt::format("memory {} MB, {} MB in one process", watched.sum_kb >> 10, watched.largest_kb >> 10));
  const std::string texts = "\n" + watched.out + "\n" + watched.err;
  const bool named =
      std::any_of(std::begin(kLimits), std::end(kLimits), [&](const char* one) { return has(texts, one); });
  const bool keeps_compilers_busy = has(input.mechanism, "bomb") || input.mechanism == "many_files";
  const double more_s = keeps_compilers_busy ? kStepSeconds : 0.0;
  if (!named && (watched.processor_s > kLate_s + more_s || watched.wall_s > late_s() + more_s))
    found(fmt::format("late: {:.1f} s, {:.1f} s of processor time", watched.wall_s, watched.processor_s));
  for (const std::string& one : watched.left) found("process left: " + one);
  if (has("\n" + watched.err, std::string("\n") + kForged) ||
      ((!prints_serial || input.on_terminal) && has(texts, std::string("\n") + kForged)))
    found("forged line");
  if (input.on_terminal) {
    if (const std::string what = carried_out(watched.out); !what.empty()) found("on the terminal: " + what);
  } else if (has(watched.err, "\033")) {
    found("escape sequence among messages");
  }
  if (input.compiles && watched.status == 2) found("is not tested, as it does not compile");
  for (const std::string& one : Place::get().touched()) found(one);
  return findings;
}

/// Collects all attempts, and prints the table and the findings at the end.
class Report : public testing::Environment {
 public:
  static std::vector<Record>& records() {
    static std::vector<Record> all;
    return all;
  }
  static void add(Record record, const std::string& output) {
    for (const std::string& finding : record.findings)
      ADD_FAILURE() << record.mode << ": " << finding << "\n" << output.substr(0, 1500);
    records().push_back(std::move(record));
  }

  void TearDown() override {
    struct Row {
      std::set<std::string> inputs;
      int commands = 0, findings = 0;
      double longest_s = 0.0;
      std::size_t largest_kb = 0, sum_kb = 0;
      std::map<std::string, int> outcomes;
    };
    std::map<std::string, Row> rows;
    const char* const file = ::getenv("ROBOSIM_HOSTILE_CSV");
    std::ofstream csv(file ? file : "hostile.csv");
    csv << "suite,mechanism,variant,mode,outcome,wall_s,processor_s,largest_kb,sum_kb,findings\n";
    for (const Record& one : records()) {
      csv << fmt::format("{},{},{:?},{},{},{:.2f},{:.2f},{},{},{:?}\n", one.suite, one.mechanism, one.variant,
                         one.mode, one.outcome, one.wall_s, one.processor_s, one.largest_kb, one.sum_kb,
                         fmt::join(one.findings, "; "));
      for (const std::string& name : {one.suite + " " + one.mechanism, one.suite + " (all)"}) {
        Row& row = rows[name];
        row.inputs.insert(one.mechanism + "/" + one.variant);
        ++row.commands;
        row.findings += static_cast<int>(one.findings.size());
        row.longest_s = std::max(row.longest_s, one.processor_s);
        row.largest_kb = std::max(row.largest_kb, one.largest_kb);
        row.sum_kb = std::max(row.sum_kb, one.sum_kb);
        ++row.outcomes[one.outcome];
      }
    }
    fmt::print("{:<34} {:>6} {:>8} {:>8} {:>9} {:>7} {:>8}  outcomes\n", "mechanism", "inputs", "commands",
               "findings", "longest", "largest", "all");
    for (const auto& [name, row] : rows) {
      std::string outcomes;
      for (const auto& [outcome, count] : row.outcomes) outcomes += fmt::format(" {} ×{}", outcome, count);
      fmt::print("{:<34} {:>6} {:>8} {:>8} {:>7.1f} s {:>4} MB {:>5} MB {}\n", name, row.inputs.size(),
                 row.commands, row.findings, row.longest_s, row.largest_kb >> 10, row.sum_kb >> 10, outcomes);
    }
    for (const Record& one : records())
      for (const std::string& finding : one.findings)
        fmt::print("finding: {} {}/{} {}: {}\n", one.suite, one.mechanism, one.variant, one.mode, finding);
  }
};

const auto* const report = testing::AddGlobalTestEnvironment(new Report);

std::string plain_name(const std::string& text, std::size_t index) {
  std::string name = std::to_string(index) + "_";
  for (const char c : text.substr(0, 40)) name += ::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}
template <typename Param>
std::string name_of(const testing::TestParamInfo<Param>& info) {
  return plain_name(info.param.mechanism + "_" + info.param.variant, info.index);
}

/// Compiles and runs an honest sketch on the same machine, and expects its correct result.
void check_neighbour() {
  static int times = 0;
  const std::string text = fmt::format(
      "// {}\nvoid setup() {{ Serial.begin(9600); int a = analogRead(A0); String s(8.0 * a / a * 10); "
      "Serial.println(s); }}\n"
      "void loop() {{ delay(1); }}\n",
      ++times);
  std::ofstream(Place::get().root() / "class/neighbour/neighbour.ino") << text;
  for (const char* target : {"host", "avr"}) {
    const Watched honest = watch({command(), "run", "./neighbour", "--map", "oval", "--robot", "uno5",
                                  "--goal", "none", "--for", "200ms", "--serial", "--target", target},
                                 Place::get().root() / "class", false, kGivenUp_s);
    EXPECT_EQ(honest.status, 0) << honest.err;
    EXPECT_THAT(honest.out, testing::HasSubstr("80.00\r\n")) << "a neighbour's sketch";
  }
}

void try_input(const char* suite, const Input& input) {
  Place& place = Place::get();
  if (!place.write_sketch(input)) GTEST_SKIP() << "this user cannot make such a file";
  const auto holds = [&](const char* name) {
    return std::any_of(input.entries.begin(), input.entries.end(),
                       [&](const Entry& one) { return one.path == name; });
  };
  const bool is_sketch = std::string(suite) == "sketches";
  std::vector<std::pair<std::string, std::vector<std::string>>> modes;
  const auto add = [&](const std::string& target, bool untrusted) {
    std::vector<std::string> words = {command(), "run",   "./S",      "--goal", "laps:1",
                                      "--for",   "300ms", "--target", target};
    if (!holds("one.map")) words.insert(words.end(), {"--map", "oval"});
    if (!holds("robot.toml")) words.insert(words.end(), {"--robot", "uno5"});
    if (untrusted) words.emplace_back("--untrusted");
    if (is_sketch) words.emplace_back("--serial");
    modes.emplace_back(target + (untrusted ? " --untrusted" : ""), words);
  };
  // Without `--untrusted`, a settings file may be a link. It may also name library folders, or the robot's
  // base, outside of the sketch's folder.
  const bool names_others = input.mechanism == "link_as_settings" ||
                            (input.mechanism == "platformio" && input.variant == "libraries") ||
                            (input.mechanism == "robot" && input.variant == "base");
  if (input.target != Target::avr && !names_others) add("host", false);
  if (input.target != Target::avr) add("host", true);
  if (input.target != Target::host) add("avr", true);
  if (holds("checks.toml")) modes.push_back({"test --untrusted", {command(), "test", "--untrusted", "./S"}});
  for (const auto& [mode, words] : modes) {
    const Watched watched = watch(words, place.root() / "class", input.on_terminal, kGivenUp_s);
    Record record{suite,
                  input.mechanism,
                  input.variant,
                  mode,
                  fmt::format("{}", watched.status),
                  watched.wall_s,
                  watched.processor_s,
                  watched.largest_kb,
                  watched.sum_kb,
                  judge(watched, input, is_sketch)};
    Report::add(std::move(record), watched.out + watched.err);
  }
  static int tried = 0;
  if (++tried % 25 == 0) check_neighbour();
}

class Sketches : public testing::TestWithParam<Input> {};
TEST_P(Sketches, DoNoHarm) { try_input("sketches", GetParam()); }
INSTANTIATE_TEST_SUITE_P(Hostile, Sketches, testing::ValuesIn(sketches()), name_of<Input>);

class Folders : public testing::TestWithParam<Input> {};
TEST_P(Folders, DoNoHarm) { try_input("folders", GetParam()); }
INSTANTIATE_TEST_SUITE_P(Hostile, Folders, testing::ValuesIn(folders()), name_of<Input>);

/// Serves a folder with links that lead out of it.
class Server {
 public:
  Server() {
    Place& place = Place::get();
    const fs::path served = place.root() / "served";
    const std::string loop = "}\nvoid loop() { delay(1); }\n";
    make(
        served,
        {{"Mine/Mine.ino", "void setup() {\n" + loop},
         {"Prints/Prints.ino",
          "void setup() { Serial.begin(2000000); for (;;) Serial.println(F(\"<script>\\x1b[2J\"));\n" + loop},
         {"Loops/Loops.ino", "void setup() { for (;;) asm volatile(\"\");\n" + loop},
         {"Reads/Reads.ino", "#include \"../../outside/secret.h\"\nvoid setup() {\n" + loop},
         {"Grows/Grows.ino", "void setup() { for (;;) memset(malloc(1 << 20), 1, 1 << 20);\n" + loop},
         {"Includes/Includes.ino", "#include __FILE__\n#include __FILE__\nvoid setup() {\n" + loop},
         {"link.map", "../outside/secret.map", Kind::link},
         {"link.toml", "../outside/secret.toml", Kind::link},
         {"link", "../outside/Theirs", Kind::link},
         {"away", "../outside", Kind::link},
         {"loop", ".", Kind::link},
         {"pipe.map", "", Kind::pipe},
         {"junk.elf",
          "\x7f"
          "ELF"},
         {"junk.hex", ":junk\n"},
         {"fleet.toml",
          "map = \"../outside/secret.map\"\n[[agent]]\nname = \"A\"\nsketch = \"../outside/Theirs\"\n"}},
        place.replaced());
    Pipe output;
    ChildStart start;
    start.words = {command(), "serve", served.string(), "--port", std::to_string(port())};
    start.output = output.write.get();
    child_ = std::make_unique<Child>(start);
    output.write.close();
    char text[200];
    if (::read(output.read.get(), text, sizeof text) <= 0) throw std::runtime_error("no server");
    output_ = std::move(output.read);
  }
  /// Returns the server's port. The port is chosen before the server starts, because requests name it.
  static int port() {
    static const int number = QuietPort().number();
    return number;
  }
  static std::string host() { return fmt::format("127.0.0.1:{}", port()); }
  pid_t pid() const { return child_->pid(); }
  bool has_ended() const { return child_->has_ended(); }

 private:
  std::unique_ptr<Child> child_;
  Descriptor output_;
};

struct Reply {
  std::string text;
  double wall_s = 0.0;
  bool endless = false;
};

Reply ask(const HostileRequest& request, MemoryOfTree* memory, double most_s) {
  const auto begin = std::chrono::steady_clock::now();
  const auto passed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const Descriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(Server::port()));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  Reply reply;
  if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return reply;
  ::fcntl(socket.get(), F_SETFL, O_NONBLOCK);
  std::size_t part = 0, sent = 0;
  double next_s = 0.0;
  for (;;) {
    const bool sends = part < request.parts.size() && passed() >= next_s;
    pollfd ready{socket.get(), static_cast<short>(POLLIN | (sends ? POLLOUT : 0)), 0};
    ::poll(&ready, 1, 5);
    if (memory) memory->look();
    if (passed() > most_s) {
      reply.endless = true;
      break;
    }
    if (ready.revents & (POLLIN | POLLHUP | POLLERR)) {
      char buffer[65536];
      const ssize_t got = ::read(socket.get(), buffer, sizeof buffer);
      if (got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR)) break;
      if (got > 0 && reply.text.size() < (16u << 20))
        reply.text.append(buffer, static_cast<std::size_t>(got));
    }
    if (!(ready.revents & POLLOUT)) continue;
    const std::string& text = request.parts[part];
    const ssize_t gone = ::send(socket.get(), text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (gone > 0) sent += static_cast<std::size_t>(gone);
    if (sent < text.size()) continue;
    ++part, sent = 0;
    if (request.stays_open) next_s = passed() + 0.2;
    if (part == request.parts.size() && !request.stays_open && text.empty())
      ::shutdown(socket.get(), SHUT_WR);
  }
  reply.wall_s = passed();
  return reply;
}

class Requests : public testing::TestWithParam<HostileRequest> {
 protected:
  static Server& server() {
    static std::unique_ptr<Server> one = std::make_unique<Server>();
    return *one;
  }
};

TEST_P(Requests, DoNoHarm) {
  HostileRequest request = GetParam();
  const pid_t pid = server().pid();
  for (std::string& part : request.parts) part = replace_all(part, Place::get().replaced());
  Place::get().write_sketch({"", "", {}});
  MemoryOfTree memory(pid);
  const Reply reply = ask(request, &memory, kGivenUp_s);
  std::vector<std::string> findings = judge_texts(reply.text, "");
  const std::string status = reply.text.substr(0, reply.text.find('\r')).substr(0, 12);
  const auto found = [&](std::string what) { findings.push_back(std::move(what)); };
  if (reply.endless) found("endless");
  if (!reply.text.empty() && (status.size() < 12 || !status.starts_with("HTTP/1.1 ") || status[9] == '5'))
    found("answer: " + status);
  for (const char* bad : {"\"status\":3", "\"status\":0", "\"live\":"})
    if (has(reply.text, bad) && (request.mechanism == "origin" || request.mechanism == "fetch_site" ||
                                 std::string(bad) == "\"status\":3"))
      found(std::string("answer with ") + bad);
  const bool named = std::any_of(std::begin(kLimits), std::end(kLimits),
                                 [&](const char* one) { return has(reply.text, one); });
  if (!named && reply.wall_s > late_s()) found(fmt::format("late: {:.1f} s", reply.wall_s));
  if (memory.sum_kb() > kMostMemory_kb) found(fmt::format("memory {} MB", memory.sum_kb() >> 10));
  if (server().has_ended()) found("the server has ended");
  const Reply next = ask(
      {"", "", {fmt::format("GET /api/folder HTTP/1.1\r\nHost: {}\r\n\r\n", Server::host())}}, nullptr, 20.0);
  if (!next.text.starts_with("HTTP/1.1 200"))
    found("the next request is not answered: " + next.text.substr(0, 12));
  for (const std::string& one : end_processes_left(pid)) found("process left: " + one);
  // The files that docs/howto/serving.md allows the server to write, and the folder of its runs.
  static const std::regex plain(
      "(written|changed|removed): "
      "(served(/[A-Za-z0-9][A-Za-z0-9_-]*(\\.(hex|elf|toml|map))?(/[A-Za-z0-9_-]+\\.ino)?)?"
      "|tmp|tmp/robosim-serve-.*)");
  for (const std::string& one : Place::get().touched())
    if (!std::regex_match(one, plain) || has(one, "checks.toml")) found(one);
  Record record{"requests",
                request.mechanism,
                request.variant,
                "serve",
                reply.text.empty() ? "closed" : status.substr(9),
                reply.wall_s,
                0.0,
                memory.largest_kb(),
                memory.sum_kb(),
                std::move(findings)};
  Report::add(std::move(record), reply.text);
}
INSTANTIATE_TEST_SUITE_P(Hostile, Requests, testing::ValuesIn(requests(Server::host())),
                         name_of<HostileRequest>);

}  // namespace hostile_test
}  // namespace robosim::hostile
