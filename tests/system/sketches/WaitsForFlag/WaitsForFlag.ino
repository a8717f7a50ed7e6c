// Busy-waits for a volatile flag that the interrupt of a start button on pin 3 sets. Then prints a line.
volatile bool flag = false;

void onPress() { flag = true; }

void setup() {
  Serial.begin(9600);
  pinMode(3, INPUT_PULLUP);
  attachInterrupt(digitalPinToInterrupt(3), onPress, FALLING);
  while (!flag);
  Serial.println("went on");
}

void loop() { delay(10); }
