// Writes a little past what it asked for, over and over, and lives on its own ruins.
void setup() {
  for (int i = 0; i < 50; i++) {
    char* text = (char*)malloc(16);
    if (text) memset(text, 'x', 64);
  }
}

void loop() { delay(10); }
