// Includes all of LineKit: the parts of a line follower, one header each.
//
//   LineSensors.h      where is the line?         analog, digital and RC sensors
//   DriveMotors.h      two wheels                 L298N, TB6612, drivers with PWM on their IN pins
//   PidController.h    how much to steer          output limits, no wind-up
//   PushButton.h       start and stop             debounced, never waits
//   PathFollower.h     lines with junctions       three digital sensors, left or right branch first
//   WheelEncoders.h    distance of each wheel     one channel per wheel, by interrupts
//   LineWalker.h       from landmark to landmark  five analog sensors and encoders; for nav/
//   ShiftRegisters.h   more outputs               a chain of 74HC595
//   ClockedReceiver.h  messages by radio          clock, data and enable, by interrupts
//
// The code for networks of lines uses neither pins nor Arduino.h. Include its headers by name:
//
//   nav/Explorer.h      scans a network           nav/Landmark.h lists what a robot must be able to do
//   nav/FixedNetwork.h  stores it on a chip       200 nodes in 1 KB of RAM; can be saved to EEPROM
//   nav/FixedTree.h     stores a tree             200 nodes in 436 bytes
//   nav/Navigator.h     drives to any node        plans around obstacles, with nav/NextPlanners.h
//   nav/Plan.h          seven planners            from breadth-first search to Dijkstra's algorithm
//
// No function waits, with two exceptions. LineWalker's functions return only after the robot has arrived.
// Reading sensors takes a few hundred microseconds (analog) or up to 2.5 ms (RC). No function allocates
// memory.
#ifndef LINEKIT_H
#define LINEKIT_H

#include "ClockedReceiver.h"
#include "DriveMotors.h"
#include "LineSensors.h"
#include "LineWalker.h"
#include "PathFollower.h"
#include "PidController.h"
#include "PushButton.h"
#include "ShiftRegisters.h"
#include "WheelEncoders.h"

#endif
