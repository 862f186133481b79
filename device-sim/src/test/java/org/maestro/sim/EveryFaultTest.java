package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.home.Home;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.transport.Transport;
import org.maestro.sim.scene.Deed;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sim.scene.ScriptedFault;

/** Each kind of fault: at its time by a scene file, at random and upon an event by the API. */
class EveryFaultTest {
  private static final Path SCENES = Path.of("../scenarios/assembly/src/main/resources/scenes");
  private static final Duration A_WHILE = Duration.ofSeconds(1);
  private static final int MOST_TRIES = 60;

  private static final Transport.ConnectionListener DEAF =
      new Transport.ConnectionListener() {
        @Override
        public void connected() {}

        @Override
        public void lost(String reason) {}
      };

  /**
   * @param words what a fault says after its time
   * @param prepared so that it is not so already
   * @param happened looks, and tries, whether it is so
   */
  private record Trouble(
      String home,
      String scene,
      String subject,
      String words,
      Consumer<Homes> prepared,
      Predicate<Homes> happened) {
    static Trouble of(String subject, String words, Predicate<Homes> happened) {
      return of(subject, words, homes -> {}, happened);
    }

    static Trouble of(
        String subject, String words, Consumer<Homes> prepared, Predicate<Homes> happened) {
      return new Trouble("bob", "bob-lit", subject, words, prepared, happened);
    }

    static Trouble ofTheSky(String words, double cloudsBefore, Predicate<Homes> happened) {
      return new Trouble(
          "arena-windows",
          "arena-windows",
          "",
          words,
          homes -> homes.world().setClouds(cloudsBefore),
          happened);
    }

    ScriptedFault fault(String when) {
      return ScriptedFault.parse(when + " " + words);
    }
  }

  /** A kind without a case here does not compile. */
  private static Trouble trouble(Deed deed) {
    return switch (deed) {
      case DIE -> Trouble.of("lamp-b1", "die", homes -> !homes.world().isAlive("lamp-b1"));
      case REVIVE ->
          Trouble.of(
              "lamp-b1",
              "revive",
              homes -> homes.world().die("lamp-b1"),
              homes -> homes.world().isAlive("lamp-b1"));
      case BREAK -> Trouble.of("lamp-b1", "break", homes -> dimmed(homes) == Outcome.FAILED);
      case REPAIR ->
          Trouble.of(
              "lamp-b1",
              "repair",
              homes -> homes.world().breakDown("lamp-b1", "it is broken"),
              homes -> dimmed(homes) == Outcome.SUCCEEDED);
      case FREEZE -> Trouble.of("lamp-b1", "freeze 4", homes -> seconds(homes) > 2);
      case LIE -> Trouble.of("lux-b", "lie 1.5", homes -> measured(homes) > 1.3);
      case DRIFT -> Trouble.of("lux-b", "drift 3600", homes -> measured(homes) > 1.3);
      case SLIP -> Trouble.of("rose", "slip 1", homes -> moved(homes) == Outcome.FAILED);
      case DROP ->
          Trouble.of(
              "rose",
              "drop",
              homes -> homes.call("rose", "pick", Map.of("object", homes.at("Cup"))),
              homes -> homes.world().held("rose").isEmpty());
      case CHARGE -> Trouble.of("rose", "charge 0.5", homes -> homes.world().charge("rose") <= 0.5);
      case WEAKEN -> Trouble.of("lamp-b1", "weaken 0", homes -> homes.world().lux("zone-b") < 60);
      case LOSE -> Trouble.of("lamp-b1", "lose 1", homes -> dimmed(homes) == Outcome.TIMED_OUT);
      case DELAY -> Trouble.of("lamp-b1", "delay 2", homes -> seconds(homes) > 4);
      case DUPLICATE -> Trouble.of("lamp-b1", "duplicate 1", homes -> answers(homes) > 1);
      case OFFLINE ->
          Trouble.of("lamp-b1", "offline", homes -> phase(homes) == MemberStatus.Phase.LOST);
      case ONLINE ->
          Trouble.of(
              "lamp-b1",
              "online",
              homes -> homes.bus.cut("lamp-b1"),
              homes -> phase(homes) == MemberStatus.Phase.READY);
      case DARK -> Trouble.of("zone-b", "dark", homes -> homes.world().lux("zone-b") < 1);
      case AMBIENT ->
          Trouble.of("zone-b", "ambient 500", homes -> homes.world().lux("zone-b") > 500);
      case CLOUDS -> Trouble.ofTheSky("clouds 1", 0, homes -> daylight(homes) < 10_000);
      case SUN -> Trouble.ofTheSky("sun", 1, homes -> daylight(homes) > 10_000);
      case WALK ->
          Trouble.of("Bob", "walk 1.2 2.1", homes -> isAt(homes, "Bob", new Point2(1.2, 2.1)));
      case MOVE -> Trouble.of("Cup", "move 4 2", homes -> isAt(homes, "Cup", new Point2(4, 2)));
      case BLOCK ->
          Trouble.of("Bob", "block door-ab", homes -> isAt(homes, "Bob", new Point2(3, 2.35)));
      case HIDE -> Trouble.of("Cup", "hide", homes -> homes.world().isHidden("Cup"));
      case SHOW ->
          Trouble.of(
              "Cup",
              "show",
              homes -> homes.world().hide("Cup", true),
              homes -> !homes.world().isHidden("Cup"));
      case OPEN ->
          Trouble.of(
              "door-ab",
              "open",
              homes -> homes.world().setDoor("door-ab", false),
              homes -> homes.world().isOpen("door-ab"));
      case CLOSE -> Trouble.of("door-ab", "close", homes -> !homes.world().isOpen("door-ab"));
    };
  }

