package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.conformance.DeviceRule;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;

/** A device made with the Java runtime is examined by the command. */
class DeviceTestCommandTest {

  @Test
  void tellsOfEachRuleWhetherItIsKeptAndHowManyItCannotSee() throws IOException {
    PacedClock clock = new PacedClock(1);
    try (EmbeddedBroker broker = EmbeddedBroker.start()) {
      RatsMember bell =
          RatsMember.start(
              bell(clock), List::of, new PahoTransport(broker.uri(), "bell-1"), "maestro", clock);
      String uri = broker.uri().toString();
      String said = said("device", "test", uri, "bell-1", "--call", "ring");
      JsonNode document =
          new ObjectMapper().readTree(said("device", "test", uri, "bell-1", "--json"));
      bell.close();

      int judged = DeviceRule.values().length;
      assertThat(said)
          .contains("%d kept, 0 broken, 0 not tried.".formatted(judged))
          .contains("These are %d of the %d rules".formatted(judged, DeviceRule.OF_ALL));
      assertThat(document.path("rules").intValue()).isEqualTo(DeviceRule.OF_ALL);
      assertThat(document.path("findings"))
          .hasSize(judged)
          .extracting(finding -> finding.path("verdict").asText())
          .containsOnly("kept", "not tried");
    } finally {
      clock.close();
    }
  }

  private static MemberProfile bell(PacedClock clock) {
    Procedure ring =
        new Procedure() {
          @Override
          public void start(Execution execution) {
            clock.schedule(Duration.ofMillis(300), "bell-1", () -> execution.succeed(Map.of()));
          }

          @Override
          public CostAnswer cost(Map<String, Object> parameters) {
            return new CostAnswer(Optional.of(1.0), Optional.of(0.3), Optional.empty());
          }
        };
    return new MemberProfile(
        "bell-1",
        "{\"id\":\"#bell-1\",\"offers\":{\"id\":\"https://example.org/b#ring\"}}",
        Set.of("standby"),
        "standby",
        Set.of("standby"),
        MemberProfile.byId(
            List.of(
                new MemberProfile.Feature(
                    "ring",
                    Set.of(),
                    Set.of("clapper"),
                    false,
                    Optional.empty(),
                    "standby",
                    ring))));
  }

  private static String said(String... arguments) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    PrintStream nowhere = new PrintStream(new ByteArrayOutputStream());
    int exitCode = Maestro.commandLine(new PrintStream(out), nowhere).execute(arguments);
    String said = out.toString(StandardCharsets.UTF_8);
    assertThat(exitCode).as(said).isZero();
    return said;
  }
}
