#include "sim/view/serve/origin_check.h"

#include <gtest/gtest.h>

namespace robosim::serve {
namespace origin_check_test {

struct Hostile {
  const char* what;
  RequestHead asked;
  int status;
};

RequestHead get(const char* path) { return {"GET", path, "127.0.0.1:8080", "", "", "", "", ""}; }
RequestHead post(const char* origin, const char* site, const char* robosim, const char* type) {
  RequestHead asked{"POST", "/api/run", "127.0.0.1:8080", origin, site, robosim, type, ""};
  asked.content_length = "2";
  return asked;
}
RequestHead host(const char* name) { return {"GET", "/", name, "", "", "", "", ""}; }

TEST(OriginCheck, RefusesWhatIsNotOfItsOwnPage) {
  const OriginCheck origin_check("127.0.0.1", 8080, "");
  const std::string own = "http://127.0.0.1:8080", json = "application/json";
  const std::string long_path = "/" + std::string(300, 'a');
  const Hostile hostile[] = {
      {"up", get("/../etc/passwd"), 400},
      {"up within", get("/recording/../../etc/passwd"), 400},
      {"up in percent signs", get("/%2e%2e/%2e%2e/etc/passwd"), 400},
      {"twice in percent signs", get("/%252e%252e/etc/passwd"), 400},
      {"a NUL", get("/recording/1.html%00.png"), 400},
      {"a backslash", get("/..\\..\\etc\\passwd"), 400},
      {"an absolute path", get("//etc/passwd"), 400},
      {"a whole address", get("http://127.0.0.1:8080/"), 400},
      {"no path", get(""), 400},
      {"a star", get("*"), 400},
      {"UTF-8 made too long", get("/\xC0\xAE\xC0\xAE/etc"), 400},
      {"a new line", get("/%0d%0aSet-Cookie:a=b"), 400},
      {"a long path", get(long_path.c_str()), 400},
      {"another name", host("evil.example:8080"), 421},
      {"a name that begins as ours", host("127.0.0.1.evil.example:8080"), 421},
      {"another port", host("127.0.0.1:80"), 421},
      {"no port", host("127.0.0.1"), 421},
      {"no name", host(""), 421},
      {"a name before an at", host("127.0.0.1:8080@evil.example"), 421},
      {"an address of the network", host("192.168.0.10:8080"), 421},
      {"another origin", post("http://evil.example", "", "1", json.c_str()), 403},
      {"no origin to speak of", post("null", "", "1", json.c_str()), 403},
      {"our host by another scheme", post("https://127.0.0.1:8080", "", "1", json.c_str()), 403},
      {"our host at another port", post("http://127.0.0.1:3000", "", "1", json.c_str()), 403},
      {"from another site", post("", "cross-site", "1", json.c_str()), 403},
      {"from a neighbour", post("", "same-site", "1", json.c_str()), 403},
      {"a form", post(own.c_str(), "same-origin", "", "application/x-www-form-urlencoded"), 403},
      {"a form with the header", post(own.c_str(), "same-origin", "1", "text/plain"), 415},
      {"JSON as a form sends it", post(own.c_str(), "same-origin", "1", "application/json;a=b"), 415},
      {"PUT", {"PUT", "/api/run", "127.0.0.1:8080", "", "", "1", json, ""}, 405},
      {"DELETE", {"DELETE", "/", "127.0.0.1:8080", "", "", "1", json, ""}, 405},
      {"OPTIONS", {"OPTIONS", "/", "127.0.0.1:8080", "", "", "", "", ""}, 405},
      {"CONNECT", {"CONNECT", "/", "127.0.0.1:8080", "", "", "1", json, ""}, 405},
  };
  for (const Hostile& one : hostile) {
    const auto refusal = origin_check.refuse(one.asked);
    ASSERT_TRUE(refusal) << one.what;
    EXPECT_EQ(refusal->status, one.status) << one.what;
    EXPECT_FALSE(refusal->sentence.empty()) << one.what;
  }
}

TEST(OriginCheck, AnswersItsOwnPageByEachNameOfThisMachine) {
  const OriginCheck origin_check("127.0.0.1", 8080, "");
  for (const char* name : {"127.0.0.1:8080", "localhost:8080", "[::1]:8080"})
    EXPECT_FALSE(origin_check.refuse(host(name))) << name;
  EXPECT_FALSE(origin_check.refuse(post("http://127.0.0.1:8080", "same-origin", "1", "application/json")));
  EXPECT_EQ(origin_check.url(), "http://127.0.0.1:8080/");
}

TEST(OriginCheck, LetsNoRequestGrow) {
  const OriginCheck origin_check("127.0.0.1", 8080, "");
  const RequestHead good = post("", "", "1", "application/json");
  ASSERT_FALSE(origin_check.refuse(good));
  const auto status = [&](std::string RequestHead::*header, const char* value) {
    RequestHead asked = good;
    asked.*header = value;
    const auto refusal = origin_check.refuse(asked);
    return refusal ? refusal->status : 200;
  };
  for (const char* coding : {"gzip", "deflate", "br", "GZIP", "identity, gzip", ",gzip"})
    EXPECT_EQ(status(&RequestHead::content_encoding, coding), 415) << coding;
  for (const char* coding : {"chunked", "identity", ",chunked"})
    EXPECT_EQ(status(&RequestHead::transfer_encoding, coding), 411) << coding;
  for (const char* length : {"", "-1", "2,2", "0x10", "1e9", " 2", "99999999999999999999"})
    EXPECT_EQ(status(&RequestHead::content_length, length), 411) << length;
  EXPECT_EQ(status(&RequestHead::range, "bytes=0-1"), 200);
  EXPECT_EQ(status(&RequestHead::range, "bytes=0-1,0-1"), 416);
}

TEST(OriginCheck, WantsATokenWhereOthersMayConnect) {
  const OriginCheck origin_check("192.168.0.10", 8080, "secret");
  RequestHead asked{"GET", "/", "192.168.0.10:8080", "", "", "", "", ""};
  EXPECT_EQ(origin_check.refuse(asked)->status, 401);
  for (const char* wrong : {"secre", "secret1", "SECRET"}) {
    asked.token = wrong;
    EXPECT_EQ(origin_check.refuse(asked)->status, 401) << wrong;
  }
  asked.token = "secret";
  EXPECT_FALSE(origin_check.refuse(asked));
  asked.host = "evil.example:8080";
  EXPECT_EQ(origin_check.refuse(asked)->status, 421);
  EXPECT_EQ(origin_check.url(), "http://192.168.0.10:8080/?token=secret");
  EXPECT_EQ(OriginCheck("::", 80, "").url(), "http://[::]:80/");
}

TEST(OriginCheck, TokensAreLongAndDiffer) {
  EXPECT_EQ(random_token().size(), 32u);
  EXPECT_NE(random_token(), random_token());
}

}  // namespace origin_check_test
}  // namespace robosim::serve
