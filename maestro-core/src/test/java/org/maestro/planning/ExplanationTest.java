package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningResult.Cure;
import org.maestro.planning.api.PlanningResult.Explanation;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningResult.Obstacle.Kind;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.api.Unavailable;
import org.maestro.planning.explanation.Cures;
import org.maestro.sl.Term;

/** Why there is no plan, and that each cure named is one. */
class ExplanationTest {
  private static final String GOAL = "(nextTo Cup Bob)";

  private final OptimalPlanner planner = new OptimalPlanner();

  private List<Obstacle> obstacles(PlanningTask task) {
    PlanningResult result = planner.plan(task);
    assertThat(result).isInstanceOf(PlanningResult.Impossible.class);
    Explanation explanation = ((PlanningResult.Impossible) result).explanation();
    if (explanation.obstacles().stream().noneMatch(o -> o.kind() == Kind.GOAL)) {
      assertThat(explanation.proven()).isTrue();
      check(task, explanation.obstacles());
    }
    return explanation.obstacles();
  }

  /**
   * All cured: there is a plan. One left out: none. Cured, it is not cited any more. Each cure
   * named instead of one: there is a plan.
   */
  private void check(PlanningTask task, List<Obstacle> cited) {
    assertThat(isSolvable(Cures.applied(task, cited))).as("all of %s", cited).isTrue();
    for (Obstacle obstacle : cited) {
      List<Obstacle> others = new ArrayList<>(cited);
      others.remove(obstacle);
      assertThat(isSolvable(Cures.applied(task, others))).as("without %s", obstacle).isFalse();
      PlanningTask better = Cures.applied(task, List.of(obstacle));
      if (planner.plan(better) instanceof PlanningResult.Impossible impossible) {
        assertThat(impossible.explanation().obstacles())
            .extracting(Obstacle::condition)
            .doesNotContain(obstacle.condition());
      }
      for (Cure cure : obstacle.cures()) {
        List<Obstacle> instead = new ArrayList<>(others);
        instead.addAll(cure.conditions());
        assertThat(isSolvable(Cures.applied(task, instead))).as("with %s", cure).isTrue();
      }
    }
  }

  private boolean isSolvable(PlanningTask task) {
    return planner.solve(task) instanceof PlanningResult.Found;
  }

  private static List<Unavailable> absent(SmallWorld world, String... members) {
    List<Unavailable> absent = new ArrayList<>();
    for (String member : members) {
      world.offers.stream()
          .filter(offer -> offer.member().equals(member))
          .forEach(offer -> absent.add(new Unavailable(offer, "lost since 12 s")));
      world.withdraw(member);
    }
    return absent;
  }

  private static List<String> curesOf(Obstacle obstacle) {
    return obstacle.cures().stream()
        .map(
            cure ->
                String.join(" + ", cure.conditions().stream().map(Obstacle::condition).toList()))
        .toList();
  }

  private static SmallWorld home() {
    return BobsHome.dark()
        .word("open", "", "?d - Door")
        .word("locked", "", "?d - Door")
        .word("adjoins", "symmetric", "?a - Zone", "?b - Zone");
  }

  private static SmallWorld bright() {
    return home().facts("(= (illuminance zone-a) 100)", "(= (illuminance zone-b) 100)");
  }

  private static SmallWorld darkInB() {
    return home()
        .facts("(= (illuminance zone-b) 17)", "(= (illuminance zone-a) 92)")
        .facts("(in Bob zone-a)", "(not (in Cup zone-a))");
  }

  @Test
  void namesTheLightThatNoLampCanGiveAndTheLampThatCould() {
    SmallWorld world = darkInB();
    List<Unavailable> absent = absent(world, "lamp-b1", "lamp-b2");
    assertThat(obstacles(world.task(GOAL).withUnavailable(absent, Map.of())))
        .singleElement()
        .satisfies(
            obstacle -> {
              assertThat(obstacle.condition()).isEqualTo("(>= (illuminance zone-b) 72)");
              assertThat(obstacle.needed()).isEqualTo(">= 72");
              assertThat(obstacle.possible()).isEqualTo("42");
              assertThat(obstacle.missing()).hasValue(30);
              assertThat(obstacle.neededBy()).map(StepKey::member).contains("cam-b");
              assertThat(curesOf(obstacle)).containsExactly("lamp-b1", "lamp-b2");
            });
  }

