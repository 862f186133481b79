package org.maestro.rats.security;

import java.nio.file.Path;
import org.maestro.rats.broker.RunsProgram;
import org.maestro.rats.broker.TestBroker;

/** The insider on the embedded Artemis. */
@RunsProgram(value = "python3", pythonModule = "paho.mqtt.enums")
class InsiderOnArtemisTest extends InsiderContract {

  @Override
  TestBroker broker(Path files) {
    return TestBroker.embeddedSecured(files);
  }
}
