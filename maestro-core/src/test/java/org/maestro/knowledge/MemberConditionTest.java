package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.DescribedFeatures;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.MemberCondition;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Truth;

/**
 * The states of all members are a part of the environment's state, and conditions may speak of them
 * (Three-layered architecture, 3.2.2; M49).
 */
class MemberConditionTest {
  private static final Path BOB = Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl");

  /** A bell that does not disturb Rose. */
  private static final String BELL =
      """

      home:chimed a maestro:Predicate ; maestro:arguments ( ) .
      home:chime a maestro:Action ; maestro:sentence "{self} chimes" ;
        maestro:precondition "(and (not (busy rose)) (not (lost rose)) (memberState rose \\"standby\\"))" ;
        maestro:effect "(chimed)" ; maestro:cost "1" ; maestro:seconds "1" .
      home:Bell a <http://www.w3.org/2002/07/owl#Class> ;
        <http://www.w3.org/2000/01/rdf-schema#subClassOf> maestro:Device ; maestro:offers home:chime .
      home:bell a home:Bell ; rdfs:label "the bell" .
      """;

  private final CollectiveKnowledge knowledge =
      new CollectiveKnowledge(new HomeLoader().load(home(), "bob.ttl"), new SteppedClock());

  @AfterEach
  void close() {
    knowledge.close();
  }

  @Test
  void aSnapshotHasTheStatesOfAllMembersWithWhoSaidSo() {
    knowledge.condition("rose", new MemberCondition("driving", true));
    knowledge.condition("cam-a", new MemberCondition("safe", false));
    knowledge.condition("lamp-b1", new MemberCondition("standby", false));
    knowledge.lost("lamp-b1");

    assertThat(truth("(and (busy rose) (memberState rose \"driving\"))")).isEqualTo(Truth.TRUE);
    assertThat(truth("(inSafeState rose)")).isEqualTo(Truth.FALSE);
    assertThat(truth("(and (inSafeState cam-a) (not (busy cam-a)))")).isEqualTo(Truth.TRUE);
    assertThat(truth("(lost lamp-b1)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(memberState lamp-b1 \"standby\")")).isEqualTo(Truth.UNKNOWN);
    assertThat(truth("(inSafeState lamp-b2)")).as("it has told nothing").isEqualTo(Truth.UNKNOWN);
    assertThat(knowledge.snapshot().belief((Formula.Atom) SlParser.formula("(busy rose)")))
        .map(Belief::source)
        .contains(new Source(Source.Kind.OBSERVED, "rose"));
  }

  @Test
  void itStandsBesideWhatTheMemberTellsOfItselfAndGoesWithItsLoss() {
    knowledge.condition("rose", new MemberCondition("driving", true));
    knowledge.state(
        new Source(Source.Kind.STATED, "rose"), List.of("(in rose zone-b)", "(= (charge rose) 1)"));

    assertThat(truth("(and (busy rose) (in rose zone-b))")).isEqualTo(Truth.TRUE);

    knowledge.lost("rose");
    assertThat(truth("(and (lost rose) (not (busy rose)))")).isEqualTo(Truth.TRUE);

    knowledge.condition("rose", new MemberCondition("standby", false));
    assertThat(truth("(and (not (lost rose)) (memberState rose \"standby\"))"))
        .isEqualTo(Truth.TRUE);
  }

  @Test
  void aPreconditionThatSpeaksOfItIsHonoured() {
    knowledge.condition("rose", new MemberCondition("driving", true));
    assertThat(plan("(chimed)")).isInstanceOf(PlanningResult.Impossible.class);

    knowledge.condition("rose", new MemberCondition("standby", false));
    assertThat(plan("(chimed)")).isInstanceOf(PlanningResult.Found.class);

    knowledge.lost("rose");
    assertThat(plan("(chimed)")).isInstanceOf(PlanningResult.Impossible.class);
  }

  private PlanningResult plan(String goal) {
    return new OptimalPlanner()
        .plan(
            new PlanningTask(
                knowledge.home().vocabulary(),
                knowledge.snapshot(),
                DescribedFeatures.of(knowledge.home(), member -> true),
                SlParser.formula(goal),
                Set.of()));
  }

  private Truth truth(String formula) {
    return new Instances(SlParser.formula(formula), knowledge.snapshot())
        .truth(SlParser.formula(formula));
  }

  private static String home() {
    try {
      return Files.readString(BOB) + BELL;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
