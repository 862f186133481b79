package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.assembly.PastDays;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;

/** The introduction of ADE (1), sentence by sentence: A1, A3, A4, A5, A6. */
class EveningTest {
  private static final String HELLO = "Hello Dave, I hope you had a good day at work.";
  private static final String WISH = "Dave, what would you like for dinner?";
  private static final String LATER =
      "Dave, would you like me to hold off on heating dinner for a while?";
  private static final String READY = "Dinner is ready.";

  @TempDir Path data;

  @Test
  void daveComesHomeAndHasAScotchAndDinnerHalfAnHourLater() {
    try (EveningStage evening = comingHome()) {
      Stage stage = evening.stage();
      Speaker dave = stage.speaker("Dave").in("hallway");
      untilHeSits(evening);

      dave.says("I'd like a scotch, please.")
          .means("(initCNP (:goal (served Scotch Dave)))")
          .isReached();
      assertThat(evening.setting("bar", "drink")).isEqualTo("Scotch");
      dave.awaits(LATER);
      dave.says("Yes, half an hour.").isAnAnswer();
      Duration agreed = stage.clock().now();
      stage.run(Duration.ofMinutes(29));
      assertThat(evening.said(READY)).isEmpty();
      assertThat(evening.setting("microwave", "food")).isEmpty();
      evening.awaitSaid(READY);

      assertThat(evening.said(LATER)).hasSize(1);
      assertThat(evening.said(READY))
          .singleElement()
          .satisfies(
              said ->
                  assertThat(said.at().minus(agreed))
                      .isBetween(Duration.ofMinutes(30), Duration.ofMinutes(37)));
      dinnerIsThere(evening);
    }
  }

  @Test
  @Tag("full")
  void afterAWineDinnerGoesOnAndNobodyIsAsked() {
    try (EveningStage evening = comingHome()) {
      Stage stage = evening.stage();
      Speaker dave = stage.speaker("Dave").in("hallway");
      untilHeSits(evening);

      Duration asked = stage.clock().now();
      dave.says("I'd like a glass of wine, please.")
          .means("(initCNP (:goal (served Wine Dave)))")
          .isReached();
      evening.awaitSaid(READY);

      assertThat(stage.clock().now().minus(asked)).isLessThan(Duration.ofMinutes(10));
      assertThat(evening.said(LATER)).isEmpty();
      dinnerIsThere(evening);
    }
  }

  @Test
  void anotherHistoryGivesAnotherShowAndWhatIsNotThereIsNotHeated() {
    PastDays past =
        PastDays.read(
            """
            1..7\t1\t(wentTo Dave livingroom)
            1..7\t2\t(watched Dave Opera)
            1..7\t3\t(dined Dave)
            """);
    try (EveningStage evening = EveningStage.of(data, past, "homecoming")) {
      Stage stage = evening.stage();
      Speaker dave = stage.speaker("Dave").in("hallway");
      dave.awaits(WISH);
      stage.await("the opera is on", () -> evening.setting("tv", "selection").equals("Opera"));

      dave.says("The lasagne.").isAnAnswer();
      dave.awaits("I am sorry, the lasagne is not there. Would you like the pasta?");
      dave.says("Yes, please.").isAnAnswer();
      dave.awaits("I am beginning to heat the pasta.");
    }
  }

  private EveningStage comingHome() {
    return EveningStage.of(data, PastDays.shipped("evening"), "homecoming");
  }

  /** Until Dave is in the living room, and dinner is being heated. */
  private static void untilHeSits(EveningStage evening) {
    Stage stage = evening.stage();
    Speaker dave = stage.speaker("Dave");
    evening.awaitSaid(HELLO);
    assertThat(evening.said(HELLO).get(0).to()).isEqualTo("hallway");
    assertThat(stage.knowledge()).knows("(in Dave hallway)").knows("(wasOpened front-door)");
    stage.await(
        "the room is asked for",
        () -> evening.isTold("asks for: the script (prepareRoom livingroom Dave)"));

    stage.await("the living room is light", () -> stage.world().lux("livingroom") >= 150);
    stage.await("the news are on", () -> evening.setting("tv", "selection").equals("EveningNews"));
    assertThat(evening.isOn("tv")).isTrue();
    assertThat(stage.world().zone("Dave")).as("he is not there yet").contains("hallway");

    dave.awaits(WISH);
    assertThat(evening.isTold("asks for: the script (seeToDinner Dave)")).isTrue();
    dave.says("The pasta, please.").isAnAnswer();
    dave.awaits("I am beginning to heat the pasta.");
    stage.await("he sits", () -> stage.world().zone("Dave").equals(Optional.of("livingroom")));
    stage.run(Duration.ofSeconds(15));
    assertThat(stage.knowledge()).knows("(in Dave livingroom)");
    dave.in("livingroom");
  }

  private static void dinnerIsThere(EveningStage evening) {
    Stage stage = evening.stage();
    assertThat(evening.said(READY).get(0).to()).isEqualTo("livingroom");
    assertThat(evening.said(HELLO)).hasSize(1);
    assertThat(evening.setting("microwave", "food")).as("warm").isEqualTo("pasta-1");
    assertThat(stage.world()).hasInZone("pasta-1", "kitchen").hasInSight("pasta-1");
    assertThat(stage.world()).hasLampAt("hall-lamp", 0).hasLampAt("bed-lamp", 0);
    for (String device : List.of("oven", "hob", "stereo", "microwave")) {
      assertThat(evening.isOn(device)).as(device).isFalse();
    }
    assertThat(evening.isOn("tv")).isTrue();
    assertThat(stage.world().isOpen("front-door")).isFalse();
  }
}
