// Repeatedly writes slightly beyond its allocated memory, and continues with damaged data.
void setup() {
  for (int i = 0; i < 50; i++) {
    char* text = (char*)malloc(16);
    if (text) memset(text, 'x', 64);
  }
}

void loop() { delay(10); }
