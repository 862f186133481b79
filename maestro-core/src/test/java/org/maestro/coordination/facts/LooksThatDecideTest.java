package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.sl.Facts;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Truth;

/** A goal that nobody can bring about may be so already: which looks would tell. */
class LooksThatDecideTest {
  private static final String NEXT =
      "(or (nextTo Cup Bob) (and (unknown (nextTo Cup Bob)) (seen% Cup) (seen% Bob)))";

  private final KnownHome home = KnownHome.ofBob();

  @ParameterizedTest
  @CsvSource({
    "(nextTo Cup Bob), true",
    "(not (nextTo Cup Bob)), true",
    "(nextTo ?thing Bob), true",
    "(<= (distance Cup Bob) 1), true",
    "(inside Cup zone-a), true",
    "(in Cup zone-a), false",
    "(<= (distance zone-a zone-b) 1), false",
    "(>= (illuminance zone-a) 72), false",
    "(canSee cam-a Cup), false"
  })
  void theyHelpWithWhatNoLookByItselfTells(String goal, boolean helps) {
    assertThat(EpistemicGoal.helps(home.formula(goal), home.now(), home.vocabulary))
        .isEqualTo(helps);
  }

  @Test
  void theyHelpNoMoreWhenAllHasBeenSeen() {
    home.seen("cam-a", "(position Cup \"1 1 0\")", "(position Bob \"1 2 0\")");

    assertThat(helps("(nextTo Cup Bob)")).isFalse();
    assertThat(helps("(<= (distance Cup Bob) 1)")).isFalse();
    assertThat(helps("(inside Cup zone-a)")).isFalse();
    assertThat(helps("(nextTo ?thing Bob)")).as("of whom, is open").isTrue();
  }

  private boolean helps(String goal) {
    return EpistemicGoal.helps(home.formula(goal), home.now(), home.vocabulary);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(nextTo Cup Bob) | " + NEXT,
        "(and (nextTo Cup Bob) (in Cup zone-a)) | (and " + NEXT + " (in Cup zone-a))",
        "(or (nextTo Cup Bob) (in Cup zone-a)) | (or " + NEXT + " (in Cup zone-a))",
        "(not (unknown (nextTo Cup Bob)))"
            + " | (or (not (unknown (nextTo Cup Bob)))"
            + " (and (unknown (nextTo Cup Bob)) (seen% Cup) (seen% Bob)))",
        "(exists (?x - Item) (nextTo ?x Bob))"
            + " | (exists (?x - Item) (or (nextTo ?x Bob)"
            + " (and (unknown (nextTo ?x Bob)) (seen% ?x) (seen% Bob))))",
        "(forall (?x - Item) (nextTo ?x Bob))"
            + " | (forall (?x - Item) (or (nextTo ?x Bob)"
            + " (and (unknown (nextTo ?x Bob)) (seen% ?x) (seen% Bob))))",
        "(<= (distance Cup Bob) 1)"
            + " | (or (<= (distance Cup Bob) 1) (and (unknown (distance Cup Bob))"
            + " (or (seen% Cup) (not (Thing Cup))) (or (seen% Bob) (not (Thing Bob)))))",
        "(inside Cup zone-a)"
            + " | (or (inside Cup zone-a) (and (unknown (inside Cup zone-a))"
            + " (or (seen% Cup) (not (Thing Cup))) (or (seen% zone-a) (not (Thing zone-a)))))"
      })
  void toHaveSeenWhatDecidesIsEnough(String goal, String seen) {
    assertThat(SlPrinter.print(EpistemicGoal.goal(home.formula(goal), home.vocabulary)))
        .isEqualTo(seen);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "(in Cup zone-a)",
        "(>= (illuminance zone-a) 72)",
        "(not (nextTo Cup Bob))",
        "(not (unknown (in Cup zone-a)))",
        "(unknown (nextTo Cup Bob))"
      })
  void otherGoalsStayAsTheyAre(String goal) {
    assertThat(SlPrinter.print(EpistemicGoal.goal(home.formula(goal), home.vocabulary)))
        .isEqualTo(goal);
  }

  @Test
  void whoeverFindsOutWhereThingsAreCanHelp() {
    assertThat(
            SlPrinter.print(
                EpistemicGoal.relevant(home.formula("(nextTo Cup Bob)"), home.vocabulary)))
        .isEqualTo("(and (nextTo Cup Bob) (in ?x ?p))");
  }

  @Test
  void whatHasAPositionHasBeenSeen() {
    home.seen("cam-a", "(position Cup \"1 1 0\")");
    Facts facts = EpistemicGoal.withWhatIsSeen(home.now(), home.now());

    assertThat(facts.truth(home.atom("(seen% Cup)"))).isEqualTo(Truth.TRUE);
    assertThat(facts.truth(home.atom("(seen% Bob)"))).isEqualTo(Truth.FALSE);
    assertThat(facts.truth(home.atom("(in Cup zone-a)"))).isEqualTo(Truth.TRUE);
    assertThat(facts.number(KnownHome.fluent("(mass Cup)"))).hasValue(0.25);
    assertThat(facts.individuals("Person")).hasSize(1);
  }
}
