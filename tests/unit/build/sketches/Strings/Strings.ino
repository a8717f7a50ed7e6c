// Uses String for texts, and for commands from the serial port.
String command = "";
String words[3] = {"left", "right", "stop"};

void setup() {
  Serial.begin(9600);
  Serial.setTimeout(20);
  String text = String(3.14159, 3) + ' ' + String(255, HEX) + " " + String(-7);
  text.replace("FF", "ff");
  text.trim();
  text.toUpperCase();
  Serial.println(text);
  Serial.println(text.substring(0, 4).toFloat() * 2);
  Serial.println(text.indexOf('F'));
  Serial.println(String("12").toInt() + 1);
}

void loop() {
  while (Serial.available() > 0) {
    char c = Serial.read();
    if (c == '\n') {
      obey(command);
      command = "";
    } else {
      command += c;
    }
  }
}

void obey(String what) {
  if (what == words[0])
    turn(-1);
  else if (what.equals("right"))
    turn(1);
  else if (what.startsWith("speed "))
    analogWrite(5, what.substring(6).toInt());
}

void turn(int way) {
  Serial.print("turn ");
  Serial.println(way);
}
