package org.maestro.rats.link;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.maestro.rats.broker.TestBroker;

class PahoLinkTest extends PahoLinkContract {

  private static final TestBroker BROKER = TestBroker.embedded();

  @BeforeAll
  static void startBroker() {
    BROKER.start();
  }

  @AfterAll
  static void stopsWithoutTrace() {
    BROKER.stop();
    assertNoThreadIsLeft();
  }

  @Override
  TestBroker broker() {
    return BROKER;
  }
}
