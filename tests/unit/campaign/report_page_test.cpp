// Tests how `robosim report` reads its input files, and how it writes its page.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/campaign/report/junit_cases.h"
#include "sim/campaign/report/report_page.h"
#include "sim/campaign/report/sweep_rows.h"

namespace robosim::campaign {
namespace report_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

constexpr const char* kHeader =
    "sketch,map,robot,target,seed,verdict,time_s,cross_track_max_mm,trace_hash,why\n";

template <class Read>
std::string refusal(const Read& read, const std::string& text) {
  try {
    read(text, "x");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(AReportsXml, IsWhatRobosimCtestAndGoogleTestWrite) {
  const auto cases = read_junit(R"(<?xml version="1.0"?>
<!-- <testcase name="no"> -->
<testsuites><testsuite name="all" tests="5">
  <testcase classname="Ada" name="drives &quot;two&quot; laps &lt;3&#10;" time="1.5"/>
  <testcase classname="Bo &amp; Co" name="drives" time="0.5"><properties><property name="x" value="1"/></properties>
    <failure message="lost&#x21;"/><failure message="and slow">text with <![CDATA[<testcase name="no">]]></failure></testcase>
  <testcase classname='Suite.Test' name='Suite.Test' status="fail"><failure message=""></failure><system-out>Running
[ RUN      ] Suite.Test
a.cpp:7: Failure
  kept:   artifacts/Suite.Test; open its run.html in a browser
[  FAILED  ] Suite.Test (2 ms)
[==========] 1 test</system-out></testcase>
  <testcase name="Suite.Other" classname="Suite.Other" status="notrun"/>
  <testcase classname="Ada" name="waits"><skipped/></testcase>
</testsuite></testsuites>)",
                                "x.xml");
  ASSERT_THAT(cases, SizeIs(5));
  EXPECT_EQ(cases[0].name, "drives \"two\" laps <3\n");
  EXPECT_EQ(cases[0].time_s, 1.5);
  EXPECT_EQ(cases[1].group, "Bo & Co");
  EXPECT_EQ(cases[1].ending, JunitCase::Ending::failed);
  EXPECT_EQ(cases[1].message, "lost!\nand slow");
  EXPECT_EQ(cases[2].group, "Suite") << "tests of ctest have no class";
  EXPECT_EQ(cases[2].ending, JunitCase::Ending::failed);
  EXPECT_THAT(cases[2].message, AllOf(StartsWith("a.cpp:7: Failure"), EndsWith("in a browser")))
      << "the test's output explains the failure, but ctest's message does not";
  EXPECT_EQ(kept_page(cases[2].message), "artifacts/Suite.Test/run.html");
  EXPECT_EQ(cases[3].ending, JunitCase::Ending::skipped);
  EXPECT_EQ(cases[4].ending, JunitCase::Ending::skipped);
}

TEST(AReportsXml, IsRefusedWithItsLine) {
  EXPECT_THAT(refusal(read_junit, "<a>\n<b x=1/></a>"), StartsWith("x:2: this is not valid XML: "));
  EXPECT_THAT(refusal(read_junit, "<!DOCTYPE a [<!ENTITY b \"c\">]><a/>"),
              HasSubstr("document types are not supported"));
  EXPECT_THAT(refusal(read_junit, "<testsuite/>"), HasSubstr("expected at least one <testcase>"));
  for (const char* cut : {"<", "<a", "<a ", "<a b", "<a b=", "<a b=\"c", "<a b=\"c\"", "<!-- a", "</"})
    EXPECT_THAT(refusal(read_junit, cut), StartsWith("x:1: ")) << cut;
}

TEST(AReportsTable, IsRefusedWithItsLine) {
  EXPECT_THAT(refusal(read_swept_runs, "a,b\n1,2\n"),
              HasSubstr("x:1: expected a table of robosim sweep --csv"));
  EXPECT_THAT(refusal(read_swept_runs, kHeader), HasSubstr("expected at least one run"));
  EXPECT_THAT(refusal(read_swept_runs, kHeader + std::string("a,b\n")), HasSubstr("x:2: expected "));
  EXPECT_THAT(refusal(read_swept_runs, kHeader + std::string("S,m,r,host,1,lost,soon,1,h,why\n")),
              HasSubstr("x:2: time_s: expected a number, got “soon”"));
}

TEST(AReport, HasARowForEachCombinationAndTheWorstOfEach) {
  const auto runs = read_swept_runs(kHeader + std::string("Ada,m,r,host,1,reached,2,5,h,ok\n"
                                                          "Ada,m,r,host,2,reached,4,5,h,ok\n"
                                                          "<b>Bo,m,r,host,1,reached,3,5,h,ok\n"
                                                          "<b>Bo,m,r,host,2,lost,1,5,h,\"left, at 1 s\"\n"),
                                    "runs.csv");
  const auto combinations = combinations_of(runs);
  EXPECT_THAT(combinations, ElementsAre(ElementsAre(0, 1), ElementsAre(2, 3)));
  EXPECT_EQ(worst_of(runs, combinations[0]), 1u) << "the slowest run";
  EXPECT_EQ(worst_of(runs, combinations[1]), 3u) << "the run that failed";
  ReportExtras extras;
  extras.replays[3] = "runs/Bo.html";
  extras.other = 2;
  record::FloorShapes floor;
  floor.width_mm = 1000;
  floor.height_mm = 500;
  extras.add({"m", "its text", floor, {{100.0, 200.0}}});
  const std::string page = sweep_page("runs.csv", runs, extras);
  EXPECT_THAT(
      page,
      AllOf(HasSubstr("4 runs, 3 reached their goal"), HasSubstr("</span>2/2"), HasSubstr("</span>1/2"),
            HasSubstr("3.00 s"), HasSubstr("slowest, seed 2"), HasSubstr("1 lost"),
            HasSubstr("<a href=\"runs/Bo.html\">lost after 0.0 m, seed 2</a>"), HasSubstr("left, at 1 s")));
  EXPECT_THAT(page, AllOf(HasSubstr("&lt;b&gt;Bo"), Not(HasSubstr("<b>Bo"))));
  EXPECT_THAT(page, HasSubstr("<circle cx=\"100\" cy=\"300\"")) << "y points down in a picture";
  EXPECT_THAT(page, HasSubstr("2 of the runs had another result"));
}

TEST(AReport, ShowsTheRunThatFailedSoonest) {
  const std::string header =
      "sketch,map,robot,target,seed,verdict,time_s,distance_m,cross_track_max_mm,laps,stations,trace_hash,"
      "why\n";
  const std::string made[] = {"reached,90,30,5,3,0",  "lost,50,18,40,2,0",  "lost,9,3.25,40,1,0",
                              "timeout,60,25,40,1,0", "lost,8,3.25,45,1,0", "error,,,,,"};
  const auto worst = [&](std::vector<std::size_t> which) {
    std::string table = header;
    for (const std::size_t i : which) table += "S,m,r,host," + std::to_string(i) + "," + made[i] + ",h,why\n";
    const auto runs = read_swept_runs(table, "runs.csv");
    return std::pair(runs[worst_of(runs, combinations_of(runs)[0])].seed, sweep_page("runs.csv", runs, {}));
  };
  EXPECT_EQ(worst({5, 0, 1, 2, 3, 4}).first, 4u)
      << "fewest laps and shortest distance, then largest deviation";
  EXPECT_THAT(worst({1, 2, 3}).second, HasSubstr("lost after 3.2 m, 1 lap, seed 2"));
  EXPECT_EQ(worst({0, 1}).first, 1u) << "a failed run is worse, however far it drove";
  EXPECT_EQ(worst({3, 1}).first, 3u) << "driving in circles is no progress";
  EXPECT_EQ(worst({5, 0}).first, 0u) << "a failure of Robosim itself has no replay";
}

TEST(AReport, HasAtMostFiveThousandRowsAndSaysSo) {
  std::string table = kHeader;
  std::vector<JunitCase> cases;
  for (int i = 0; i < 5001; ++i) {
    table += "S" + std::to_string(i) + ",m,r,host,1,reached,2,5,h,ok\n";
    cases.push_back({"pupil" + std::to_string(i), "laps", JunitCase::Ending::passed, 0.1, ""});
  }
  EXPECT_THAT(sweep_page("runs.csv", read_swept_runs(table, "runs.csv"), {}),
              AllOf(HasSubstr("5001 runs"), HasSubstr("Combinations, the first 5000 of 5001"),
                    HasSubstr(">S4999<"), Not(HasSubstr(">S5000<"))));
  EXPECT_THAT(junit_page("class.xml", cases, {}),
              AllOf(HasSubstr("Names, the first 5000 of 5001"), HasSubstr(">pupil4999<"),
                    Not(HasSubstr(">pupil5000<"))));
}

TEST(AReport, HasARowForEachPupilAndAColumnForEachCheck) {
  using Ending = JunitCase::Ending;
  ReportExtras extras;
  extras.replays[3] = "class-runs/Bo-laps.html";
  const std::string page = junit_page("class.xml",
                                      {{"Ada", "starts", Ending::passed, 0.1, ""},
                                       {"Ada", "laps", Ending::passed, 0.2, ""},
                                       {"Bo", "starts", Ending::passed, 0.1, ""},
                                       {"Bo", "laps", Ending::failed, 0.2, "lost \"it\""}},
                                      extras);
  EXPECT_THAT(
      page,
      AllOf(HasSubstr("4 checks: 3 passed, 1 failed, 0 left out"), HasSubstr("<th>starts</th><th>laps</th>"),
            HasSubstr("Names without a failure: 1 of 2"), HasSubstr("</span>1/2"),
            HasSubstr("title=\"lost &quot;it&quot;\"><a href=\"class-runs/Bo-laps.html\">✗"),
            HasSubstr("<a href=\"class-runs/Bo-laps.html\">laps</a></td><td class=\"good\">✓")));
}

TEST(AReport, SortsAClassByPassedChecksAndThenByTheShortestLap) {
  const auto cases = read_junit(R"(<testsuites><testsuite name="all">
  <testcase classname="Ada" name="laps"><properties><property name="best_lap_s" value="9.25"/></properties></testcase>
  <testcase classname="Bo" name="laps"><failure message="lost"/></testcase>
  <testcase classname="Dan" name="laps"><properties><property name="best_lap_s" value="nan"/></properties></testcase>
  <testcase classname="Cleo" name="laps"><properties><property name="best_lap_s" value="8.5"/></properties></testcase>
</testsuite></testsuites>)",
                                "class.xml");
  const std::string page = junit_page("class.xml", cases, {});
  EXPECT_THAT(page, AllOf(HasSubstr("sorted by passed checks, then by the shortest lap"),
                          HasSubstr("<th>best lap</th>"), HasSubstr("<td>8.50 s</td>")));
  const std::size_t ada = page.find(">Ada<"), bo = page.find(">Bo<"), cleo = page.find(">Cleo<");
  const std::size_t dan = page.find(">Dan<");
  EXPECT_LT(cleo, ada);
  EXPECT_LT(ada, dan) << "a lap time of nan is not a lap";
  EXPECT_LT(dan, bo);
}

}  // namespace report_test
}  // namespace robosim::campaign
