package org.maestro.rats.transport;

import org.maestro.rats.broker.TestBroker;

class PahoTransportTest extends PahoTransportContract {

  @Override
  TestBroker broker() {
    return TestBroker.embedded();
  }
}
