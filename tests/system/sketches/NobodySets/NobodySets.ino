// Waits for a flag that no interrupt sets, with Serial's interrupts on.
volatile bool flag = false;

void setup() {
  Serial.begin(9600);
  while (!flag);
}

void loop() {}
