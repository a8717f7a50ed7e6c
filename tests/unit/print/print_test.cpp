#include "sim/map/print/print.h"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

namespace robosim::print {
namespace print_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

map::Map path_map(const std::string& segments, const std::string& more = "") {
  return map::parse_map("+++\nsize = [\"1 m\", \"600 mm\"]\n" + more +
                            "[[path]]\nfrom = [\"100 mm\", \"100 mm\"]\nsegments = [" + segments + "]\n+++\n",
                        "course.map");
}

Printed printed(const map::Map& map, bool swapped = false, Paper paper = {}) {
  return print_map(map, {.paper = paper, .swapped = swapped, .compressed = false});
}

std::vector<std::string> pages_of(const std::string& pdf) {
  std::vector<std::string> pages;
  for (std::size_t at = 0; (at = pdf.find("stream\r\n", at)) != pdf.npos;) {
    const std::size_t end = pdf.find("endstream", at);
    pages.push_back(pdf.substr(at, end - at));
    at = end + 9;
  }
  return pages;
}

struct Operation {
  std::string name;
  std::vector<double> mm;
};

std::vector<Operation> operations_of(const std::string& page) {
  std::vector<Operation> all;
  std::vector<double> numbers;
  std::istringstream words(page);
  for (std::string word; words >> word;) {
    std::size_t used = 0;
    try {
      const double number = std::stod(word, &used);
      if (used == word.size()) {
        numbers.push_back(number * 25.4 / 72.0);
        continue;
      }
    } catch (const std::exception&) {
    }
    all.push_back({word, numbers});
    numbers.clear();
  }
  return all;
}

std::string message_of(const map::Map& map, Paper paper = {}) {
  try {
    printed(map, false, paper);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<std::string> numbers_of(const Sheets& sheets) {
  std::vector<std::string> numbers;
  for (const Sheet& sheet : sheets.printed)
    numbers.push_back(std::to_string(sheet.row) + "-" + std::to_string(sheet.column));
  return numbers;
}

// An A4 sheet shows 180 x 267 mm of the floor in portrait format. In landscape format it shows 267 x 180 mm.
TEST(Print, SheetsLieSideBySideFromTheUpperLeftCornerAndEmptyOnesAreLeftOut) {
  const Printed one = printed(path_map("{ length = \"600 mm\" }"));
  EXPECT_EQ(one.sheets.rows, 4);
  EXPECT_THAT(numbers_of(one.sheets), ElementsAre("3-1", "3-2", "3-3"));
  EXPECT_NEAR(one.sheets.piece({3, 2}).left, 267.0, 1e-9);
  EXPECT_NEAR(one.sheets.piece({3, 2}).high, 600.0 - 360.0, 1e-9);
  EXPECT_EQ(pages_of(one.pdf).size(), 4u);
}

TEST(Print, TheBarOnEachSheetIs100MillimetresLong) {
  const auto pages = pages_of(printed(path_map("{ length = \"600 mm\" }")).pdf);
  for (std::size_t page = 1; page < pages.size(); ++page) {
    const auto all = operations_of(pages[page]);
    int bars = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
      bars += all[i].name == "l" && all[i - 1].name == "m" && all[i].mm[1] == all[i - 1].mm[1] &&
              std::fabs(all[i].mm[0] - all[i - 1].mm[0] - 100.0) < 1e-3;
    EXPECT_EQ(bars, 1) << "page " << page;
    EXPECT_THAT(pages[page], HasSubstr("(100 mm)"));
  }
}

// The second sheet shows the floor from x = 267 mm on. This x is 15 mm from the sheet's left edge.
TEST(Print, ALineGoesOnAtTheSamePlaceOnTheNextSheet) {
  const auto pages = pages_of(printed(path_map("{ length = \"600 mm\" }")).pdf);
  const auto ends_of = [&](std::size_t page) {
    double least = 1e9, most = -1e9;
    const auto all = operations_of(pages[page]);
    for (std::size_t i = 1; i < all.size(); ++i) {
      // The line is 100 mm above the floor's lower edge. These sheets show the floor from 60 mm above this
      // edge.
      if (all[i].name != "l" || std::fabs(all[i].mm[1] - (100.0 - 60.0 + 15.0)) > 1e-3) continue;
      least = std::min(least, all[i - 1].mm[0]);
      most = std::max(most, all[i].mm[0]);
    }
    return std::pair{least, most};
  };
  EXPECT_NEAR(ends_of(1).first, 100.0 + 15.0, 1e-3);
  EXPECT_GE(ends_of(1).second, 267.0 + 15.0 + kFlap);
  EXPECT_LE(ends_of(2).first, 15.0 - kFlap);
  EXPECT_NEAR(ends_of(3).second, 700.0 - 2.0 * 267.0 + 15.0, 1e-3);
}

TEST(Print, ArcsAreWithinAHundredthOfAMillimetre) {
  const map::Map map = path_map("{ radius = \"200 mm\", angle = \"180 deg\" }");
  const Printed one = printed(map);
  const auto pages = pages_of(one.pdf);
  int curves = 0;
  for (std::size_t page = 1; page < pages.size(); ++page) {
    const Box piece = one.sheets.piece(one.sheets.printed[page - 1]);
    const Vec2 centre{100.0 - piece.left + 15.0, 300.0 - piece.low + 15.0};
    const auto all = operations_of(pages[page]);
    for (std::size_t i = 1; i < all.size(); ++i) {
      if (all[i].name != "c") continue;
      ++curves;
      const auto& from = all[i - 1].mm;
      const auto& c = all[i].mm;
      for (const double t : {0.0, 0.25, 0.5, 1.0}) {
        const double s = 1.0 - t;
        const auto at = [&](std::size_t k) {
          return s * s * s * from[k] + 3 * s * s * t * c[k] + 3 * s * t * t * c[k + 2] + t * t * t * c[k + 4];
        };
        EXPECT_NEAR(length(Vec2{at(0), at(1)} - centre), 200.0, 0.01);
      }
    }
  }
  EXPECT_GE(curves, 8);
}

TEST(Print, AGapStaysWhite) {
  const Printed one = printed(
      path_map("{ length = \"50 mm\" }, { length = \"600 mm\", gap = true }, { length = \"50 mm\" }"));
  EXPECT_THAT(numbers_of(one.sheets), ElementsAre("2-1", "2-5"));
}

TEST(Print, ADarkFloorIsPrintedWholeOrAsADarkLineOnPaper) {
  const map::Map map = path_map("{ length = \"600 mm\" }", "paint = \"white on black\"\n");
  EXPECT_EQ(printed(map).sheets.printed.size(), 16u);
  EXPECT_EQ(printed(map, true).sheets.printed.size(), 3u);
}

TEST(Print, TheSameMapGivesTheSameBytesWithoutADate) {
  const map::Map map = path_map("{ length = \"600 mm\" }");
  const std::string pdf = print_map(map, {}).pdf;
  EXPECT_EQ(pdf, print_map(map, {}).pdf);
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  EXPECT_THAT(printed(map).pdf, Not(HasSubstr("Date")));
}

TEST(Print, WallsAreThinOutlinesAndTakeNoSheetOfTheirOwn) {
  const map::Map map = map::parse_map("....______\n#########_\n", "walls.map");
  const Printed one = printed(map);
  EXPECT_THAT(numbers_of(one.sheets), ElementsAre("1-1", "1-2"));
  EXPECT_THAT(pages_of(one.pdf)[1], HasSubstr(" re"));
}

TEST(Print, HillsAreThinOutlines) {
  const auto lines = [](const std::string& hill) {
    const auto all = operations_of(pages_of(printed(path_map("{ length = \"100 mm\" }", hill)).pdf)[0]);
    return std::count_if(all.begin(), all.end(), [](const Operation& o) { return o.name == "l"; });
  };
  EXPECT_EQ(lines("[[hill]]\nalong = \"50 mm\"\nsize = [\"50 mm\", \"40 mm\"]\nslope = \"5 deg\"\n"),
            lines("") + 4);
}

TEST(Print, SaysThatWornLinesAreWhole) {
  const auto overview = [](const std::string& keys) {
    return pages_of(printed(path_map("{ length = \"100 mm\"" + keys + " }", "")).pdf)[0];
  };
  EXPECT_THAT(overview(", worn = \"40 %\""), HasSubstr("printed whole"));
  EXPECT_THAT(overview(""), Not(HasSubstr("printed whole")));
}

TEST(Print, PaintedAreasArePrintedInTheirColours) {
  const Printed one = printed(
      path_map("{ length = \"100 mm\" }",
               "[[area]]\ncolour = \"green\"\nat = [\"900 mm\", \"100 mm\"]\nsize = [\"25 mm\", "
               "\"25 mm\"]\n[[area]]\ncolour = \"black\"\nat = [\"500 mm\", \"120 mm\"]\nradius = \"50 "
               "mm\"\n"));
  EXPECT_THAT(numbers_of(one.sheets), ElementsAre("3-1", "3-2", "3-3", "3-4"));
  EXPECT_THAT(pages_of(one.pdf).at(4), HasSubstr("0.12 0.62 0.3 RG"));
  // The PDF draws the disc as a dot whose line width is the disc's diameter.
  const auto all = operations_of(pages_of(one.pdf).at(2));
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Operation& o) {
    return o.name == "w" && std::fabs(o.mm.back() - 100.0) < 1e-3;
  }));
}

TEST(Print, TooManySheetsAreCountedAndRefused) {
  const std::string large =
      "+++\nsize = [\"9 m\", \"9 m\"]\npaint = \"white on black\"\n[[path]]\n"
      "from = [\"1 m\", \"1 m\"]\nsegments = [{ length = \"1 m\" }]\n+++\n";
  EXPECT_EQ(message_of(map::parse_map(large, "large.map")),
            "large.map: takes 1700 pages of this paper with its dark floor; at most 400 are printed");
  std::string huge = large;
  huge.replace(huge.find("9 m"), 3, "3000 m");
  EXPECT_THAT(message_of(map::parse_map(huge, "huge.map")),
              HasSubstr("huge.map: its floor of 3000.0 x 9.0 m is 566678 pages"));
}

}  // namespace print_test
}  // namespace robosim::print
