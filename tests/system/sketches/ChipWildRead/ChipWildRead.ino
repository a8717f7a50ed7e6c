// Reads far beyond the chip's memory through a wrong index.
volatile byte table[4];

byte look(unsigned index) { return table[index]; }

void setup() {
  Serial.begin(115200);
  delay(20);
  volatile unsigned wrong = 40000;
  Serial.println(look(wrong));
}

void loop() {}
