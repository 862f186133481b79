package org.maestro.rats.transport;

import org.maestro.rats.broker.RunsProgram;
import org.maestro.rats.broker.TestBroker;

@RunsProgram("mosquitto")
class MosquittoTransportTest extends PahoTransportContract {

  @Override
  TestBroker broker() {
    return TestBroker.mosquitto();
  }
}
