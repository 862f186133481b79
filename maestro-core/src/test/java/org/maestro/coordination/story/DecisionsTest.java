package org.maestro.coordination.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.PretendHouse;
import org.maestro.coordination.api.Proposal;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningTask;
import org.maestro.sl.SlParser;

class DecisionsTest {
  private static final Proposal REFUSED =
      new Proposal("rose", Map.of(), Optional.of("no hand is free"));

  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = DecisionsTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);

  private Decision decision(int bids) {
    return new Decision(
        new PlanningTask(
            house.knowledge.home().vocabulary(),
            house.knowledge.snapshot(),
            List.of(),
            SlParser.formula("(in Cup zone-a)"),
            Set.of()),
        new Plan(List.of(), 0, Map.of()),
        Collections.nCopies(bids, REFUSED),
        0);
  }

  @Test
  void theLatestFivePlansAreKept() {
    Decisions decisions = new Decisions();
    for (int plan = 1; plan <= 7; plan++) {
      decisions.add(plan, decision(3));
    }
    assertThat(decisions.find(OptionalInt.of(2))).isEmpty();
    assertThat(decisions.find(OptionalInt.of(3))).isPresent();
    assertThat(decisions.find(OptionalInt.of(7))).isPresent();
  }

  @Test
  void ofLargeOnesNoMoreThanThereIsRoomForAndTheLatestAlways() {
    Decisions decisions = new Decisions();
    decisions.add(1, decision(3));
    decisions.add(2, decision(600));
    decisions.add(3, decision(300));
    assertThat(decisions.find(OptionalInt.of(1))).isPresent();
    decisions.add(4, decision(300));
    assertThat(decisions.find(OptionalInt.of(2))).isEmpty();
    assertThat(decisions.find(OptionalInt.of(3))).isPresent();
    assertThat(decisions.bytes()).isLessThan(256 << 10);
    decisions.add(5, decision(10_000));
    assertThat(decisions.find(OptionalInt.of(4))).isEmpty();
    assertThat(decisions.find(OptionalInt.empty())).isPresent();
  }
}
