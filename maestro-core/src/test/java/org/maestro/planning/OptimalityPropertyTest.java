package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.problem.GroundProblem;

/** Random small worlds: the plan costs what exhaustive search finds, and holds when executed. */
public class OptimalityPropertyTest {
  /** What may be wanted in a random home. */
  static final List<String> HOME_GOALS =
      List.of(
          "(nextTo Cup Bob)",
          "(canSee ?agent Cup)",
          "(canSee cam-a Cup)",
          "(in Cup zone-a)",
          "(and (in Cup zone-b) (canSee cam-b Bob))",
          "(or (in Bob zone-a) (>= (illuminance zone-b) 60))",
          "(and (>= (illuminance zone-b) 40) (<= (illuminance zone-b) 60))",
          "(and (>= (illuminance zone-a) 80) (>= (illuminance zone-b) 80))",
          "(and (<= (illuminance zone-a) 30) (= (level lamp-b1) 0.5))",
          "(forall (?z - Zone) (not (unknown (illuminance ?z))))",
          "(exists (?z - Zone) (and (in Cup ?z) (not (in rose ?z))))",
          "(imply (in rose zone-b) (in Cup rose))");

  private final OptimalPlanner planner = new OptimalPlanner();

  @Property(tries = 60)
  void homesLikeBobs(@ForAll Random random) {
    PlanningTask task = homeTask(random);
    check(task, new Grounder(task).ground());
  }

  public static PlanningTask homeTask(Random random) {
    SmallWorld world = home(random);
    return world.task(HOME_GOALS.get(random.nextInt(HOME_GOALS.size())));
  }

  static SmallWorld home(Random random) {
    SmallWorld world =
        BobsHome.words()
            .individuals("Zone Place", "zone-a", "zone-b")
            .individuals("Door", "door-ab")
            .individuals("Thing", "Bob")
            .individuals("Thing Item", "Cup")
            .facts("(side door-ab zone-a)", "(side door-ab zone-b)", "(= (mass Cup) 0.25)");
    BobsHome.camera(world, "cam-a", "zone-a");
    BobsHome.camera(world, "cam-b", "zone-b");
    BobsHome.sensor(world, "lux-a", "zone-a");
    BobsHome.sensor(world, "lux-b", "zone-b");
    int lamps = 1 + random.nextInt(3);
    for (int i = 1; i <= lamps; i++) {
      String name = "lamp-b" + i;
      BobsHome.lamp(
          world,
          name,
          random.nextInt(3) / 2.0,
          random.nextBoolean()
              ? String.valueOf(random.nextInt(4))
              : "(+ 0.3 (* " + random.nextInt(4) + " (max 0 (- ?level (level ?self)))))",
          "(= (gain " + name + " zone-b) " + random.nextInt(50) + ")",
          "(= (gain " + name + " zone-a) " + random.nextInt(2) * random.nextInt(50) + ")");
    }
    BobsHome.robot(world, "rose", random.nextBoolean() ? "zone-a" : "zone-b", "5");
    world.offer("door-ab", "openDoor", String.valueOf(random.nextInt(3)));
    maybe(random, world, "(open door-ab)");
    maybe(random, world, "(= (illuminance zone-a) " + random.nextInt(120) + ")");
    maybe(random, world, "(= (illuminance zone-b) " + random.nextInt(120) + ")");
    maybe(random, world, "(usuallyIn Cup zone-a)");
    maybe(random, world, "(usuallyIn Bob zone-b)");
    maybe(random, world, "(not (in Bob zone-b))");
    maybe(random, world, "(not (in Cup zone-a))");
    maybe(random, world, "(in Cup " + (random.nextBoolean() ? "zone-a)" : "zone-b)"));
    maybe(random, world, "(canSee cam-b Cup)");
    return world;
  }

  private static void maybe(Random random, SmallWorld world, String fact) {
    if (random.nextInt(3) == 0) {
      world.facts(fact);
    }
  }

