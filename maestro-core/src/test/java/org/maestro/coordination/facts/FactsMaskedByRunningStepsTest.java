package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.planning.api.Step;
import org.maestro.sl.Facts;
import org.maestro.sl.Truth;

/** What a step is just changing is no news until it has ended. */
class FactsMaskedByRunningStepsTest {
  private final KnownHome home = KnownHome.withRoseAtTheCup();
  private final Step pick = home.step("rose", "pick", "object=Cup", "zone=zone-b");
  private final Snapshot before = home.now();

  private FactsMaskedByRunningSteps masked() {
    return new FactsMaskedByRunningSteps(home.now(), home.vocabulary);
  }

  private FactsMaskedByRunningSteps maskedBy(FactsMaskedByRunningSteps.Handled handled) {
    FactsMaskedByRunningSteps masked = masked();
    masked.add(handled);
    return masked;
  }

  private FactsMaskedByRunningSteps.Handled handled(Step step) {
    return masked().handled(step, before);
  }

  private void theCameraLosesTheCup() {
    home.seen("cam-b", "(not (in Cup zone-b))", "(in Bob zone-b)");
  }

  @Test
  void whatItChangesIsAsItWasWhenItBegan() {
    theCameraLosesTheCup();

    assertThat(masked().truth(home.atom("(in Cup zone-b)"))).isEqualTo(Truth.FALSE);
    assertThat(maskedBy(handled(pick)).truth(home.atom("(in Cup zone-b)"))).isEqualTo(Truth.TRUE);
    assertThat(maskedBy(handled(pick)).truth(home.atom("(in Bob zone-b)")))
        .as("that is none of its doing")
        .isEqualTo(Truth.TRUE);
  }

  @Test
  void whatHoldsBothWaysIsMaskedBothWays() {
    home.seen("cam-b", "(nextTo Cup Bob)");

    for (String asked : List.of("(nextTo Cup Bob)", "(nextTo Bob Cup)")) {
      assertThat(masked().truth(home.atom(asked))).isEqualTo(Truth.TRUE);
      assertThat(maskedBy(handled(pick)).truth(home.atom(asked))).isEqualTo(Truth.UNKNOWN);
    }
  }

  @Test
  void ofNumbersOnlyTheMembersOwnAreMasked() {
    Step light = home.step("lamp-b1", "adjustLight", "level=1");
    home.told("lamp-b1", "(= (level lamp-b1) 1)");
    home.seen("lux-b", "(= (illuminance zone-b) 47)");
    FactsMaskedByRunningSteps masked = maskedBy(handled(light));

    assertThat(masked.number(KnownHome.fluent("(level lamp-b1)"))).hasValue(0);
    assertThat(masked.number(KnownHome.fluent("(illuminance zone-b)"))).hasValue(47);
  }

  @Test
  void aChangeThatTheStepMakesIsHidden() {
    FactsMaskedByRunningSteps masked = maskedBy(handled(pick));

    assertThat(masked.hides(home.changes("(not (in Cup zone-b))"))).isTrue();
    assertThat(masked.hides(home.changes("(in Bob zone-b)"))).isFalse();
    assertThat(masked.hides(home.changes("(open door-ab)"))).isFalse();
    assertThat(masked().hides(home.changes("(not (in Cup zone-b))"))).isFalse();
  }

  @Test
  void itIsNoNewsWhatWasSeenThenOrIsHidden() {
    KnowledgeVersion version = new KnowledgeVersion(5, maskedBy(handled(pick)));

    assertThat(version.has(change(5, "(in Bob zone-b)"), home.changes("(in Bob zone-b)"))).isTrue();
    assertThat(version.has(change(6, "(in Bob zone-b)"), home.changes("(in Bob zone-b)")))
        .isFalse();
    assertThat(version.has(change(5, "(in Cup zone-a)"), home.changes("(in Cup zone-a)")))
        .as("it was hidden, and so not looked at")
        .isFalse();
  }

  private static KnowledgeBase.Change change(long version, String fact) {
    return new KnowledgeBase.Change(
        version, new Source(Source.Kind.OBSERVED, "cam-b"), List.of(fact));
  }

  @Test
  void theRestIsAsItIs() {
    FactsMaskedByRunningSteps masked = maskedBy(handled(pick));

    assertThat(masked.individuals("Item")).isEqualTo(home.now().individuals("Item")).isNotEmpty();
    assertThat(masked.chanceStill(home.atom("(in Cup zone-b)")))
        .isEqualTo(home.now().chanceStill(home.atom("(in Cup zone-b)")));
    assertThat(masked.candidates(home.atom("(side ?d zone-a)"), "d"))
        .isEqualTo(home.now().candidates(home.atom("(side ?d zone-a)"), "d"));
    assertThat(masked.candidates(home.atom("(in ?x zone-b)"), "x"))
        .as("each has to be asked for")
        .isEmpty();
  }

  @Test
  void answersTellOnWhatTheyRest() {
    List<Object> told = new ArrayList<>();
    FactsMaskedByRunningSteps masked = maskedBy(handled(pick));
    Facts traced = masked.tracing(told::add).orElseThrow();
    theCameraLosesTheCup();

    assertThat(traced.truth(home.atom("(in Cup zone-b)"))).isEqualTo(Truth.TRUE);
    assertThat(told)
        .contains(new FactsMaskedByRunningSteps.Subject("in", home.atom("(x Cup)").arguments()));
    told.clear();
    assertThat(traced.number(KnownHome.fluent("(illuminance zone-b)"))).hasValue(17);
    assertThat(told)
        .contains(
            new FactsMaskedByRunningSteps.Subject(
                "illuminance", home.atom("(x zone-b)").arguments()));
    told.clear();
    assertThat(traced.candidates(home.atom("(in ?x zone-b)"), "x")).isEmpty();
    assertThat(told).contains(new FactsMaskedByRunningSteps.Subject("in", List.of()));
    assertThat(traced.candidates(home.atom("(side ?d zone-a)"), "d"))
        .isEqualTo(masked.candidates(home.atom("(side ?d zone-a)"), "d"));
    assertThat(traced.individuals("Item")).isEqualTo(masked.individuals("Item"));
    assertThat(traced.chanceStill(home.atom("(in Cup zone-b)")))
        .isEqualTo(masked.chanceStill(home.atom("(in Cup zone-b)")));
  }

  @Test
  void otherStepsAreADifferenceInWhatTheyChange() {
    FactsMaskedByRunningSteps plain = masked();
    FactsMaskedByRunningSteps picking = maskedBy(handled(pick));
    Object cup = new FactsMaskedByRunningSteps.Subject("in", home.atom("(x Cup)").arguments());

    assertThat(plain.changedSince(plain)).contains(Set.of());
    assertThat(picking.changedSince(plain))
        .hasValueSatisfying(all -> assertThat(all).contains(cup));
    assertThat(plain.changedSince(picking))
        .hasValueSatisfying(
            all ->
                assertThat(all)
                    .contains(cup, new FactsMaskedByRunningSteps.Subject("in", List.of())));
    assertThat(picking.changedSince(home.now())).isEmpty();
  }

  @Test
  void whatItIsOfIsToldAsChangesTellIt() {
    Map<String, Set<String>> spokenOf = handled(pick).spokenOf();

    assertThat(spokenOf.get("in")).containsExactly("Cup");
    assertThat(spokenOf.get("nextTo")).contains("Cup", "Bob");
    assertThat(spokenOf.get("canSee")).contains("cam-a", "cam-b");
  }
}
