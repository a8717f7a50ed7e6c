// A PID controller: computes how hard to steer against an error.
//
//   output = kp * e  +  ki * integral of e dt  +  kd * de/dt,   limited to [lowest, highest]
//
//   kp   reacts to the present error. If kp is too large, the robot oscillates.
//   kd   reacts to how fast the error changes, and damps the oscillation.
//   ki   removes a lasting error, for example if one motor is weaker than the other. Line followers
//        need little or none.
//
// Units: any for error and output; time in seconds. For an error in sensor pitches and an output in PWM
// steps: kp is PWM steps per pitch; ki PWM steps per (pitch x second); kd PWM steps per (pitch / second).
//
// Two details that a textbook formula omits and a robot needs:
// - Wind-up. While the output is at its limit, the integral must not grow further in that direction.
//   Otherwise the robot turns long after the error is gone. Steps that would let the integral grow further
//   leave it unchanged (conditional integration).
// - The first call has no previous error, so it has no derivative. Call reset() whenever control starts
//   again.
//
// Example: steer by the line's position every 5 ms.
//
//   PidController pid(60, 0, 4);
//   void setup() { pid.setLimits(-150, 150); }
//   void loop() {
//     sensors.read();
//     float turn = pid.update(sensors.position() / 1000.0, 0.005);
//     motors.drive(180 + turn, 180 - turn);
//     delay(5);
//   }
#ifndef LINEKIT_PID_CONTROLLER_H
#define LINEKIT_PID_CONTROLLER_H

class PidController {
 public:
  PidController(float kp, float ki, float kd) : kp_(kp), ki_(ki), kd_(kd) {}

  void setGains(float kp, float ki, float kd);
  /// Sets the bounds of the output. By default the output has no bounds. Swapped bounds are corrected.
  void setLimits(float lowest, float highest);
  /// Smooths the derivative over about `seconds`, against noisy sensors; 0 (the default) = no smoothing.
  void setDerivativeSmoothing(float seconds) { smoothing_ = seconds > 0 ? seconds : 0; }

  /// Returns the output after one step. `dt` is the time since the last call, in seconds. If it is 0 or less,
  /// integral and derivative do not change.
  float update(float error, float dt);

  /// Clears the integral and the derivative, as if update() had never been called.
  void reset();

  float integral() const { return integral_; }  ///< error * seconds

 private:
  float limited(float output) const;

  float kp_, ki_, kd_;
  float lowest_ = -3.4e38f, highest_ = 3.4e38f;
  float smoothing_ = 0;
  float integral_ = 0;
  float last_error_ = 0;
  float slope_ = 0;
  bool started_ = false;
};

#endif
