#include "sim/robot/description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hal/board/board_spec.h"
#include "sim/base/config_text.h"
#include "sim/base/file.h"
#include "sim/robot/describe.h"
#include "sim/robot/parts/reflectance.h"
#include "tests/support/readable.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace description_test {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

std::string message_of(const std::string& text) {
  try {
    parse_description(text, "robot.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// Returns the robot file kBareRobot with `from` replaced by `to`.
std::string changed(std::string from, const std::string& to) {
  std::string text = kBareRobot;
  text.replace(text.find(from), from.size(), to);
  return text;
}

std::string part(const std::string& keys) { return "[[part]]\n" + keys; }

constexpr const char* kEye = "name = \"eye\"\ntype = \"reflectance\"\nat = [\"0 mm\", \"0 mm\"]\n";

struct Case {
  std::string text;
  const char* message;
};

class BadDescription : public ::testing::TestWithParam<Case> {};

TEST_P(BadDescription, IsRefusedWithPlaceAndWhatIsAllowed) {
  const std::string message = message_of(GetParam().text);
  EXPECT_THAT(message, HasSubstr(GetParam().message));
  EXPECT_THAT(message, ::testing::MatchesRegex("robot.toml:[0-9]+.*"));
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadDescription,
    ::testing::Values(
        Case{changed("board = \"nano\"", "bord = \"nano\""), "lacks the key board"},
        Case{changed("board = \"nano\"", "board = \"teensy\""), "board: expected uno"},
        Case{changed("mass = \"300 g\"", "mass = 300"),
             "robot.toml:5:8: mass: expected a string with a unit"},
        Case{changed("mass = \"300 g\"", "mass = \"300 kg\""), "mass: expected 0.02 to 5 kg, got 300 kg"},
        Case{changed("mass = \"300 g\"", "wieght = \"300 g\""), "lacks the key mass"},
        Case{kBareRobot + "standby = 99\n", "standby: expected a pin of board nano"},
        Case{changed("radius = \"60 mm\"", "radius = \"60 mm\", hight = 3"), "unknown key hight in outline"},
        Case{changed("outline = { radius = \"60 mm\" }",
                     "outline = [[\"0 mm\", \"0 mm\"], [\"50 mm\", \"0 mm\"], [\"10 mm\", \"10 mm\"], [\"0 "
                     "mm\", \"50 mm\"]]"),
             "outline: expected a convex outline"},
        Case{changed("outline = { radius = \"60 mm\" }", "outline = [[\"0 mm\", \"0 mm\"]]"),
             "3 to 32 corners"},
        Case{changed("mass = \"300 g\"", "mass = { value = \"300 g\", spread = \"99 %\" }"),
             "the spread of mass: expected values from 20 to 5000 g, got 3 to 597"},
        Case{changed("mass = \"300 g\"", "mass = { value = \"300 g\", spraed = \"5 %\" }"),
             "unknown key spraed"},
        Case{changed("chip = \"tb6612\"", "chip = \"tb6613\""), "chip: expected l298n"},
        Case{changed("stall_current = \"1.6 A\"", "stall_current = \"1.6 A\"\nno_load_current = \"1.5 A\""),
             "stall_current: expected at least 1.25 times no_load_current"},
        Case{kBareRobot + "[[prat]]\nname = \"x\"\n", "unknown key prat in a robot file"},
        Case{kBareRobot + "[part]\nname = \"x\"\n", "part: expected a table [[part]] for each part"},
        Case{kBareRobot + part("type = \"led\"\npin = 13\n"), "[[part]] lacks the key name"},
        Case{kBareRobot + part("name = \"my led\"\ntype = \"led\"\npin = 13\n"), "without spaces"},
        Case{kBareRobot + part("name = \"x\"\ntype = \"lamp\"\npin = 13\n"), "type: expected motor"},
        Case{kBareRobot + part("name = \"x\"\ntype = \"led\"\npin = 22\n"),
             "pin: expected a pin of board nano"},
        Case{kBareRobot + part("name = \"x\"\ntype = \"led\"\npin = \"A6\"\n"), "an analog input only"},
        Case{kBareRobot + part("name = \"x\"\ntype = \"led\"\npin = true\n"),
             "pin: expected a pin such as 5"},
        Case{kBareRobot + part("name = \"x\"\ntype = \"led\"\npin = 13\ncolour = \"red\"\n"),
             "unknown key colour"},
        Case{kBareRobot + part(kEye) + "pin = 9\n", "expected a pin with an analog input on board nano, A0"},
        Case{kBareRobot + part(kEye) + "pin = \"A0\"\nread = \"quick\"\n",
             "read: expected analog, digital or rc"},
        Case{kBareRobot + part(kEye) + "pin = \"A7\"\nread = \"rc\"\n", "an analog input only"},
        Case{kBareRobot + part(kEye) + "pin = \"A0\"\nread = \"rc\"\nblack = \"low\"\n", "unknown key black"},
        Case{kBareRobot + part(kEye) + "pin = \"A0\"\nread = \"rc\"\nwhite_time = \"3 ms\"\n",
             "white_time shorter than black_time"},
        Case{kBareRobot + part(kEye) +
                 "pin = \"A0\"\nblack = \"low\"\nwhite_volts = \"1 V\"\nblack_volts = \"2 V\"\n",
             "contradicts"},
        Case{kBareRobot + part("name = \"e\"\ntype = \"reflectance-array\"\nat = [\"70 mm\", \"0 "
                               "mm\"]\npitch = \"9 mm\"\n"
                               "pins = [\"A0\", \"A1\"]\nwhite_volts = [\"1 V\"]\n"),
             "white_volts: expected 2 values, one for each pin of e, got 1"},
        Case{kBareRobot + part("name = \"e\"\ntype = \"encoder\"\nperiods = 20\npins = { a = 2 }\n"),
             "requires the key wheel"},
        Case{kBareRobot + part("name = \"left\"\ntype = \"motor\"\npins = { in1 = 2 }\n"),
             "exactly these pins"},
        Case{kBareRobot + part("name = \"x\"\ntype = \"voltage\"\npin = \"A0\"\n"), "either volts or share"},
        Case{"base = \"uno9\"\n",
             "there is no robot “uno9”; did you mean uno2? There are bluepill2, bluepill3, bluepill5, "
             "bluepony, digispark2, "
             "leonardo5, mega5, "
             "nano8rc, "
             "pony, rover5, uno2, uno3 and uno5"},
        Case{"base = \"./none.toml\"\n", "base: no such file ./none.toml"},
        Case{"base = \"/dev/zero\"\n", "base: no such file /dev/zero"},
        Case{changed("outline = { radius = \"60 mm\" }",
                     "outline = [[\"0 mm\", \"50 mm\"], [\"29 mm\", \"-40 mm\"], [\"-47 mm\", \"15 mm\"], "
                     "[\"47 mm\", \"15 mm\"], [\"-29 mm\", \"-40 mm\"]]"),
             "outline: expected a convex outline"},
        Case{"base = \"uno5\"\nremove = [\"horn\"]\n", "remove: unknown part of the base: expected left"},
        Case{"remove = [\"horn\"]\n" + kBareRobot, "remove requires the key base"},
        Case{"base = \"uno5\"\nbroad = \"uno\"\n", "unknown key broad"},
        Case{"board = \n", "not valid TOML"}),
    test::numbered(&Case::message));

TEST(Description, TwoPartsOnOnePinAreRefusedNamingBoth) {
  const std::string message = message_of(kBareRobot + part("name = \"x\"\ntype = \"led\"\npin = 13\n") +
                                         part("name = \"y\"\ntype = \"buzzer\"\npin = \"D13\"\n"));
  EXPECT_THAT(message, HasSubstr("robot.toml:23:7: pin 13 is already used by pin of x (robot.toml:19)"));
}

TEST(Description, ALineThatIsInheritedIsNamedWithTheFileThatExtendsIt) {
  const std::string uno5 = find_robot("uno5").string();
  EXPECT_THAT(message_of("base = \"uno5\"\n" + part("name = \"x\"\ntype = \"led\"\npin = 5\n")),
              AllOf(HasSubstr("robot.toml:5"), HasSubstr("already used by en of left (" + uno5 + ":"),
                    HasSubstr(", which robot.toml:1 extends)")));
  EXPECT_THAT(
      message_of("base = \"uno5\"\nboard = \"gemma\"\n"),
      AllOf(HasSubstr(uno5 + ":"), HasSubstr("board gemma"), HasSubstr("(robot.toml:1 extends this file)")));
}

TEST(Description, ItsFullTextIsOneFileThatMeansTheSame) {
  for (const std::string& name : stock_robots()) {
    const std::string text = full_text(name);
    const Description one = parse_description(text, "one.toml"), robot = load_description(name);
    ASSERT_EQ(one.parts.size(), robot.parts.size()) << name;
    EXPECT_EQ(one.chassis.mass.value, robot.chassis.mass.value) << name;
    for (std::size_t i = 0; i < robot.parts.size(); ++i) EXPECT_EQ(one.parts[i]->name, robot.parts[i]->name);
    EXPECT_EQ(to_toml(parse_toml(text, "one.toml"), "one.toml"),
              to_toml(parse_toml(to_toml(parse_toml(text, "a"), "a"), "a"), "a"))
        << name;
    EXPECT_EQ(text.find("\nbase"), std::string::npos) << name;
  }
  EXPECT_THAT(full_text("mega5"), ContainsRegex("\nmass = .* # uno5.toml:[0-9]+\n"));
}

TEST(Description, TwoPartsOfOneNameAreRefused) {
  EXPECT_THAT(message_of(kBareRobot + part("name = \"x\"\ntype = \"led\"\npin = 13\n") +
                         part("name = \"x\"\ntype = \"buzzer\"\npin = 12\n")),
              HasSubstr("duplicate name x"));
}

TEST(Description, TwoMotorsOnOneWheelAreRefused) {
  EXPECT_THAT(
      message_of(kBareRobot + part("name = \"left\"\ntype = \"motor\"\npins = { in1 = 2, in2 = 3 }\n") +
                 part("name = \"b\"\ntype = \"motor\"\nwheel = \"left\"\npins = { in1 = 4, in2 = 5 }\n")),
      HasSubstr("motors left and b drive the same wheel"));
}

TEST(Description, PinsHaveTheNamesPeopleUse) {
  const Description robot =
      parse_description(kBareRobot + part("name = \"a\"\ntype = \"led\"\npin = \"D5\"\n") +
                            part("name = \"b\"\ntype = \"led\"\npin = \"A0\"\n") +
                            part("name = \"c\"\ntype = \"led\"\npin = 15\n"),
                        "robot.toml");
  EXPECT_EQ(robot.parts[0]->wires[0].pin, 5);
  EXPECT_EQ(robot.parts[1]->wires[0].pin, 14);
  EXPECT_EQ(robot.parts[2]->wires[0].pin, 15);
}

TEST(Description, ABudgetIsWhatFirmwareMayTakeOfTheChip) {
  EXPECT_EQ(parse_description(kBareRobot, "r.toml").budget.flash_bytes, 0);
  const Description robot = parse_description(kBareRobot + "[budget]\nflash = 28000\nram = 1500\n", "r.toml");
  EXPECT_EQ(robot.budget.flash_bytes, 28000);
  EXPECT_EQ(describe(robot).budget.ram_bytes, 1500);
  EXPECT_THAT(message_of(kBareRobot + "[budget]\nflash = 31000\n"),
              HasSubstr("flash: expected a whole number from 1 to 30720, got 31000"));
  EXPECT_THAT(message_of(kBareRobot + "[budget]\nram = 0\n"),
              HasSubstr("ram: expected a whole number from 1 to 2048, got 0"));
  EXPECT_THAT(message_of(kBareRobot + "[budget]\nheap = 300\n"), HasSubstr("unknown key heap"));
  const Description run =
      parse_description(kBareRobot + "[budget]\nstack = 300\nloop = \"20 ms\"\n", "r.toml");
  EXPECT_EQ(run.budget.stack_bytes, 300);
  EXPECT_DOUBLE_EQ(run.budget.loop_s, 0.02);
}

TEST(Description, ABaseIsInheritedAndItsPartsAreOverriddenByName) {
  const Description base = load_description("uno5");
  const Description robot = parse_description(R"(
base = "uno5"
remove = ["buzzer"]
[chassis]
mass = "400 g"
[[part]]
name = "left"
reversed = true
[[part]]
name = "extra"
type = "led"
pin = 11
)",
                                              "mine.toml");
  EXPECT_EQ(robot.name, "mine");
  EXPECT_DOUBLE_EQ(robot.chassis.mass.value, 0.4);
  EXPECT_EQ(robot.chassis.track.value, base.chassis.track.value);
  EXPECT_EQ(robot.motors.no_load.value, base.motors.no_load.value);
  ASSERT_EQ(robot.parts.size(), base.parts.size());
  EXPECT_EQ(robot.parts[0]->name, "left");
  EXPECT_EQ(robot.parts[0]->wires.size(), base.parts[0]->wires.size());
  EXPECT_EQ(robot.parts.back()->name, "extra");
  EXPECT_NE(robot.sha256, base.sha256);
}

TEST(Description, OfABaseNothingButTheBodyMayBeWanted) {
  const Description robot = parse_description(
      "base = \"uno5\"\nremove = \"all\"\n[[part]]\nname = \"left\"\ntype = \"led\"\npin = 11\n",
      "mine.toml");
  ASSERT_EQ(robot.parts.size(), 1u);
  EXPECT_EQ(robot.parts[0]->type, "led");
  EXPECT_EQ(robot.chassis.track.value, load_description("uno5").chassis.track.value);
  EXPECT_THAT(message_of("base = \"uno5\"\nremove = \"most\"\n"), HasSubstr("or \"all\""));
}

TEST(Description, OfABaseWithoutItsPartsTheStandbyIsNotWiredEither) {
  const std::string uses_its_pin =
      "base = \"nano8rc\"\nremove = \"all\"\n[[part]]\nname = \"led\"\ntype = \"led\"\npin = 3\n";
  const Description robot = parse_description(uses_its_pin, "mine.toml");
  EXPECT_EQ(robot.driver.standby, kNoPin);
  EXPECT_STREQ(robot.driver.chip->name, load_description("nano8rc").driver.chip->name);
  EXPECT_EQ(parse_description(uses_its_pin + "[driver]\nstandby = 4\n", "mine.toml").driver.standby, 4);
}

TEST(Description, APartOfAnotherTypeReplacesTheBasesPart) {
  const Description robot = parse_description(
      "base = \"uno5\"\n[[part]]\nname = \"buzzer\"\ntype = \"led\"\npin = 11\nactive = \"low\"\n",
      "mine.toml");
  const auto found =
      std::find_if(robot.parts.begin(), robot.parts.end(), [](const auto& p) { return p->name == "buzzer"; });
  ASSERT_NE(found, robot.parts.end());
  EXPECT_EQ((*found)->type, "led");
}

TEST(Description, ErrorsInABaseNameTheBasesFile) {
  const test::TemporaryFolder own;
  const std::filesystem::path& folder = own.path();
  write_file(folder / "below.toml", kBareRobot + "[[part]]\nname = \"x\"\ntype = \"led\"\npin = 77\n");
  write_file(folder / "self.toml", "base = \"./self.toml\"\n");
  try {
    parse_description("base = \"./below.toml\"\n", folder / "top.toml");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place().file, (folder / "./below.toml").string());
    EXPECT_EQ(error.place().line, 19);
  }
  try {
    load_description((folder / "self.toml").string());
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("its own base"));
  }
}

