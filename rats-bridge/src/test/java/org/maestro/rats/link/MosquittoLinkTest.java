package org.maestro.rats.link;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.TestInfo;
import org.maestro.rats.broker.RunsProgram;
import org.maestro.rats.broker.TestBroker;

@RunsProgram("mosquitto")
class MosquittoLinkTest extends PahoLinkContract {

  private static final TestBroker BROKER = TestBroker.mosquitto();

  @BeforeAll
  static void startBroker() {
    BROKER.start();
  }

  @AfterAll
  static void stopsWithoutTrace(TestInfo test) {
    BROKER.stop();
    assertNoThreadIsLeft(test);
  }

  @Override
  TestBroker broker() {
    return BROKER;
  }
}
