// Logs with String objects. Their heap fits in the RAM of an Uno.
#define LED_PIN LED_BUILTIN
String robotName = "Robi";
String logLine;
String history[4];
int logCount = 0;
unsigned long lastLog = 0;

String toText(int values[], int count) {
  String s = "[";
  for (int i = 0; i < count; i++) {
    s += values[i];
    if (i < count - 1) s += ", ";
  }
  return s + "]";
}

void logIt(const String &what) {
  logCount++;
  logLine = String(millis() / 1000.0, 1) + "s #" + logCount + " " + robotName + ": " + what;
  Serial.println(logLine);
  for (int i = 3; i > 0; i--) history[i] = history[i - 1];
  history[0] = what;
}

void setup() {
  Serial.begin(115200);
  pinMode(LED_PIN, OUTPUT);
  for (int p = 5; p <= 10; p++) pinMode(p, OUTPUT);
  logIt("hello, I am " + robotName + String('!'));
}

void drive(int left, int right) {
  digitalWrite(7, left >= 0);
  digitalWrite(8, left < 0);
  digitalWrite(9, right >= 0);
  digitalWrite(10, right < 0);
  analogWrite(5, min(abs(left), 255));
  analogWrite(6, min(abs(right), 255));
}

void loop() {
  int values[5];
  for (int i = 0; i < 5; i++) values[i] = analogRead(A0 + i);

  int darkest = 0;
  for (int i = 1; i < 5; i++)
    if (values[i] > values[darkest]) darkest = i;
  int turn = (darkest - 2) * 25;
  drive(90 + turn, 90 - turn);

  if (millis() - lastLog >= 250) {
    lastLog = millis();
    logIt(String(values[darkest] > 400 ? "on the line" : "lost it") + " after " + millis() / 1000 + " s");
  }

  if (Serial.available()) {
    String command = Serial.readStringUntil('\n');
    command.trim();
    command.toLowerCase();
    if (command.startsWith("name ")) {
      robotName = command.substring(5);
      robotName.setCharAt(0, toupper(robotName[0]));
      logIt("that is my name now");
    } else if (command == "history") {
      for (int i = 0; i < 4; i++) Serial.println("  " + history[i]);
      int lengths[4];
      for (int i = 0; i < 4; i++) lengths[i] = history[i].length();
      Serial.println(toText(lengths, 4));
    } else if (command.indexOf('?') >= 0) {
      logIt("you have asked: " + command + ", " + command.length() + " letters");
    }
  }
}
