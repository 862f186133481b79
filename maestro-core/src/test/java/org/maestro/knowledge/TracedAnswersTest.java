package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** An answer that rests on nothing that has changed since is the same answer now. */
class TracedAnswersTest {
  private static final int MOMENTS = 12;
  private static final List<String> STATEMENTS =
      List.of(
          "(position Cup \"1 0 0\")",
          "(position Cup \"4 0 0\")",
          "(position Bob \"4.2 0 0\")",
          "(position rose \"1 0 0\")",
          "(in Cup zone-a)",
          "(in Cup rose)",
          "(not (in Cup zone-b))",
          "(not (in Cup zone-a))",
          "(in Bob zone-b)",
          "(canSee cam-b Cup)",
          "(not (canSee cam-b Cup))",
          "(nextTo Bob Cup)",
          "(unknown (in Cup zone-a))",
          "(covers cam-a zone-b)",
          "(open lamp-b1)",
          "(not (open lamp-b1))",
          "(= (illuminance zone-a) 100)",
          "(= (illuminance zone-a) 20)",
          "(= (level lamp-b1) 0.5)");
  private static final List<String> ATOMS =
      List.of(
          "(in Cup zone-a)",
          "(in Cup zone-b)",
          "(in Cup rose)",
          "(in Bob zone-a)",
          "(in Bob zone-b)",
          "(in rose zone-a)",
          "(nextTo Cup Bob)",
          "(nextTo Bob Cup)",
          "(canSee cam-b Cup)",
          "(covers cam-a zone-a)",
          "(covers cam-a zone-b)",
          "(open lamp-b1)",
          "(handFree rose)",
          "(Item Cup)");
  private static final List<String> PATTERNS =
      List.of("(covers ?d zone-a)", "(covers cam-a ?d)", "(open ?d)", "(in Cup ?d)");
  private static final List<String> FLUENTS =
      List.of("(illuminance zone-a)", "(illuminance zone-b)", "(level lamp-b1)");

  private static final List<String> OPEN_FLUENTS =
      List.of("(distance Bob ?d)", "(distance ?d Cup)", "(level ?d)", "(viewShare cam-a ?d)");

  @Property(tries = 25)
  void whatRestsOnNothingThatChangedIsTheSame(@ForAll Random random) {
    Household household = new Household();
    try {
      List<Snapshot> moments = new ArrayList<>();
      for (int n = 0; n < MOMENTS; n++) {
        Source source = random.nextBoolean() ? Household.CAMERA : Household.ROBOT;
        household.state(source, STATEMENTS.get(random.nextInt(STATEMENTS.size())));
        if (random.nextInt(3) == 0) {
          household.pass(Duration.ofSeconds(random.nextInt(400)));
        }
        moments.add(household.knowledge.snapshot());
      }
      for (Snapshot then : moments) {
        for (Snapshot now : moments) {
          compare(then, now);
        }
      }
    } finally {
      household.knowledge.close();
    }
  }

  private static void compare(Snapshot then, Snapshot now) {
    Set<Object> changed = now.changedSince(then).orElseThrow();
    Map<String, Set<Object>> grounds = new HashMap<>();
    Map<String, Object> before = answers(then, grounds);
    Map<String, Object> after = answers(now, new HashMap<>());
    before.forEach(
        (question, answer) -> {
          if (Collections.disjoint(grounds.get(question), changed)) {
            assertThat(after.get(question)).as(question).isEqualTo(answer);
          }
        });
  }

  private static Map<String, Object> answers(Snapshot snapshot, Map<String, Set<Object>> grounds) {
    Set<Object> told = new HashSet<>();
    Facts traced = snapshot.tracing(told::add).orElseThrow();
    Map<String, Object> answers = new HashMap<>();
    for (String atom : ATOMS) {
      told.clear();
      answers.put(atom, traced.truth((Formula.Atom) SlParser.formula(atom)));
      grounds.put(atom, Set.copyOf(told));
    }
    for (String pattern : PATTERNS) {
      told.clear();
      answers.put(pattern, traced.candidates((Formula.Atom) SlParser.formula(pattern), "d"));
      grounds.put(pattern, Set.copyOf(told));
    }
    for (String fluent : OPEN_FLUENTS) {
      told.clear();
      answers.put(fluent, traced.aboveZero((Expression.Fluent) SlParser.expression(fluent), "d"));
      grounds.put(fluent, Set.copyOf(told));
    }
    for (String fluent : FLUENTS) {
      told.clear();
      answers.put(fluent, traced.number((Expression.Fluent) SlParser.expression(fluent)));
      grounds.put(fluent, Set.copyOf(told));
    }
    return answers;
  }

  /** What the home says alone is in the index; once members speak of it, all are tried again. */
  @Test
  void forWhomAPredicateMayHoldIsReadFromTheHome() {
    Household household = new Household();
    try {
      Formula.Atom pattern = (Formula.Atom) SlParser.formula("(covers ?d zone-a)");
      Snapshot then = household.knowledge.snapshot();
      assertThat(then.candidates(pattern, "d")).contains(Set.of(new Term.Name("cam-a")));
      household.state(Household.CAMERA, "(covers cam-b zone-a)");
      assertThat(household.knowledge.snapshot().candidates(pattern, "d")).isEmpty();
      assertThat(then.candidates((Formula.Atom) SlParser.formula("(in Cup ?d)"), "d")).isEmpty();
    } finally {
      household.close();
    }
  }

  /** Nobody is left out with whom it may be more, those of whom nothing is known included. */
  @Test
  void withWhomANumberMayBeMoreThanNothingIsReckonedOfTheHome() {
    Household household = new Household();
    try {
      household.state(Household.CAMERA, "(position Bob \"4 0 0\")", "(position Cup \"1 0 0\")");
      Snapshot now = household.knowledge.snapshot();
      Expression.Fluent open = (Expression.Fluent) SlParser.expression("(distance Bob ?d)");
      Set<Term> above = now.aboveZero(open, "d").orElseThrow();

      assertThat(above).contains(new Term.Name("Cup")).doesNotContain(new Term.Name("Bob"));
      for (Term.Name individual : now.individuals("")) {
        OptionalDouble distance =
            now.number(
                new Expression.Fluent("distance", List.of(new Term.Name("Bob"), individual)));
        assertThat(above.contains(individual))
            .as(individual.text())
            .isEqualTo(distance.isEmpty() || distance.getAsDouble() > 0);
      }
      household.state(Household.CAMERA, "(= (distance Bob Cup) 3)");
      assertThat(household.knowledge.snapshot().aboveZero(open, "d")).isEmpty();
    } finally {
      household.close();
    }
  }

  @Test
  void littleIsAskedAgainWhenLittleHasChanged() {
    Household household = new Household();
    try {
      household.state(Household.CAMERA, "(position Bob \"4 0 0\")", "(position Cup \"1 0 0\")");
      Snapshot then = household.knowledge.snapshot();
      household.state(Household.CAMERA, "(= (level lamp-b1) 0.5)");
      Set<Object> changed = household.knowledge.snapshot().changedSince(then).orElseThrow();
      assertThat(changed).hasSize(1);
      assertThat(then.changedSince(then).orElseThrow()).isEmpty();
      assertThat(then.notOlderThan(Duration.ofSeconds(1)).changedSince(then)).isEmpty();
    } finally {
      household.close();
    }
  }
}
