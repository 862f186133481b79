package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.maestro.junit.MaestroAssertions;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;
import org.maestro.sim.world.Talk;
import org.slf4j.LoggerFactory;

/** A room with what any room has, of one file (A71). */
@ResourceLock("the log of rooms")
@MaestroTest(home = "parlour", scene = "parlour")
class ParlourTest {
  private static final String DEAF =
      "There is a problem with my speech recognition, so you will need to use the keyboard"
          + " interface.";

  private static final String ON = "I will turn on the light.";

  private final Logger speech = (Logger) LoggerFactory.getLogger("org.maestro.agents.rooms");
  private final ListAppender<ILoggingEvent> log = new ListAppender<>();

  @BeforeEach
  void listenToTheLog() {
    speech.setLevel(Level.DEBUG);
    log.start();
    speech.addAppender(log);
  }

  @AfterEach
  void leaveTheLog() {
    speech.detachAppender(log);
    speech.setLevel(Level.WARN);
  }

  @Test
  void howWarmItIsIsAskedAndSet(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("parlour");
    dave.says("how warm is it in the parlour?")
        .means("(query-ref (:value (temperature parlour)))")
        .replies("19 °C.");
    dave.says("set the temperature to 22 degrees").isReached();

    stage.run(Duration.ofHours(3));

    assertThat(stage.world().celsius("parlour")).isBetween(21.7, 22.3);
    dave.says("is the parlour warmer than 21 degrees?")
        .means("(query-if (> (temperature parlour) 21))")
        .replies("Yes.");
  }

  /**
   * Light, motion, temperature and microphone; switch, thermostat, shades and loudspeaker; goals,
   * knowledge and scripts, without any other agent that manages goals.
   */
  @Test
  void aRoomOfOneFileHasWhatAnyRoomHas(Stage stage) {
    stage.run(Duration.ofSeconds(2));
    MaestroAssertions.assertThat(stage.knowledge())
        .knows("(presence radar)")
        .knows("(> (temperature parlour) 18.5)")
        .knows("(= (opening blind) 1)")
        .knows("(= (targetTemperature parlour) 19)")
        .knows("(prefers evening-news EveningNews)");
    assertThat(stage.goal("(>= (illuminance parlour) 100)").reached())
        .as("by the switch, and seen by the light sensor")
        .isTrue();
    MaestroAssertions.assertThat(stage.knowledge())
        .knows("(= (level lamp) 1)")
        .knows("(>= (illuminance parlour) 100)");
    assertThat(stage.goal("(settleDown)").reached()).isTrue();
    MaestroAssertions.assertThat(stage.knowledge())
        .knows("(= (opening blind) 0)")
        .knows("(= (targetTemperature parlour) 22)");

    stage.platform().endAgent("CCA");
    stage.world().talk().say("Dave", "turn off the light");
    stage.await("the light is off", () -> stage.world().lampLevel("lamp") == 0);
    stage.await("an answer", () -> heard(stage).equals(List.of("I will turn off the light.")));
  }

  /** What a loudspeaker of the room has said. */
  private static List<String> heard(Stage stage) {
    return stage.world().talk().sounded().stream().map(Talk.Sounded::text).toList();
  }

  /** The stations of figure 3 of the ADE paper (A51), each with its number. */
  private static List<String> stations(ListAppender<ILoggingEvent> log) {
    return new ArrayList<>(log.list)
        .stream()
            .filter(event -> event.getLevel() == Level.DEBUG)
            .map(event -> event.getFormattedMessage().split(" ", 3)[2])
            .toList();
  }

  @Test
  void whatAMicrophoneHearsIsDoneWhileItIsSaidAndAnsweredAloud(Stage stage) {
    stage.run(Duration.ofSeconds(2));
    stage.world().talk().say("Dave", "turn on the light please");

    stage.await("an answer", () -> stations(log).contains("10 " + ON));

    assertThat(stage.world().lampLevel("lamp")).isEqualTo(1);
    assertThat(heard(stage)).containsExactly(ON);
    assertThat(stations(log))
        .as("a word that was heard otherwise at first, and each but the last before it is said")
        .containsExactly(
            "1 tarn",
            "1 turn un",
            "1 turn on the",
            "1 turn on the light",
            "2 G1 is begun",
            "3 looks at lamp",
            "4 nods",
            "1 turn on the light please",
            "1 turn on the light please.",
            "5 (initCNP (:goal (= (level lamp) 1)))",
            "6 G1",
            "9 " + ON,
            "10 " + ON);
  }

  @Test
  void whatIsAskedAloudIsAnsweredAloud(Stage stage) {
    stage.run(Duration.ofSeconds(2));
    stage.world().talk().say("Dave", "how warm is it");

    stage.await("an answer", () -> !heard(stage).isEmpty());

    assertThat(heard(stage)).singleElement().isEqualTo("19 °C.");
  }

  /** The microphone dies between two sentences (A38), and comes back. */
  @Test
  void whoHearsNoMoreSaysSoAndHearsAgainWhenTheMicrophoneIsBack(Stage stage) {
    stage.run(Duration.ofSeconds(2));
    Speaker dave = stage.speaker("Dave").in("parlour");
    stage.kill("microphone");

    dave.awaits(DEAF);
    stage.await("the sentence is spoken", () -> heard(stage).equals(List.of(DEAF)));
    assertThat(new ArrayList<>(log.list))
        .filteredOn(event -> event.getLevel() == Level.WARN)
        .singleElement()
        .satisfies(
            event -> assertThat(event.getFormattedMessage()).contains("microphone").endsWith(DEAF));

    stage.revive("microphone");
    stage.run(Duration.ofSeconds(70));
    stage.world().talk().say("Dave", "turn on the light");
    stage.await("the light is on", () -> stage.world().lampLevel("lamp") == 1);
  }

  @Test
  void aMicrophoneThatIsBackSoonIsNotMissed(Stage stage) {
    stage.run(Duration.ofSeconds(2));
    stage.kill("microphone");
    stage.run(Duration.ofSeconds(3));
    stage.revive("microphone");
    stage.run(Duration.ofSeconds(70));
    stage.world().talk().say("Dave", "turn on the light");

    stage.await("the light is on", () -> stage.world().lampLevel("lamp") == 1);
    stage.run(Duration.ofSeconds(5));
    assertThat(heard(stage)).containsExactly(ON);
  }
}
