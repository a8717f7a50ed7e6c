// Takes pictures of a recording's page (`robosim run --record run.html`) and of a report. Compares some of
// them with the pictures in docs.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/browser/page.h"

namespace robosim::test {
namespace page_pictures_test {

using Json = nlohmann::json;

// Takes pictures for people to look at: of a wide screen with the light theme, and of a phone with the dark
// theme.
TEST_F(Page, IsPhotographed) {
  const std::filesystem::path pictures = ROBOSIM_PICTURES;
  for (const char* tab : {"plots", "pins", "serial", "events", "wiring"}) {
    for (const auto& [theme, width] : {std::pair{"light", 1400}, std::pair{"dark", 390}}) {
      const auto picture = pictures / (std::string(tab) + "-" + theme + "-" + std::to_string(width) + ".png");
      in_page(file().string() + "#t=2.6&tab=" + tab + "&theme=" + theme, "await drawn();", width, 900);
      browser().picture(picture);
      EXPECT_GT(std::filesystem::file_size(picture), 20'000u);
    }
  }
}

/// Returns the fraction of points that differ between two pictures, or 1 if their sizes differ. Other
/// versions of the browser draw the edges of letters slightly differently.
double difference(const std::filesystem::path& a, const std::filesystem::path& b) {
  browser().open("about:blank");
  const auto source = [](const std::filesystem::path& file) {
    return Json("data:image/png;base64," + base64(read_file(file))).dump();
  };
  return browser().run("const sources = [" + source(a) + ", " + source(b) + R"(];
    const points = async (src) => {
      const image = Object.assign(new Image(), { src });
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
      const ctx = canvas.getContext('2d');
      ctx.drawImage(image, 0, 0);
      return ctx.getImageData(0, 0, image.width, image.height);
    };
    const [one, other] = [await points(sources[0]), await points(sources[1])];
    if (one.width !== other.width || one.height !== other.height) return 1;
    let count = 0;
    for (let i = 0; i < one.data.length; i += 4)
      count += [0, 1, 2].some((k) => Math.abs(one.data[i + k] - other.data[i + k]) > 48);
    return count / (one.data.length / 4);)");
}

TEST_F(Page, IsInTheDocs) {
  const std::filesystem::path pictures = ROBOSIM_PICTURES;
  const auto run = [&](std::vector<std::string> words) {
    ASSERT_EQ(robosim_command(std::move(words), folder->path()).status, 0);
  };
  const auto picture = [&](const char* page, const char* name, int height) {
    browser().open("file://" + (*folder / page).string(), 1200, height);
    browser().run(
        "await until(() => document.documentElement.dataset.ready || !$('recording')); await drawn();");
    browser().picture(pictures / name);
    const std::filesystem::path kept = std::filesystem::path(ROBOSIM_DOCS_PICTURES) / name;
    if (std::getenv("ROBOSIM_WRITE_DOCS"))
      std::filesystem::copy_file(pictures / name, kept, std::filesystem::copy_options::overwrite_existing);
    EXPECT_LT(difference(pictures / name, kept), 0.02)
        << kept << " differs from the page: ROBOSIM_WRITE_DOCS=1 ./robosim test --browser regenerates it";
  };
  run({"run", "PidFollower", "--map", "tight", "--record", "one.html"});
  run({"run", "PidFollower", "--map", "tight", "--seed", "2", "--record", "two.rec"});
  run({"replay", "one.html", "--over", "two.rec", "--record", "both.html"});
  run({"new", "MyFollower"});
  run({"sweep", "PidFollower", "./MyFollower", "--map", "tight", "--robot", "uno5", "--seeds", "1..30",
       "--csv", "runs.csv"});
  run({"report", "runs.csv"});
  picture("one.html#t=2.6&theme=light", "page.png", 760);
  picture("both.html#t=5&theme=light", "two-runs.png", 760);
  picture("report.html", "report.png", 860);
}

}  // namespace page_pictures_test
}  // namespace robosim::test
