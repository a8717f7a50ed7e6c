// Generates hostile HTTP requests to `robosim serve`.
#include <fmt/format.h>

#include <utility>

#include "tests/hostile/input.h"

namespace robosim::hostile {
namespace {

using Named = std::pair<const char*, std::string>;

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

class Requests {
 public:
  explicit Requests(std::string host) : host_(std::move(host)) {}

  void add(const std::string& mechanism, const std::string& variant, std::vector<std::string> parts,
           bool stays_open = false) {
    all_.push_back({mechanism, variant, std::move(parts), stays_open});
  }
  /// Returns the head of a request: the line `first`, the Host header, and `lines`. `lines` are more header
  /// lines, each with its CR LF.
  std::string head(const std::string& first, const std::string& lines = "") const {
    return fmt::format("{} HTTP/1.1\r\nHost: {}\r\n{}\r\n", first, host_, lines);
  }
  std::string post(const std::string& path, const std::string& body, const std::string& lines = "") const {
    return head("POST " + path,
                fmt::format("X-Robosim: 1\r\nContent-Type: application/json\r\nContent-Length: {}\r\n{}",
                            body.size(), lines)) +
           body;
  }
  void add_framing();
  void add_heads();
  void add_bodies();
  void add_files();
  void add_runs();
  void add_slow();
  std::vector<HostileRequest> take() { return std::move(all_); }

