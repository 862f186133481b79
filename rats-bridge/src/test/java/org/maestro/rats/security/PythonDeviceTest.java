package org.maestro.rats.security;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.rats.security.SecuredSite.await;
import static org.maestro.rats.security.SecuredSite.isReady;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.broker.RunsProgram;
import org.maestro.rats.broker.TestBroker;
import org.maestro.rats.conformance.DeviceExamination;
import org.maestro.rats.conformance.DeviceRule;
import org.maestro.rats.conformance.FeatureCall;
import org.maestro.rats.conformance.Finding;
import org.maestro.rats.conformance.Patience;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** A device in another language, on a secured site: it joins, answers, and is missed. */
@RunsProgram(value = "python3", pythonModule = "paho.mqtt.enums")
class PythonDeviceTest {

  @TempDir Path directory;

  @Test
  void isShort() throws IOException {
    assertThat(Files.readAllLines(Path.of("..", "docs", "examples", "kettle.py")))
        .hasSizeLessThan(100);
  }

  @ParameterizedTest
  @EnumSource
  void joinsIsCalledAndAnswers(PythonKettle.Script script) throws IOException {
    Path files = SecuredSite.files(directory);
    SecureSite.make(
        files, SecuredSite.SITE, List.of("127.0.0.1"), List.of(), List.of(PythonKettle.ID));
    try (SecuredSite site = new SecuredSite(files, TestBroker.embeddedSecured(files))) {
      RatsLink link = site.connect(site.security.password("cca"));
      try (PythonKettle kettle =
          PythonKettle.start(
              script, site.uri(), SecuredSite.SITE, Optional.of(files.resolve("users/kettle-1")))) {
        await(() -> isReady(link, PythonKettle.ID));
        speakRubbish(site);
        RatsLink.Order brew =
            new RatsLink.Order(
                Optional.of("b1"),
                PythonKettle.ID,
                Optional.empty(),
                "brew",
                Map.of(
                    "drink", Map.of("ref", "urn:home:x#Tea"),
                    "guest", Map.of("ref", "urn:home:x#Anna")),
                Duration.ofSeconds(20),
                Optional.of("G1"));
        for (int again = 0; again < 2; again++) {
          SecuredBusContract.Heard heard = new SecuredBusContract.Heard();
          link.call(brew, heard);
          await(() -> !heard.results.isEmpty());
          assertThat(heard.results.get(0).outcome()).isEqualTo(Outcome.SUCCEEDED);
        }
        assertThat(values(link)).as("brewed once").containsExactly("(served Tea Anna)");
        SecuredBusContract.Heard unknown = new SecuredBusContract.Heard();
        link.call(
            PythonKettle.ID, "fly", Map.of(), Duration.ofSeconds(20), Optional.empty(), unknown);
        await(() -> !unknown.results.isEmpty());
        assertThat(unknown.results.get(0).error().orElseThrow().code())
            .isEqualTo(ErrorCode.UNKNOWN_FEATURE);
        List<List<CostAnswer>> prices = new CopyOnWriteArrayList<>();
        link.cost(PythonKettle.ID, "brew", List.of(Map.of(), Map.of()), prices::add);
        await(() -> !prices.isEmpty());
        assertThat(prices.get(0)).hasSize(2).allMatch(price -> price.cost().isPresent());
        kettle.kill();
        await(() -> phase(link).filter(MemberStatus.Phase.LOST::equals).isPresent());
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void keepsTheRulesOfTheBus(PythonKettle.Script script) throws IOException {
    Map<String, Object> tea =
        Map.of("drink", Map.of("ref", "urn:home:x#Tea"), "guest", Map.of("ref", "urn:home:x#Anna"));
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        PythonKettle kettle =
            PythonKettle.start(script, broker.uri(), SecuredSite.SITE, Optional.empty())) {
      assertThat(kettle.hasEnded()).isFalse();
      List<Finding> findings =
          new DeviceExamination(
                  new PahoTransport(broker.uri(), "examiner"),
                  SecuredSite.SITE,
                  PythonKettle.ID,
                  Optional.of(new FeatureCall("brew", tea)),
                  true,
                  new Patience(
                      Duration.ofSeconds(20), Duration.ofSeconds(5), Duration.ofMillis(500)))
              .run();

      assertThat(findings)
          .filteredOn(finding -> finding.verdict() == Finding.Verdict.BROKEN)
          .isEmpty();
      assertThat(findings)
          .filteredOn(finding -> finding.verdict() == Finding.Verdict.NOT_TRIED)
          .extracting(Finding::rule)
          .containsExactlyElementsOf(notTried(script));
    }
  }

  /** The one without the package looks at t nowhere, does all at once, and tells of no past. */
  private static List<DeviceRule> notTried(PythonKettle.Script script) {
    return switch (script) {
      case BARE ->
          List.of(
              DeviceRule.TIME_IN_QUEUE,
              DeviceRule.TIME_WHEN_RUNNING,
              DeviceRule.NAMED_FIELD,
              DeviceRule.RECENT);
      case WITH_PACKAGE -> List.of();
    };
  }

  /** Else they would throw each other off the bus for ever. */
  @ParameterizedTest
  @EnumSource
  void ofTwoThatCallThemselvesTheSameOneGives(PythonKettle.Script script) throws IOException {
    Path files = SecuredSite.files(directory);
    SecureSite.make(
        files, SecuredSite.SITE, List.of("127.0.0.1"), List.of(), List.of(PythonKettle.ID));
    Optional<Path> folder = Optional.of(files.resolve("users/kettle-1"));
    try (SecuredSite site = new SecuredSite(files, TestBroker.embeddedSecured(files))) {
      RatsLink link = site.connect(site.security.password("cca"));
      try (PythonKettle one = PythonKettle.start(script, site.uri(), SecuredSite.SITE, folder)) {
        await(() -> isReady(link, PythonKettle.ID));
        try (PythonKettle other =
            PythonKettle.start(script, site.uri(), SecuredSite.SITE, folder)) {
          await(() -> one.hasEnded() || other.hasEnded());
          await(() -> isReady(link, PythonKettle.ID));
        }
      }
    }
  }

  /** What is no JSON, and a call without what it needs. */
  private static void speakRubbish(SecuredSite site) {
    PahoTransport lamp = new PahoTransport(site.uri(), site.security.password("lamp"));
    AtomicInteger taken = new AtomicInteger();
    List<String> rubbish = List.of("{{", "[]", "{\"id\":\"x\",\"r\":\"kettle-1\",\"f\":\"brew\"}");
    lamp.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            for (String text : rubbish) {
              lamp.publish(
                  Publication.reliable(
                      new Topics(SecuredSite.SITE).call("lamp"),
                      text.getBytes(UTF_8),
                      Optional.empty()),
                  failure -> taken.incrementAndGet());
            }
          }

          @Override
          public void lost(String reason) {
            // It tries again.
          }
        });
    await(() -> taken.get() >= rubbish.size());
    lamp.close();
  }

  private static List<String> values(RatsLink link) {
    return member(link).flatMap(RatsLink.Member::state).orElseThrow().values();
  }

  private static Optional<MemberStatus.Phase> phase(RatsLink link) {
    return member(link).map(RatsLink.Member::phase);
  }

  private static Optional<RatsLink.Member> member(RatsLink link) {
    return link.members().stream().filter(m -> m.id().equals(PythonKettle.ID)).findFirst();
  }
}
