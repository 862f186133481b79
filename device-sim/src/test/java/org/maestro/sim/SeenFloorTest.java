package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.hal.Surroundings;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;

/**
 * A robot knows what it has seen, and no more: Rose stands in the lower corner of zone-b, whence no
 * sight leads through the door to where Bob is.
 */
class SeenFloorTest {
  private static final Position BEHIND_THE_WALL = new Position(0.8, 1.2, 0);
  private static final Position BEHIND_THE_DOOR = new Position(2.4, 2.35, 0);

  private final Homes homes =
      new Homes(
          "bob", "bob-lit", 1, scene -> scene.with("Bob", scene.of("Bob").at(BEHIND_THE_WALL)));

  @AfterEach
  void close() {
    homes.close();
  }

  private Surroundings floor() {
    return homes.simulated.drivers("rose").find(Surroundings.class).orElseThrow();
  }

  private List<String> known() {
    return names(floor());
  }

  private static List<String> names(Surroundings floor) {
    return floor.obstacles().stream().map(Obstacle::name).sorted().toList();
  }

  private Result move(String zone) {
    return homes.call("rose", "move", Map.of("to", Homes.ref(zone))).result().orElseThrow();
  }

  private void put(String thing, Position place) {
    homes.world().moveByHand(thing, place);
  }

  @Test
  void nobodyIsSeenThroughAWall() {
    assertThat(known()).containsExactly("Cup");

    assertThat(move("zone-a").outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(known()).containsExactly("Bob", "Cup");
  }

  @Test
  void whatWasSeenIsTakenToBeThereUntilItsPlaceIsSeenEmpty() {
    assertThat(known()).contains("Cup");
    put("rose", new Position(0.5, 0.5, 0));
    put("Cup", new Position(3.3, 0.3, 0));

    assertThat(floor().obstacles())
        .filteredOn(body -> body.name().equals("Cup"))
        .extracting(Obstacle::middle)
        .containsExactly(new Point2(5.2, 2.2));
    assertThat(names(floor().inView())).containsExactly("Bob");

    put("rose", new Position(2.5, 2.35, 0));
    assertThat(known()).doesNotContain("Cup");
  }

  @Test
  void whoMovesIsNotTakenToBeThereForLong() {
    move("zone-a");
    assertThat(known()).contains("Bob");
    put("Bob", new Position(0.8, 2.4, 0));
    assertThat(known()).contains("Bob");
    move("zone-b");
    put("rose", new Position(4, 0.8, 0));

    assertThat(known()).contains("Bob");
    homes.clock.run(Duration.ofSeconds(11));
    assertThat(known()).doesNotContain("Bob");
  }

  @Test
  void aDoorIsOpenUntilItIsSeenClosed() {
    put("rose", new Position(5.6, 0.4, 0));
    int open = floor().walls().size();
    homes.world().setDoor("door-ab", false);

    assertThat(floor().walls()).hasSizeLessThan(open);
    homes.world().setDoor("door-ab", true);
    assertThat(floor().walls()).hasSize(open);
  }

  /**
   * Out of sight of the door it drives there, since only that shows whether he still stands there.
   */
  @Test
  void isRefusedForWhatIsSeenNowAlone() {
    put("rose", new Position(3.36, 0.4, 0));
    put("Bob", BEHIND_THE_DOOR);
    Result barred = move("zone-a");

    assertThat(barred.outcome()).isEqualTo(Outcome.FAILED);
    assertThat(barred.error().orElseThrow().message()).contains("Bob stands in it");
    assertThat(homes.world().position("rose").orElseThrow().y()).isGreaterThan(0.5);

    put("Bob", BEHIND_THE_WALL);
    assertThat(move("zone-a").outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  private Result placeAtBob(Runnable before) {
    assertThat(
            homes
                .call("rose", "pick", Map.of("object", homes.at("Cup")))
                .result()
                .orElseThrow()
                .outcome())
        .isEqualTo(Outcome.SUCCEEDED);
    Map<String, Object> bob = new HashMap<>(homes.at("Bob"));
    bob.put("size", "0.5 0.5 1.2");
    put("rose", new Position(2, 2.35, 0));
    before.run();
    return homes
        .call("rose", "place", Map.of("object", Homes.ref("Cup"), "target", bob))
        .result()
        .orElseThrow();
  }

  /** He is where he was told to be when it sets out, and walks on before its eyes. */
  @Test
  void comesAfterWhoWalksOn() {
    Result placed =
        placeAtBob(
            () ->
                homes.clock.schedule(
                    Duration.ofMillis(800), "Bob", () -> put("Bob", new Position(0.8, 0.5, 0))));

    assertThat(placed.outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(homes.world().isNextTo("Cup", "Bob")).isTrue();
  }

  @Test
  void placesNothingBesideWhoIsThereNoMore() {
    Result gone = placeAtBob(() -> put("Bob", new Position(5.5, 0.4, 0)));

    assertThat(gone.outcome()).isEqualTo(Outcome.FAILED);
    assertThat(gone.error().orElseThrow().message())
        .isEqualTo("Cannot place Cup at Bob: Bob is not there any more.");
    assertThat(homes.world().holder("Cup")).contains("rose");
  }

  /** A point has no size, and nothing needs to stand there. */
  @Test
  void placesAtAMerePoint() {
    homes.call("rose", "pick", Map.of("object", homes.at("Cup")));
    Map<String, Object> point =
        Map.of(
            "ref",
            "https://w3id.org/maestro/home/bob#at_4_1.5",
            "position",
            List.of(4.0, 1.5, 0.0));

    assertThat(
            homes
                .call("rose", "place", Map.of("object", Homes.ref("Cup"), "target", point))
                .result()
                .orElseThrow()
                .outcome())
        .isEqualTo(Outcome.SUCCEEDED);
  }
}
