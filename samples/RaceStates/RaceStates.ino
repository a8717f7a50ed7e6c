// A state machine for a school's line race: WAIT -> COUNTDOWN -> FOLLOW <-> SEARCH -> FINISHED
// The robot has three sensors. The finish is a black bar that all three see at the same time.

enum class State : uint8_t { Wait, Countdown, Follow, Search, Finished };

struct Motors {
  uint8_t enable, forward, backward;
  void begin() const {
    pinMode(enable, OUTPUT);
    pinMode(forward, OUTPUT);
    pinMode(backward, OUTPUT);
  }
  void set(int speed) const {
    digitalWrite(forward, speed > 0 ? HIGH : LOW);
    digitalWrite(backward, speed < 0 ? HIGH : LOW);
    analogWrite(enable, constrain(abs(speed), 0, 255));
  }
};

const Motors leftMotor = {3, 4, 2};
const Motors rightMotor = {11, 12, 13};
const uint8_t LEFT = A3, MIDDLE = A4, RIGHT = A5, BUTTON = 7, LED = 10;

State state = State::Wait;
unsigned long entered;
int8_t lastSide = 0;

const char* name(State s) {
  switch (s) {
    case State::Wait: return "WAIT";
    case State::Countdown: return "COUNTDOWN";
    case State::Follow: return "FOLLOW";
    case State::Search: return "SEARCH";
    case State::Finished: return "FINISHED";
  }
  return "?";
}

void go(State next) {
  Serial.print(millis());
  Serial.print(F(" ms: "));
  Serial.print(name(state));
  Serial.print(F(" -> "));
  Serial.println(name(next));
  state = next;
  entered = millis();
}

void drive(int l, int r) {
  leftMotor.set(l);
  rightMotor.set(r);
}

void setup() {
  leftMotor.begin();
  rightMotor.begin();
  pinMode(BUTTON, INPUT);
  pinMode(LED, OUTPUT);
  Serial.begin(57600);
}

void loop() {
  // the modules pull their output LOW over the line
  bool l = !digitalRead(LEFT), m = !digitalRead(MIDDLE), r = !digitalRead(RIGHT);
  unsigned long age = millis() - entered;

  switch (state) {
    case State::Wait:
      drive(0, 0);
      if (digitalRead(BUTTON)) go(State::Countdown);
      break;

    case State::Countdown:
      digitalWrite(LED, (age / 250) % 2);
      if (age > 2000) {
        digitalWrite(LED, HIGH);
        go(State::Follow);
      }
      break;

    case State::Follow:
      if (l && m && r && age > 1000) {
        go(State::Finished);
      } else if (!l && !m && !r) {
        go(State::Search);
      } else if (l && !r) {
        lastSide = -1;
        drive(m ? 60 : -70, 150);
      } else if (r && !l) {
        lastSide = 1;
        drive(150, m ? 60 : -70);
      } else {
        drive(140, 140);
      }
      break;

    case State::Search:
      if (l || m || r) go(State::Follow);
      else if (age < 800) drive(lastSide < 0 ? -110 : 140, lastSide < 0 ? 140 : -110);
      else drive(110, -110);
      break;

    case State::Finished:
      drive(0, 0);
      digitalWrite(LED, LOW);
      break;
  }
}
