package org.maestro.rats.faults;

import org.maestro.rats.broker.TestBroker;

/** The embedded Artemis. */
class ArtemisFaultsTest extends BrokerFaultsContract {

  @Override
  TestBroker broker() {
    return TestBroker.embedded();
  }
}
