package org.maestro.coordination.contention;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Step;

class ExecutionOrderTest {
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = ExecutionOrderTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  @Test
  void nobodyDrivesOffBeforeTheLookThatMayMakeItVain() {
    ExecutionOrder order =
        order(
            step(1, "rose", "move"),
            step(2, "cam-a", "observeObject"),
            step(3, "rose", "pick", 1, 2));

    assertThat(order.startable(Set.of())).extracting(Step::number).containsExactly(2);
    assertThat(order.startable(Set.of(2))).extracting(Step::number).containsExactly(1);
  }

  @Test
  void whatALookNeedsIsDoneAtOnce() {
    ExecutionOrder order =
        order(
            step(1, "lamp-b1", "adjustLight"),
            step(2, "lux-a", "measureIllumination"),
            step(3, "cam-b", "observeObject", 1));

    assertThat(order.startable(Set.of())).extracting(Step::number).containsExactly(1, 2);
  }

  @Test
  void twoLooksThatNeedDifferentStepsDoNotBlockEachOther() {
    ExecutionOrder order =
        order(
            step(1, "lamp-a1", "adjustLight"),
            step(2, "lamp-b1", "adjustLight"),
            step(3, "cam-a", "observeObject", 1),
            step(4, "cam-b", "observeObject", 2));

    assertThat(order.startable(Set.of())).extracting(Step::number).containsExactly(1, 2);
    assertThat(order.startable(Set.of(1))).extracting(Step::number).containsExactly(2, 3);
  }

  private static ExecutionOrder order(Step... steps) {
    return new ExecutionOrder(new Plan(List.of(steps), 1, Map.of()));
  }

  private static Step step(int number, String member, String feature, Integer... after) {
    return new Step(
        number,
        member,
        home.devices().get(member).features().stream()
            .filter(f -> f.name().equals(feature))
            .findFirst()
            .orElseThrow(),
        Map.of(),
        1,
        1,
        true,
        Set.of(after));
  }
}
