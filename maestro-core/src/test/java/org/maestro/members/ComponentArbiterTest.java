package org.maestro.members;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.HeldElsewhere;

/** Which of several managers may use which components of one robot. */
class ComponentArbiterTest {
  private final List<String> said = new ArrayList<>();
  private final ComponentArbiter arbiter =
      new ComponentArbiter(
          new ComponentArbiter.Managers() {
            @Override
            public void askToYield(String holder, String by, ComponentWant want) {
              said.add("%s yields to %s of %s".formatted(holder, want.goalId(), by));
            }

            @Override
            public void wantedNoMore(String holder, String goalId) {
              said.add("%s: %s wants no more".formatted(holder, goalId));
            }

            @Override
            public void got(String manager, Set<String> components) {
              said.add("%s got %s".formatted(manager, new TreeSet<>(components)));
            }
          });

  private Optional<HeldElsewhere> use(String manager, String... components) {
    return arbiter.use(manager, manager + "-1", Set.of(components), true);
  }

  private void want(String manager, int priority, String... components) {
    arbiter.want(
        manager,
        new ComponentWant(
            manager + "-1",
            new GoalPriority(priority, Optional.empty(), 0),
            "rose",
            Set.of(components)));
  }

  @Test
  void theFirstThatUsesAComponentHasItAndNothingIsSaid() {
    assertThat(use("kitchen", "arm", "base")).isEmpty();
    arbiter.used(Set.of("arm", "base"));

    assertThat(use("garden", "base")).contains(new HeldElsewhere("kitchen", "kitchen-1"));
    assertThat(use("garden", "camera")).isEmpty();
    assertThat(use("kitchen", "base")).isEmpty();
    assertThat(said).isEmpty();
  }

  @Test
  void whoGivesItBackIsFollowedByWhoGoesFirst() {
    use("kitchen", "arm");
    want("garden", 0, "arm");
    want("house", 5, "arm");
    arbiter.giveBack("kitchen", Set.of("arm"));
    arbiter.giveBack("house", Set.of("arm"));

    assertThat(said)
        .containsExactly(
            "kitchen yields to garden-1 of garden",
            "kitchen yields to house-1 of house",
            "house got [arm]",
            "house yields to garden-1 of garden",
            "garden got [arm]");
  }

  @Test
  void ofEqualsWhoAskedFirstGoesFirst() {
    use("kitchen", "arm");
    want("house", 0, "arm");
    want("garden", 0, "arm");
    arbiter.giveBack("kitchen", Set.of("arm"));

    assertThat(said).contains("house got [arm]").doesNotContain("garden got [arm]");
  }

  /** Else who wants two things would wait for ever while others take the one or the other. */
  @Test
  void allIsGotAtOnceAndWhatIsFreeWaitsForWhoGoesFirst() {
    use("kitchen", "arm");
    want("house", 5, "arm", "base");
    want("garden", 0, "base");

    assertThat(said).containsExactly("kitchen yields to house-1 of house");
    arbiter.giveBack("kitchen", Set.of("arm"));
    assertThat(said).contains("house got [arm, base]").doesNotContain("garden got [base]");
  }

  @Test
  void whoWantsItNoMoreIsForgottenAndTheHolderIsTold() {
    use("kitchen", "arm");
    want("garden", 0, "arm");
    arbiter.wantNoMore("garden", "garden-1");
    arbiter.giveBack("kitchen", Set.of("arm"));

    assertThat(said)
        .containsExactly("kitchen yields to garden-1 of garden", "kitchen: garden-1 wants no more");
    assertThat(use("house", "arm")).isEmpty();
  }

  @Test
  void whatIsStillAtWorkForWhoIsGoneIsNobodysBeforeItsEnd() {
    use("kitchen", "arm");
    want("garden", 0, "arm");
    arbiter.gone("kitchen");

    assertThat(said).doesNotContain("garden got [arm]");
    assertThat(use("house", "arm")).isPresent();
    arbiter.used(Set.of("arm"));
    assertThat(said).contains("garden got [arm]");
  }

  @Test
  void whoWasTakenForGoneAndSpeaksAgainIsThere() {
    use("kitchen", "arm");
    arbiter.gone("kitchen");
    use("kitchen", "arm");
    arbiter.used(Set.of("arm"));
    arbiter.used(Set.of("arm"));

    assertThat(use("garden", "arm")).contains(new HeldElsewhere("kitchen", "kitchen-1"));
  }
}
