// Tests the messages of a recording's page (`robosim run --record run.html`) for broken files.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/record/compressed.h"
#include "sim/record/recording_header.h"
#include "tests/browser/page.h"

namespace robosim::test {
namespace page_broken_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Json = nlohmann::json;

TEST_F(Page, SaysInOneSentenceThatItsRecordingIsBroken) {
  const std::string good = read_file(file());
  const std::size_t at = good.find("octet-stream\">") + 14;
  const std::string lacking = base64(record::kRecordingMagic + record::deflated("{}\n"));
  for (const auto& [broken, sentence] :
       {std::pair{good.substr(0, at) + good.substr(good.find("</script>", at)), "not a recording of Robosim"},
        std::pair{good.substr(0, at) + lacking + good.substr(good.find("</script>", at)),
                  "header is damaged"},
        std::pair{good.substr(0, at + 2000) + good.substr(good.find("</script>", at)), "damaged or cut off"},
        std::pair{good.substr(0, at + 60) + "AAAA" + good.substr(at + 64), "damaged"},
        std::pair{good.substr(0, at + 60) + "<!!>" + good.substr(at + 64), "damaged"}}) {
    write_file(*folder / "broken.html", broken);
    const Json said = in_page(*folder / "broken.html",
                              "return [$('problem').hidden, $('problem').textContent, $('main').hidden];");
    EXPECT_FALSE(said[0].get<bool>());
    EXPECT_THAT(said[1].get<std::string>(), HasSubstr(sentence));
    EXPECT_TRUE(said[2].get<bool>());
  }
}

// Cuts the page's file off within its style sheet, its recording or its script. The script then does not run.
TEST_F(Page, SaysThatItIsCutOff) {
  const std::string good = read_file(file());
  const std::size_t begins = good.find("octet-stream\">") + 14;
  for (const std::size_t size : {good.find("</style>") - 100, begins + 5000, good.rfind("begin();")}) {
    write_file(*folder / "cut.html", good.substr(0, size));
    const Json said = in_page(*folder / "cut.html", "return document.body.innerText;");
    EXPECT_THAT(said.get<std::string>(),
                AllOf(HasSubstr("This page is cut off"), ::testing::Not(HasSubstr("reading"))))
        << size;
  }
  const Json over = in_page(file(), "const cut = " + Json(good.substr(0, begins + 5000)).dump() + R"(;
    await page.open(new File([cut], 'cut.html'));
    return $('problem').textContent;)");
  EXPECT_THAT(over.get<std::string>(), HasSubstr("cut off"));
}

// Opens broken files with "Compare…". The page stays unchanged, and so does a run that is laid over it.
TEST_F(Page, SaysWhatIsBrokenInAFileThatIsToBeComparedWith) {
  const std::string good = read_file(*folder / "run.rec");
  const auto made = [](const std::string& header) {
    return record::kRecordingMagic + record::deflated(header + "\n");
  };
  struct Broken {
    const char* name;
    std::string content;
    const char* sentence;
  };
  const std::vector<Broken> files = {
      {"cut.rec", good.substr(0, good.size() / 2),
       "The recording is damaged or cut off: record the run again."},
      {"begun.rec", good.substr(0, 8), "This is not a recording of Robosim."},
      {"odd.rec", good.substr(0, 400) + "robosim" + good.substr(407),
       "The recording is damaged or cut off: record the run again."},
      {"newer.rec", "robosim.rec/2\n" + good.substr(14),
       "This recording was made by a newer version of Robosim than this page."},
      {"empty.rec", "", "This is not a recording of Robosim."},
      {"other.html", "<!doctype html><title>Another page</title>", "This page has no recording of Robosim."},
      {"bare.rec", made("{}"), "The recording’s header is damaged: record the run again."},
      {"hollow.rec", made(R"({"streams":[],"notes":[],"result":{},"started":{},"robot_info":{}})"),
       "The recording’s header is damaged: record the run again."},
      {"photo.rec", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), "This is not a recording of Robosim."}};
  Json chosen = Json::array();
  for (const Broken& file : files) chosen.push_back({file.name, base64(file.content)});
  const Json seen = in_page(file(), "const files = " + chosen.dump() + ", good = '" + base64(good) + R"(';
    const choose = async (name, content, done) => {
      const files = new DataTransfer();
      files.items.add(new File([Uint8Array.from(atob(content), (c) => c.charCodeAt(0))], name));
      $('problem').textContent = '';
      $('other-file').files = files.files;
      $('other-file').dispatchEvent(new Event('change'));
      await until(done);
    };
    const seen = [];
    for (const before of [false, true]) {
      if (before) await choose('good.rec', good, () => $('other-box').textContent.includes('good.rec'));
      for (const [name, content] of files) {
        await choose(name, content, () => $('problem').textContent);
        page.player.seek(3);
        seen.push({ said: $('problem').hidden ? '' : $('problem').textContent, over: !$('other-box').hidden && $('other-box').textContent.includes('good.rec'),
          alone: $('other-box').hidden, shown: !$('main').hidden && parseFloat($('now-speed_mm_s').textContent) > 0 });
      }
    }
    return seen;)");
  ASSERT_EQ(seen.size(), 2 * files.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Broken& file = files[i % files.size()];
    const bool over = i >= files.size();
    EXPECT_EQ(seen[i]["said"], std::string(file.name) + ": " + file.sentence);
    EXPECT_EQ(seen[i]["over"], over) << file.name;
    EXPECT_EQ(seen[i]["alone"], !over) << file.name;
    EXPECT_EQ(seen[i]["shown"], true) << file.name;
  }
}

}  // namespace page_broken_test
}  // namespace robosim::test
