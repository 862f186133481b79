package org.maestro.sim.life;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Completion;
import org.maestro.hal.MobileBase;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.home.Home;
import org.maestro.sim.Homes;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.World;

/** What persons do who go about of their own accord. */
class LifeTest {
  private static final Home BOB = Homes.home("bob");
  private static final Duration LOOK = Duration.ofMillis(50);

  private static Homes lived(String said, long seed) {
    String turtle =
        "@prefix scene: <%s> .\n<#rose> scene:position \"4 0.8 0\" .\n%s"
            .formatted(SceneLoader.NAMESPACE, said);
    return new Homes(
        BOB,
        SceneLoader.load(
            "x.ttl", new ByteArrayInputStream(turtle.getBytes(StandardCharsets.UTF_8)), BOB),
        seed);
  }

  private static Homes lived(long seed) {
    return lived(
        """
        <#Bob> scene:position "0.8 2.1 0" ; scene:radius 0.25 ; scene:roams 10 .
        <#Cup> scene:position "5.2 2.2 0" ; scene:radius 0.04 ; scene:mass 0.25 .
        """,
        seed);
  }

  @Test
  void goesThroughTheDoorAndStandsInItAndCarriesThings() {
    try (Homes homes = lived(1)) {
      World world = homes.world();
      List<WorldEvent> deeds = new ArrayList<>();
      world.listen(deeds::add);
      Set<String> zones = new TreeSet<>();
      boolean stoodInDoor = false;
      for (int minute = 0; minute < 20 * 60; minute++) {
        homes.clock.run(Duration.ofSeconds(1));
        world.zone("Bob").ifPresent(zones::add);
        stoodInDoor |=
            place(world, "Bob").distance(new Point2(3, 2.35)) < 0.01
                && world.whereabouts().drive("Bob").isEmpty();
      }

      assertThat(zones).containsExactly("zone-a", "zone-b");
      assertThat(stoodInDoor).isTrue();
      assertThat(deeds)
          .filteredOn(deed -> deed.thing().equals(Optional.of("Cup")))
          .extracting(WorldEvent::kind)
          .startsWith(WorldEvent.Kind.PICKED, WorldEvent.Kind.PLACED, WorldEvent.Kind.PICKED);
    }
  }

  @Test
  void livesTheSameLifeForTheSameSeed() {
    assertThat(path(3)).isEqualTo(path(3)).isNotEqualTo(path(4));
  }

  private static List<Position> path(long seed) {
    List<Position> path = new ArrayList<>();
    try (Homes homes = lived(seed)) {
      for (int minute = 0; minute < 60; minute++) {
        homes.clock.run(Duration.ofSeconds(5));
        path.add(homes.world().position("Bob").orElseThrow());
      }
    }
    return path;
  }

  /** A door that is closed stays closed, and nobody goes through walls. */
  @Test
  void staysWhereNoDoorIsOpen() {
    try (Homes homes =
        lived(
            """
            <#Bob> scene:position "0.8 2.1 0" ; scene:radius 0.25 ; scene:roams 5 .
            <#door-ab> scene:open false .
            """,
            1)) {
      Set<Point2> places = new HashSet<>();
      for (int second = 0; second < 10 * 60; second++) {
        homes.clock.run(Duration.ofSeconds(1));
        places.add(place(homes.world(), "Bob"));
        assertThat(homes.world().zone("Bob")).contains("zone-a");
      }
      assertThat(places).hasSizeGreaterThan(20);
    }
  }

  /** A robot that drives all the time, where Bob does as he likes: neither touches the other. */
  @Test
  void nobodyIsRunInto() {
    for (long seed = 1; seed <= 5; seed++) {
      try (Homes homes =
          lived(
              """
              <#Bob> scene:position "0.8 2.1 0" ; scene:radius 0.25 ; scene:roams 2 .
              <#Cup> scene:position "5.2 2.2 0" ; scene:radius 0.04 ; scene:mass 0.25 .
              """,
              seed)) {
        World world = homes.world();
        MobileBase base = homes.simulated.drivers("rose").find(MobileBase.class).orElseThrow();
        Random random = new Random(seed);
        double nearest = Double.POSITIVE_INFINITY;
        int drives = 0;
        for (long at = 0; at < 600_000; at += LOOK.toMillis()) {
          if (world.whereabouts().drive("rose").isEmpty()) {
            base.drive(List.of(somewhere(random)), ignored());
            drives++;
          }
          homes.clock.run(LOOK);
          nearest = Math.min(nearest, world.distance("rose", "Bob") - world.radius("rose") - 0.25);
        }
        assertThat(drives).as("seed %d", seed).isGreaterThan(100);
        assertThat(nearest).as("seed %d", seed).isBetween(-0.02, 0.1);
      }
    }
  }

  private static Point2 somewhere(Random random) {
    return new Point2(0.4 + 5.2 * random.nextDouble(), 0.4 + 2.2 * random.nextDouble());
  }

  private static Completion ignored() {
    return new Completion() {
      @Override
      public void done() {}

      @Override
      public void failed(String reason) {}
    };
  }

  private static Point2 place(World world, String name) {
    return world.position(name).orElseThrow().floor();
  }
}
