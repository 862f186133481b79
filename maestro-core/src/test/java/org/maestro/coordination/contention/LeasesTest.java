package org.maestro.coordination.contention;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.WaitsFor;

class LeasesTest {
  private static final Resource BASE = Resource.component("rose", "base");
  private static final Resource ARM = Resource.component("tim", "arm");
  private static final Resource DOOR = Resource.individual("door-1");

  private final List<String> woken = new ArrayList<>();
  private final Leases leases = new Leases(woken::add);

  @BeforeEach
  void enterGoals() {
    leases.enter("G1", new GoalPriority(0, Optional.empty(), 1));
    leases.enter("G2", new GoalPriority(0, Optional.empty(), 2));
    leases.enter("G3", new GoalPriority(5, Optional.empty(), 3));
  }

  @Test
  void whatOneKeepsTheOtherCannotHave() {
    leases.keep("G1", Set.of(BASE));

    assertThat(leases.obstaclesToKeep("G2", Set.of(BASE, ARM)))
        .containsExactly(new WaitsFor("G2", BASE, "G1"));
    assertThat(leases.obstaclesToKeep("G1", Set.of(BASE, ARM))).isEmpty();
  }

  @Test
  void theFirstInTheQueueIsWokenFirstAndNotOvertaken() {
    leases.keep("G1", Set.of(BASE));
    waitFor("G2", BASE, "G1");
    waitFor("G3", BASE, "G1");
    leases.letGo("G1", Set.of(BASE));

    assertThat(woken).containsExactly("G3", "G2");
    assertThat(leases.obstaclesToKeep("G2", Set.of(BASE)))
        .containsExactly(new WaitsFor("G2", BASE, "G3"));
    assertThat(leases.obstaclesToKeep("G3", Set.of(BASE))).isEmpty();
  }

  @Test
  void aGoalGoesAsEarlyAsTheFirstOfThoseThatWaitForIt() {
    waitFor("G3", BASE, "G1");

    assertThat(leases.standing("G1").priority()).isEqualTo(5);
    assertThat(leases.standingWithout("G1", "G3").priority()).isZero();
  }

  @Test
  void aCircleIsSeen() {
    leases.keep("G1", Set.of(BASE));
    leases.keep("G2", Set.of(ARM));
    waitFor("G1", ARM, "G2");
    assertThat(leases.circle("G1")).isEmpty();

    waitFor("G2", BASE, "G1");
    assertThat(leases.circle("G2")).containsExactly("G2", "G1");
  }

  @Test
  void aDeadMemberLosesWhatItsStepHadAndItsLateReportTakesNothingFromOthers() {
    leases.run("G1", "tim", Set.of(DOOR));
    assertThat(leases.obstaclesToRun("G2", Set.of(DOOR))).hasSize(1);

    leases.lost("tim");
    assertThat(leases.obstaclesToRun("G2", Set.of(DOOR))).isEmpty();

    leases.run("G1", "rose", Set.of(DOOR));
    leases.ended("G1", "tim", Set.of(DOOR));
    assertThat(leases.obstaclesToRun("G2", Set.of(DOOR))).hasSize(1);
  }

  @Test
  void nobodyPassesADoorWhoseDriveIsMovingNorTheOtherWayRound() {
    leases.run("G1", "door-1", Set.of(Resource.component("door-1", "drive")));
    assertThat(leases.obstaclesToRun("G2", Set.of(DOOR))).hasSize(1);
  }

  @Test
  void twoStepsOfOneGoalDoNotShareADoorEither() {
    leases.run("G1", "tim", Set.of(DOOR));

    assertThat(leases.obstaclesToRun("G1", Set.of(DOOR))).hasSize(1);
  }

  private void waitFor(String goal, Resource resource, String holder) {
    leases.waitFor(goal, Set.of(resource), List.of(new WaitsFor(goal, resource, holder)));
  }
}