 private:
  std::string host_;
  std::vector<HostileRequest> all_;
};

// One line for each request.
// clang-format off
void Requests::add_framing() {
  const std::string body = R"({"name":"a.map","text":"S"})";
  const std::string ours = "X-Robosim: 1\r\nContent-Type: application/json\r\n";
  const std::string get = head("GET /api/folder"), hidden = post("/api/run", R"({"sketch":"./Mine"})");
  const Named raw[] = {
      {"nothing", ""}, {"ends_of_lines", repeated("\r\n", 5000)}, {"zeros", std::string(70'000, '\0')}, {"no_version", "GET /\r\n\r\n"}, {"version_9", "GET / HTTP/9.9\r\nHost: x\r\n\r\n"},
      {"version_2", "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"}, {"tls", std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11) + std::string(500, 'x')}, {"line_feeds", "GET / HTTP/1.1\nHost: " + host_ + "\n\n"},
      {"returns", "GET / HTTP/1.1\rHost: " + host_ + "\r\r"}, {"zero_in_the_head", head("GET /", std::string("X: a\0b\r\n", 8))}, {"no_colon", head("GET /", "X\r\n")}, {"blank_before_colon", head("GET /", "Host : x\r\n")},
      {"folded", head("GET /", "X: a\r\n b\r\n\tc\r\n")}, {"empty_name", head("GET /", ": x\r\n")}, {"long_line", "GET /" + std::string(200'000, 'x')}, {"long_header", head("GET /", "X: " + std::string(200'000, 'x') + "\r\n")},
      {"many_headers", head("GET /", repeated("X: y\r\n", 20'000))}, {"many_names", head("GET /", [] { std::string all; for (int i = 0; i < 5000; ++i) all += fmt::format("X{}: y\r\n", i); return all; }())},
      {"escape", head("GET /", "X: \033[2J\r\nUser-Agent: \r\033]0;x\007\r\n")}, {"absolute", "GET http://" + host_ + "/ HTTP/1.1\r\nHost: evil\r\n\r\n"}, {"authority", "CONNECT 127.0.0.1:@PORT@ HTTP/1.1\r\nHost: " + host_ + "\r\n\r\n"},
      {"asterisk", head("OPTIONS *")}, {"pipelined", get + get + get}, {"pipelined_after_a_refusal", head("POST /api/run", "Content-Length: 9999\r\n") + hidden}, {"hidden_in_a_get", head("GET /api/folder", fmt::format("Content-Length: {}\r\n", hidden.size())) + hidden},
      {"websocket", head("GET /api/live/1", "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: x\r\nSec-WebSocket-Version: 13\r\n") + std::string("\x81\x80\0\0\0\0", 6)}, {"h2c", head("GET /", "Upgrade: h2c\r\nConnection: Upgrade, HTTP2-Settings\r\nHTTP2-Settings: AAMAAABk\r\n")},
      {"continue", head("POST /api/run", ours + "Expect: 100-continue\r\nContent-Length: 10\r\n")}, {"keep_alive", head("GET /", "Connection: keep-alive\r\nKeep-Alive: timeout=999999, max=999999\r\n") + get}, {"multipart", post("/api/file", "--x\r\nContent-Disposition: form-data; name=\"f\"; filename=\"../x.ino\"\r\n\r\nx\r\n--x--", "Content-Type: multipart/form-data; boundary=x\r\n")},
      {"multipart_without_end", head("POST /api/file", "X-Robosim: 1\r\nContent-Type: multipart/form-data; boundary=" + std::string(5000, '-') + "\r\nContent-Length: 20\r\n") + std::string(20, '-')}, {"form", head("POST /api/run", "Content-Type: application/x-www-form-urlencoded\r\nContent-Length: 3\r\n") + "a=b"}};
  for (const auto& [variant, text] : raw) add("framing", variant, {text});
  for (const char* length : {"-1", "+9", "0x9", "9 9", "9,9", "99999999999999999999", "4294967297", "18446744073709551615", "", " ", "9\r\nContent-Length: 10", "9\r\nTransfer-Encoding: chunked", "1e3", "٣"})
    add("length", length, {head("POST /api/file", ours + "Content-Length: " + length + "\r\n") + body});
  for (const char* coding : {"chunked", "chunked, chunked", "gzip, chunked", "identity", "Chunked ", "x", "\vchunked", "chunked\r\nTransfer-Encoding: x"})
    add("transfer", coding, {head("POST /api/file", ours + "Transfer-Encoding: " + coding + "\r\n") + "5\r\nabcde\r\n0\r\n\r\n"});
  for (const char* chunk : {"ffffffffffffffff\r\nx", "-1\r\nx", "5;a=b\r\nabcde\r\n0\r\nX: y\r\n\r\n", "x\r\n"})
    add("chunk", chunk, {head("POST /api/file", ours + "Transfer-Encoding: chunked\r\n") + chunk});
}

void Requests::add_heads() {
  for (const char* method : {"PUT", "DELETE", "PATCH", "TRACE", "HEAD", "OPTIONS", "CONNECT", "get", "PROPFIND", "X", "GET\t", "G\0T"}) {
    add("method", method, {head(std::string(method) + " /api/folder")});
    add("method_on_a_run", method, {head(std::string(method) + " /api/run", "X-Robosim: 1\r\nContent-Type: application/json\r\nContent-Length: 19\r\n") + R"({"sketch":"./Mine"})"});
  }
  for (const char* path : {"/../outside/secret", "/%2e%2e/outside/secret", "/..%2foutside/secret", "/....//outside/secret", "/recording/../../outside/secret", "/recording/..%2f1.html", "/recording/1.html/../../x", "//etc/passwd", "/etc/passwd",
                           "/%00", "/recording/1.html%00", "/recording/99999999999999999999.html", "/recording/-1.html", "/recording/0.html", "/recording/1", "/api/live/999999999", "/api/live/9999999999", "/api/live/-1", "/api/live/0", "/api/../bench.js",
                           "/./bench.js", "/bench.js/", "/BENCH.JS", "/bench.js;x", "/bench.js?x=1", "/bench.js#x", "/?token=x", "/\\..\\x", "/~root", "/api/folder?dir=/etc", "/a|id", "/$(id)", "/%c0%ae%c0%ae/", "/\xff\xfe", "/*", "/api//folder", "x", "http:///etc/passwd", "/proc/self/environ"})
    add("path", path, {head(std::string("GET ") + path)});
  add("path", "long", {head("GET /" + std::string(9000, 'x'))});
  add("path", "many_parameters", {head("GET /?" + repeated("a=b&", 10'000))});
  for (const std::string& host : {std::string("evil.example"), std::string("evil.example:8080"), std::string(""), host_ + ".evil", host_ + "@evil", "x@" + host_, host_ + " ", std::string("[::1]"), std::string("127.1"), std::string("0x7f000001"), std::string("localhost.evil:80"), std::string("127.0.0.1"), host_ + "\r\nHost: evil", "[" + host_ + "]", std::string(5000, 'h')})
    add("host", host.substr(0, 30) + std::to_string(host.size()), {"GET /api/folder HTTP/1.1\r\nHost: " + host + "\r\n\r\n"});
  for (const std::string& origin : {std::string("http://evil.example"), std::string("null"), "https://" + host_, "http://" + host_ + ".evil", "http://" + host_ + "/", "HTTP://" + host_, "http://" + host_ + "\r\nOrigin: http://evil", "file://" + host_})
    add("origin", origin.substr(0, 40), {post("/api/run", R"({"sketch":"./Mine"})", "Origin: " + origin + "\r\n")});
  for (const char* site : {"cross-site", "same-site", "none", "same-origin, cross-site", "x", "Same-Origin"})
    add("fetch_site", site, {post("/api/run", R"({"sketch":"./Nowhere"})", std::string("Sec-Fetch-Site: ") + site + "\r\n")});
  for (const std::string& range : {std::string("bytes=0-"), std::string("bytes=-1"), std::string("bytes=5-1"), std::string("bytes=99999999999999999999-"), std::string("bytes=0-0,1-1"), repeated("bytes=0-,", 1500), std::string("bytes=-"), std::string("x=0-1"), std::string("bytes= 0 - 1"), std::string("bytes=0-\r\nRange: bytes=1-"), std::string("bytes=-9999999999"), std::string("bytes=0x0-1")})
    add("range", range.substr(0, 30) + std::to_string(range.size()), {head("GET /bench.js", "Range: " + range + "\r\n")});
  for (const char* type : {"text/plain", "application/json; charset=utf-7", "application/json\r\nContent-Type: text/plain", "APPLICATION/JSON", "multipart/form-data; boundary=", "application/x-www-form-urlencoded", ""})
    add("content_type", type, {head("POST /api/run", fmt::format("X-Robosim: 1\r\nContent-Type: {}\r\nContent-Length: 2\r\n", type)) + "{}"});
  for (const char* encoding : {"gzip", "deflate", "br", "zstd", "identity", "gzip, gzip", "x", "\r\nContent-Encoding: gzip"})
    add("content_encoding", encoding, {post("/api/file", std::string("\x1f\x8b\x08\0\0\0\0\0\0\x03", 10) + std::string(9000, '\0'), std::string("Content-Encoding: ") + encoding + "\r\n")});
  for (const char* header : {"X-Forwarded-For: 127.0.0.1", "X-HTTP-Method-Override: DELETE", "Cookie: robosim=x; robosim=y", "Authorization: Basic eDp4", "Accept-Encoding: gzip;q=0, br;q=99999999999, *;q=-1", "If-Range: x", "If-Modified-Since: x", "Proxy: http://127.0.0.1:@PORT@", "Accept: */*;q=x", "TE: trailers"})
    add("header", header, {head("GET /", std::string(header) + "\r\n")});
}

void Requests::add_bodies() {
  const std::string deep = repeated("[", 100'000), lists = repeated("[],", 60'000);
  const Named bodies[] = {
      {"empty", ""}, {"null", "null"}, {"number", "1"}, {"list", "[]"}, {"nothing_in_it", "{}"}, {"deep", deep}, {"deep_objects", repeated("{\"a\":", 50'000)}, {"deep_and_closed", deep + repeated("]", 100'000)}, {"many_values", "[" + lists + "1]"},
      {"many_keys", [] { std::string all = "{"; for (int i = 0; i < 15'000; ++i) all += fmt::format("\"k{}\":1,", i); return all + "\"k\":1}"; }()}, {"same_key", "{" + repeated("\"name\":\"a.map\",", 10'000) + "\"text\":\"S\"}"}, {"long_key", "{\"" + std::string(250'000, 'k') + "\":1}"},
      {"long_text", "{\"name\":\"" + std::string(250'000, 'x') + "\",\"text\":\"\"}"}, {"too_long", "{\"name\":\"" + std::string(300'000, 'x') + "\"}"}, {"huge_number", "{\"seed\":1e99999,\"for_s\":-1e99999,\"sketch\":\"./Mine\"}"},
      {"long_number", "{\"seed\":" + std::string(200'000, '9') + "}"}, {"types", R"({"name":1,"text":{},"base64":[],"replace":"x","sketch":null})"}, {"surrogate", R"({"name":"\ud800.map","text":"\udfff"})"}, {"zero_in_text", R"({"name":"a\u0000.map","text":"\u0000"})"}, {"bad_utf8", "{\"name\":\"\xff\xc0\x80\",\"text\":\"\xed\xa0\x80\"}"},
      {"mark_in_front", "\xef\xbb\xbf{\"name\":\"a.map\",\"text\":\"S\"}"}, {"rest_after_it", R"({"name":"a.map","text":"S"}{})"}, {"comment", R"({"name":"a.map",/**/"text":"S"})"}, {"not_a_number", R"({"seed":NaN,"for_s":Infinity})"}, {"cut", R"({"name":"a.map","te)"}, {"escape", R"({"name":"\u001b[2J.map","text":"\u001b]0;x\u0007"})"}, {"prototype", R"({"__proto__":{"x":1},"constructor":1})"}};
  for (const char* path : {"/api/run", "/api/live", "/api/map", "/api/floor", "/api/file", "/api/live/1"})
    for (const auto& [variant, body] : bodies) add(std::string("body_of_") + (path + 5), variant, {post(path, body)});
}

void Requests::add_files() {
  add("body_of_file", "far_too_long", {post("/api/file", std::string(4'000'000, ' '))});
  add("body_of_run", "far_too_long", {post("/api/run", std::string(4'000'000, ' '))});
  const std::string text = R"(,"text":"void setup() {} void loop() {}","replace":true})";
  for (const char* name : {"../x.ino", "/etc/x.map", "./../x.map", "./link.map", "link.toml", "link.map", "away/x.map", "./away/x.map", "checks.toml", "CHECKS.TOML", ".map", "-x.map", "@x.ino", "x.ino/../../y.map", "x\\\\y.map", "x\\n.map", "x\\u0000.map", "x.map\\u0000.ino", "x.MAP", "x.sh", "platformio.ini", "con.map", "x..map", "pipe.map", "Mine.ino", "away.ino", "\\u202ex.map", "./Mine/Mine.ino", "/proc/self/x.map", "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa.map"})
    add("name_of_a_file", name, {post("/api/file", "{\"name\":\"" + std::string(name) + "\"" + text)});
  for (const char* name : {"./link.map", "../outside/secret.map", "/etc/passwd", "./away/secret.map", "oval/../../x", "../maps/oval", "./pipe.map", "", "oval\\u0000", "./loop/loop/loop/x.map"})
    add("map_that_is_read", name, {post("/api/map", "{\"name\":\"" + std::string(name) + "\",\"text\":\"\"}")});
  const Named maps[] = {{"wide", std::string(240'000, '.')}, {"tall", repeated(".\\n", 80'000)}, {"declared", "+++\\nsize = 99999\\n[[path]]\\nstart = \\\"0,0\\\"\\nforward = \\\"1e9 m\\\"\\n+++\\nS..\\n"}, {"front_matter", "+++\\nx = " + repeated("[", 100'000)}, {"cells", repeated(repeated("-", 500) + "\\n", 400)}, {"paths", "+++\\n" + repeated("[[path]]\\nstart = \\\"1,1\\\"\\nforward = \\\"1 m\\\"\\n", 4000) + "+++\\n.S.\\n"}, {"escape", "\\u001b[2J"}};
  for (const auto& [variant, map] : maps) add("floor", variant, {post("/api/floor", "{\"name\":\"a.map\",\"text\":\"" + map + "\"}")});
  const Named images[] = {{"empty", ""}, {"junk", "AAAA"}, {"not_base64", "*%&$"}, {"elf", "f0VMRgEBAQAAAAAAAAAAAAIAUwABAAAA/////w=="}, {"megabytes", repeated("AAAA", 500'000)}};
  for (const auto& [variant, image] : images) {
    add("image", variant, {post("/api/file", "{\"name\":\"i.elf\",\"base64\":\"" + image + "\",\"replace\":true}")});
    add("image_in_hex", variant, {post("/api/file", "{\"name\":\"i.hex\",\"base64\":\"Og==" + image + "\",\"replace\":true}")});
  }
}

void Requests::add_runs() {
  for (const char* rest : {R"("map":"../outside/secret.map")", R"("map":"/etc/passwd")", R"("map":"./link.map")", R"("robot":"./link.toml")", R"("robot":"--help")", R"("goal":"--version")", R"("goal":"laps:99999999999999999999")", R"("goal":"\u001b[2J")", R"("target":"gdb")", R"("target":"avr\u0000")", R"("for_s":1e308)", R"("for_s":-1)", R"("seed":1.5)", R"("seed":-1)", R"("script":"at 1e999s press start")", R"("script":"include /etc/passwd")", R"("scripts":{"../x":"at 1s press start"})", R"("record":"/tmp/x.html")", R"("map":"oval","for_s":0.01,"script":"\u0000")", R"("sketch":"./Mine")"})
    add("run", rest, {post("/api/run", std::string(R"({"sketch":"./Mine",)") + rest + "}")});
  for (const char* sketch : {"../outside", "./away/Theirs", "/etc", "-x", "./link", "./Mine/../Mine", "", "./Mine\\u0000", "./fleet.toml", "./pipe.map", "./junk.elf", "./junk.hex"})
    add("run_of", sketch, {post("/api/run", "{\"sketch\":\"" + std::string(sketch) + "\",\"for_s\":0.01}")});
  for (const char* sketch : {"Prints", "Loops", "Reads", "Grows", "Includes"})
    add("run_of_a_hostile_sketch", sketch, {post("/api/run", fmt::format(R"({{"sketch":"./{}","map":"oval","for_s":20}})", sketch))});
  add("live", "never_watched", {post("/api/live", R"({"sketch":"./Mine","map":"oval"})")});
  add("live", "of_a_hostile_sketch", {post("/api/live", R"({"sketch":"./Prints","map":"oval"})")});
}

void Requests::add_slow() {
  const std::string whole = post("/api/file", R"({"name":"slow.map","text":"S"})");
  add("slow", "nothing", {""}, true);
  add("slow", "half_a_line", {"GET /api"}, true);
  add("slow", "half_a_head", {"GET / HTTP/1.1\r\nHost: x\r\n"}, true);
  add("slow", "no_body", {whole.substr(0, whole.find("\r\n\r\n") + 4)}, true);
  add("slow", "half_a_body", {whole.substr(0, whole.size() - 5)}, true);
  add("slow", "many_small_parts", std::vector<std::string>(30'000, "X: y\r\n"), true);
  add("slow", "answer_not_read", {repeated(head("GET /live.html"), 50)}, true);
}

// clang-format on

}  // namespace

std::vector<HostileRequest> requests(const std::string& host) {
  Requests all(host);
  all.add_framing();
  all.add_heads();
  all.add_bodies();
  all.add_files();
  all.add_runs();
  all.add_slow();
  return all.take();
}

}  // namespace robosim::hostile
