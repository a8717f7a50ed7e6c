// Calls a null function pointer: on an AVR the sketch begins again.
typedef void (*Handler)();
Handler volatile handler;

void call() { handler(); }

void setup() {
  Serial.begin(115200);
  Serial.println("begun");
  delay(20);
  call();
}

void loop() {}
