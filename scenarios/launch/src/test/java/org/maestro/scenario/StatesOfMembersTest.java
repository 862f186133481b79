package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;
import org.maestro.knowledge.Instances;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.SlParser;
import org.maestro.sl.Truth;

/**
 * A snapshot of the environment's state has the states of all members (Three-layered architecture,
 * 3.2.2; M49).
 */
@MaestroTest(home = "bob", scene = "bob-dark")
class StatesOfMembersTest {
  @Test
  void whatEachMemberIsAtIsKnownWhileItWorksAndWhenItIsLost(Stage stage) {
    stage.await(
        "all members have told their states",
        () -> isSo(stage, "(forall (?d - Device) (memberState ?d \"standby\"))"));
    assertThat(isSo(stage, "(exists (?d - Device) (busy ?d))")).isFalse();

    Pursuit fetch = stage.begin("(nextTo Cup Bob)").awaitTelling(": rose picks up");
    stage.await("the robot is busy", () -> isSo(stage, "(busy rose)"));
    Snapshot now = stage.knowledge().snapshot();
    assertThat(isSo(now, "(memberState rose \"arm-in-movement\")")).isTrue();
    assertThat(isSo(now, "(and (not (busy lux-a)) (not (inSafeState rose)) (not (lost rose)))"))
        .isTrue();

    stage.kill("lamp-b3");
    stage.await("the lamp is lost", () -> isSo(stage, "(lost lamp-b3)"));
    assertThat(isSo(stage, "(unknown (memberState lamp-b3 \"standby\"))")).isTrue();
    stage.await("the robot carries", () -> isSo(stage, "(in Cup rose)"));

    assertThat(fetch.await().reached()).isTrue();
    stage.await(
        "the robot is at rest", () -> isSo(stage, "(and (not (busy rose)) (not (in Cup rose)))"));
    stage.revive("lamp-b3");
    stage.await("the lamp is back", () -> isSo(stage, "(not (lost lamp-b3))"));
  }

  private static boolean isSo(Stage stage, String condition) {
    return isSo(stage.knowledge().snapshot(), condition);
  }

  private static boolean isSo(Snapshot now, String condition) {
    return new Instances(SlParser.formula(condition), now).truth(SlParser.formula(condition))
        == Truth.TRUE;
  }
}
