package org.maestro.rats.security;

import static org.maestro.rats.security.SecuredSite.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
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

  /** A backslash in the wrong place is no I/O error; it ended the looking for good. */
  @Test
  void whoIsTakenOutAfterTheListOfUsersWasUnreadableIsCutOffAllTheSame() throws IOException {
    Path files = SecuredSite.files(directory);
    Path users = files.resolve("artemis/users.properties");
    try (SecuredSite site = new SecuredSite(files, byPassword(files));
        LogLines log = LogLines.of("org.maestro.rats.broker.SiteWatch");
        Kept lamp = new Kept(site, site.security.password("lamp"))) {
      await(() -> lamp.connects > 0);
      String right = Files.readString(users);
      PrivateFiles.write(users, right + "rose=\\u00zz\n");
      await(() -> log.lines().stream().anyMatch(line -> line.contains("goes on as before")));
      PrivateFiles.write(users, right);

      SecureSite.in(files).revoke(List.of("lamp"));

      await(() -> lamp.losses > 0);
    }
  }
}
