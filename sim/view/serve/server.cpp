#include "sim/view/serve/server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/record/page_text.h"
#include "sim/view/serve/embedded_page.h"
#include "sim/view/serve/file_store.h"
#include "sim/view/serve/folder.h"
#include "sim/view/serve/job_manager.h"
#include "sim/view/serve/origin_check.h"
#include "sim/view/serve/request_deadline.h"
#include "sim/wire/json_parse.h"

namespace robosim::serve {
namespace {

using Json = nlohmann::json;
using httplib::Request;
using httplib::Response;

constexpr std::size_t kLongestBody = 256 * 1024;
constexpr std::size_t kLongestImage = 3 * 1024 * 1024;  // about 2 MB, in base64
constexpr const char* kFiles = "/api/file";             // path that accepts such images
constexpr std::size_t kLongestRequest = 4000;           // bytes of a request to a watched run
constexpr std::size_t kThreads = 64;                    // each waits for one client
constexpr std::uintmax_t kBlock = 4096;                 // bytes in a block of a disk
constexpr int kUsualPort = 8080;
constexpr int kPatience_s = 3;  // maximum time between two bytes
constexpr const char* kCookie = "robosim=";

const Refusal kTooLong{413, "the request is too large: expected at most 256 KB, or 3 MB with an image"};

std::string json_text(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string token_of(const Request& request) {
  if (request.has_param("token")) return request.get_param_value("token");
  const std::string cookies = request.get_header_value("Cookie");
  const std::size_t at = cookies.find(kCookie);
  if (at == cookies.npos) return "";
  const std::size_t begin = at + std::string_view(kCookie).size();
  return cookies.substr(begin, cookies.find(';', begin) - begin);
}

bool has_body(const Request& request) {
  return request.has_header("Transfer-Encoding") || request.has_header("Content-Length");
}

// Returns the values of a header, separated by commas if a request repeats it.
std::string all_of(const Request& request, const char* header) {
  std::string all;
  const auto [begin, end] = request.headers.equal_range(header);
  for (auto one = begin; one != end; ++one) all += (one == begin ? "" : ",") + one->second;
  return all;
}

RequestHead asked_of(const Request& request) {
  return {request.method,
          request.target.substr(0, request.target.find('?')),
          all_of(request, "Host"),
          request.get_header_value("Origin"),
          request.get_header_value("Sec-Fetch-Site"),
          request.get_header_value("X-Robosim"),
          request.get_header_value("Content-Type"),
          token_of(request),
          all_of(request, "Range"),
          all_of(request, "Content-Encoding"),
          all_of(request, "Transfer-Encoding"),
          all_of(request, "Content-Length")};
}

void refuse(Response& response, const Refusal& refusal) {
  response.status = refusal.status;
  response.set_content(json_text({{"error", refusal.sentence}}), "application/json");
}

/// Returns the complete HTTP answer to a request that exceeds the deadline.
std::string too_slow(std::chrono::milliseconds deadline) {
  const std::string sentence = fmt::format("the request is too slow: expected all of it within {} s",
                                           1e-3 * static_cast<double>(deadline.count()));
  const std::string body = json_text({{"error", sentence}});
  return fmt::format(
      "HTTP/1.1 408 Request Timeout\r\nContent-Type: application/json\r\nContent-Length: {}\r\n"
      "Connection: close\r\n\r\n{}",
      body.size(), body);
}

// Formats each line as a server-sent event.
std::string server_sent(std::string_view lines) {
  std::string text;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size() - 1);
    text += fmt::format("data: {}\n", lines.substr(0, end + 1));
    lines.remove_prefix(end + 1);
  }
  return text;
}

// Parses "7.html" to 7; returns 0 for other names.
int number_of(std::string_view name) {
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool whole =
      error == std::errc() && std::string_view(end, name.data() + name.size() - end) == ".html";
  return whole ? number : 0;
}

/// A pool of threads, each of which answers a connection within its time limit. The result of enqueue() is
/// bool or void, depending on the library's release. The library's own pool is a member, because it may be a
/// final class.
class Threads : public httplib::TaskQueue {
 public:
  explicit Threads(RequestDeadline& deadline) : deadline_(deadline), pool_(kThreads) {}
  auto enqueue(std::function<void()> work) -> decltype(TaskQueue::enqueue(work)) override {
    return pool_.enqueue([this, connection = deadline_.accepted(), work = std::move(work)] {
      deadline_.answer(connection, work);
    });
  }
  void shutdown() override { pool_.shutdown(); }