  @Test
  void namesThePlacesThatWereSearched() {
    SmallWorld world =
        bright().facts("(in Bob zone-a)", "(not (in Cup zone-a))", "(not (in Cup zone-b))");
    assertThat(obstacles(world.task(GOAL)))
        .singleElement()
        .satisfies(
            obstacle -> {
              assertThat(obstacle.kind()).isEqualTo(Kind.EXCLUDED);
              assertThat(obstacle.condition()).startsWith("(in Cup zone-");
              assertThat(obstacle.possible()).isEqualTo("zone-a zone-b");
              assertThat(curesOf(obstacle)).anyMatch(cure -> cure.startsWith("(in Cup zone-"));
            });
  }

  @Test
  void namesTheWeightThatIsTooMuch() {
    SmallWorld world = home().facts("(= (mass Cup) 0.75)");
    assertThat(obstacles(world.task(GOAL)))
        .singleElement()
        .satisfies(
            obstacle -> {
              assertThat(obstacle.condition()).isEqualTo("(<= (mass Cup) (payload rose))");
              assertThat(obstacle.needed()).isEqualTo("<= 0.5");
              assertThat(obstacle.possible()).isEqualTo("0.75");
              assertThat(obstacle.neededBy()).map(StepKey::feature).contains("pick");
            });
  }

  @Test
  void namesTheLockOfTheDoor() {
    SmallWorld world = bright();
    world.facts("(in Bob zone-a)", "(in Cup zone-b)", "(not (open door-ab))", "(locked door-ab)");
    world.offer("door-ab", "openDoor", "3");
    assertThat(obstacles(world.task(GOAL)))
        .singleElement()
        .extracting(Obstacle::condition, Obstacle::possible)
        .containsExactly("(not (locked door-ab))", "true");
  }

  @Test
  void namesTheDoorThatNobodyOpens() {
    SmallWorld world = bright();
    world.facts("(in Bob zone-a)", "(in Cup zone-b)", "(not (open door-ab))");
    assertThat(obstacles(world.task(GOAL)))
        .singleElement()
        .extracting(Obstacle::condition)
        .isEqualTo("(open door-ab)");
  }

  @Test
  void namesTheMemberThatIsLost() {
    SmallWorld world = bright();
    List<Unavailable> absent = absent(world, "rose");
    assertThat(obstacles(world.task(GOAL).withUnavailable(absent, Map.of())))
        .singleElement()
        .satisfies(
            obstacle -> {
              assertThat(obstacle.kind()).isEqualTo(Kind.MEMBER);
              assertThat(obstacle.condition()).isEqualTo("rose");
              assertThat(obstacle.possible()).isEqualTo("lost since 12 s");
            });
  }

  /** Whoever is away might do it: so it is not nobody for good. */
  @Test
  void whatNobodyDoesNowSomebodyWhoIsAwayMightDo() {
    SmallWorld world = home();
    List<Unavailable> absent = absent(world, "rose");
    assertThat(obstacles(world.task("(adjoins zone-a zone-b)").withUnavailable(absent, Map.of())))
        .extracting(Obstacle::kind, Obstacle::extent)
        .containsExactly(tuple(Kind.GOAL, Obstacle.Extent.LIMIT_NOW));
    assertThat(obstacles(home().task("(adjoins zone-a zone-b)")))
        .extracting(Obstacle::kind, Obstacle::extent)
        .containsExactly(tuple(Kind.GOAL, Obstacle.Extent.LIMIT));
  }

  @Test
  void namesWhatNobodyChanges() {
    assertThat(obstacles(home().withdraw("rose").task(GOAL)))
        .extracting(Obstacle::condition)
        .containsExactly(GOAL);
    assertThat(obstacles(home().task("(adjoins zone-a zone-b)")))
        .extracting(Obstacle::kind)
        .containsExactly(Kind.GOAL);
  }

