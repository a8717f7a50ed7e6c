// Gives up by itself.
void setup() { exit(3); }

void loop() {}
