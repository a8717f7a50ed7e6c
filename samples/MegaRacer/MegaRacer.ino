// Mega 2560: sensors on A8 to A12, telemetry on Serial1 (without a listener), motor directions on PORTA.
#define DIRECTIONS PORTA
#define TELEMETRY Serial1
const uint8_t ch[] = {A8, A9, A10, A11, A12};
struct __attribute__((packed)) Packet { uint8_t head; int16_t error; uint16_t ms; } packet = {0x55, 0, 0};
int16_t e, e1;
void setup() {
  DDRA = 0x0F;
  pinMode(44, OUTPUT);
  pinMode(45, OUTPUT);
  TELEMETRY.begin(115200);
  DIRECTIONS = 0b0101;
}
void loop() {
  int32_t s = 0, w = 0;
  for (uint8_t i = 0; i < 5; ++i) {
    int16_t v = analogRead(ch[i]);
    s += v;
    w += (int32_t)v * (i * 256);
  }
  e = w / s - 512;
  int16_t u = e * 3 / 8 + (e - e1) * 2;
  e1 = e;
  analogWrite(44, constrain(110 + u, 0, 255));
  analogWrite(45, constrain(110 - u, 0, 255));
  packet.error = e;
  packet.ms = millis();
  TELEMETRY.write((uint8_t*)&packet, sizeof packet);
  delay(2);
}
