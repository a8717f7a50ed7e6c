// Uses functions before they are defined. Their prototypes are hard to generate.
enum Direction { LEFT, STRAIGHT, RIGHT };

struct Reading {
  int left;
  int right;
};

typedef void (*Action)(int);

Reading now;
void (*callback)(int) = &announce;

void setup() {
  Serial.begin(9600);
  turn(LEFT, slow());
  blink();
  blink(3);
  blink(3, "two (2), a=b");
  now = read_all();
  Serial.println(difference(now));
  Serial.println(largest(3, 4));
  perform(announce, 5);
  callback(choose(RIGHT)[0]);
  scale(now);
  Serial.println(total(table(), 3));
}

void loop() { hidden(); }

void turn(Direction direction, int speed) {
  switch (direction) {
    case LEFT:
      Serial.println(-speed);
      break;
    case RIGHT:
      Serial.println(speed);
      break;
    default:
      break;
  }
}

int slow() { return 60; }

void blink(int times = 1, const char *why = "none, (yet)") {
  Serial.print(times);
  Serial.println(why);
}

Reading read_all() {
  Reading reading = {10, 20};
  return reading;
}

int difference(const Reading &reading) { return reading.right - reading.left; }

template <typename T>
T largest(T a, T b) {
  return a > b ? a : b;
}

void perform(Action action, int value) { action(value); }

void announce(int value) { Serial.println(value); }

const int *choose(Direction direction) {
  static const int speeds[] = {1, 2};
  return speeds + (direction == RIGHT);
}

void scale(struct Reading &reading) { reading.left *= 2; }

int total(const int values[], byte count) {
  int sum = 0;
  for (byte i = 0; i < count; i++) sum += values[i];
  return sum;
}

int *table() {
  static int values[3] = {1, 2, 3};
  return values;
}

static void hidden() {}

namespace details {
int inner() { return 1; }
}  // namespace details

extern "C" void plain_c(int) {}

#if 0
void never(Unknown thing) {}
#endif