  @Property(tries = 400)
  void arbitraryFeatures(@ForAll Random random) {
    PlanningTask task = puzzleTask(random);
    check(task, Everything.ground(task));
  }

  /** No condition asks for what f5 does; it only keeps f1 from setting the number that it finds. */
  @Test
  void whatOnlyKeepsAnotherStepFromItsEffect() {
    String both = "x:Thing ; y:Thing";
    PlanningTask task =
        puzzleWords()
            .feature("f0", both, "(not (p ?y))", "(p ?x)")
            .offer("agent", "f0", "0")
            .feature(
                "f1",
                both,
                "(and (unknown (seen ?y)) (not (at ?y ?x)))",
                "(and (sense (n ?x)) (when (linked ?x ?y) (assign (n ?x) 2)))")
            .offer("agent", "f1", "2")
            .feature(
                "f2",
                both,
                "(and (not (= (n ?x) 2)) (< (n ?x) (n ?y)))",
                "(and (at ?x ?y) (sense (n ?x)) (not (at ?x ?y)))")
            .offer("agent", "f2", "0")
            .feature(
                "f3",
                both,
                "(and (not (at ?x ?y)) (p ?y))",
                "(and (increase (n ?x) (- 1 (n ?x))) (seen ?x) (linked ?x ?y))")
            .offer("agent", "f3", "3")
            .feature(
                "f4",
                both,
                "(and (imply (p ?y) (at ?y ?x)) (< (n ?y) (n ?x)))",
                "(sense (at ?x ?y))")
            .offer("agent", "f4", "2")
            .feature(
                "f5",
                both,
                "(and (or (p ?x) (seen ?y)) (unknown (n ?y)))",
                "(forall (?z - Thing) (not (linked ?x ?z)))")
            .offer("agent", "f5", "1")
            .facts("(p b)", "(seen a)", "(not (at b a))", "(linked a b)")
            .task("(and (at a b) (p a))");
    check(task, Everything.ground(task));
  }

  /** What only a condition of an effect names, and what is the value of what an effect changes. */
  @ParameterizedTest
  @ValueSource(longs = {349_124, 30_915})
  void parametersThatDecideWhetherSomethingHappens(long seed) {
    PlanningTask task = puzzleTask(new Random(seed));
    check(task, Everything.ground(task));
  }

  public static PlanningTask puzzleTask(Random random) {
    return puzzle(random).task(conjunction(random, 2));
  }

  private static SmallWorld puzzleWords() {
    return new SmallWorld()
        .individuals("Thing", "a", "b")
        .individuals("Agent", "agent")
        .word("p", "", "?x - Thing")
        .word("seen", "observable", "?x - Thing")
        .word("at", "observable functional", "?x - Thing", "?y - Thing")
        .word("mode", "functional", "?x - Thing", "?y - Thing")
        .word("n", "fluent observable", "?x - Thing")
        .word("linked", "symmetric", "?x - Thing", "?y - Thing")
        .derived("calm", "(not (exists (?y - Thing) (linked ?x ?y)))", "?x - Thing");
  }

  static SmallWorld puzzle(Random random) {
    SmallWorld world = puzzleWords();
    int features = 3 + random.nextInt(5);
    for (int i = 0; i < features; i++) {
      String effect = "(and " + effects(random, 1 + random.nextInt(3)) + ")";
      world
          .feature("f" + i, "x:Thing ; y:Thing", conjunction(random, 2, "?x", "?y"), effect)
          .offer("agent", "f" + i, String.valueOf(random.nextInt(4)));
    }
    for (String fact :
        List.of(
            "(p a)",
            "(p b)",
            "(seen a)",
            "(not (seen b))",
            "(at a b)",
            "(not (at b a))",
            "(mode a a)",
            "(linked a b)",
            "(= (n a) 1)",
            "(= (n b) 2)")) {
      maybe(random, world, fact);
    }
    return world;
  }

