package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.assertj.core.api.Assertions;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.RatsError;

/**
 * Impatience and acquiescence as in ALLIANCE (Three-layered architecture, 3.2.1; M43, M44): who
 * could do a running task for less offers to, who fails gives back, and the holder of the contract
 * decides. Never two are at it.
 */
@MaestroTest(home = "bob", scene = "bob-lit")
class TakeoverTest {

  private static final String WISH = "(nextTo Cup Bob)";

  private final List<String> log = new ArrayList<>();
  private int atWork;
  private int mostAtWork;

  @Test
  void theFasterBandAssumesTheTaskOnceItIsFree(Stage stage) {
    stage.kill("rose");
    Band slow = new Band(stage, "band-slow", 40);
    Band fast = new Band(stage, "band-fast", 3);
    fast.blocked = true;
    slow.join();
    fast.join();
    Pursuit pursuit = stage.begin(WISH).awaitTelling("band-slow wafts Cup to Bob");
    stage.await("the slow band is at it", () -> atWork == 1);
    stage.run(Duration.ofSeconds(4));
    fast.unblock();

    GoalOutcome outcome = pursuit.await();

    assertThat(outcome)
        .isReached()
        .isConfirmed()
        .tells("band-fast offers to do for 3")
        .tells("band-fast wafts Cup to Bob");
    assertThat(stage.world()).hasNextTo("Cup", "Bob");
    Assertions.assertThat(log)
        .as(outcome.storyText())
        .containsExactly(
            "band-slow begins", "band-slow stops", "band-fast begins", "band-fast is done");
    Assertions.assertThat(mostAtWork).isEqualTo(1);
  }

  @Test
  void whoIsNearlyDoneKeepsItsTask(Stage stage) {
    stage.kill("rose");
    Band slow = new Band(stage, "band-slow", 8);
    Band fast = new Band(stage, "band-fast", 3);
    fast.blocked = true;
    slow.join();
    fast.join();
    Pursuit pursuit = stage.begin(WISH);
    stage.await("the slow band is at it", () -> atWork == 1);
    stage.run(Duration.ofSeconds(6));
    fast.unblock();

    assertThat(pursuit.await()).isReached();
    Assertions.assertThat(log).containsExactly("band-slow begins", "band-slow is done");
  }

  @Test
  void whoIsStuckAndSaysNothingIsRelieved(Stage stage) {
    stage.kill("rose");
    Band stuck = new Band(stage, "band-stuck", 2);
    Band other = new Band(stage, "band-other", 5);
    stuck.isStuck = true;
    stuck.join();
    other.join();

    GoalOutcome outcome = stage.goal(WISH);

    assertThat(outcome).isReached().tells("band-other offers to do it for 5");
    Assertions.assertThat(log)
        .containsExactly(
            "band-stuck begins", "band-stuck stops", "band-other begins", "band-other is done");
    Assertions.assertThat(mostAtWork).isEqualTo(1);
  }

  @Test
  void whoJamsGivesItBackAndAnotherGetsIt(Stage stage) {
    stage.kill("rose");
    Band jammed = new Band(stage, "band-jammed", 4);
    Band other = new Band(stage, "band-other", 9);
    jammed.jams = true;
    jammed.join();
    other.join();

    GoalOutcome outcome = stage.goal(WISH);

    assertThat(outcome)
        .isReached()
        .tells("band-jammed gives step")
        .tells("the belt is torn")
        .tells("band-other wafts Cup to Bob");
    Assertions.assertThat(log)
        .containsExactly(
            "band-jammed begins", "band-jammed stops", "band-other begins", "band-other is done");
    Assertions.assertThat(mostAtWork).isEqualTo(1);
  }

  /** Its call has ended long before for the one who made it. */
  @Test
  void anAlarmThatComesLateIsTold(Stage stage) {
    stage.kill("rose");
    Band hung = new Band(stage, "band-hung", 2);
    Band other = new Band(stage, "band-other", 150);
    hung.isStuck = true;
    hung.neverStops = true;
    hung.join();
    other.join();

    GoalOutcome outcome = stage.goal(WISH);

    assertThat(outcome)
        .isReached()
        .tells("band-hung gave no answer in time")
        .tells("band-hung raises an alarm: The exit strategy of waft did not end within 60 s");
  }

  /** Carries what lies anywhere to a person; its stopping takes two seconds. */
  private final class Band implements Procedure {
    private final Stage stage;
    private final String id;
    private final double seconds;
    private boolean blocked;
    private boolean isStuck;
    private boolean neverStops;
    private boolean jams;
    private boolean torn;
    private RatsMember member;

    Band(Stage stage, String id, double seconds) {
      this.stage = stage;
      this.id = id;
      this.seconds = seconds;
    }

    void join() {
      MemberProfile.Feature waft =
          new MemberProfile.Feature(
              "waft", Set.of(), Set.of("belt"), false, Optional.empty(), "busy", this);
      MemberProfile profile =
          new MemberProfile(
                  id,
                  NewDeviceTest.BAND.replace("#band-1", "#" + id),
                  Set.of("calm", "busy"),
                  "calm",
                  Set.of("calm"),
                  Map.of("waft", waft))
              .takingOver(Set.of("waft"));
      member = stage.join(profile, List::of);
      stage.await(id + " joined", () -> stage.platform().presentMembers().contains(id));
      if (blocked) {
        onItsThread(() -> member.disable("waft", "something lies on the belt"));
      }
    }

    void unblock() {
      blocked = false;
      onItsThread(() -> member.enable("waft"));
    }

    private void onItsThread(Runnable action) {
      stage.clock().schedule(Duration.ZERO, id, action);
      stage.run(Duration.ofMillis(50));
    }

    @Override
    public void start(Execution execution) {
      note("begins", 1);
      execution.onCancel(
          safe ->
              later(
                  neverStops ? 10_000 : 2,
                  () -> {
                    note("stops", -1);
                    safe.run();
                  }));
      if (jams) {
        later(1, () -> giveBack(execution));
      } else if (!isStuck) {
        later(seconds, () -> deliver(execution));
      }
    }

    private void giveBack(Execution execution) {
      torn = true;
      member.disable("waft", "the belt is torn");
      execution.giveBack(
          new RatsError(
              ErrorCode.HARDWARE_FAILURE,
              RatsError.Level.WARNING,
              "the belt is torn",
              Optional.empty(),
              List.of(),
              false));
    }

    private void deliver(Execution execution) {
      if (!execution.ended()) {
        Position bob = stage.world().position("Bob").orElseThrow();
        stage.world().moveByHand("Cup", new Position(bob.x() + 0.4, bob.y(), 0));
        note("is done", -1);
        execution.succeed(Map.of());
      }
    }

    private void later(double after, Runnable action) {
      stage.clock().schedule(Duration.ofMillis((long) (after * 1_000)), id, action);
    }

    private void note(String what, int more) {
      log.add(id + " " + what);
      atWork += more;
      mostAtWork = Math.max(mostAtWork, atWork);
    }

    @Override
    public CostAnswer cost(Map<String, Object> parameters) {
      return blocked || torn
          ? new CostAnswer(Optional.empty(), Optional.empty(), Optional.of("the belt is blocked"))
          : new CostAnswer(Optional.of(seconds), Optional.of(seconds), Optional.empty());
    }
  }
}
