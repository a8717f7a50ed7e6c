// Calls through a function pointer that was never set, but is not null.
typedef void (*Handler)();

void call(Handler handler) { handler(); }

void setup() {
  delay(20);
  volatile unsigned where = 0x3A00;
  call((Handler)where);
}

void loop() {}
