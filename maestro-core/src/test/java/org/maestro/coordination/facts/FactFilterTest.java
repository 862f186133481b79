package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Change;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** A change wakes those whom it concerns, and no others. */
class FactFilterTest {
  private static KnownHome home;
  private static Vocabulary vocabulary;

  @BeforeAll
  static void loadVocabulary() {
    home = KnownHome.ofBob();
    vocabulary = home.vocabulary;
  }

  @Test
  void whoAsksForACupIsNotConcernedByWhatIsSeenOfOthers() {
    assertThat(wakes("(canSee ?agent Cup)", "(canSee cam-a Cup)")).isTrue();
    assertThat(wakes("(canSee ?agent Cup)", "(unknown (canSee cam-a Cup))")).isTrue();
    assertThat(wakes("(canSee ?agent Cup)", "(not (canSee cam-a Cup))")).isTrue();
    assertThat(wakes("(canSee ?agent Cup)", "(canSee cam-a Bob)")).isFalse();
    assertThat(wakes("(canSee ?agent ?thing)", "(canSee cam-a Bob)")).isTrue();
    assertThat(wakes("(canSee cam-a ?thing)", "(canSee cam-b Bob)")).isFalse();
  }

  @Test
  void theValueIsWhatChanges() {
    assertThat(wakes("(in Cup zone-a)", "(in Cup zone-b)")).isTrue();
    assertThat(wakes("(in ?thing zone-a)", "(in Cup zone-b)")).isTrue();
    assertThat(wakes("(in Cup zone-a)", "(in Bob zone-a)")).isFalse();
  }

  @Test
  void whatHoldsBothWaysIsToldBothWays() {
    assertThat(wakes("(nextTo Cup ?who)", "(nextTo Bob Cup)")).isTrue();
    assertThat(wakes("(nextTo ?who Cup)", "(nextTo Cup Bob)")).isTrue();
    assertThat(wakes("(nextTo ?who Cup)", "(position Cup \"1 2 0\")")).isTrue();
    assertThat(wakes("(nextTo Cup Bob)", "(position Rose \"1 2 0\")")).isFalse();
  }

  @Test
  void numbersAreOfWhatTheyMeasure() {
    assertThat(wakes("(>= (illuminance zone-a) 72)", "(= (illuminance zone-a) 30)")).isTrue();
    assertThat(wakes("(>= (illuminance zone-a) 72)", "(= (illuminance zone-b) 30)")).isFalse();
    assertThat(wakes("(>= (illuminance ?zone) 72)", "(= (illuminance zone-b) 30)")).isTrue();
  }

  @Test
  void changesSpeakOfWhatTheyAreAbout() {
    FactFilter lost = FactFilter.of(List.of("(unknown (in Cup zone-a))"), vocabulary);

    assertThat(lost.speaksOf("(in Cup zone-b)")).isTrue();
    assertThat(lost.speaksOf("(in Bob zone-a)")).isFalse();
  }

  @Test
  void aChangeIsToldByAllItsArguments() {
    assertThat(FactFilter.of(List.of("(in Cup zone-b)"), vocabulary).subjects())
        .containsExactly(entry("in", Set.of("1:zone-b", "Cup")));
    assertThat(FactFilter.of(List.of("(nextTo Cup Bob)"), vocabulary).subjects())
        .as("whichever way round")
        .containsExactly(entry("nextTo", Set.of("Bob", "Cup")));
    assertThat(FactFilter.of(List.of("(= (illuminance zone-b) 3)"), vocabulary).subjects())
        .containsExactly(entry("illuminance", Set.of("zone-b")));
    assertThat(FactFilter.of(List.of("(raining)"), vocabulary).subjects())
        .containsExactly(entry("raining", Set.of("")));
  }

  @Test
  void whatWasToldIsToldAgain() {
    FactFilter cup = FactFilter.of(List.of("(in Cup zone-b)"), vocabulary);
    FactFilter again = FactFilter.of(cup.subjects(), vocabulary);

    assertThat(again.subjects()).isEqualTo(cup.subjects());
    again.addAll(FactFilter.of(List.of("(in Bob zone-a)", "(open door-ab)"), vocabulary));
    assertThat(again.subjects())
        .containsExactly(
            entry("in", Set.of("1:zone-a", "1:zone-b", "Bob", "Cup")),
            entry("open", Set.of("door-ab")));
    assertThat(cup.subjects()).as("who was added to").hasSize(1);
  }

