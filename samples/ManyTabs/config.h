#ifndef CONFIG_H
#define CONFIG_H

#define BAUD 38400
#define SENSORS 3

enum Mode { MODE_STOP, MODE_SLOW, MODE_FAST };

struct Reading {
  byte black;        // number of sensors over the line
  float position;    // -1 left ... 1 right
  float lastSeen;
};

const byte SENSOR_PINS[SENSORS] = {14, 15, 16};
const byte EN_L = 5, EN_R = 6;
const byte MOTOR_PINS[4] = {7, 8, 9, 10};

#endif
