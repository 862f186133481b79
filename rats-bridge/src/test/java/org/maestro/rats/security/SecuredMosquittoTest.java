package org.maestro.rats.security;

import java.nio.file.Path;
import org.maestro.rats.broker.RunsProgram;
import org.maestro.rats.broker.TestBroker;

/** The program mosquitto, with a port for each kind of credentials. */
@RunsProgram("mosquitto")
class SecuredMosquittoTest extends SecuredBusContract {

  @Override
  TestBroker byPassword(Path files) {
    return TestBroker.mosquittoSecured(files, MosquittoFiles.PASSWORD_PORT);
  }

  @Override
  TestBroker byCertificate(Path files) {
    return TestBroker.mosquittoSecured(files, MosquittoFiles.CERTIFICATE_PORT);
  }

  /** It reads its list of revoked certificates, and who came by one, only when it begins. */
  @Override
  void tellOfRevokedCertificates(TestBroker broker) {
    broker.stop();
    broker.start();
  }

  @Override
  boolean othersStayWhenCertificatesAreRevoked() {
    return false;
  }
}
