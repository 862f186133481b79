package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.sl.Effect;
import org.maestro.sl.SlPrinter;

/** What an effect finds out. */
class SensingTest {
  private final KnownHome home = KnownHome.ofBob();

  @Test
  void itIsFoundHoweverDeepItStands() {
    Effect look = effect("(when (open door-ab) (forall (?z - Zone) (and (sense (glare ?z)))))");

    assertThat(Sensing.isIn(look)).isTrue();
    assertThat(Sensing.isOfAtoms(look)).isTrue();
  }

  @Test
  void aMeasurementIsSensingButNotOfAtoms() {
    Effect measurement = effect("(sense (illuminance zone-a))");

    assertThat(Sensing.isIn(measurement)).isTrue();
    assertThat(Sensing.isOfAtoms(measurement)).isFalse();
  }

  @Test
  void whatIsOnlyDoneIsNoSensing() {
    Effect deed = effect("(and (in Cup rose) (not (open door-ab)) (assign (level lamp-a1) 1))");

    assertThat(Sensing.isIn(deed)).isFalse();
    assertThat(Sensing.isOfAtoms(deed)).isFalse();
    assertThat(Sensing.names(deed)).isEmpty();
  }

  @Test
  void itsNamesAreThoseOfAtomsAndNumbers() {
    assertThat(
            Sensing.names(
                effect(
                    "(and (in Cup rose) (sense (glare zone-a))"
                        + " (when (open door-ab) (sense (illuminance zone-a))))")))
        .containsExactly("glare", "illuminance");
  }

  @Test
  void onlyWhatIsAtOnePlaceAtATimeIsSought() {
    Effect looks =
        effect(
            """
            (and (sense (in ?object ?zone)) (when (open door-ab) (sense (in Bob ?zone)))
              (sense (nextTo Cup Bob)) (sense (glare zone-a)) (in Cup zone-b)
              (forall (?z - Zone) (sense (in Cup ?z))))""");

    assertThat(Sensing.sought(looks, home.vocabulary).stream().map(SlPrinter::print))
        .containsExactly("(in ?object ?zone)", "(in Bob ?zone)");
  }

  @Test
  void nothingIsLookedAtAfterWhatWasWanted() {
    List<String> asked = new ArrayList<>();

    boolean found =
        Sensing.any(
            effect("(and (open door-ab) (in Cup rose) (glare zone-a))"),
            part -> {
              asked.add(SlPrinter.print(part));
              return asked.size() == 2;
            });

    assertThat(found).isTrue();
    assertThat(asked).containsExactly("(open door-ab)", "(in Cup rose)");
  }

  private Effect effect(String text) {
    return home.effect(text);
  }
}
