package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.maestro.planning.api.Step;
import org.maestro.sl.Change;
import org.maestro.sl.Truth;

/** The facts as they will be when a step is done. */
class ProgressedStateTest {
  private final KnownHome home = KnownHome.withRoseAtTheCup();
  private final Step pick = home.step("rose", "pick", "object=Cup", "zone=zone-b");
  private final ProgressedState picked = after(pick);

  @Test
  void whatTheStepBringsAboutIsSo() {
    assertThat(picked.truth(home.atom("(in Cup rose)"))).isEqualTo(Truth.TRUE);
    assertThat(picked.truth(home.atom("(nextTo Cup Bob)"))).isEqualTo(Truth.FALSE);
    assertThat(picked.truth(home.atom("(nextTo Bob Cup)"))).as("both ways").isEqualTo(Truth.FALSE);
  }

  @Test
  void ofSeveralPlacesAThingIsInOne() {
    assertThat(home.now().truth(home.atom("(in Cup zone-b)"))).isEqualTo(Truth.TRUE);
    assertThat(picked.truth(home.atom("(in Cup zone-b)"))).isEqualTo(Truth.FALSE);
    assertThat(picked.truth(home.atom("(in rose zone-b)"))).isEqualTo(Truth.TRUE);
  }

  @Test
  void whatIsDerivedFollows() {
    assertThat(home.now().truth(home.atom("(handFree rose)"))).isEqualTo(Truth.TRUE);
    assertThat(picked.truth(home.atom("(handFree rose)"))).isEqualTo(Truth.FALSE);
    assertThat(picked.truth(home.atom("(passable zone-a zone-b)"))).isEqualTo(Truth.TRUE);
  }

  @Test
  void whatIsDerivedFromTheUnknownIsNotSo() {
    KnownHome nothingKnown = KnownHome.ofBob();
    ProgressedState same =
        new ProgressedState(nothingKnown.now(), List.of(), nothingKnown.vocabulary);

    assertThat(same.truth(home.atom("(in Cup rose)"))).isEqualTo(Truth.UNKNOWN);
    assertThat(same.truth(home.atom("(handFree rose)"))).isEqualTo(Truth.FALSE);
  }

  @Test
  void aValueThatIsTakenAwaySaysNothingOfOthers() {
    ProgressedState gone =
        new ProgressedState(
            home.now(),
            List.of(new Change.OfTruth(home.atom("(in Cup zone-a)"), false)),
            home.vocabulary);

    assertThat(gone.truth(home.atom("(in Cup zone-b)"))).isEqualTo(Truth.TRUE);
    assertThat(gone.truth(home.atom("(in Cup zone-a)"))).isEqualTo(Truth.FALSE);
  }

  @Test
  void numbersAreReckoned() {
    ProgressedState lit = after(home.step("lamp-b1", "adjustLight", "level=1"));

    assertThat(lit.number(KnownHome.fluent("(level lamp-b1)"))).hasValue(1);
    assertThat(lit.number(KnownHome.fluent("(illuminance zone-b)")).orElseThrow())
        .isCloseTo(47, within(0.5));
    assertThat(lit.number(KnownHome.fluent("(illuminance zone-a)"))).isEmpty();
    assertThat(picked.number(KnownHome.fluent("(illuminance zone-b)"))).hasValue(17);
  }

  @Test
  void aNumberThatNobodyCanReckonIsUnknown() {
    ProgressedState measured =
        new ProgressedState(
            home.now(),
            List.of(
                new Change.OfNumber(
                    KnownHome.fluent("(illuminance zone-b)"), OptionalDouble.empty())),
            home.vocabulary);

    assertThat(measured.number(KnownHome.fluent("(illuminance zone-b)"))).isEmpty();
  }

  @Test
  void thereAreNoMoreThingsThanBefore() {
    assertThat(picked.individuals("Item")).isEqualTo(home.now().individuals("Item"));
  }

  private ProgressedState after(Step step) {
    return ProgressedState.of(home.now(), home.vocabulary, step);
  }
}
