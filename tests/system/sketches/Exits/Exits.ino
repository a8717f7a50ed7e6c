// Ends its own process by exit().
void setup() { exit(3); }

void loop() {}
