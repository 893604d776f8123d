// Firmware for driver.py beside this file: one proportional valve and one pressure sensor per channel, two channels per
// segment (right, left), on a board such as an Arduino Mega. Adapt the pins and the sensors' constants to your build.
//
//   S 0 250 0 0    set points in mbar gauge, one per channel
//   V              vent all
// is answered by
//   P 12345 0 248 0 1    clock in ms, measured pressures in mbar gauge
//
// The watchdog is the last deadman: when the computer is silent for 300 ms, whatever the reason, all channels vent.

const int CHANNELS = 4;                                   // two per segment
const int VALVE_PIN[CHANNELS] = {2, 3, 5, 6};             // PWM of the inlet valve; 0 closes it
const int VENT_PIN[CHANNELS] = {22, 23, 24, 25};          // normally open vent valve: LOW vents, also without power
const int SENSOR_PIN[CHANNELS] = {A0, A1, A2, A3};
const float MBAR_PER_COUNT = 2000.0 / 818.0;              // 0.5 to 4.5 V over 2 bar, 10 bits at 5 V
const float ZERO_COUNT = 102.0;
const float LIMIT_MBAR = 1000.0;                          // nothing above is ever set, whoever asks
const unsigned long SILENCE_MS = 300;
const float GAIN = 0.4;                                   // PWM counts per mbar of error
const float DEAD_BAND_MBAR = 3.0;

float setpoint[CHANNELS];
float measured[CHANNELS];
bool vented = true;
unsigned long last_line_ms = 0;
char line[96];
int length = 0;

void vent() {
  vented = true;
  for (int c = 0; c < CHANNELS; ++c) {
    setpoint[c] = 0;
    analogWrite(VALVE_PIN[c], 0);
    digitalWrite(VENT_PIN[c], LOW);
  }
}

// Proportional control with a dead band; the vent valve opens where the pressure is too high.
void control() {
  for (int c = 0; c < CHANNELS; ++c) {
    measured[c] = (analogRead(SENSOR_PIN[c]) - ZERO_COUNT) * MBAR_PER_COUNT;
    if (vented) continue;
    float error = setpoint[c] - measured[c];
    analogWrite(VALVE_PIN[c], error > DEAD_BAND_MBAR ? min(255, int(GAIN * error) + 40) : 0);
    digitalWrite(VENT_PIN[c], error < -DEAD_BAND_MBAR || setpoint[c] <= 0 ? LOW : HIGH);
  }
}

void answer() {
  Serial.print("P ");
  Serial.print(millis());
  for (int c = 0; c < CHANNELS; ++c) {
    Serial.print(' ');
    Serial.print(measured[c], 1);
  }
  Serial.print('\n');
}

// "S" and exactly CHANNELS numbers within the limit; anything else vents.
bool set_from(char* text) {
  float wanted[CHANNELS];
  for (int c = 0; c < CHANNELS; ++c) {
    char* end;
    wanted[c] = strtod(text, &end);
    if (end == text || !(wanted[c] >= 0 && wanted[c] <= LIMIT_MBAR)) return false;
    text = end;
  }
  for (int c = 0; c < CHANNELS; ++c) setpoint[c] = wanted[c];
  vented = false;
  return true;
}

void take_line() {
  last_line_ms = millis();
  if (!(line[0] == 'S' && set_from(line + 1))) vent();
  answer();
}

void setup() {
  Serial.begin(115200);
  for (int c = 0; c < CHANNELS; ++c) {
    pinMode(VALVE_PIN[c], OUTPUT);
    pinMode(VENT_PIN[c], OUTPUT);
  }
  vent();
}

void loop() {
  control();
  if (!vented && millis() - last_line_ms > SILENCE_MS) vent();
  while (Serial.available()) {
    char c = Serial.read();
    if (c == '\n') {
      line[length] = 0;
      length = 0;
      take_line();
    } else if (length < int(sizeof line) - 1) {
      line[length++] = c;
    } else {
      length = 0;
      vent();
    }
  }
}