  @Test
  void changesOfTruthsAndNumbersAreToldAlike() {
    FactFilter changed = new FactFilter(vocabulary);
    changed.addChanges(
        List.of(
            new Change.OfTruth((Formula.Atom) SlParser.formula("(in Cup zone-b)"), false),
            new Change.OfNumber(KnownHome.fluent("(illuminance zone-b)"), OptionalDouble.of(3))));

    assertThat(changed.subjects())
        .containsExactly(
            entry("illuminance", Set.of("zone-b")), entry("in", Set.of("1:zone-b", "Cup")));
  }

  @Test
  void aStepDependsOnItsConditionAndOnWhatItClaims() {
    FactFilter filter = new FactFilter(vocabulary);
    filter.addConditions(home.step("rose", "move", "from=zone-a", "to=zone-b"));

    assertThat(filter.subjects().get("in")).containsExactly("rose");
    assertThat(filter.subjects().get("open")).as("of any door").containsExactly("");
    assertThat(filter.subjects().get("side")).contains("1:zone-a", "1:zone-b");
    assertThat(filter.subjects()).doesNotContainKey("level");
  }

  @Test
  void whatAStepDoesDependsOnWhatItsEffectAndPriceRead() {
    FactFilter filter = new FactFilter(vocabulary);
    filter.addEffects(home.step("lamp-b1", "adjustLight", "level=1"));

    assertThat(filter.subjects().get("level")).containsExactly("lamp-b1");
    assertThat(filter.subjects().get("power")).containsExactly("lamp-b1");
    assertThat(filter.subjects().get("gain")).containsExactly("lamp-b1");
    assertThat(filter.subjects()).as("what it sets is not read").doesNotContainKey("illuminance");

    FactFilter look = new FactFilter(vocabulary);
    look.addEffects(home.step("cam-a", "observeObject", "object=Cup", "zone=zone-a"));
    assertThat(look.subjects().get("in")).as("where it hopes to find it").containsExactly("Cup");

    FactFilter measurement = new FactFilter(vocabulary);
    measurement.addEffects(home.step("lux-a", "measureIllumination", "zone=zone-a"));
    assertThat(measurement.subjects().get("illuminance")).contains("zone-a");
  }

  @Test
  void whoeverIsNamedIsConcernedMoreThanWhoMayBeAny() {
    FactFilter any = new FactFilter(vocabulary);
    any.add(SlParser.formula("(and (in ?thing zone-a) (in Bob ?where))"), Map.of());

    assertThat(any.isConcernedBy(FactFilter.of(List.of("(in Ann zone-b)"), vocabulary))).isTrue();
    assertThat(any.isNamedBy(FactFilter.of(List.of("(in Ann zone-b)"), vocabulary))).isFalse();
    assertThat(any.isNamedBy(FactFilter.of(List.of("(in Bob zone-b)"), vocabulary))).isTrue();
    assertThat(any.isNamedBy(FactFilter.of(List.of("(open door-ab)"), vocabulary))).isFalse();
  }

  @Test
  void changesOfAnyOfTheseAreFound() {
    FactFilter changed = FactFilter.of(List.of("(in Cup zone-b)"), vocabulary);

    assertThat(changed.speaksOfAny(Map.of("in", Set.of("Bob", "Cup")))).isTrue();
    assertThat(changed.speaksOfAny(Map.of("in", Set.of("Bob")))).isFalse();
    assertThat(changed.speaksOfAny(Map.of("open", Set.of("Cup")))).isFalse();
    assertThat(changed.speaksOf("(>= (illuminance Cup) 3)")).isFalse();
    assertThat(changed.speaksOf("(and (open door-ab) (not (in Cup zone-a)))")).isTrue();
  }

  private static boolean wakes(String condition, String change) {
    FactFilter interest = new FactFilter(vocabulary);
    interest.add(SlParser.formula(condition, vocabulary::isFluent), Map.of());
    return interest.isConcernedBy(FactFilter.of(List.of(change), vocabulary));
  }
}
