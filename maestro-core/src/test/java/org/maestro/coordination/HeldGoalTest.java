package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.HeldNews;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;

/** Goals that are held: over pretended devices, on the stepped clock. */
class HeldGoalTest {
  private static final String LIGHT = "(keep (>= (illuminance zone-b) 72))";

  private final List<HeldNews> news = new ArrayList<>();
  private final List<GoalOutcome> outcomes = new ArrayList<>();
  private PretendHouse house;

  @BeforeEach
  void furnish() throws java.io.IOException {
    house =
        new PretendHouse(
            new HomeLoader()
                .load(
                    Files.readString(
                            Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"))
                        + "\n"
                        + "home:desk a maestro:Location ; maestro:referencePoint \"5 1.5 0.75\""
                        + " .\n",
                    "bob.ttl"));
  }

  @Test
  void itIsHeldAndSaysSo() {
    String id = submit(LIGHT);
    awaitHeld();

    assertThat(house.lux("zone-b")).isGreaterThanOrEqualTo(72);
    assertThat(news).extracting(HeldNews::kind).containsExactly(HeldNews.Kind.HELD);
    assertThat(status().state()).isEqualTo(GoalState.HOLDING);
    assertThat(outcomes).isEmpty();

    assertThat(house.coordinator.cancel(id, "Bob")).isTrue();
    assertThat(outcomes).extracting(GoalOutcome::state).containsExactly(GoalState.CANCELLED);
  }

  @Test
  void whenDaylightGoesItIsRestored() {
    house.ambientLux.put("zone-b", 80.0);
    submit(LIGHT);
    awaitHeld();
    assertThat(house.calls).noneMatch(call -> call.startsWith("adjustLight"));

    house.ambientLux.put("zone-b", 50.0);
    await(() -> news.size() == 3);

    assertThat(news)
        .extracting(HeldNews::kind)
        .containsExactly(HeldNews.Kind.HELD, HeldNews.Kind.LOST, HeldNews.Kind.HELD_AGAIN);
    assertThat(house.lux("zone-b")).isGreaterThanOrEqualTo(72);
  }

  @Test
  void whenDaylightComesTheLampsAreDimmed() {
    submit(LIGHT);
    awaitHeld();
    double power = power();
    house.ambientLux.put("zone-b", 60.0);
    await(() -> power() < power);
    assertThat(house.lux("zone-b")).isGreaterThanOrEqualTo(72);

    house.ambientLux.put("zone-b", 100.0);
    await(() -> power() == 0);
    assertThat(news).hasSize(1);
  }

  @Test
  void itDoesNotFlickerWithNoise() {
    Random random = new Random(7);
    house.noise = () -> 1 + 0.01 * random.nextGaussian();
    house.ambientLux.put("zone-b", 72.5 - 35);
    submit(LIGHT);
    awaitHeld();
    run(Duration.ofMinutes(2));
    long calls = lampCalls();
    run(Duration.ofMinutes(20));

    assertThat(lampCalls() - calls).isLessThanOrEqualTo(2);
    assertThat(house.lux("zone-b")).isGreaterThanOrEqualTo(72 * 0.97);
  }

  @Test
  void whenItCannotBeHeldItSaysWhyAndGoesOnWhenALampComesBack() {
    house.dead.addAll(List.of("lamp-b1", "lamp-b2"));
    house.coordinator.memberLost("lamp-b1", "dead");
    house.coordinator.memberLost("lamp-b2", "dead");
    submit(LIGHT);
    await(() -> !news.isEmpty());

    assertThat(news.get(0).kind()).isEqualTo(HeldNews.Kind.LOST);
    assertThat(String.join(" ", news.get(0).reasons())).contains("illuminance", "72", "45");
    assertThat(status().state()).isEqualTo(GoalState.WAITING);
    assertThat(status().detail()).contains("72");

    house.dead.clear();
    house.setLevel("lamp-b1", 0);
    house.setLevel("lamp-b2", 0);
    house.coordinator.memberPresent("lamp-b1");
    house.coordinator.memberPresent("lamp-b2");
    awaitHeld();
    assertThat(house.lux("zone-b")).isGreaterThanOrEqualTo(72);
  }

  /** Since when they are lost is another number each time, and no news. */
  @Test
  void whyItCannotBeHeldIsToldOnceHoweverOftenItIsTried() {
    submit(LIGHT);
    awaitHeld();
    news.clear();
    house.coordinator.memberLost("lamp-b1", "dead");
    house.coordinator.memberLost("lamp-b2", "dead");
    house.setLevel("lamp-b1", 0);
    house.setLevel("lamp-b2", 0);
    await(() -> status().state() == GoalState.WAITING && status().detail().contains("lost since"));
    String first = status().detail();
    int told = house.story.size();

    await(() -> status().detail().contains("lost since") && !status().detail().equals(first));
    run(Duration.ofMinutes(3));

    assertThat(news)
        .extracting(HeldNews::kind)
        .containsExactly(HeldNews.Kind.LOST, HeldNews.Kind.LOST);
    assertThat(house.story.subList(told, house.story.size())).isEmpty();
  }

  /** It is waited for a price, in each attempt anew. */
  @Test
  void norIsToldAgainWhatEachAttemptWaitsFor() {
    house.priceless.add("rose");
    submit("(keep (in rose zone-a))");
    await(() -> !news.isEmpty());
    int told = house.story.size();

    run(Duration.ofMinutes(3));

    assertThat(house.story.subList(0, told)).anyMatch(text -> text.contains("tried once more"));
    assertThat(house.story.subList(told, house.story.size())).isEmpty();
    assertThat(news).hasSize(1);
  }

  @Test
  void aSensorThatIsLostIsMissedAndTheLightGoesOnByWhatIsKnown() {
    submit(LIGHT);
    awaitHeld();
    house.dead.add("lux-b");
    house.coordinator.memberLost("lux-b", "dead");
    await(() -> status().state() == GoalState.HOLDING && !status().detail().isEmpty());

    assertThat(status().detail()).contains("nobody can observe it");
  }

  @Test
  void aDeskIsLitByWhatShinesThere() {
    house.ambientLux.put("desk", 17.0);
    submit("(keep (>= (illuminance desk) 100))");
    awaitHeld();

    assertThat(house.lux("desk")).isGreaterThanOrEqualTo(100);
    assertThat(house.calls).noneMatch(call -> call.contains("lamp-a"));
  }

  @Test
  void whatIsLitByOthersIsLeftToThem() {
    assertThat(house.achieve("(= (level lamp-b1) 1)").reached()).isTrue();
    house.ambientLux.put("zone-b", 200.0);
    submit(LIGHT);
    awaitHeld();
    run(Duration.ofMinutes(5));

    assertThat(house.level.get("lamp-b1")).isEqualTo(1);
  }

  @Test
  void twoThatContradictEachOtherDoNotTakeTurnsAtFullSpeed() {
    submit(LIGHT);
    submit("(keep (<= (illuminance zone-b) 40))");
    run(Duration.ofMinutes(10));

    // One call takes 0.3 s: at full speed there would be some two thousand.
    assertThat(lampCalls()).isLessThan(120);
  }

  @Test
  void othersGoOnMeanwhile() {
    submit(LIGHT);
    awaitHeld();

    assertThat(house.achieve("(nextTo Cup Bob)").reached()).isTrue();
    assertThat(status().state()).isEqualTo(GoalState.HOLDING);
  }

  private String submit(String goal) {
    return house.coordinator.submit(
        new GoalRequest(SlParser.formula(goal), "Bob"), news::add, outcomes::add);
  }

  private void awaitHeld() {
    await(() -> status().state() == GoalState.HOLDING);
  }

  private GoalStatus status() {
    return house.coordinator.goals().stream()
        .filter(goal -> goal.goal().startsWith("(keep"))
        .findFirst()
        .orElseThrow();
  }

  private void await(BooleanSupplier condition) {
    assertThat(house.clock.runUntil(condition, Duration.ofMinutes(10)))
        .as(String.join("\n", house.story))
        .isTrue();
  }

  private void run(Duration time) {
    house.clock.runUntil(() -> false, time);
  }

  private long lampCalls() {
    return house.calls.stream().filter(call -> call.startsWith("adjustLight")).count();
  }

  private double power() {
    return house.level.entrySet().stream()
        .filter(lamp -> lamp.getKey().startsWith("lamp-b"))
        .mapToDouble(java.util.Map.Entry::getValue)
        .sum();
  }
}