  private static String effects(Random random, int count) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < count; i++) {
      String effect = effect(random);
      text.append(
          random.nextInt(4) == 0
              ? "(when " + condition(random, "?x", "?y") + " " + effect + ")"
              : effect);
    }
    return text.toString();
  }

  private static String effect(Random random) {
    return pick(
        random,
        "(p ?x)",
        "(not (p ?y))",
        "(seen ?x)",
        "(not (seen ?y))",
        "(sense (seen ?x))",
        "(at ?x ?y)",
        "(not (at ?x ?y))",
        "(sense (at ?x ?y))",
        "(mode ?x ?y)",
        "(not (mode ?x ?y))",
        "(linked ?x ?y)",
        "(not (linked ?x ?y))",
        "(forall (?z - Thing) (not (linked ?x ?z)))",
        "(sense (n ?x))",
        "(assign (n ?x) 2)",
        "(assign (n ?y) 0)",
        "(increase (n ?x) (- 1 (n ?x)))",
        "(decrease (n ?x) (max 0 (min 1 (n ?x))))");
  }

  private static String condition(Random random, String x, String y) {
    String text =
        pick(
            random,
            "(p X)",
            "(not (p Y))",
            "(seen X)",
            "(unknown (seen X))",
            "(at X Y)",
            "(not (at X Y))",
            "(unknown (at X Y))",
            "(mode X Y)",
            "(linked X Y)",
            "(calm X)",
            "(not (calm Y))",
            "(>= (n X) 1)",
            "(< (n X) (n Y))",
            "(not (= (n X) 2))",
            "(unknown (n X))",
            "(or (p X) (seen Y))",
            "(imply (p X) (at X Y))");
    return text.replace("X", x).replace("Y", y);
  }

  static String conjunction(Random random, int size, String... names) {
    String[] terms = names.length > 0 ? names : new String[] {"a", "b"};
    StringBuilder text = new StringBuilder("(and");
    for (int i = 0; i < size; i++) {
      boolean swapped = random.nextBoolean();
      text.append(' ').append(condition(random, terms[swapped ? 1 : 0], terms[swapped ? 0 : 1]));
    }
    return text.append(')').toString();
  }

  private static String pick(Random random, String... texts) {
    return texts[random.nextInt(texts.length)];
  }

  private void check(PlanningTask task, GroundProblem problem) {
    OptionalDouble expected = ExhaustiveSearch.cheapest(problem, 20_000);
    if (expected.isPresent() && Double.isNaN(expected.getAsDouble())) {
      return;
    }
    PlanningResult result = planner.optimistic(task);
    if (expected.isEmpty()) {
      assertThat(result).isInstanceOf(PlanningResult.Impossible.class);
      return;
    }
    assertThat(result).isInstanceOf(PlanningResult.Found.class);
    Plan plan = ((PlanningResult.Found) result).plan();
    assertThat(plan.cost()).isCloseTo(expected.getAsDouble(), within(1e-6));
    assertThat(planner.revalidate(task, plan.steps()))
        .hasValueSatisfying(again -> assertThat(again.cost()).isCloseTo(plan.cost(), within(1e-6)));
    assertThat(planner.revalidate(task, latestFirst(plan.steps())))
        .hasValueSatisfying(again -> assertThat(again.cost()).isCloseTo(plan.cost(), within(1e-6)));
  }

  /**
   * Another order that respects what must wait for what: always the last step that may be taken.
   */
  private static List<Step> latestFirst(List<Step> steps) {
    List<Step> open = new ArrayList<>(steps);
    List<Step> ordered = new ArrayList<>();
    Set<Integer> done = new TreeSet<>();
    while (!open.isEmpty()) {
      int i = open.size() - 1;
      while (!done.containsAll(open.get(i).after())) {
        i--;
      }
      done.add(open.get(i).number());
      ordered.add(open.remove(i));
    }
    return ordered;
  }
}
