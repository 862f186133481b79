package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.diary.DayReport;
import org.maestro.diary.Diary;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;

/** What a home is for: to be asked, to be operated, to send a robot, and to tell what was (A69). */
@MaestroTest(home = "evening", scene = "evening")
class FourUsesTest {

  @Test
  void itIsAskedOperatedAndSendsARobotAndTellsWhatWas(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");

    dave.says("Is the stereo on?").replies("Yes.");
    dave.says("Turn off the stereo.").isReached();
    dave.says("Bring me the red cup.").isReached();

    Diary diary = stage.platform().diary();
    assertThat(diary.report("Dave", diary.today(), Set.of()).orElseThrow().requests())
        .extracting(DayReport.Request::goal, DayReport.Request::person)
        .containsExactly(
            tuple("(not (switchedOn stereo))", Optional.of("Dave")),
            tuple("(nextTo cup-red Dave)", Optional.of("Dave")));
  }
}
