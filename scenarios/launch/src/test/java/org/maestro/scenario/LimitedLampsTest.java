package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.maestro.assembly.AgentlessSite;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.Expression;
import org.maestro.sl.Term;

/**
 * A limit holds for whatever is chosen to bring about what only follows from it: how light it is in
 * a room, where lamps may be half on at most (ADE, 5; A85).
 */
class LimitedLampsTest {
  private static final Duration LIMIT = Duration.ofMinutes(3);
  private static final List<String> LAMPS = List.of("lamp-b1", "lamp-b2", "lamp-b3");
  private static final String HALF =
      """

      home:half a maestro:Permission ; maestro:person "*" ; maestro:asks :Lamp ;
        maestro:permits :adjustLight ; maestro:when "(<= ?level 0.5)" .
      """;

  @Test
  void itIsAsLightAsLampsMakeItThatAreHalfOn() throws IOException {
    try (AgentlessSite limited = site(HALF)) {
      assertThat(pursued(limited, "(>= (illuminance zone-b) 60)").reached())
          .as(story(limited))
          .isTrue();
      assertThat(levels(limited)).as(story(limited)).contains(0.5).allMatch(level -> level <= 0.5);
      assertThat(story(limited)).contains("within what is stated by half in bob.ttl");
    }
  }

  @Test
  void whatTakesMoreIsReachedOnlyWhereNothingLimitsIt() throws IOException {
    String goal = "(>= (illuminance zone-b) 72)";
    try (AgentlessSite free = site("");
        AgentlessSite limited = site(HALF)) {
      assertThat(pursued(free, goal).reached()).as(story(free)).isTrue();
      assertThat(levels(free)).as(story(free)).contains(1.0);

      assertThat(pursued(limited, goal).reached()).as(story(limited)).isFalse();
      assertThat(levels(limited)).as(story(limited)).allMatch(level -> level <= 0.5);
    }
  }

  @Test
  void whatIsForbiddenOutrightIsNotBegun() throws IOException {
    try (AgentlessSite limited = site(HALF)) {
      GoalOutcome outcome = pursued(limited, "(= (level lamp-b1) 1)");
      assertThat(outcome.reached()).as(story(limited)).isFalse();
      assertThat(outcome.calls()).isZero();
      assertThat(levels(limited)).as(story(limited)).allMatch(level -> level <= 0.5);
    }
  }

  private static GoalOutcome pursued(AgentlessSite site, String goal) {
    List<GoalOutcome> outcomes = new ArrayList<>();
    site.pursue(goal, outcomes::add);
    site.runUntil(() -> !outcomes.isEmpty(), LIMIT);
    assertThat(outcomes).as(story(site)).hasSize(1);
    return outcomes.get(0);
  }

  private static List<Double> levels(AgentlessSite site) {
    return LAMPS.stream()
        .map(
            lamp ->
                site.knowledge()
                    .snapshot()
                    .number(new Expression.Fluent("level", List.of(new Term.Name(lamp))))
                    .orElse(0))
        .toList();
  }

  private static String story(AgentlessSite site) {
    return site.story().stream().map(StoryEntry::text).collect(Collectors.joining("\n"));
  }

  private static AgentlessSite site(String more) throws IOException {
    Home home = new HomeLoader().load(text("/homes/bob.ttl") + more, "bob.ttl");
    try (InputStream turtle = LimitedLampsTest.class.getResourceAsStream("/scenes/bob-dark.ttl")) {
      return AgentlessSite.start(home, SceneLoader.load("bob-dark.ttl", turtle, home), 1);
    }
  }

  private static String text(String resource) throws IOException {
    try (InputStream turtle = LimitedLampsTest.class.getResourceAsStream(resource)) {
      return new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