TEST(Description, HashCoversTheBase) {
  const Description robot = parse_description("base = \"uno5\"\n", "mine.toml");
  EXPECT_EQ(robot.sha256, sha256("base = \"uno5\"\n" + read_file(find_robot("uno5"))));
  EXPECT_EQ(load_description("uno5").sha256, sha256(read_file(find_robot("uno5"))));
}

class AnotherBoard : public ::testing::Test {
 protected:
  std::string file(const std::string& text) const {
    write_file(folder_.path() / "mine.toml", text);
    return (folder_.path() / "mine.toml").string();
  }
  static std::string refusal(const std::string& robot) {
    try {
      load_description(robot);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  static const ReflectanceSpec& sensors_of(const Description& robot) {
    for (const auto& part : robot.parts)
      if (const auto* spec = dynamic_cast<const ReflectanceSpec*>(part.get())) return *spec;
    throw std::logic_error("no sensors");
  }

  const test::TemporaryFolder folder_;
};

TEST_F(AnotherBoard, TakesThePlaceOfTheFilesOwn) {
  const std::string mine = file("base = \"uno5\"\n[budget]\nflash = 20000\n");
  const Description own = load_description(mine);
  const Description robot = load_description(mine + "@bluepill");
  EXPECT_EQ(own.board, find_board("uno"));
  EXPECT_EQ(robot.board, find_board("bluepill"));
  EXPECT_EQ(robot.name, "mine@bluepill");
  EXPECT_NE(robot.sha256, own.sha256);
  EXPECT_EQ(own.budget.flash_bytes, 20000);
  EXPECT_EQ(robot.budget.flash_bytes, 0) << "the budget holds for one chip only";
  ASSERT_EQ(robot.parts.size(), own.parts.size());
  for (std::size_t i = 0; i < own.parts.size(); ++i)
    for (std::size_t k = 0; k < own.parts[i]->wires.size(); ++k)
      EXPECT_EQ(robot.parts[i]->wires[k].pin, own.parts[i]->wires[k].pin) << own.parts[i]->name;
}

TEST_F(AnotherBoard, BringsItsSupplyToTheSensors) {
  const auto first = [](const char* robot) { return sensors_of(load_description(robot)).elements.front(); };
  const ReflectanceSpec::Element own = first("uno5"), sensors = first("uno5@bluepill"),
                                 stock = first("bluepill5"), back = first("bluepill5@uno");
  EXPECT_DOUBLE_EQ(sensors.white.value, own.white.value / 5.0 * 3.3);
  EXPECT_DOUBLE_EQ(sensors.black.spread, own.black.spread / 5.0 * 3.3);
  EXPECT_DOUBLE_EQ(sensors.white.value, stock.white.value) << "bluepill5 is this robot";
  EXPECT_DOUBLE_EQ(sensors.white.spread, stock.white.spread);
  EXPECT_DOUBLE_EQ(sensors.black.value, stock.black.value);
  EXPECT_DOUBLE_EQ(back.black.value, own.black.value);
}

TEST_F(AnotherBoard, OfTheSameNameChangesNothing) {
  EXPECT_EQ(load_description("uno5@uno").sha256, load_description("uno5").sha256);
  EXPECT_EQ(load_description("uno5@uno").name, "uno5");
}

TEST_F(AnotherBoard, ThatLacksAPinIsRefusedWithThePinsPlace) {
  const std::string led = "base = \"bluepill5\"\n[[part]]\nname = \"x\"\ntype = \"led\"\npin = ";
  const std::string mine = file(led + "\"PB10\"\n");
  EXPECT_NO_THROW(load_description(mine));
  EXPECT_THAT(refusal(mine + "@uno"),
              AllOf(HasSubstr("mine.toml:5"), HasSubstr("pin: expected a pin of board uno")));
  const std::string eye = file(
      "base = \"bluepill2\"\n[[part]]\nname = \"x\"\ntype = \"voltage\"\n"
      "volts = \"1 V\"\npin = \"A7\"\n");
  EXPECT_THAT(refusal(eye + "@uno"), HasSubstr("expected a pin of board uno"));
}

TEST_F(AnotherBoard, ThatThereIsNoneOfIsRefusedWithThoseThereAre) {
  EXPECT_THAT(
      refusal("uno5@due"),
      HasSubstr(
          "uno5@due: unknown board: expected uno, nano, "
          "nano168, promini16, promini8, mega, leonardo, micro, digispark, gemma, attiny85, bluepill or "
          "bluepill8"));
}

TEST_F(AnotherBoard, WiresStayOnThePinsOfTheSameName) {
  const auto pin_of_s1 = [](const char* name) {
    for (const PartSummary& part : describe(load_description(name)).parts)
      if (part.name == "S") return part.pins.at(0).second;
    return kNoPin;
  };
  EXPECT_EQ(pin_of_s1("uno5"), 14) << "A0";
  EXPECT_EQ(pin_of_s1("uno5@mega"), 54) << "A0";
}

TEST(StockRobots, AllLoad) {
  EXPECT_THAT(stock_robots(), ::testing::ElementsAre("bluepill2", "bluepill3", "bluepill5", "bluepony",
                                                     "digispark2", "leonardo5", "mega5", "nano8rc", "pony",
                                                     "rover5", "uno2", "uno3", "uno5"));
  for (const std::string& name : stock_robots()) EXPECT_NO_THROW(load_description(name)) << name;
}

TEST(StockRobots, FitACircleOf120MillimetresAboutTheAxle) {
  for (const std::string& name : stock_robots())
    for (const Vec2 corner : describe(load_description(name)).outline)
      EXPECT_LT(length(corner), 0.120) << name;
}

TEST(StockRobots, UnosShareOnePinPlan) {
  // By the pin plan of docs/reference/robots.md, motors and buttons have the same pins on all these robots.
  for (const char* name : {"uno2", "uno3", "uno5", "nano8rc", "bluepill2", "bluepill3", "bluepill5"}) {
    const Summary robot = describe(load_description(name));
    const auto pin = [&](const std::string& part_name, const std::string& role) -> int {
      for (const PartSummary& p : robot.parts)
        for (const auto& [r, number] : p.pins)
          if (p.name == part_name && r == role) return number;
      return -1;
    };
    EXPECT_EQ(pin("left", "en"), 5) << name;
    EXPECT_EQ(pin("left", "in1"), 7) << name;
    EXPECT_EQ(pin("left", "in2"), 8) << name;
    EXPECT_EQ(pin("right", "en"), 6) << name;
    EXPECT_EQ(pin("right", "in1"), 9) << name;
    EXPECT_EQ(pin("right", "in2"), 10) << name;
    EXPECT_EQ(pin("start", "pin"), 4) << name;
    EXPECT_EQ(pin("LED", "pin"), 13) << name;
  }
}

TEST(StockRobots, Uno5ReachesSixtyCentimetresPerSecondWithEverySeed) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    BenchRobot bench(load_description("uno5"), Profile::typical, seed);
    for (const Pin pin : {5, 7, 6, 9}) bench.board.output(pin, true, 0);
    bench.ticks(300);
    EXPECT_GT(bench.body().speed(), 0.9) << seed;
  }
}