  @ParameterizedTest
  @EnumSource(Deed.class)
  void happensAtItsTimeByASceneFile(Deed deed) throws IOException {
    Trouble trouble = trouble(deed);
    Home home = Homes.home(trouble.home());
    String node = trouble.subject().isEmpty() ? "<>" : "<#" + trouble.subject() + ">";
    String turtle =
        Files.readString(SCENES.resolve(trouble.scene() + ".ttl"))
            + "\n%s <%sfault> \"at 20 %s\" .\n"
                .formatted(node, SceneLoader.NAMESPACE, trouble.words());
    Scene scene =
        SceneLoader.load(
            trouble.scene(),
            new ByteArrayInputStream(turtle.getBytes(StandardCharsets.UTF_8)),
            home);
    try (Homes homes = new Homes(home, scene, 1)) {
      trouble.prepared().accept(homes);
      homes.clock.run(Duration.ofSeconds(20).plus(A_WHILE).minus(homes.clock.now()));
      assertThat(trouble.happened().test(homes)).isTrue();
    }
  }

  @ParameterizedTest
  @EnumSource(Deed.class)
  @Tag("full")
  void happensUponAnEventAndNotBefore(Deed deed) {
    Trouble trouble = trouble(deed);
    String lamp = trouble.home().equals("bob") ? "lamp-a1" : "lamp-1";
    try (Homes homes = new Homes(trouble.home(), trouble.scene(), 1, scene -> scene)) {
      trouble.prepared().accept(homes);
      homes.simulated.let(trouble.subject(), trouble.fault("upon " + lamp + ".lit"));
      homes.clock.run(A_WHILE);
      assertThat(trouble.happened().test(homes)).as("before").isFalse();
      homes.call(lamp, "adjustLight", Map.of("level", 0.25));
      homes.clock.run(A_WHILE);
      assertThat(trouble.happened().test(homes)).as("after").isTrue();
    }
  }

  @ParameterizedTest
  @EnumSource(Deed.class)
  @Tag("full")
  void happensAtRandom(Deed deed) {
    Trouble trouble = trouble(deed);
    try (Homes homes = new Homes(trouble.home(), trouble.scene(), 1, scene -> scene)) {
      trouble.prepared().accept(homes);
      homes.simulated.let(trouble.subject(), trouble.fault("every 3"));
      boolean happened = false;
      for (int tries = 0; tries < MOST_TRIES && !happened; tries++) {
        homes.clock.run(A_WHILE);
        happened = trouble.happened().test(homes);
      }
      assertThat(happened).isTrue();
    }
  }

  /** Dims the lamp to another level than it has. */
  private static Outcome dimmed(Homes homes) {
    double level = homes.world().lampLevel("lamp-b1") == 1 ? 0.5 : 1;
    return homes
        .call("lamp-b1", "adjustLight", Map.of("level", level))
        .result()
        .orElseThrow()
        .outcome();
  }

  /** How often the result of one call comes over the bus. */
  private static int answers(Homes homes) {
    AtomicInteger results = new AtomicInteger();
    Transport witness = homes.bus.client("witness");
    try {
      witness.subscribe(
          new Topics("test").results("+"),
          Transport.RetainedMessages.IGNORE,
          message -> results.incrementAndGet());
      witness.open(Optional.empty(), DEAF);
      homes.clock.run(A_WHILE);
      dimmed(homes);
      homes.clock.run(A_WHILE);
    } finally {
      witness.close();
    }
    return results.get();
  }

  private static double seconds(Homes homes) {
    Duration begun = homes.clock.now();
    dimmed(homes);
    return homes.clock.now().minus(begun).toMillis() / 1e3;
  }

  /** What the sensor measures against the truth. */
  private static double measured(Homes homes) {
    Object lux = homes.call("lux-b", "measureIllumination", Map.of()).values().get("lux");
    return ((Number) lux).doubleValue() / homes.world().lux("zone-b");
  }

  private static Outcome moved(Homes homes) {
    String elsewhere =
        homes.world().zone("rose").filter("zone-b"::equals).isPresent() ? "zone-a" : "zone-b";
    return homes
        .call("rose", "move", Map.of("to", Homes.ref(elsewhere)))
        .result()
        .orElseThrow()
        .outcome();
  }

  private static MemberStatus.Phase phase(Homes homes) {
    return homes.link.members().stream()
        .filter(member -> member.id().equals("lamp-b1"))
        .findFirst()
        .orElseThrow()
        .phase();
  }

  /** Where there is most of it upon the floor. */
  private static double daylight(Homes homes) {
    double most = 0;
    for (double x = 0.2; x < 8.4; x += 0.2) {
      for (double y = 0.2; y < 3; y += 0.2) {
        Position place = Position.onFloor(new Point2(x, y));
        most = Math.max(most, homes.world().daylightWithOpenShutters(place));
      }
    }
    return most;
  }

  private static boolean isAt(Homes homes, String body, Point2 place) {
    return homes.world().position(body).orElseThrow().floor().distance(place) < 1e-9;
  }
}