  @Test
  void namesTheStepThatIsDeclined() {
    StepKey key =
        new StepKey(
            "cam-b",
            "observeObject",
            Map.of("object", new Term.Name("Cup"), "zone", new Term.Name("zone-b")));
    PlanningTask task =
        bright()
            .task("(canSee cam-b Cup)")
            .withBarred(Set.of(key))
            .withUnavailable(List.of(), Map.of(key, "it refuses: my lens is dirty"));
    assertThat(obstacles(task))
        .singleElement()
        .satisfies(
            obstacle -> {
              assertThat(obstacle.kind()).isEqualTo(Kind.STEP);
              assertThat(obstacle.subject()).contains(key);
              assertThat(obstacle.possible()).isEqualTo("it refuses: my lens is dirty");
            });
  }

  @Test
  void namesTwoObstaclesAtOnce() {
    SmallWorld world = darkInB().withdraw("lamp-b1").withdraw("lamp-b2");
    world.facts("(not (open door-ab))", "(locked door-ab)", "(= (mass Cup) 0.75)");
    world.offer("door-ab", "openDoor", "3");
    assertThat(obstacles(world.task(GOAL)))
        .extracting(Obstacle::condition)
        .containsExactlyInAnyOrder(
            "(>= (illuminance zone-b) 72)",
            "(<= (mass Cup) (payload rose))",
            "(not (locked door-ab))");
  }

  @Test
  void namesEachRobotThatCouldIfItWereStronger() {
    SmallWorld world = bright().facts("(= (mass Cup) 0.75)");
    BobsHome.robot(world, "tim", "zone-b", "9");
    assertThat(obstacles(world.task(GOAL)))
        .singleElement()
        .satisfies(
            obstacle -> {
              assertThat(obstacle.condition()).isEqualTo("(<= (mass Cup) (payload rose))");
              assertThat(curesOf(obstacle)).contains("(<= (mass Cup) (payload tim))");
            });
  }

  @Test
  void saysWhenTheBoundWasReached() {
    PlanningTask task = home().facts("(= (illuminance zone-b) 17)").task(GOAL);
    assertThat(new OptimalPlanner(2).plan(task)).isInstanceOf(PlanningResult.GaveUp.class);
  }

  @Property(tries = 25)
  void eachNamedCureOfARandomHomeIsOne(@ForAll Random random) {
    SmallWorld world = random.nextBoolean() ? bright() : home();
    String[] troubles = {
      "(= (illuminance zone-b) 7)",
      "(= (illuminance zone-a) 20)",
      "(= (mass Cup) 0.8)",
      "(not (open door-ab))",
      "(not (in Cup zone-a))",
      "(not (in Cup zone-b))",
      "(in Bob zone-a)",
      "(in Cup zone-b)",
      "(locked door-ab)",
      "(= (payload rose) 0.1)"
    };
    for (String trouble : troubles) {
      if (random.nextInt(3) == 0) {
        world.facts(trouble);
      }
    }
    if (random.nextBoolean()) {
      world.offer("door-ab", "openDoor", "2");
    }
    if (random.nextInt(3) == 0) {
      BobsHome.robot(world, "tim", "zone-a", "3");
    }
    List<Unavailable> absent = new ArrayList<>();
    for (String member : List.of("lamp-b1", "lamp-b2", "cam-a", "cam-b", "lux-b", "rose")) {
      if (random.nextInt(3) == 0) {
        absent.addAll(absent(world, member));
      }
    }
    String goal =
        List.of(GOAL, "(canSee ?agent Cup)", "(in Cup zone-a)", "(>= (illuminance zone-b) 100)")
            .get(random.nextInt(4));
    PlanningTask task = world.task(goal).withUnavailable(absent, Map.of());
    if (!isSolvable(task)) {
      assertThat(obstacles(task)).isNotEmpty();
    }
  }
}
