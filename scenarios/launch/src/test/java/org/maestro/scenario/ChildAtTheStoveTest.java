package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.assembly.PastDays;
import org.maestro.junit.Stage;

/**
 * A child enters where it is dangerous: the adults are told in the rooms in which they are (A86).
 */
class ChildAtTheStoveTest {
  private static final String ALARM = "Tom is in the kitchen, and the hob is on.";

  @TempDir Path data;

  private EveningStage evening(String... more) {
    return EveningStage.of(data, PastDays.read(""), "evening", more);
  }

  private static List<String> rooms(EveningStage evening) {
    return evening.said(ALARM).stream().map(EveningStage.Said::to).sorted().toList();
  }

  private static void hobIsOn(EveningStage evening) {
    evening.stage().run(Duration.ofSeconds(5));
    assertThat(evening.stage().goal("(switchedOn hob)")).isReached();
  }

  /** Dave is in the living room, Grandma in the bedroom, where no camera is. */
  @Test
  void eachAdultIsToldInTheRoomInWhichHeIsAndAgainOnlyAfterItWasOver() {
    String walks = "<#Tom> scene:fault \"at 60 move 6.8 4.7; at 62 walk 6.8 3.2\" .";
    try (EveningStage evening = evening(walks)) {
      Stage stage = evening.stage();
      hobIsOn(evening);
      stage.await(
          "Tom is in the kitchen", () -> stage.world().zone("Tom").toString().contains("kitchen"));
      stage.run(Duration.ofSeconds(20));

      assertThat(rooms(evening)).contains("bedroom", "livingroom").doesNotHaveDuplicates();
      int told = evening.said(ALARM).size();
      stage.run(Duration.ofSeconds(60));
      assertThat(evening.said(ALARM)).as("he is there still").hasSize(told);

      evening.put("Tom", "hallway");
      stage.run(Duration.ofSeconds(60));
      assertThat(evening.said(ALARM)).as("he has gone").hasSize(told);
      evening.put("Tom", "kitchen");
      stage.run(Duration.ofSeconds(20));
      assertThat(evening.said(ALARM)).as("he is there again").hasSize(2 * told);
    }
  }

  @Test
  void nothingIsSaidWhileNothingIsHotOrWhenAnAdultComes() {
    try (EveningStage evening = evening()) {
      evening.stage().run(Duration.ofSeconds(5));
      evening.put("Tom", "kitchen");
      evening.stage().run(Duration.ofSeconds(40));
      evening.put("Tom", "hallway");
      evening.stage().run(Duration.ofSeconds(60));
      hobIsOn(evening);
      evening.put("Dave", "kitchen");
      evening.stage().run(Duration.ofSeconds(40));

      assertThat(evening.said(ALARM)).isEmpty();
    }
  }

  @Test
  void thatNoAdultIsThereIsToldInTheStory() {
    try (EveningStage evening = evening()) {
      Stage stage = evening.stage();
      hobIsOn(evening);
      for (String gone : List.of("Dave", "Grandma", "Mia")) {
        evening.put(gone, "garden");
      }
      stage.run(Duration.ofSeconds(60));
      evening.put("Tom", "kitchen");

      stage.await(
          "it is told",
          () -> evening.isTold("No adult is known to be at home, who could be told."));
      assertThat(evening.said(ALARM)).isEmpty();
    }
  }
}
