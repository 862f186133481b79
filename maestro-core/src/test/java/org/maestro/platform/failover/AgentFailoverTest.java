package org.maestro.platform.failover;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.deployment.Provision;
import org.maestro.rats.time.SteppedClock;

/** Where agents go, on hosts that are lambdas. */
class AgentFailoverTest {
  private final SteppedClock clock = new SteppedClock();
  private final List<String> begun = new CopyOnWriteArrayList<>();
  private final List<String> problems = new CopyOnWriteArrayList<>();
  private final List<String> told = new CopyOnWriteArrayList<>();
  private volatile Provision needs = Provision.of(Set.of("microphone"));
  private final Set<String> revoked = ConcurrentHashMap.newKeySet();
  private final AgentFailover rescue =
      new AgentFailover(
          new Ways(), clock, Provision.of(List.of()), "maestro", name -> !revoked.contains(name));

  private final class Ways implements AgentFailover.Ways {
    @Override
    public Provision needs(String member) {
      return needs;
    }

    @Override
    public void beginHere(String member, String controller) {
      begin(member, "here", controller);
    }

    @Override
    public void beginThere(
        String host, String member, String controller, Consumer<Optional<String>> problem) {
      try {
        begin(member, host, controller);
        problem.accept(Optional.empty());
      } catch (IllegalStateException e) {
        problem.accept(Optional.of(e.getMessage()));
      }
    }

    private void begin(String member, String host, String controller) {
      if (!problems.isEmpty()) {
        throw new IllegalStateException(problems.remove(0));
      }
      begun.add("%s on %s calls as %s".formatted(member, host, controller));
    }

    @Override
    public void nobody(String member, String reason) {
      told.add(member + ": " + reason);
    }
  }

  @BeforeEach
  void hosts() {
    rescue.offered("attic", List.of("microphone"));
    rescue.offered("cellar", List.of("microphone", "gpu"));
  }

  /** Its own host, then a second one that dies too, then a third: that one lets go. */
  @Test
  void whoReturnsGetsItsOwnBackFromTheThirdHost() {
    String own = TakeoverLinks.controller("kitchen");
    rescue.lost("ear", own);
    awaitBegun("ear on attic calls as " + own);
    rescue.gone("attic");
    rescue.lost("ear", TakeoverLinks.controller("attic"));
    pass(Duration.ofSeconds(2));
    awaitBegun("ear on cellar calls as " + own);

    assertThat(rescue.released(own)).contains("cellar");
    assertThat(rescue.released(own)).as("once").isEmpty();
    rescue.settled("ear");
    assertThat(rescue.homeless()).isEmpty();
  }

  @Test
  void aNameThatWasTakenOutOfTheSiteIsNotUsed() {
    String own = TakeoverLinks.controller("kitchen");
    revoked.add(own);

    rescue.lost("ear", own);

    awaitBegun("ear on attic calls as " + TakeoverLinks.controller("attic"));
  }

  @Test
  void whomNobodyFitsIsToldOfAndBeginsAsSoonAsSomebodyDoes() {
    needs = Provision.of(Set.of("projector"));
    rescue.lost("screen", TakeoverLinks.controller("kitchen"));
    await().until(() -> rescue.homeless().equals(Set.of("screen")) && told.size() == 1);
    assertThat(told.get(0)).contains("projector");

    rescue.offered("hall", List.of("projector"));
    awaitBegun("screen on hall calls as " + TakeoverLinks.controller("kitchen"));
    assertThat(rescue.homeless()).isEmpty();
  }

  @Test
  void whoseProcessStaysAwayGoesOnElsewhereUnderItsName() {
    rescue.awaits("ear", TakeoverLinks.controller("kitchen"));
    pass(AgentFailover.JOINS_AGAIN_WITHIN.plusMillis(1));

    awaitBegun("ear on attic calls as " + TakeoverLinks.controller("kitchen"));
  }

  @Test
  void whoseProcessHasJoinedAgainIsBegunNowhereElse() {
    rescue.awaits("ear", TakeoverLinks.controller("kitchen"));
    rescue.awaits("eye", TakeoverLinks.controller("cellar"));
    rescue.settled("ear");
    pass(AgentFailover.JOINS_AGAIN_WITHIN.plusMillis(1));

    await().until(() -> !begun.isEmpty());
    assertThat(begun).noneMatch(line -> line.startsWith("ear "));
  }

  /** As when JADE has not let go of its name yet. */
  @Test
  void whomAllThatFitFailToBeginIsTriedAgainLater() {
    needs = Provision.of(Set.of());
    problems.addAll(List.of("its name is taken", "its name is taken", "its name is taken"));
    rescue.lost("lamp", TakeoverLinks.controller("kitchen"));
    await().until(problems::isEmpty);
    await()
        .until(
            () -> {
              pass(Duration.ofSeconds(2));
              return !begun.isEmpty();
            });

    assertThat(begun)
        .containsExactly("lamp on here calls as " + TakeoverLinks.controller("kitchen"));
    assertThat(told).isEmpty();
  }

  /** Spread out, with the needs that each has. */
  @Test
  void ofSeveralThatFitTheOneWithFewestAgentsIsTaken() {
    for (String member : List.of("ear-1", "ear-2", "ear-3")) {
      rescue.lost(member, TakeoverLinks.controller("kitchen"));
      await().until(() -> begun.stream().anyMatch(line -> line.startsWith(member + " ")));
    }
    Map<Boolean, List<String>> byHost =
        begun.stream().collect(Collectors.partitioningBy(line -> line.contains(" on attic ")));

    assertThat(byHost.get(true)).hasSize(2);
    assertThat(byHost.get(false)).hasSize(1);
  }

  private void awaitBegun(String line) {
    await().until(() -> new ArrayList<>(begun).contains(line));
  }

  private void pass(Duration duration) {
    boolean[] passed = {false};
    clock.schedule(duration, "test", () -> passed[0] = true);
    clock.runUntil(() -> passed[0], duration.plusSeconds(1));
  }
}
