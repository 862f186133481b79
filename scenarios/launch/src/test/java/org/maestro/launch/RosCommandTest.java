package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.Awaitility;
import org.awaitility.core.ThrowingRunnable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.fixtures.RosbridgeServer;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;

/** Robot, camera and sensor behind ROS become those of a home (Three-layered architecture, M89). */
class RosCommandTest {
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
      home:dawn a :LightSensor ; rdfs:label "the light sensor"@en ; maestro:pose "5 5 3" .
      home:mast a :Camera ; rdfs:label "the mast's camera"@en ; maestro:pose "5 5 3" ; maestro:viewAngle 90 ;
        maestro:frameRate 30 ; maestro:resolution "1920 1080" ; :minimumIlluminance 72 ; :maximumIlluminance 2000 .
      home:stone a :Item ; rdfs:label "the stone"@en ; :colour "green" ; :size "0.1 0.1 0.1" .
      """;

  private static final String STONE =
      """
      {"header": {"frame_id": "map"}, "detections": [{"results": [
       {"hypothesis": {"class_id": "rock", "score": 0.9},
        "pose": {"pose": {"position": {"x": 4, "y": 3, "z": 0.1}}}}]}]}\
      """;

  @TempDir private Path directory;

  @Test
  void whatIsBehindAServerJoinsAsTheHomesAndIsUsed() throws Exception {
    Path home = Files.writeString(directory.resolve("crater.ttl"), HOME);
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        RosbridgeServer server = new RosbridgeServer(0, 0, 0);
        PacedClock clock = new PacedClock(1);
        RatsLink link =
            BusLink.connect("cca", "crater", new PahoTransport(broker.uri(), "cca"), clock);
        RunningCommand command = ros(home, server, broker)) {
      await(command, () -> assertThat(ready(link)).containsExactly("rover"));
      await(
          command,
          () -> {
            server.tell("/lux", "{\"illuminance\": 120.0, \"variance\": 0.0}");
            server.tell("/detections", STONE);
            assertThat(ready(link)).containsExactlyInAnyOrder("dawn", "mast", "rover");
          });

      assertThat(called(link, server, "rover", "drive", Map.of("metres", 0.5)).outcome())
          .isEqualTo(Outcome.SUCCEEDED);
      assertThat(server.orders()).anyMatch(order -> order.contains("\"linear\":{\"x\":0.5,"));
      await(command, () -> assertThat(said(link, "rover")).contains("plain", "position"));

      assertThat(seen(link, server, "mast", "stone"))
          .containsEntry("found", true)
          .containsEntry("pose", List.of(4.0, 3.0, 0.1));

      server.fallSilent();
      await(command, () -> assertThat(disabled(link, "rover")).contains("drive", "turn"));
      assertThat(said(link, "rover")).as("what is not known any more").isEqualTo("[]");
      assertThat(called(link, server, "rover", "drive", Map.of("metres", 1)).toString())
          .contains("has told nothing on /odom for more than 2 s");
      assertThat(command.said()).contains("rover, dawn, mast joins").doesNotContain("rror");
    }
  }

  private static RunningCommand ros(Path home, RosbridgeServer server, EmbeddedBroker broker) {
    return new RunningCommand(
        "ros",
        home.toString(),
        "--server",
        server.address().toString(),
        "--robot",
        "rover",
        "--at",
        "2 2 90",
        "--sensor",
        "dawn=/lux",
        "--camera",
        "mast=/detections",
        "--class",
        "rock=stone",
        "--broker",
        broker.uri().toString(),
        "--site",
        "crater");
  }

  private static void await(RunningCommand command, ThrowingRunnable assertion) {
    Awaitility.await()
        .alias("what it says")
        .atMost(Duration.ofMinutes(2))
        .conditionEvaluationListener(condition -> command.said())
        .untilAsserted(assertion);
  }

  private static List<String> ready(RatsLink link) {
    return link.members().stream()
        .filter(m -> m.phase() == MemberStatus.Phase.READY && m.state().isPresent())
        .map(RatsLink.Member::id)
        .toList();
  }

  private static Result called(
      RatsLink link, RosbridgeServer server, String member, String feature, Map<String, Object> p) {
    List<Result> results = new CopyOnWriteArrayList<>();
    link.call(member, feature, p, Duration.ofSeconds(30), Optional.empty(), results::add);
    Awaitility.await()
        .atMost(Duration.ofSeconds(60))
        .until(
            () -> {
              server.tell("/lux", "{\"illuminance\": 120.0, \"variance\": 0.0}");
              server.tell("/detections", STONE);
              return !results.isEmpty();
            });
    return results.get(0);
  }

  /** What a look establishes, which goes on then. */
  private static Map<String, Object> seen(
      RatsLink link, RosbridgeServer server, String camera, String thing) {
    List<Map<String, Object>> told = new CopyOnWriteArrayList<>();
    link.call(
        camera,
        "observeObject",
        Map.of("object", Map.of("ref", thing)),
        Duration.ofSeconds(30),
        Optional.empty(),
        new RatsLink.CallListener() {
          @Override
          public void progressed(Progress progress) {
            told.add(progress.values());
          }

          @Override
          public void ended(Result result) {
            told.add(Map.of("ended", result));
          }
        });
    Awaitility.await()
        .atMost(Duration.ofSeconds(60))
        .until(
            () -> {
              server.tell("/detections", STONE);
              return told.stream().anyMatch(values -> !values.isEmpty());
            });
    return told.stream().filter(values -> !values.isEmpty()).findFirst().orElseThrow();
  }

  private static List<MemberState> states(RatsLink link, String id) {
    List<MemberState> states = new ArrayList<>();
    link.members().stream()
        .filter(member -> member.id().equals(id))
        .forEach(member -> member.state().ifPresent(states::add));
    return states;
  }

  private static String said(RatsLink link, String id) {
    return states(link, id).get(0).values().toString();
  }

  private static List<String> disabled(RatsLink link, String id) {
    return states(link, id).get(0).disabled();
  }
}
