3.1
A title
void setup() {
  SET_V_MAX ALL 200
}
void loop() {
  SLEEP 100
}
END