 private:
  RequestDeadline& deadline_;
  httplib::ThreadPool pool_;
};

int bind(httplib::Server& server, const Settings& settings) {
  server.set_socket_options([](socket_t socket) {  // the library's default lets two servers share a port
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  if (settings.port == 0 && server.bind_to_port(settings.address.c_str(), kUsualPort)) return kUsualPort;
  server.stop();  // otherwise cpp-httplib 0.18 refuses a second attempt
  const int port = settings.port == 0 ? server.bind_to_any_port(settings.address.c_str())
                   : server.bind_to_port(settings.address.c_str(), settings.port) ? settings.port
                                                                                  : -1;
  if (port < 0)
    throw InputError(
        settings.port == 0
            ? fmt::format("cannot listen on {}: it is not an address of this machine", settings.address)
            : fmt::format("cannot listen on port {} of {}: another program uses the port, or it is not an "
                          "address of this machine",
                          settings.port, settings.address));
  return port;
}

}  // namespace

struct Server::Impl {
  explicit Impl(const Settings& settings)
      : jobs(settings.robosim, settings.folder),
        most_saved(settings.most_saved),
        port(bind(http, settings)),
        origin_check(settings.address, port, is_loopback(settings.address) ? "" : random_token()),
        deadline(port, settings.deadline, too_slow(settings.deadline)) {
    http.new_task_queue = [this] { return new Threads(deadline); };
    // Serves one request per connection. The library does not read the body of a refused request, and would
    // treat this body as the next request. So another site's page could put a request into a body, with
    // headers that the page itself may not send.
    http.set_keep_alive_max_count(1);
    http.set_logger([this](const Request& request, const Response&) {
      if (request.body.empty() && has_body(request)) deadline.read_away();
    });
    http.set_payload_max_length(kLongestImage);
    http.set_read_timeout(kPatience_s);
    http.set_write_timeout(kPatience_s);
    http.set_tcp_nodelay(true);  // sends each frame immediately
    http.set_default_headers({{"X-Content-Type-Options", "nosniff"},
                              {"Referrer-Policy", "no-referrer"},
                              {"X-Frame-Options", "SAMEORIGIN"},
                              {"Cache-Control", "no-store"}});
    http.set_pre_routing_handler(
        [this](const Request& request, Response& response) { return check(request, response); });
    http.set_error_handler([](const Request&, Response& response) {
      if (response.body.empty()) refuse(response, {response.status, "no such page"});
    });
    http.Get("/", [this](const Request& request, Response& response) { front(request, response); });
    give("/bench.css", bench_css(), "text/css");
    give("/bench.js", bench_js(), "text/javascript");
    give("/watch.js", watch_js(), "text/javascript");
    give("/editor.js", editor_js(), "text/javascript");
    give("/drop.js", drop_js(), "text/javascript");
    give("/hands.js", hands_js(), "text/javascript");
    give("/scripts.js", scripts_js(), "text/javascript");
    http.Get("/api/folder", [this](const Request&, Response& response) { list(response); });
    post("/api/run", [this](const Request& request, Response& response) { run(request, response); });
    post("/api/live", [this](const Request& request, Response& response) { prepare(request, response); });
    http.Get(R"(/api/live/([0-9]{1,9}))",
             [this](const Request& request, Response& response) { watch(request, response); });
    post(R"(/api/live/([0-9]{1,9}))",
         [this](const Request& request, Response& response) { ask(request, response); });
    act("/api/map", [this](const Offered& offered) {
      return Json{{"text", map_text(jobs.folder(), offered.name)}};
    });
    act("/api/floor", [](const Offered& offered) { return Json{{"floor", Json::parse(floor_of(offered))}}; });
    act(kFiles, [this](const Offered& offered) { return Json{{"saved", save(offered)}}; });
    http.Get("/live.html", [](const Request&, Response& response) {
      const std::string_view page = record::page_text();
      response.set_content(page.data(), page.size(), "text/html; charset=utf-8");
    });
    http.Get(R"(/recording/([0-9]+\.html))", [this](const Request& request, Response& response) {
      const std::string page = jobs.page_of(number_of(request.matches[1].str()));
      if (page.empty()) return refuse(response, {404, "this run is no longer stored: run it again"});
      response.set_content(page, "text/html; charset=utf-8");
    });
  }

  /// Registers a handler of POST requests, which is called with the complete body.
  void post(const char* path, httplib::Server::Handler answer) {
    http.Post(path, [this, answer = std::move(answer)](const Request& request, Response& response) {
      deadline.is_here();
      answer(request, response);
    });
  }

  /// Registers a handler of requests {"name", "text"}. The handler answers with the JSON from `work`, or with
  /// the message of an exception from `work`.
  void act(const char* path, std::function<Json(const Offered&)> work) {
    post(path, [work = std::move(work)](const Request& request, Response& response) {
      try {
        const Offered offered = read_offered(request.body);
        if (!is_image(offered.name) && request.body.size() > kLongestBody) return refuse(response, kTooLong);
        response.set_content(json_text(work(offered)), "application/json");
      } catch (const InputError& error) {
        refuse(response, {400, error.what()});
      } catch (const IsThere& there) {
        refuse(response, {409, there.sentence});
      }
    });
  }

  /// Saves a file within the limit. Concurrent requests count towards the limit; rejected requests do not.
  std::string save(const Offered& offered) {
    const std::uintmax_t size = std::max<std::uintmax_t>(offered.text.size(), kBlock);
    const bool is_too_much = (saved += size) > most_saved;
    try {
      if (is_too_much)
        throw InputError(fmt::format(
            "no space is left: expected at most {} MB of saved files until the server ends; start "
            "it again",
            most_saved / 1'000'000));
      return keep(jobs.folder(), offered);
    } catch (...) {
      saved -= size;
      throw;
    }
  }

  httplib::Server::HandlerResponse check(const Request& request, Response& response) {
    deadline.head_is_here();
    if (request.method != "POST") deadline.is_here();
    auto refusal = origin_check.refuse(asked_of(request));
    const auto length = std::strtoull(request.get_header_value("Content-Length").c_str(), nullptr, 10);
    if (!refusal && length > (request.path == kFiles ? kLongestImage : kLongestBody)) refusal = kTooLong;
    if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
    refuse(response, *refusal);
    return httplib::Server::HandlerResponse::Handled;
  }

  void give(const char* path, std::string_view text, const char* type) {
    http.Get(path, [text, type](const Request&, Response& response) {
      response.set_content(text.data(), text.size(), type);
    });
  }

  void front(const Request&, Response& response) const {
    response.set_header(
        "Content-Security-Policy",
        "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; frame-src 'self'; "
        "img-src data:; base-uri 'none'; form-action 'none'");
    if (!origin_check.token().empty())
      response.set_header("Set-Cookie",
                          kCookie + origin_check.token() + "; HttpOnly; SameSite=Strict; Path=/");
    const std::string_view page = bench_html();
    response.set_content(page.data(), page.size(), "text/html; charset=utf-8");
  }

  void list(Response& response) const {
    const Choices choices = choices_in(jobs.folder());
    response.set_content(json_text({{"folder", jobs.folder().path().filename().string()},
                                    {"sketches", choices.sketches},
                                    {"robots", choices.robots},
                                    {"maps", choices.maps}}),
                         "application/json");
  }

  /// Parses the requested run. If it is invalid, answers with the reason and returns nullopt.
  std::optional<RunForm> wanted_by(const Request& request, Response& response) const {
    try {
      return read_run_form(request.body, choices_in(jobs.folder()));
    } catch (const InputError& error) {
      refuse(response, {400, error.what()});
      return std::nullopt;
    }
  }

  static Json json_of(const JobManager::Done& done) {
    return {{"done", {{"status", done.status}, {"recording", done.recording}, {"sentence", done.sentence}}}};
  }

  void run(const Request& request, Response& response) {
    const auto form = wanted_by(request, response);
    if (!form) return;
    response.set_chunked_content_provider(
        "application/x-ndjson", [this, form = *form](std::size_t, httplib::DataSink& sink) {
          const auto line = [&](const Json& json) {
            const std::string text = json_text(json) + "\n";
            return sink.write(text.data(), text.size());
          };
          const auto done = jobs.run(form, [&](const std::string& text) {
            return text.empty() ? sink.is_writable() : line({{"say", text}});
          });
          line(json_of(done.value_or(JobManager::busy())));
          sink.done();
          return true;
        });
  }

  void prepare(const Request& request, Response& response) {
    if (const auto form = wanted_by(request, response))
      response.set_content(json_text({{"live", jobs.prepare(*form)}}), "application/json");
  }

  // Starts the run when its page begins to listen, and ends the run when the page stops listening.
  void watch(const Request& request, Response& response) {
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, number = std::stoi(request.matches[1].str())](std::size_t, httplib::DataSink& sink) {
          const auto event = [&](const std::string& lines) {
            const std::string text = server_sent(lines);
            return sink.write(text.data(), text.size());
          };
          bool heard = true;
          const auto done = jobs.watch(number, [&](JobManager::Said said, const std::string& text) {
            heard = text.empty()
                        ? sink.is_writable()
                        : event(said == JobManager::Said::lines ? text : json_text({{"say", text}}) + "\n");
            return heard;
          });
          if (!heard || jobs.ending()) return false;  // the page detects the closed stream
          event(json_text(json_of(done.value_or(JobManager::Done{5, 0, "no such run to watch"}))) + "\n");
          sink.done();
          return true;
        });
  }

