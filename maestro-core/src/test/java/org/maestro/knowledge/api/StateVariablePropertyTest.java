package org.maestro.knowledge.api;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.maestro.knowledge.Household;
import org.maestro.sl.Truth;

class StateVariablePropertyTest {

  private static final List<String> PLACES = List.of("zone-a", "zone-b", "rose");

  /** A word about where the cup is: value, exclusion, or (with "") loss. */
  record Word(boolean holds, String place) {
    String fact() {
      String atom = "(in Cup " + (place.isEmpty() ? "zone-a" : place) + ")";
      if (place.isEmpty()) {
        return "(unknown " + atom + ")";
      }
      return holds ? atom : "(not " + atom + ")";
    }
  }

  @Property(tries = 200)
  void oneValueAtATimeAndExclusionsAddUp(@ForAll("words") List<Word> words) {
    Household home = new Household();
    Optional<String> value = Optional.empty();
    Set<String> excluded = new LinkedHashSet<>();
    for (Word word : words) {
      home.state(Household.CAMERA, word.fact());
      if (word.place().isEmpty() || word.holds()) {
        excluded.clear();
        value = Optional.of(word.place()).filter(place -> !place.isEmpty());
      } else {
        excluded.add(word.place());
        value = value.filter(place -> !place.equals(word.place()));
      }
      for (String place : PLACES) {
        Truth expected =
            value.isPresent()
                ? Truth.of(value.get().equals(place))
                : excluded.contains(place) ? Truth.FALSE : Truth.UNKNOWN;
        assertThat(home.truth("(in Cup " + place + ")")).as(place).isEqualTo(expected);
      }
    }
    home.knowledge.close();
  }

  @Property(tries = 50)
  void theSameWordsGiveTheSameBeliefs(@ForAll("words") List<Word> words) {
    assertThat(beliefs(words)).isEqualTo(beliefs(words));
  }

  private static List<Belief> beliefs(List<Word> words) {
    Household home = new Household();
    words.forEach(word -> home.state(Household.CAMERA, word.fact()));
    List<Belief> beliefs = home.knowledge.snapshot().beliefs();
    home.knowledge.close();
    return beliefs;
  }

  @Provide
  Arbitrary<List<Word>> words() {
    Arbitrary<String> places = Arbitraries.of("zone-a", "zone-b", "rose", "");
    return Arbitraries.of(true, false)
        .flatMap(holds -> places.map(place -> new Word(holds, place)))
        .list()
        .ofMaxSize(12);
  }
}
