// Follows a black line with five sensors: the further the line is from the middle, the harder the robot
// steers. The pins are those of the robot uno5: `robosim robot show uno5`.

const int SENSORS[] = {A0, A1, A2, A3, A4};                          // left to right
const int LEFT_SPEED = 5, LEFT_FORWARD = 7, LEFT_BACKWARD = 8;       // the motor driver's pins
const int RIGHT_SPEED = 6, RIGHT_FORWARD = 9, RIGHT_BACKWARD = 10;

const int FLOOR = 110;     // analogRead() over the floor
const int LINE = 880;      // analogRead() over the line
const int BASE_SPEED = 110; // of 255; for both wheels while the line is in the middle
const float STEERING = 70; // change of speed if the line is off by one sensor

float off = 0;             // position of the line: -2 under the left sensor .. 2 under the right one

// Measures the position of the line. If no sensor sees the line, `off` keeps its last value.
void look() {
  long weight = 0, sum = 0;
  for (int i = 0; i < 5; i++) {
    int black = constrain(map(analogRead(SENSORS[i]), FLOOR, LINE, 0, 100), 0, 100);
    if (black < 10) black = 0;  // noise
    weight += black;
    sum += (long)black * (i - 2);
  }
  if (weight > 30) off = (float)sum / weight;
}

void turn_wheel(int speed_pin, int forward_pin, int backward_pin, int speed) {
  digitalWrite(forward_pin, speed > 0);
  digitalWrite(backward_pin, speed < 0);
  analogWrite(speed_pin, constrain(abs(speed), 0, 255));
}

void setup() {
  for (int pin = LEFT_SPEED; pin <= RIGHT_BACKWARD; pin++) pinMode(pin, OUTPUT);
  Serial.begin(9600);
  Serial.println("ready");
}

void loop() {
  look();
  int turn = STEERING * off;
  turn_wheel(LEFT_SPEED, LEFT_FORWARD, LEFT_BACKWARD, BASE_SPEED + turn);
  turn_wheel(RIGHT_SPEED, RIGHT_FORWARD, RIGHT_BACKWARD, BASE_SPEED - turn);
  delay(5);
}
