package org.maestro.rats.conformance;

import org.maestro.rats.broker.RunsProgram;
import org.maestro.rats.broker.TestBroker;

@RunsProgram({"cc", "mosquitto"})
class BellOnMosquittoTest extends BellContract {

  @Override
  TestBroker broker() {
    return TestBroker.mosquitto();
  }
}
