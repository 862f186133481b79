package org.maestro.rats.link;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.rats.broker.TestBroker;

@Isolated("other tests start threads and write to the log")
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
