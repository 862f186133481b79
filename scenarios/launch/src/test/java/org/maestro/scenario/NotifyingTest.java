package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.Speech;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;

/** Who asks to be told when something is so is told once, when it is. */
@MaestroTest(home = "evening", scene = "evening")
class NotifyingTest {

  @Test
  void itIsToldOnceWhenItIsSo(Stage stage) {
    List<Speech> heard = new CopyOnWriteArrayList<>();
    stage.platform().desk().whenSaid(heard::add);
    Speaker dave = stage.speaker("Dave").in("livingroom");
    dave.says("let me know when the hall light is on")
        .means(
            """
            (once (> (level hall-lamp) 0)
              (perform (:script tell) (:to Dave) (:text (> (level hall-lamp) 0))))""");
    stage.run(Duration.ofMinutes(1));
    dave.hasHeardNothing();

    assertThat(stage.goal("(= (level hall-lamp) 1)")).isReached();
    dave.awaits("The hall light is on.");
    assertThat(stage.goal("(= (level hall-lamp) 0)")).isReached();
    assertThat(stage.goal("(= (level hall-lamp) 1)")).isReached();
    stage.run(Duration.ofMinutes(1));

    assertThat(heard).extracting(Speech::text).containsExactly("The hall light is on.");
  }

  @Test
  void whatIsSoAlreadyIsToldAtOnce(Stage stage) {
    assertThat(stage.goal("(= (level hall-lamp) 1)")).isReached();
    Speaker rose = stage.speaker("Rose").in("kitchen");

    rose.says("tell me as soon as the hall light is on").isReached();
    rose.awaits("The hall light is on.");
  }
}
