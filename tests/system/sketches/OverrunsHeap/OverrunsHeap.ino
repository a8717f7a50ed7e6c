// Writes far beyond its allocated memory.
void setup() {
  char* text = (char*)malloc(16);
  for (long i = 0; i < 10000000L; i++) text[i] = 'x';
  Serial.begin(9600);
  Serial.println(text[20]);
}

void loop() { delay(10); }
