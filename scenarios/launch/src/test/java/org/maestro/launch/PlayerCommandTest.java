package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.fixtures.PlayerServer;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;

/** A robot behind a Player server becomes one of a home by one command (ADE, 3.3; A40). */
class PlayerCommandTest {
  private static final String HOME =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://w3id.org/maestro/home/crater#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      <https://w3id.org/maestro/home/crater> a maestro:Home ; rdfs:label "a crater"@en .
      home:crater a maestro:Room ; rdfs:label "the crater"@en ; maestro:outline "0 0, 9 0, 9 9, 0 9" ; maestro:height 4 .
      home:plain a maestro:Zone ; rdfs:label "the plain"@en ; maestro:outline "0 0, 9 0, 9 9, 0 9" .
      home:rover a :PioneerDX ; rdfs:label "the rover"@en ; :colour "red" ; :size "0.4 0.4 0.3" ; :speed 0.5 .
      """;

  @TempDir private Path directory;

  @Test
  void aRobotOfAServerJoinsAsTheHomesAndDrives() throws Exception {
    Path home = Files.writeString(directory.resolve("crater.ttl"), HOME);
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        PlayerServer server = new PlayerServer(0, 0, 0);
        PacedClock clock = new PacedClock(1);
        RatsLink link =
            BusLink.connect("cca", "crater", new PahoTransport(broker.uri(), "cca"), clock);
        RunningCommand command = player(home, server, broker)) {
      Awaitility.await()
          .atMost(Duration.ofMinutes(2))
          .untilAsserted(() -> assertThat(isReady(link)).as(command::said).isTrue());
      Awaitility.await()
          .atMost(Duration.ofMinutes(2))
          .untilAsserted(
              () ->
                  assertThat(called(link, "drive", Map.of("metres", 0.5)).outcome())
                      .as(command::said)
                      .isEqualTo(Outcome.SUCCEEDED));

      assertThat(server.commands()).as("metres and radians a second").contains("0.50 0.00");
      Awaitility.await().atMost(Duration.ofSeconds(30)).until(() -> said(link).contains("plain"));
      Result there = called(link, "goTo", Map.of("x", 3, "y", 3, "heading", 0));
      assertThat(there.outcome()).as(there.toString()).isEqualTo(Outcome.SUCCEEDED);
      assertThat(number(there, "reachedX")).isCloseTo(3, within(0.2));
      assertThat(number(there, "reachedY")).isCloseTo(3, within(0.2));
      assertThat(Math.IEEEremainder(number(there, "facing"), 360)).isCloseTo(0, within(5.0));
      assertThat(command.said()).contains("is rover on").doesNotContain("rror");
    }
  }

  private static RunningCommand player(Path home, PlayerServer server, EmbeddedBroker broker) {
    return new RunningCommand(
        "player",
        home.toString(),
        "--robot",
        "rover",
        "--server",
        server.address().getHostString() + ":" + server.address().getPort(),
        "--at",
        "2 2 90",
        "--broker",
        broker.uri().toString(),
        "--site",
        "crater");
  }

  private static boolean isReady(RatsLink link) {
    return link.members().stream()
        .anyMatch(m -> m.phase() == MemberStatus.Phase.READY && m.state().isPresent());
  }

  private static double number(Result result, String name) {
    return ((Number) result.values().get(name)).doubleValue();
  }

  private static Result called(RatsLink link, String feature, Map<String, Object> parameters) {
    List<Result> results = new CopyOnWriteArrayList<>();
    link.call("rover", feature, parameters, Duration.ofSeconds(30), Optional.empty(), results::add);
    Awaitility.await().atMost(Duration.ofSeconds(40)).until(() -> !results.isEmpty());
    return results.get(0);
  }

  private static String said(RatsLink link) {
    return link.members().stream()
        .map(member -> String.valueOf(member.state()))
        .toList()
        .toString();
  }
}
