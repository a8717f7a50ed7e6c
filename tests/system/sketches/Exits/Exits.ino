// Ends itself.
void setup() { exit(3); }

void loop() {}
