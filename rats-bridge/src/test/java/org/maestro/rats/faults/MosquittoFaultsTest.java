package org.maestro.rats.faults;

import org.maestro.rats.broker.RunsProgram;
import org.maestro.rats.broker.TestBroker;

/** The program mosquitto. */
@RunsProgram("mosquitto")
class MosquittoFaultsTest extends BrokerFaultsContract {

  @Override
  TestBroker broker() {
    return TestBroker.mosquitto();
  }
}