TEST(StockRobots, OuterSensorsOfUno3AreOffACentredLineButNearIt) {
  for (const SensorPlace& sensor : describe(load_description("uno3")).sensors) {
    if (sensor.name == "middle_sensor") continue;
    EXPECT_GT(std::abs(sensor.at.y), 0.0125) << "the 5 mm footprint is off the 20 mm line";
    EXPECT_LT(std::abs(sensor.at.y), 0.025) << "otherwise the line could hide between two sensors";
  }
}

TEST(BodyParams, AreTheFilesInTheIdealProfile) {
  const Description robot = load_description("uno5");
  const world::BodyParams one = body_params(robot, 1, Profile::ideal);
  EXPECT_EQ(one.mass_kg, robot.chassis.mass.value);
  EXPECT_EQ(one.wheel[0].no_load_rate, one.wheel[1].no_load_rate);
  EXPECT_EQ(one.supply_volts, 7.4);
}

TEST(BodyParams, AFigureMayBeAnotherFromTypical2On) {
  std::string text = kBareRobot;
  const std::string torque = "stall_torque = \"15 oz in\"";
  text.replace(
      text.find(torque), torque.size(),
      "stall_torque = { value = \"0.1 N m\", \"typical@2\" = { value = \"0.07 N m\", spread = \"10 %\" } }");
  const Description robot = parse_description(text, "r.toml");
  const auto torque_in = [&](Profile profile, std::uint64_t seed) {
    return body_params(robot, seed, profile).wheel[0].stall_torque;
  };
  EXPECT_EQ(torque_in(Profile::ideal, 1), 0.1);
  EXPECT_EQ(torque_in(Profile::typical_1, 1), 0.1);
  EXPECT_NEAR(torque_in(Profile::typical_2, 1), 0.07, 0.007);
  EXPECT_NE(torque_in(Profile::typical_2, 1), torque_in(Profile::typical_2, 2));
}

