package org.maestro.planning.alike;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Collection;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.DescribedFeatures;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.ReplanningPlanner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** Six robots in three rooms, of which nobody has said anything. */
class FewAlikeTest {
  private static final List<String> ROBOTS = List.of("r0", "r1", "r2", "r3", "r4", "r5");

  private final CollectiveKnowledge knowledge = knowledge("");

  @Test
  void ofSixThatAreAlikeThreeArePlannedWith() {
    PlanningTask few = FewAlike.of(task("(nextTo Cup Anna)")).orElseThrow().task();

    assertThat(few.features()).extracting("member").contains("r0", "r1", "r2", "cam-0");
    assertThat(few.features()).extracting("member").doesNotContain("r3", "r4", "r5");
    assertThat(few.facts().individuals("MobileRobot"))
        .extracting(Term.Name::text)
        .containsExactly("r0", "r1", "r2");
  }

  @Test
  void whoIsSpokenOfIsLikeNobody() {
    knowledge.state(new Source(Source.Kind.STATED, "r1"), List.of("(in r1 z1)"));
    knowledge.state(new Source(Source.Kind.OBSERVED, "cam-2"), List.of("(in Cup r4)"));

    assertThat(knowledge.snapshot().alike(names("r0", "r1", "r2", "r3", "r4", "r5")))
        .containsExactly(names("r0", "r2", "r3", "r5"));
  }

  @Test
  void whoIsDescribedOtherwiseIsNotLikeThem() {
    CollectiveKnowledge other =
        knowledge("home:r6 a :MobileRobot ; :colour \"green\" ; :size \"0.58 0.38 0.4\" .\n");

    assertThat(other.snapshot().alike(names("r0", "r5", "r6", "Anna", "Cup")))
        .containsExactly(names("r0", "r5"));
  }

  @Test
  void whoIsNamedInTheGoalIsLikeNobody() {
    PlanningTask few = FewAlike.of(task("(in r4 z2)")).orElseThrow().task();

    assertThat(few.features()).extracting("member").contains("r0", "r1", "r2", "r4");
    assertThat(few.features()).extracting("member").doesNotContain("r3", "r5");
  }

  @Test
  void aPlanCostsWhatItCostsWithAllOfThem() {
    PlanningTask task = task("(nextTo Cup Anna)");

    PlanningResult.Found few = (PlanningResult.Found) new OptimalPlanner().plan(task);
    PlanningResult.Found all =
        (PlanningResult.Found) new OptimalPlanner().plan(task.withFacts(unlike(task.facts())));

    assertThat(few.plan().cost()).isCloseTo(all.plan().cost(), within(1e-9));
    assertThat(few.contenders()).containsAll(ROBOTS);
    assertThat(((PlanningResult.Found) new ReplanningPlanner(new OptimalPlanner()).plan(task)))
        .extracting(found -> found.plan().cost())
        .isEqualTo(few.plan().cost());
  }

  /** With few of them it would be a smaller goal. */
  @Test
  void aGoalForAllOfThemIsPlannedWithAllOfThem() {
    PlanningResult.Found found =
        (PlanningResult.Found)
            new OptimalPlanner().plan(task("(forall (?r - MobileRobot) (in ?r z1))"));

    Set<String> looked =
        found.plan().steps().stream()
            .map(Step::bindings)
            .filter(bindings -> bindings.containsKey("object"))
            .map(bindings -> ((Term.Name) bindings.get("object")).text())
            .collect(Collectors.toSet());
    assertThat(looked).containsExactlyInAnyOrderElementsOf(ROBOTS);
  }

  private PlanningTask task(String goal) {
    Home home = knowledge.home();
    return new PlanningTask(
        home.vocabulary(),
        knowledge.snapshot(),
        DescribedFeatures.of(home, device -> true),
        SlParser.formula(goal, home.vocabulary()::isFluent),
        Set.of());
  }

  private static List<Term.Name> names(String... names) {
    return List.of(names).stream().map(Term.Name::new).toList();
  }

  private static CollectiveKnowledge knowledge(String more) {
    StringBuilder home =
        new StringBuilder(
            """
            @prefix : <https://w3id.org/maestro/domain#> .
            @prefix home: <https://w3id.org/maestro/home/alike#> .
            @prefix maestro: <https://w3id.org/maestro#> .
            @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
            <https://w3id.org/maestro/home/alike> a maestro:Home ; rdfs:label "a house"@en .
            home:Anna a :Person ; :colour "blue" ; :size "0.5 0.5 1.2" .
            home:Cup a :Item ; :colour "red" ; :size "0.08 0.08 0.1" ; :mass 0.25 .
            """);
    for (int room = 0; room < 3; room++) {
      int x = 4 * room;
      String outline = "%d 0, %d 0, %d 4, %d 4".formatted(x, x + 4, x + 4, x);
      home.append(
          """
          home:room%1$d a maestro:Room ; maestro:outline "%2$s" ; maestro:height 2.8 .
          home:z%1$d a maestro:Zone ; maestro:outline "%2$s" ; maestro:referencePoint "%3$d.5 1 0" .
          home:cam-%1$d a :Camera ; maestro:pose "%4$d 2 2.8" ; maestro:viewAngle 100 ;
            :minimumIlluminance 72 ; :maximumIlluminance 2000 .
          home:lux-%1$d a :LightSensor ; maestro:pose "%3$d.5 1 0" .
          """
              .formatted(room, outline, x, x + 2));
      if (room > 0) {
        home.append(
            """
            home:door%1$d a maestro:Door ; maestro:openingFrom "%2$d 1" ;
              maestro:openingTo "%2$d 2" ; :side home:z%3$d , home:z%1$d ; :open true .
            """
                .formatted(room, x, room - 1));
      }
    }
    IntStream.range(0, ROBOTS.size())
        .forEach(
            robot ->
                home.append(
                    """
                    home:r%1$d a :MobileRobot ; maestro:order %1$d ; :colour "orange" ;
                      :size "0.58 0.38 0.4" ; :speed 0.8 ; :payload 0.5 .
                    """
                        .formatted(robot)));
    Home loaded = new HomeLoader().load(home + more, "alike.ttl");
    return new CollectiveKnowledge(loaded, new SteppedClock());
  }

  /** The same facts, of which nobody says who is alike. */
  private static Facts unlike(Facts facts) {
    return new Facts() {
      @Override
      public Truth truth(Formula.Atom atom) {
        return facts.truth(atom);
      }

      @Override
      public OptionalDouble number(Expression.Fluent fluent) {
        return facts.number(fluent);
      }

      @Override
      public Collection<Term.Name> individuals(String className) {
        return facts.individuals(className);
      }
    };
  }
}