  void ask(const Request& request, Response& response) {
    const Json json = wire::parsed_json(request.body);
    if (!json.is_object() || request.body.size() > kLongestRequest)
      return refuse(response, {400, "the request: expected a JSON object of at most 4000 bytes"});
    if (!jobs.ask(std::stoi(request.matches[1].str()), json_text(json) + "\n"))
      return refuse(response, {409, "this run accepts no requests: it is over or has too many"});
    response.set_content("{}", "application/json");
  }

  httplib::Server http;
  JobManager jobs;
  const std::uintmax_t most_saved;        // bytes
  std::atomic<std::uintmax_t> saved = 0;  // bytes
  std::atomic<bool> serving = false, stopped = false;
  const int port;
  const OriginCheck origin_check;
  RequestDeadline deadline;
};

Server::Server(const Settings& settings) : impl_(std::make_unique<Impl>(settings)) {}
Server::~Server() = default;
std::string Server::url() const { return impl_->origin_check.url(); }
void Server::serve() {
  impl_->serving = true;
  if (!impl_->stopped) impl_->http.listen_after_bind();
  impl_->serving = false;
}
// Waits until the library listens, because it ignores a call of its stop() before that.
void Server::stop() {
  impl_->stopped = true;
  impl_->jobs.end();
  while (impl_->serving && !impl_->http.is_running())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  impl_->http.stop();
}

}  // namespace robosim::serve