TEST(BodyParams, DifferInsideTheSpreadInTheTypicalProfile) {
  const Description robot = load_description("uno5");
  double least = 1e9, most = 0.0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const world::BodyParams params = body_params(robot, seed, Profile::typical);
    EXPECT_EQ(params.mass_kg, body_params(robot, seed, Profile::typical).mass_kg);
    EXPECT_NE(params.wheel[0].no_load_rate, params.wheel[1].no_load_rate);
    least = std::min(least, params.mass_kg);
    most = std::max(most, params.mass_kg);
  }
  EXPECT_THAT(least, ::testing::AllOf(::testing::Ge(0.28 * 0.97), ::testing::Lt(0.28 * 0.975)));
  EXPECT_THAT(most, ::testing::AllOf(::testing::Le(0.28 * 1.03), ::testing::Gt(0.28 * 1.025)));
}

TEST(BodyParams, AMissingInertiaIsThatOfAPlate) {
  const world::BodyParams disc = body_params(parse_description(kBareRobot, "r.toml"), 1, Profile::ideal);
  EXPECT_NEAR(disc.yaw_inertia_kgm2, 0.5 * 0.3 * 0.06 * 0.06, 1e-12);
  const world::BodyParams square = body_params(
      parse_description(changed("{ radius = \"60 mm\" }",
                                "[[\"50 mm\", \"50 mm\"], [\"50 mm\", \"-50 mm\"], [\"-50 mm\", \"-50 mm\"], "
                                "[\"-50 mm\", \"50 mm\"]]"),
                        "r.toml"),
      1, Profile::ideal);
  EXPECT_NEAR(square.yaw_inertia_kgm2, 0.3 * (0.1 * 0.1 + 0.1 * 0.1) / 12.0, 1e-12);
}

