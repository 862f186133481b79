package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.maestro.planning.api.Step;
import org.maestro.sl.Change;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** What a goal counts on must not be spoilt by others. */
class CausalLinksTest {
  private final KnownHome home = KnownHome.withRoseAtTheCup();
  private final CausalLinks links = new CausalLinks(home.vocabulary);
  private final Step pick = home.step("rose", "pick", "object=Cup", "zone=zone-b");

  @Test
  void theConditionsOfAStepAreProtected() {
    links.addConditions(pick);

    assertThat(brokenBy(holds("(in rose zone-a)"))).contains("(in rose zone-b)");
    assertThat(brokenBy(holds("(in Cup zone-a)"))).contains("(in Cup zone-b)");
    assertThat(brokenBy(holds("(in Bob zone-b)"))).isEmpty();
    assertThat(brokenBy(holds("(open door-ab)"))).isEmpty();
  }

  @Test
  void whatHoldsOfAnyThingIsProtectedToo() {
    links.addConditions(home.step("rose", "pick", "object=Cup", "zone=zone-a"));

    assertThat(brokenBy(holds("(in Cup rose)")))
        .contains("(not (exists (?x - Item) (in ?x rose)))");
  }

  @Test
  void whatIsNotSoNowCannotBeSpoilt() {
    links.addAll(home.formula("(in Cup zone-a)"), Map.of());

    assertThat(brokenBy(holds("(in Cup rose)"))).isEmpty();
  }

  @Test
  void thatSomethingIsNotKnownIsNoFactToSpoil() {
    links.addConditions(pick);

    assertThat(
            brokenBy(new Change.OfNumber(KnownHome.fluent("(mass Cup)"), OptionalDouble.of(500))))
        .isEmpty();
  }

  @Test
  void ofAGoalThoseParts() {
    links.addAchieved(
        home.formula("(and (in ?what zone-b) (in rose zone-b))"),
        Map.of("what", new Term.Name("Cup")),
        home.changes("(in Cup zone-b)"));

    assertThat(brokenBy(holds("(in Cup zone-a)"))).contains("(in Cup zone-b)");
    assertThat(brokenBy(holds("(in rose zone-a)"))).as("it did not bring that about").isEmpty();
  }

  @Test
  void ofAStepsConditionsThoseThatWereBroughtAbout() {
    links.addAchievedConditions(pick, home.changes("(in rose zone-b)"));

    assertThat(brokenBy(holds("(in rose zone-a)"))).contains("(in rose zone-b)");
    assertThat(brokenBy(holds("(in Cup zone-a)"))).isEmpty();
  }

  @Test
  void aPartThatIsOfNothingCertainIsNot() {
    links.addAll(home.formula("(in ?x zone-b)"), Map.of());

    assertThat(brokenBy(holds("(in Cup zone-a)"))).isEmpty();
  }

  @Test
  void numbersAreProtected() {
    links.addAll(home.formula("(>= (illuminance zone-b) 10)"), Map.of());

    assertThat(brokenBy(number(OptionalDouble.of(5)))).contains("(>= (illuminance zone-b) 10)");
    assertThat(brokenBy(number(OptionalDouble.empty()))).as("nobody would know").isPresent();
    assertThat(brokenBy(number(OptionalDouble.of(11)))).isEmpty();
  }

  @Test
  void noChangeAndNoConditionBreakNothing() {
    assertThat(brokenBy(holds("(in Cup zone-a)"))).isEmpty();

    links.addConditions(pick);

    assertThat(links.brokenBy(List.of(), home.now())).isEmpty();
  }

  private static Change number(OptionalDouble value) {
    return new Change.OfNumber(KnownHome.fluent("(illuminance zone-b)"), value);
  }

  private Change holds(String atom) {
    return new Change.OfTruth(home.atom(atom), true);
  }

  private Optional<String> brokenBy(Change change) {
    return links.brokenBy(List.of(change), home.now()).map(SlPrinter::print);
  }
}
