package org.maestro.rats.security;

import java.nio.file.Path;
import org.maestro.rats.broker.RunsProgram;
import org.maestro.rats.broker.TestBroker;

/** The insider on the program mosquitto. */
@RunsProgram(
    value = {"python3", "mosquitto"},
    pythonModule = "paho.mqtt.enums")
class InsiderOnMosquittoTest extends InsiderContract {

  @Override
  TestBroker broker(Path files) {
    return TestBroker.mosquittoSecured(files, MosquittoFiles.PASSWORD_PORT);
  }
}
