// Decodes a kit's infrared remote control (NEC) by an interrupt on pin 2. Keys: CH- CH CH+ / |<< >>| >|| ...
#define IR_PIN 2
#define KEY_PLAY  0x43
#define KEY_MINUS 0x07
#define KEY_PLUS  0x15
#define KEY_EQ    0x09

volatile uint32_t frame;
volatile byte bits;
volatile bool ready = false, again = false;
volatile unsigned long lastFall;

void onFall() {
  unsigned long now = micros();
  unsigned long gap = now - lastFall;
  lastFall = now;
  if (gap > 12500 && gap < 14500) {        // start: 9 ms + 4.5 ms
    bits = 0;
    frame = 0;
  } else if (gap > 10500 && gap < 12500) { // repeat: 9 ms + 2.25 ms
    again = true;
  } else if (gap > 900 && gap < 1400) {    // 0
    frame >>= 1;
    bits++;
  } else if (gap > 1900 && gap < 2600) {   // 1
    frame = (frame >> 1) | 0x80000000UL;
    bits++;
  }
  if (bits == 32) {
    ready = true;
    bits = 33;
  }
}

bool following = false;
int speed = 120;

void setup() {
  Serial.begin(115200);
  pinMode(IR_PIN, INPUT);
  attachInterrupt(0, onFall, FALLING);
  pinMode(9, OUTPUT); pinMode(10, OUTPUT); pinMode(11, OUTPUT); pinMode(12, OUTPUT);
  pinMode(5, OUTPUT); pinMode(6, OUTPUT);
}

void handle(byte key) {
  switch (key) {
    case KEY_PLAY:
      following = !following;
      Serial.println(following ? "go" : "stop");
      break;
    case KEY_PLUS:
    case KEY_MINUS:
      speed = constrain(speed + (key == KEY_PLUS ? 10 : -10), 70, 250);
      Serial.print("speed ");
      Serial.println(speed);
      break;
    case KEY_EQ:
      Serial.println("there is no EQ on a robot");
      break;
    default:
      Serial.print("key 0x");
      Serial.println(key, HEX);
  }
}

void loop() {
  static byte lastKey = 0;
  if (ready) {
    noInterrupts();
    uint32_t f = frame;
    ready = false;
    interrupts();
    byte key = f >> 16, check = f >> 24;
    if ((byte)~key == check) {
      lastKey = key;
      handle(key);
    } else {
      Serial.println("garbled");
    }
  }
  if (again) {
    again = false;
    if (lastKey == KEY_PLUS || lastKey == KEY_MINUS) handle(lastKey);
  }

  int l = 0, r = 0;
  if (following) {
    bool left = digitalRead(A0), right = digitalRead(A2);
    l = left && !right ? 0 : speed;
    r = right && !left ? 0 : speed;
  }
  digitalWrite(9, l > 0);  digitalWrite(10, LOW); analogWrite(5, l);
  digitalWrite(11, r > 0); digitalWrite(12, LOW); analogWrite(6, r);
}
