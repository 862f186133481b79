package org.maestro.rats.conformance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Transport;

/**
 * Devices that break one rule are found to break that one, and no other. An examination is mostly
 * waiting: each has a broker of its own, so that many go on side by side.
 */
@Execution(ExecutionMode.CONCURRENT)
class DeviceExaminationTest {
  private static final String SITE = "examined";
  private static final Patience PATIENCE =
      new Patience(Duration.ofSeconds(3), Duration.ofSeconds(3), Duration.ofMillis(250));

  private final EmbeddedBroker broker = EmbeddedBroker.start();

  @AfterEach
  void stop() {
    broker.close();
  }

  private static List<Finding> examine(URI broker, String member, Optional<FeatureCall> call) {
    return examine(new PahoTransport(broker, "examiner"), member, call);
  }

  private static List<Finding> examine(
      Transport transport, String member, Optional<FeatureCall> call) {
    return new DeviceExamination(transport, SITE, member, call, true, PATIENCE).run();
  }

  @ParameterizedTest
  @EnumSource(
      names = {
        "NONE",
        "IS_SLOW_ONCE",
        "TELLS_ITS_STATE_LATE",
        "TELLS_NO_STATE",
        "BELIEVES_ANY_SENDER",
        "DOES_TWICE",
        "TAKES_ANY_BOOT",
        "DIES_OF_DEPTH"
      })
  void aFlawIsFoundWhereItIs(Flaw flaw) {
    isFound(flaw);
  }

  @ParameterizedTest
  @EnumSource
  @Tag("full")
  void eachFlawIsFoundWhereItIs(Flaw flaw) {
    isFound(flaw);
  }

  private void isFound(Flaw flaw) {
    // The embedded broker hands no retained call on; nothing can break that rule there.
    List<DeviceRule> expected = flaw == Flaw.TAKES_RETAINED_CALLS ? List.of() : flaw.breaks();
    try (FlawedDevice device = new FlawedDevice(flaw, broker.uri(), SITE)) {
      List<Finding> findings =
          examine(broker.uri(), device.id(), Optional.of(new FeatureCall("ring", Map.of())));

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
          examine(broker.uri(), "anna", Optional.of(new FeatureCall("wave", Map.of())));
      member.close();

      assertThat(findings)
          .filteredOn(finding -> finding.verdict() != Finding.Verdict.KEPT)
          .isEmpty();
    } finally {
      clock.close();
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"NONE", "RETAINS_NOTHING"})
  void whoComesLaterIsJudgedByWhatTheBrokerKeeps(Flaw flaw) {
    List<DeviceRule> expected = flaw == Flaw.NONE ? List.of() : List.of(DeviceRule.DOCUMENTS);
    try (Late late = new Late(new PahoTransport(broker.uri(), "examiner"), flaw)) {
      List<Finding> findings = examine(late.examiner(), "bell-1", Optional.empty());

      assertThat(findings)
          .filteredOn(finding -> finding.verdict() == Finding.Verdict.BROKEN)
          .as(findings.toString())
          .extracting(Finding::rule)
          .containsExactlyElementsOf(expected);
    }
  }

  /** A device that is there as soon as its examiner is. */
  private final class Late implements AutoCloseable {
    private final Transport examiner;
    private final Flaw flaw;
    private @Nullable FlawedDevice device;

    Late(Transport transport, Flaw flaw) {
      this.flaw = flaw;
      this.examiner =
          (Transport)
              Proxy.newProxyInstance(
                  Late.class.getClassLoader(),
                  new Class<?>[] {Transport.class},
                  (proxy, method, arguments) -> {
                    if (method.getName().equals("open")) {
                      transport.open(
                          Optional.empty(), whenThere((Transport.ConnectionListener) arguments[1]));
                      return null;
                    }
                    return method.invoke(transport, arguments);
                  });
    }

    private Transport.ConnectionListener whenThere(Transport.ConnectionListener listener) {
      return new Transport.ConnectionListener() {
        @Override
        public void connected() {
          device = new FlawedDevice(flaw, broker.uri(), SITE);
          listener.connected();
        }

        @Override
        public void lost(String reason) {}
      };
    }

    Transport examiner() {
      return examiner;
    }

    @Override
    public void close() {
      if (device != null) {
        device.close();
      }
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
    assertThat(table.lines().filter(line -> line.matches("\\| \\d+ \\|.*")))
        .hasSize(DeviceRule.OF_ALL);
    assertThat(Files.readString(Path.of("..", "docs", "guide-bus.md")))
        .contains("judges %d of".formatted(DeviceRule.values().length))
        .contains("[the %d rules]".formatted(DeviceRule.OF_ALL));
  }

  @Test
  void eachRuleIsBrokenBySomeFlaw() {
    assertThat(Flaw.values())
        .flatExtracting(Flaw::breaks)
        .as("no verdict that cannot be bad")
        .contains(DeviceRule.values());
  }
}
