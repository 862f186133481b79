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
import org.maestro.hal.Position;
import org.maestro.knowledge.api.Dispute;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

/** What changes without anybody reporting it is noticed, and running plans change. */
class NoticingTest {
  private static final String WISH = "(nextTo Cup Bob)";
  private static final Duration LIMIT = Duration.ofMinutes(20);

  @Test
  void aStrangerMovesTheCupWhileRoseIsOnHerWay() throws IOException {
    try (AgentlessSite site = site("bob", "bob-lit")) {
      List<GoalOutcome> outcomes = begin(site, WISH);
      awaitTelling(site, "rose picks up Cup");
      site.world().moveByHand("Cup", new Position(2.2, 0.6, 0));

      assertReached(site, outcomes);
      assertThat(story(site)).contains("Plan again, because");
    }
  }

  @Test
  void thePersonGoesToTheOtherRoomWhileTheCupIsCarried() throws IOException {
    try (AgentlessSite site = site("bob", "bob-lit")) {
      List<GoalOutcome> outcomes = begin(site, WISH);
      awaitTelling(site, "rose reports: Cup is in rose");
      site.world().moveByHand("Bob", new Position(4.2, 0.8, 0));

      assertReached(site, outcomes);
    }
  }

  @Test
  void aRobotOfAnotherGoalMovesTheCup() throws IOException {
    try (AgentlessSite site = site("bob-two-robots", "bob-two-robots")) {
      List<GoalOutcome> first = begin(site, "(in Cup zone-a)");
      List<GoalOutcome> second = begin(site, WISH);

      assertReached(site, second);
      site.runUntil(() -> !first.isEmpty(), LIMIT);
      assertThat(first.get(0).reached()).as(story(site)).isTrue();
    }
  }

  @Test
  void twoCamerasThatDisagreeAreBothShownAndTheTruthIsFoundOut() throws IOException {
    try (AgentlessSite site = site("bob", "bob-lit")) {
      see(site, "cam-b", "(position Cup \"4.5 1 0\")");
      see(site, "cam-a", "(position Cup \"2.6 0.5 0\")");
      List<Dispute> disputes = site.knowledge().snapshot().disputes();
      assertThat(disputes)
          .anySatisfy(
              dispute -> {
                assertThat(dispute.believed().orElseThrow().source().agent()).isEqualTo("cam-a");
                assertThat(dispute.losers().get(0).belief().source().agent()).isEqualTo("cam-b");
                assertThat(dispute.losers().get(0).rule()).isEqualTo(Dispute.Rule.LATER);
              });

      assertReached(site, begin(site, WISH));
    }
  }

  @Test
  void whatWasSeenTooLongAgoIsSoughtAnew() throws IOException {
    try (AgentlessSite site = site("bob", "bob-cup-in-a")) {
      see(site, "cam-b", "(in Cup zone-b)");
      site.runUntil(() -> false, Duration.ofMinutes(11));

      assertReached(site, begin(site, WISH));
      assertThat(story(site)).contains("Where Cup is, nobody knows");
      assertThat(site.knowledge().history("(in Cup zone-b)").get(0).fact())
          .isEqualTo("(in Cup zone-b)");
    }
  }

  @Test
  void whatGrowsTooOldWhileThePlanRunsIsNoticed() throws IOException {
    try (AgentlessSite site = site("bob", "bob-lit")) {
      see(site, "cam-a", "(position Bob \"0.8 2.1 0\")");
      site.runUntil(() -> false, Duration.ofSeconds(24));

      assertReached(site, begin(site, WISH));
      assertThat(story(site))
          .contains("it is no longer known whether Bob is in zone-a; step 5")
          .contains("cam-a looks for Bob");
    }
  }

  private static void see(AgentlessSite site, String camera, String fact) {
    site.knowledge().state(new Source(Source.Kind.OBSERVED, camera), List.of(fact));
  }

  private static List<GoalOutcome> begin(AgentlessSite site, String goal) {
    List<GoalOutcome> outcomes = new ArrayList<>();
    site.pursue(goal, outcomes::add);
    return outcomes;
  }

  private static void awaitTelling(AgentlessSite site, String part) {
    assertThat(site.runUntil(() -> story(site).contains(part), LIMIT))
        .as("it tells %s:%n%s", part, story(site))
        .isTrue();
  }

  private static void assertReached(AgentlessSite site, List<GoalOutcome> outcomes) {
    site.runUntil(() -> !outcomes.isEmpty(), LIMIT);
    assertThat(outcomes).as(story(site)).hasSize(1);
    assertThat(outcomes.get(0).reached()).as(story(site)).isTrue();
    assertThat(site.world().isNextTo("Cup", "Bob")).as(story(site)).isTrue();
  }

  private static String story(AgentlessSite site) {
    return site.story().stream().map(StoryEntry::text).collect(Collectors.joining("\n"));
  }

  private static AgentlessSite site(String home, String scene) throws IOException {
    Home loaded = new HomeLoader().load(text("/homes/" + home + ".ttl"), home + ".ttl");
    try (InputStream turtle = NoticingTest.class.getResourceAsStream("/scenes/" + scene + ".ttl")) {
      return AgentlessSite.start(loaded, SceneLoader.load(scene + ".ttl", turtle, loaded), 1);
    }
  }

  private static String text(String resource) throws IOException {
    try (InputStream turtle = NoticingTest.class.getResourceAsStream(resource)) {
      return new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
