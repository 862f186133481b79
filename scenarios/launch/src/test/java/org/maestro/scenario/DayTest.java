package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.diary.DayReport;
import org.maestro.diary.DaySentences;
import org.maestro.diary.Diary;
import org.maestro.hal.Position;
import org.maestro.junit.MaestroAssertions;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;
import org.maestro.language.Language;
import org.maestro.ontology.home.Home;

/** What is told of a resident's day is what happened in it (ADE, 5; A70). */
@MaestroTest(home = "evening", scene = "evening")
class DayTest {

  private static DayReport report(Stage stage) {
    Diary diary = stage.platform().diary();
    return diary.report("Dave", diary.today(), Set.of()).orElseThrow();
  }

  private static List<DaySentences.Told> told(Stage stage) {
    Home home = stage.knowledge().home();
    return new DaySentences(
            home,
            stage.platform().diary().zone(),
            Language.of(home, Language.spoken(home, Optional.empty())).grammar())
        .of(report(stage));
  }

  private static void see(Stage stage) {
    MaestroAssertions.assertThat(stage.goal("(canSee ?who Dave)")).isReached();
  }

  @Test
  void theDayHasWhereHeWasWhatDevicesDidAndWhatWasAskedFor(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");
    stage.run(Duration.ofMinutes(2));
    see(stage);
    dave.says("Turn off the floor lamp.").isReached();
    stage.run(Duration.ofMinutes(2));
    stage.world().moveByHand("Dave", new Position(7, 3, 0));
    see(stage);
    stage.run(Duration.ofMinutes(5));

    DayReport report = report(stage);
    assertThat(report.stays())
        .extracting(DayReport.Stay::zone)
        .as("each until nobody has seen him for half a minute")
        .containsExactly("livingroom", "kitchen");
    assertThat(report.silences()).hasSize(3);
    assertThat(report.changes())
        .extracting(DayReport.Change::fact)
        .as("what he wished, and that somebody was noticed elsewhere then")
        .containsSubsequence("(= (level floor-lamp) 0)", "(presence motion-kitchen)");
    assertThat(report.requests())
        .extracting(DayReport.Request::goal, DayReport.Request::person)
        .as("the rules of the home begin something, too")
        .startsWith(
            tuple("(canSee ?who Dave)", Optional.empty()),
            tuple("(= (level floor-lamp) 0)", Optional.of("Dave")),
            tuple("(canSee ?who Dave)", Optional.empty()));
    assertThat(told(stage))
        .extracting(DaySentences.Told::text)
        .containsSubsequence(
            "Nobody knows where Dave is.",
            "Somebody asks me to look at Dave.",
            "Dave is in the living room.",
            "As was asked: It is done.",
            "Dave asks me to turn off the floor lamp.",
            "The floor lamp is off.",
            "As was asked: The floor lamp is off. That is what I was told; nobody has seen it.",
            "Nobody knows where Dave is.",
            "Somebody asks me to look at Dave.",
            "Dave is in the kitchen.",
            "As was asked: It is done.",
            "Nobody knows where Dave is.")
        .as("no ids")
        .noneMatch(line -> line.contains("floor-lamp"));
  }
}
