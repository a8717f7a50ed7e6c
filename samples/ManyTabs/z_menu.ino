void printMenu() {
  Serial.println("0 stop, 1 slow, 2 fast");
}

void menu() {
  if (!Serial.available()) return;
  char c = Serial.read();
  if (c >= '0' && c <= '2') {
    mode = (Mode)(c - '0');
    Serial.print("mode ");
    Serial.println(mode);
  }
}
