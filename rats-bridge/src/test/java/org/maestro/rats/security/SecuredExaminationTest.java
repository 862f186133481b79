package org.maestro.rats.security;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.rats.broker.TestBroker;
import org.maestro.rats.conformance.DeviceExamination;
import org.maestro.rats.conformance.DeviceRule;
import org.maestro.rats.conformance.FeatureCall;
import org.maestro.rats.conformance.Finding;
import org.maestro.rats.conformance.Patience;
import org.maestro.rats.transport.PahoTransport;

/** On a secured site a device is examined, too, but for what nobody may say there. */
class SecuredExaminationTest {

  @Test
  void allIsTriedButWhatNobodyMaySay(@TempDir Path directory) {
    Path files = SecuredSite.files(directory);
    try (SecuredSite site = new SecuredSite(files, TestBroker.embeddedSecured(files))) {
      site.join(site.security.password("lamp"));
      List<Finding> findings =
          new DeviceExamination(
                  new PahoTransport(site.uri(), site.security.password("cca")),
                  SecuredSite.SITE,
                  "lamp",
                  Optional.of(new FeatureCall("wave", Map.of())),
                  false,
                  new Patience(
                      Duration.ofSeconds(20), Duration.ofSeconds(5), Duration.ofMillis(250)))
              .run();

      assertThat(findings)
          .filteredOn(finding -> finding.verdict() == Finding.Verdict.BROKEN)
          .isEmpty();
      assertThat(findings)
          .filteredOn(finding -> finding.verdict() == Finding.Verdict.NOT_TRIED)
          .extracting(Finding::rule)
          .containsExactly(
              DeviceRule.BARE_TOPIC,
              DeviceRule.LATE_WILL,
              DeviceRule.OWN_WILL,
              DeviceRule.CLEARED_STATUS,
              DeviceRule.NAMESAKE,
              DeviceRule.FORGED_DESCRIPTION,
              DeviceRule.FORGED_END);
    }
  }
}
