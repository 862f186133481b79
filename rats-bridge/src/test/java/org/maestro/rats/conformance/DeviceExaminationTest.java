package org.maestro.rats.conformance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;

/** Devices that break one rule are found to break that one, and no other. */
class DeviceExaminationTest {
  private static final String SITE = "examined";
  private static final Patience PATIENCE =
      new Patience(Duration.ofSeconds(3), Duration.ofSeconds(2), Duration.ofMillis(250));

  private static EmbeddedBroker broker;

  @BeforeAll
  static void start() {
    broker = EmbeddedBroker.start();
  }

  @AfterAll
  static void stop() {
    broker.close();
  }

  private static List<Finding> examine(
      URI broker, String member, Optional<DeviceExamination.FeatureCall> call) {
    return new DeviceExamination(
            new PahoTransport(broker, "examiner"), SITE, member, call, true, PATIENCE)
        .run();
  }

  @ParameterizedTest
  @EnumSource(
      names = {
        "NONE",
        "TELLS_NO_STATE",
        "BELIEVES_ANY_SENDER",
        "DOES_TWICE",
        "TAKES_ANY_BOOT",
        "DIES_OF_DEPTH"
      })
  void aFlawIsFoundWhereItIs(FlawedDevice.Flaw flaw) {
    isFound(flaw);
  }

  @ParameterizedTest
  @EnumSource
  @Tag("full")
  void eachFlawIsFoundWhereItIs(FlawedDevice.Flaw flaw) {
    isFound(flaw);
  }

  private static void isFound(FlawedDevice.Flaw flaw) {
    // The embedded broker hands no retained call on; nothing can break that rule there.
    List<DeviceRule> expected =
        flaw == FlawedDevice.Flaw.TAKES_RETAINED_CALLS ? List.of() : flaw.breaks();
    try (FlawedDevice device = new FlawedDevice(flaw, broker.uri(), SITE)) {
      List<Finding> findings =
          examine(
              broker.uri(),
              device.id(),
              Optional.of(new DeviceExamination.FeatureCall("ring", Map.of())));

      assertThat(findings).extracting(Finding::rule).containsExactly(DeviceRule.values());
      assertThat(findings)
          .filteredOn(finding -> finding.verdict() == Finding.Verdict.BROKEN)
          .as(findings.toString())
          .extracting(Finding::rule)
          .containsExactlyElementsOf(expected);
    }
  }

  @Test
  void ourOwnMembersKeepTheRules() {
    PacedClock clock = new PacedClock(1);
    try {
      RatsMember member =
          RatsMember.start(
              new TestDevice("anna", clock).profile(),
              List::of,
              new PahoTransport(broker.uri(), "anna"),
              SITE,
              clock);
      List<Finding> findings =
          examine(
              broker.uri(),
              "anna",
              Optional.of(new DeviceExamination.FeatureCall("echo", Map.of("a", 1))));
      member.close();

      assertThat(findings)
          .filteredOn(finding -> finding.verdict() != Finding.Verdict.KEPT)
          .isEmpty();
    } finally {
      clock.close();
    }
  }

  @Test
  void whoIsNotThereIsNotJudged() {
    List<Finding> findings = examine(broker.uri(), "nobody", Optional.empty());

    assertThat(findings).extracting(Finding::rule).containsExactly(DeviceRule.values());
    assertThat(findings.get(0).why()).contains("nothing was heard on status, description, state");
    assertThat(findings)
        .filteredOn(finding -> finding.verdict() == Finding.Verdict.BROKEN)
        .hasSize(1);
  }

  @Test
  void theRulesAreThoseOfTheTable() throws IOException {
    String table = Files.readString(Path.of("..", "docs", "bus-rules.md"));
    for (DeviceRule rule : DeviceRule.values()) {
      assertThat(table).contains("| %d | %s |".formatted(rule.number(), rule.sentence()));
    }
  }
}