TEST(Describe, SaysWhatClientsNeed) {
  const Summary robot = describe(load_description("uno5"));
  EXPECT_EQ(robot.name, "uno5");
  EXPECT_STREQ(robot.board->fqbn, "arduino:avr:uno");
  ASSERT_EQ(robot.sensors.size(), 5u);
  EXPECT_EQ(robot.sensors[0].name, "S1");
  EXPECT_NEAR(robot.sensors[0].at.y, 0.01905, 1e-12);
  EXPECT_EQ(robot.parts[0].type, "motor");
  EXPECT_EQ(robot.parts[0].pins[0], (std::pair<std::string, Pin>{"en", Pin{5}}));
}

TEST(Robot, TellsItsWiringAndSensorMidpoint) {
  BenchRobot bench(load_description("nano8rc"));
  EXPECT_NEAR(bench.robot.sensor_midpoint().x, 0.055, 1e-12);
  EXPECT_NEAR(bench.robot.sensor_midpoint().y, 0.0, 1e-12);
  const auto wiring = bench.robot.wiring();
  ASSERT_FALSE(wiring.empty());
  EXPECT_EQ(wiring[0].part, "driver");
  EXPECT_EQ(wiring[0].role, "standby");
  EXPECT_EQ(wiring[0].pin, 3);
}

}  // namespace description_test
}  // namespace robosim::robot
