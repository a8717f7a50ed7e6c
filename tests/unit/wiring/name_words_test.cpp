#include "sim/campaign/wiring/name_words.h"

#include <gtest/gtest.h>

namespace robosim::wiring {
namespace name_words_test {

TEST(Sides, AreKnownByTheNamesThatPeopleGive) {
  for (const char* name : {"leftMotor", "MOTOR_LEFT_1", "lmf", "LM1", "L_EN", "ENA", "IN1", "IN2", "AIN1",
                           "PWMA", "motorA", "M1_DIR", "izquierda", "leftmotorpin", "lms"})
    EXPECT_EQ(side_of(words_of(name)), Side::left) << name;
  for (const char* name :
       {"right_motor", "RM2", "rmb", "ENB", "IN3", "IN4", "BIN2", "PWMB", "motor2", "E2", "derecha"})
    EXPECT_EQ(side_of(words_of(name)), Side::right) << name;
  for (const char* name : {"LED", "buzzer", "RX", "line", "reset", "motor", "lcd", "robot", "IN5", "",
                           "brightness", "solenoid", "sagittal", "M10", "order", "link", "gain"})
    EXPECT_EQ(side_of(words_of(name)), Side::unknown) << name;
}

TEST(Sides, AreKnownInTheLanguagesOfPublishedSketches) {
  for (const char* name : {"motorIzquierdo", "sensor_izq", "motorEsquerdo", "MOTOR_ESQ", "moteurGauche",
                           "linksMotor", "sensorSX", "motoreSinistro", "solMotor", "SOL_ILERI", "solileri",
                           "sensorkiri", "motorkif", "motor_baye", "bayenMotor", "MotorLE", "SL", "ML_F"})
    EXPECT_EQ(spelled_side(words_of(name)), Side::left) << name;
  for (const char* name :
       {"motorDerecho", "sensor_der", "motorDireito", "sensorDireita", "moteurDroit", "capteur_droite",
        "rechtsVor", "sensorDX", "motoreDestro", "sagMotor", "SAG_GERI", "sagmotor", "sensorkanan",
        "sensorka", "motor_daye", "dahinaMotor", "MotorRE", "SR", "MR_B"})
    EXPECT_EQ(spelled_side(words_of(name)), Side::right) << name;
}

TEST(Sides, OfLettersAndNumbersAreConventions) {
  for (const char* name : {"ENA", "IN1", "motorB", "M2_DIR", "AIN2", "m21"})
    EXPECT_EQ(spelled_side(words_of(name)), Side::unknown) << name;
  EXPECT_EQ(side_of(words_of("m12")), Side::left) << "the second input of motor 1";
  EXPECT_EQ(side_of(words_of("m21")), Side::right) << "the first input of motor 2";
  EXPECT_EQ(side_of(words_of("IN1_B")), Side::right) << "the first input of motor B";
  EXPECT_EQ(side_of(words_of("motor1DirB")), Side::left) << "the second input of motor 1";
}

TEST(Directions, AreKnownInTheLanguagesOfPublishedSketches) {
  for (const char* name : {"leftForward", "solIleri", "izq_adelante", "esqFrente", "gaucheAvant", "kiriMaju"})
    EXPECT_TRUE(says_forward(words_of(name)) && !says_backward(words_of(name))) << name;
  for (const char* name :
       {"rightBack", "sagGeri", "der_atras", "droiteArriere", "destraIndietro", "kananMundur"})
    EXPECT_TRUE(says_backward(words_of(name)) && !says_forward(words_of(name))) << name;
}

}  // namespace name_words_test
}  // namespace robosim::wiring
