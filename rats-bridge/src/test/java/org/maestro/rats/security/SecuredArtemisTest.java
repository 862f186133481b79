package org.maestro.rats.security;

import java.nio.file.Path;
import org.maestro.rats.broker.TestBroker;

/** The embedded Artemis; one port for both kinds of credentials. */
class SecuredArtemisTest extends SecuredBusContract {

  @Override
  TestBroker byPassword(Path files) {
    return TestBroker.embeddedSecured(files);
  }

  @Override
  TestBroker byCertificate(Path files) {
    return TestBroker.embeddedSecured(files);
  }
}
