package org.maestro.hal.sight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.hal.sight.Recollection.Verdict;

class RecollectionTest {
  private static final Position HERE = new Position(1, 1, 0);
  private static final Position THERE = new Position(3, 1, 0);
  private static final Position ELSEWHERE = new Position(9, 9, 0);
  private static final Set<String> OTHER = Set.of("B");

  private final Recollection recollection = new Recollection(Map.of("A", HERE, "B", THERE));

  private Verdict judge(String wanted, Set<String> alike, Position... seen) {
    return recollection.judge(wanted, alike, List.of(seen), place -> !place.equals(ELSEWHERE));
  }

  @Test
  void eachIsKnownByItsPlace() {
    assertThat(judge("A", OTHER, THERE, HERE).place()).contains(HERE);
    assertThat(judge("B", Set.of("A"), THERE, HERE).place()).contains(THERE);
  }

  @Test
  void whatWasMovedIsTheOneThatIsNotTheOther() {
    Position moved = new Position(1, 2, 0);

    assertThat(judge("A", OTHER, THERE, moved).place()).contains(moved);
    assertThat(judge("A", OTHER, THERE, moved).place()).contains(moved);
  }

  @Test
  void theOtherIsNotTakenForIt() {
    assertThat(judge("A", OTHER, THERE)).isEqualTo(new Verdict(Optional.empty(), Optional.empty()));
  }

  @Test
  void whenBothWereMovedNobodyCanTell() {
    Verdict verdict = judge("A", OTHER, new Position(1, 3, 0), new Position(3, 3, 0));

    assertThat(verdict.place()).isEmpty();
    assertThat(verdict.doubt().orElseThrow()).contains("A as well as B");
  }

  @Test
  void whatIsOutOfViewIsStillWhereItWas() {
    Recollection far = new Recollection(Map.of("B", ELSEWHERE));

    assertThat(far.judge("A", OTHER, List.of(HERE), place -> !place.equals(ELSEWHERE)).place())
        .contains(HERE);
  }

  /** A was seen elsewhere, and so was B: either may have been moved here. */
  @Test
  void whatMayBeAnotherThatWasMovedIsNotTakenForIt() {
    Recollection far = new Recollection(Map.of("A", ELSEWHERE, "B", ELSEWHERE));

    assertThat(
            far.judge("A", OTHER, List.of(HERE), place -> !place.equals(ELSEWHERE))
                .doubt()
                .orElseThrow())
        .contains("may be A as well as B");
  }

  @Test
  void whatNobodyKnowsOfMayBeIt() {
    Recollection empty = new Recollection(Map.of());

    assertThat(empty.judge("A", OTHER, List.of(HERE), place -> true).doubt().orElseThrow())
        .contains("may be A as well as B");
    assertThat(empty.judge("A", Set.of(), List.of(HERE), place -> true).place()).contains(HERE);
    assertThat(empty.judge("A", Set.of(), List.of(HERE, ELSEWHERE), place -> true).place())
        .contains(HERE);
    assertThat(
            empty
                .judge("A", Set.of(), List.of(THERE, ELSEWHERE), place -> true)
                .doubt()
                .orElseThrow())
        .contains("2 things in view look like A");
  }
}
